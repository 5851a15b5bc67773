#include "src/output/files/disk_reservation.hpp"

#include <fcntl.h>

#include "src/error.hpp"

namespace percuss {

DiskReservation::DiskReservation(const std::string& path) : file_(path, O_RDWR) {}

void DiskReservation::reserve(std::uint64_t size, std::uint64_t bytes) {
  file_.check_place();
  begin_ = static_cast<std::int64_t>(size);
  end_ = begin_ + static_cast<std::int64_t>(bytes);
  try {
    // A file system that cannot reserve reports a full disk later, while writing.
    file_.reserve(begin_, end_ - begin_);
  } catch (const SystemError&) {
    try {
      file_.truncate(begin_);
    } catch (const SystemError&) {  // the first error is the one to tell
    }
    throw;
  }
}

void DiskReservation::trim(std::uint64_t size) const { file_.truncate(static_cast<std::int64_t>(size)); }

void DiskReservation::trim_if_unused() const {
  if (file_.size() == end_) file_.truncate(begin_);
}

}  // namespace percuss
