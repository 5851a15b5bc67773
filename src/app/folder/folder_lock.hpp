#pragma once
// One run at a time writes into a folder of results: DIR/run.lock names it.

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace percuss {

/// Name of the file within the folder.
inline constexpr const char* lock_file_name = "run.lock";

/// Held while this lives, by one process of a run. The file appears whole and at once on file systems of one machine
/// and of many (NFS), and is touched every ten seconds as a sign of life.
class FolderLock {
 public:
  /// Takes the lock of a folder that exists. One whose holder has ended is taken over. Throws InputError if another
  /// run holds it or may hold it, SystemError if the file cannot be made.
  explicit FolderLock(const std::string& folder);
  /// Removes the file, if it is still this one's.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  const std::string& path() const { return path_; }
  /// Content of the file, of this lock alone.
  const std::string& text() const { return text_; }
  /// Message for the user on a lock that was taken over; empty if there was none.
  const std::string& note() const { return note_; }

 private:
  bool try_to_take(const std::string& temporary);
  void judge_other();
  void remove_ended(const std::string& text);
  void show_life();

  std::string path_, text_, note_;
  std::mutex mutex_;
  std::condition_variable change_;
  bool is_ending_ = false;
  std::thread heartbeat_;
};

/// Removes the lock file at `path` if `text` is what it holds: for a rank that ends all ranks at once. Throws nothing.
void remove_lock(const std::string& path, const std::string& text) noexcept;

/// Who holds the folder's lock and whether that run is active, as one line; empty if there is no lock.
std::string describe_lock(const std::string& folder);

}  // namespace percuss
