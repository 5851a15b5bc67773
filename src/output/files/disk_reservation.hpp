#pragma once
// Reserves disk space before it is needed, so that a full disk is detected before anything is half written.

#include <cstdint>
#include <string>

#include "src/output/files/posix_file.hpp"

namespace percuss {

/// A second descriptor of a file that another library writes. All functions throw SystemError with path and reason.
class DiskReservation {
 public:
  DiskReservation() = default;
  /// A link at `path` is followed only where `follows_links`: not of a file that was just made there.
  explicit DiskReservation(const std::string& path, bool follows_links = false);

  /// Makes the disk hold `bytes` more behind the first `size` bytes; if it cannot, the file is `size` bytes long after.
  /// Throws as well if the path no longer leads to the file.
  void reserve(std::uint64_t size, std::uint64_t bytes);

  /// Gives back what lies behind the first `size` bytes.
  void trim(std::uint64_t size) const;

  /// Does as trim() does, for an owner that has cut the file to its data by itself, unless they fitted in before: if
  /// the file is still as long as reserve() made it, all that was reserved is given back.
  void trim_if_unused() const;

  /// Gives back all room of the file, which is empty then. Without an error: it is for a file that is given up.
  void release() const noexcept;

  const PosixFile& file() const { return file_; }

 private:
  PosixFile file_;
  std::int64_t begin_ = 0, end_ = 0;  // what was reserved last
};

}  // namespace percuss
