#pragma once
// A file by system calls, each of which is checked: what the system refuses reaches the caller, with path and reason.

#include <cstdint>
#include <string>

namespace percuss {

/// All functions throw SystemError with path and reason.
class PosixFile {
 public:
  PosixFile() = default;

  /// Opens `path` as open(2) does with these flags; a new file may be read and written by all whom the umask lets.
  /// name: what messages call the file, if not by its path.
  PosixFile(std::string path, int flags, std::string name = "");
  /// Closes; an error is lost then: close() first.
  ~PosixFile();
  PosixFile(PosixFile&& other) noexcept;
  PosixFile& operator=(PosixFile&& other) noexcept;

  std::int64_t size() const;

  /// Bytes [offset, offset + count), all of them. A full disk is waited for: PERCUSS_WAIT_FOR_SPACE seconds, 60
  /// without.
  void read(void* into, std::int64_t offset, std::int64_t count) const;
  void write(const void* from, std::int64_t offset, std::int64_t count) const;

  /// Makes the disk hold bytes [offset, offset + count), and waits likewise. False: this file system cannot reserve
  /// room.
  bool reserve(std::int64_t offset, std::int64_t count) const;

  /// Cuts or extends it to so many bytes.
  void truncate(std::int64_t bytes) const;

  /// Waits until the disk holds the file.
  void sync() const;

  /// Closes it. Some file systems tell only now that data did not arrive.
  void close();

  /// Whether the path still leads to this file.
  bool is_in_place() const;
  /// Throws unless it does.
  void check_place() const;

 private:
  [[noreturn]] void fail(const char* action) const;

  std::string path_, name_;
  int descriptor_ = -1;
};

}  // namespace percuss
