#include "src/output/files/posix_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <utility>

#include "src/output/files/atomic_file.hpp"
#include "src/output/files/safe_text.hpp"

namespace percuss {
namespace {

constexpr double usual_wait = 60;             // seconds that a full disk is given
constexpr double longest_wait_asked = 86400;  // that can be requested

/// PERCUSS_WAIT_FOR_SPACE in seconds; what is no number of them is as if it was not there.
double find_longest_wait() {
  const char* const text = std::getenv("PERCUSS_WAIT_FOR_SPACE");
  if (text == nullptr) return usual_wait;
  char* end = nullptr;
  const double seconds = std::strtod(text, &end);
  return end != text && *end == '\0' && seconds >= 0 && seconds <= longest_wait_asked ? seconds : usual_wait;
}

/// Handles a full disk: writing is tried again every second until there is room, the wait is over or a signal comes. A
/// warning tells of the wait.
class WaitForSpace {
 public:
  explicit WaitForSpace(const std::string& name) : name_(name) {}

  /// Whether the call that failed with this error is to be tried again.
  bool tries_again(int error_number) {
    if (error_number != ENOSPC && error_number != EDQUOT) return false;
    if (left_ < 0) begin();
    if (left_ < 1) return false;
    left_ -= 1;
    const timespec second{1, 0};
    return ::nanosleep(&second, nullptr) == 0;
  }

 private:
  void begin() {
    left_ = find_longest_wait();
    if (left_ < 1) return;
    print_text(stderr, fmt::format("percuss: warning: the disk is full (the run writes '{}'): free some space within "
                                   "{:g} s, for which the run waits\n",
                                   name_, left_));
  }

  const std::string& name_;
  double left_ = -1;  // seconds; -1: it has not been full yet
};

}  // namespace

PosixFile::PosixFile(std::string path, int flags, std::string name)
    : path_(std::move(path)),
      name_(name.empty() ? path_ : std::move(name)),
      descriptor_(::open(path_.c_str(), flags | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) fail((flags & O_ACCMODE) == O_RDONLY ? "read" : "write");
}

PosixFile::~PosixFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

PosixFile::PosixFile(PosixFile&& other) noexcept
    : path_(std::move(other.path_)), name_(std::move(other.name_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

PosixFile& PosixFile::operator=(PosixFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(name_, other.name_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

void PosixFile::fail(const char* action) const { throw make_io_error(action, name_, errno); }

std::int64_t PosixFile::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) fail("read");
  return status.st_size;
}

void PosixFile::read(void* into, std::int64_t offset, std::int64_t count) const {
  auto* at = static_cast<char*>(into);
  while (count > 0) {
    const ssize_t got = ::pread(descriptor_, at, static_cast<std::size_t>(count), offset);
    if (got < 0 && errno == EINTR) continue;
    if (got == 0) errno = EIO;  // it is shorter than it was
    if (got <= 0) fail("read");
    at += got, offset += got, count -= got;
  }
}

void PosixFile::write(const void* from, std::int64_t offset, std::int64_t count) const {
  const auto* at = static_cast<const char*>(from);
  WaitForSpace wait(name_);
  while (count > 0) {
    const ssize_t done = ::pwrite(descriptor_, at, static_cast<std::size_t>(count), offset);
    if (done < 0 && errno == EINTR) continue;
    if (done == 0) errno = ENOSPC;
    if (done <= 0) {
      const int error_number = errno;
      if (wait.tries_again(error_number)) continue;
      errno = error_number;
      fail("write");
    }
    at += done, offset += done, count -= done;
  }
}

bool PosixFile::reserve(std::int64_t offset, std::int64_t count) const {
  int error_number = 0;
  WaitForSpace wait(name_);
  do {  // returns its error, and leaves errno alone
    error_number = ::posix_fallocate(descriptor_, offset, count);
  } while (error_number == EINTR || wait.tries_again(error_number));
  if (error_number == EOPNOTSUPP || error_number == EINVAL) return false;
  errno = error_number;
  if (error_number != 0) fail("write");
  return true;
}

void PosixFile::truncate(std::int64_t bytes) const {
  if (::ftruncate(descriptor_, bytes) != 0) fail("write");
}

void PosixFile::sync() const {
  if (::fsync(descriptor_) != 0) fail("write");
}

void PosixFile::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) fail("write");
}

bool PosixFile::is_in_place() const {
  struct stat own {
  }, found{};
  if (::fstat(descriptor_, &own) != 0 || ::stat(path_.c_str(), &found) != 0) return false;
  return own.st_dev == found.st_dev && own.st_ino == found.st_ino;
}

void PosixFile::check_place() const {
  if (is_in_place()) return;
  throw SystemError(
      fmt::format("cannot write '{}' (it was removed or replaced while the run wrote it): choose another folder with "
                  "--out, and go on there from the last checkpoint with --restart",
                  name_));
}

}  // namespace percuss
