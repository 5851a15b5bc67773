#include "src/output/disk_reservation.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "src/output/atomic_file.hpp"

namespace percuss {

DiskReservation::DiskReservation(const std::string& path)
    : path_(path), descriptor_(::open(path.c_str(), O_RDWR | O_CLOEXEC)) {
  if (descriptor_ < 0) throw make_io_error("write", path_, errno);
}

DiskReservation::~DiskReservation() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

DiskReservation::DiskReservation(DiskReservation&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      begin_(other.begin_),
      end_(other.end_) {}

DiskReservation& DiskReservation::operator=(DiskReservation&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(begin_, other.begin_);
  std::swap(end_, other.end_);
  return *this;
}

void DiskReservation::reserve(std::uint64_t size, std::uint64_t bytes) {
  begin_ = size;
  end_ = size + bytes;
  int error_number = 0;
  do {  // returns its error, and leaves errno alone
    error_number = ::posix_fallocate(descriptor_, static_cast<off_t>(size), static_cast<off_t>(bytes));
  } while (error_number == EINTR);
  // A file system that cannot reserve tells of a full disk later, while writing.
  if (error_number == 0 || error_number == EOPNOTSUPP || error_number == EINVAL) return;
  [[maybe_unused]] const int cut = ::ftruncate(descriptor_, static_cast<off_t>(size));
  throw make_io_error("write", path_, error_number);
}

void DiskReservation::trim(std::uint64_t size) {
  if (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0) throw make_io_error("write", path_, errno);
}

void DiskReservation::trim_if_unused() {
  if (size() == end_) trim(begin_);
}

std::uint64_t DiskReservation::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) throw make_io_error("write", path_, errno);
  return static_cast<std::uint64_t>(status.st_size);
}

void DiskReservation::sync() {
  if (::fsync(descriptor_) != 0) throw make_io_error("write", path_, errno);
}

}  // namespace percuss
