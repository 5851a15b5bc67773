#include "src/output/files/posix_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "src/output/files/atomic_file.hpp"

namespace percuss {

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
  while (count > 0) {
    const ssize_t done = ::pwrite(descriptor_, at, static_cast<std::size_t>(count), offset);
    if (done < 0 && errno == EINTR) continue;
    if (done == 0) errno = ENOSPC;
    if (done <= 0) fail("write");
    at += done, offset += done, count -= done;
  }
}

bool PosixFile::reserve(std::int64_t offset, std::int64_t count) const {
  int error_number = 0;
  do {  // returns its error, and leaves errno alone
    error_number = ::posix_fallocate(descriptor_, offset, count);
  } while (error_number == EINTR);
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
