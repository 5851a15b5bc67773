#include "src/app/folder/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <optional>
#include <system_error>

#include "src/app/folder/lock_holder.hpp"
#include "src/output/files/atomic_file.hpp"

namespace percuss {
namespace {

constexpr auto heartbeat_interval = std::chrono::seconds(10);
constexpr std::size_t longest_lock = 64 << 10;  // bytes
constexpr const char* removal_suffix = ".removal";
constexpr auto pause_after_loss = std::chrono::milliseconds(20);
constexpr int most_losses = 100;  // two seconds of such pauses

struct LockFile {
  std::string text;
  double silent_s = 0;  // since it was touched, by the clocks of the file system and of this machine
};

/// Nothing if there is no such file.
std::optional<LockFile> read_lock(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW);
  if (descriptor < 0) return errno == ENOENT ? std::nullopt : std::optional(LockFile{});
  LockFile lock;
  std::array<char, 4096> part{};
  for (ssize_t count = 1; count > 0 && lock.text.size() < longest_lock;) {
    count = ::read(descriptor, part.data(), part.size());
    if (count > 0) lock.text.append(part.data(), static_cast<std::size_t>(count));
  }
  struct stat status {};
  if (::fstat(descriptor, &status) == 0) lock.silent_s = std::difftime(std::time(nullptr), status.st_mtime);
  ::close(descriptor);
  return lock;
}

bool write_new_file(const std::string& path, const std::string& text) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return false;
  const bool written = ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const int write_error = errno;
  const bool closed = ::close(descriptor) == 0;
  if (written && closed) return true;
  if (!written) errno = write_error;
  const int error_number = errno;
  ::unlink(path.c_str());
  errno = error_number;
  return false;
}

bool has_no_links(int error_number) {
  return error_number == EPERM || error_number == EOPNOTSUPP || error_number == ENOSYS || error_number == EMLINK;
}

// Over NFS the answer to link() may be lost although the link was made: the count of links decides.
bool link_exclusively(const std::string& from, const std::string& to) {
  if (::link(from.c_str(), to.c_str()) == 0) return true;
  const int error_number = errno;
  struct stat status {};
  const bool linked = ::stat(from.c_str(), &status) == 0 && status.st_nlink == 2;
  errno = error_number;
  return linked;
}

/// Containers may have processes with one id, and machines one name: the nonce tells them apart.
std::string name_temporary(const std::string& lock, const LockHolder& self) {
  std::string host = self.host;
  std::replace(host.begin(), host.end(), '/', '_');
  return fmt::format("{}.{}.{}.{}.tmp", lock, host, self.process, self.nonce);
}

std::string format_age(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds < 0 ? 0 : seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.0f} h", seconds / 3600);
}

}  // namespace

FolderLock::FolderLock(const std::string& folder) : path_(folder + "/" + lock_file_name) {
  const LockHolder self = describe_this_process();
  text_ = format_holder(self);
  const std::string temporary = name_temporary(path_, self);
  // A loss means that another run has the lock, which is refused, or had it a moment ago.
  for (int losses = 0; !try_to_take(temporary); ++losses) {
    if (losses == most_losses)
      throw InputError(
          fmt::format("{}: error: the lock of an ended run cannot be removed (another process is removing it, or was "
                      "killed while doing so): if no run is active here, remove {} and {}{}",
                      path_, path_, path_, removal_suffix));
    judge_other();
  }
  try {
    heartbeat_ = std::thread([this] { show_life(); });
  } catch (const std::system_error& error) {
    remove_lock(path_, text_);
    throw SystemError(
        fmt::format("a thread cannot be started ({}): raise the limits of the shell (ulimit -u, ulimit -v)",
                    error.code().message()));
  }
}

FolderLock::~FolderLock() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  change_.notify_all();
  heartbeat_.join();
  remove_lock(path_, text_);
}

bool FolderLock::try_to_take(const std::string& temporary) {
  if (!write_new_file(temporary, text_)) throw make_io_error("write", path_, errno);
  bool taken = link_exclusively(temporary, path_);
  int error_number = errno;
  ::unlink(temporary.c_str());
  if (!taken && has_no_links(error_number)) {
    taken = write_new_file(path_, text_);
    error_number = errno;
  }
  if (!taken && error_number != EEXIST) throw make_io_error("write", path_, error_number);
  return taken;
}

// Returns if it is worth another attempt.
void FolderLock::judge_other() {
  const std::optional<LockFile> file = read_lock(path_);
  if (!file) return;
  const LockHolder holder = parse_holder(file->text);
  switch (find_state(holder, file->silent_s)) {
    case HolderState::running:
      throw InputError(
          fmt::format("{}: error: another run writes into this folder ({}): wait for its end, or choose another folder "
                      "with --out",
                      path_, describe_holder(holder)));
    case HolderState::unknown:
      throw InputError(
          fmt::format("{}: error: another run may write into this folder ({}; it updates its lock every {} s, last {} "
                      "ago; whether it is still running cannot be checked from this machine): choose another folder "
                      "with --out, or, if that run has ended, remove {}",
                      path_, describe_holder(holder), heartbeat_interval.count(), format_age(file->silent_s), path_));
    case HolderState::ended:
      remove_ended(file->text);
  }
}

// One process at a time removes locks of others, so that none removes one that was made since it has looked.
void FolderLock::remove_ended(const std::string& text) {
  const std::string guard = path_ + removal_suffix;
  if (!write_new_file(guard, text_)) {
    if (errno != EEXIST) throw make_io_error("write", guard, errno);
    std::this_thread::sleep_for(pause_after_loss);
    return;
  }
  const std::optional<LockFile> file = read_lock(path_);
  if (file && file->text == text) {
    ::unlink(path_.c_str());
    note_ = fmt::format("note: an earlier run in this folder was killed ({}); its lock is removed",
                        describe_holder(parse_holder(text)));
  }
  ::unlink(guard.c_str());
}

void FolderLock::show_life() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);  // they are for the thread that computes
  std::unique_lock lock(mutex_);
  while (!change_.wait_for(lock, heartbeat_interval, [this] { return is_ending_; }))
    ::utimensat(AT_FDCWD, path_.c_str(), nullptr, 0);
}

void remove_lock(const std::string& path, const std::string& text) noexcept {
  try {
    const std::optional<LockFile> file = read_lock(path);
    if (file && file->text == text) ::unlink(path.c_str());
  } catch (...) {  // memory is exhausted: the next run finds out whose lock it is
  }
}

std::string describe_lock(const std::string& folder) {
  const std::optional<LockFile> file = read_lock(folder + "/" + lock_file_name);
  if (!file) return "";
  const LockHolder holder = parse_holder(file->text);
  switch (find_state(holder, file->silent_s)) {
    case HolderState::running:
      return fmt::format("a run is under way ({})", describe_holder(holder));
    case HolderState::ended:
      return fmt::format("the last run was killed ({})", describe_holder(holder));
    case HolderState::unknown:
      break;
  }
  return fmt::format("a run may be under way ({}; it last updated its lock {} ago)", describe_holder(holder),
                     format_age(file->silent_s));
}

}  // namespace percuss
