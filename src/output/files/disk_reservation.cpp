#include "src/output/files/disk_reservation.hpp"

#include <fcntl.h>

#include "src/error.hpp"

namespace percuss {

DiskReservation::DiskReservation(const std::string& path, bool follows_links)
    : file_(path, O_RDWR | (follows_links ? 0 : O_NOFOLLOW)) {}

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

void DiskReservation::release() const noexcept {
  try {
    file_.truncate(0);
  } catch (const SystemError&) {  // it was not even opened, or the disk is gone
  }
}

}  // namespace percuss
