#include "src/output/hdf5_handle.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>

#include "src/output/atomic_file.hpp"

namespace percuss::hdf5 {
namespace {

// HDF5's drivers put errno into the text of their error, as "errno = 28, error message = '...'".
int parse_errno(const char* description) {
  static constexpr char key[] = "errno = ";
  const char* found = std::strstr(description, key);
  return found == nullptr ? 0 : static_cast<int>(std::strtol(found + sizeof key - 1, nullptr, 10));
}

// Walking upward starts at the innermost error; the first one that carries an errno decides, else the innermost text.
herr_t look_at_error(unsigned depth, const H5E_error2_t* error, void* data) {
  auto& reason = *static_cast<Reason*>(data);
  if (error->desc == nullptr) return 0;
  if (depth == 0) reason.text = error->desc;
  if (reason.error_number != 0) return 0;
  reason.error_number = parse_errno(error->desc);
  if (reason.error_number != 0) reason.text = std::strerror(reason.error_number);
  return 0;
}

}  // namespace

QuietErrors::QuietErrors() {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietErrors::~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

Reason find_reason() {
  Reason reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, look_at_error, &reason);
  if (reason.text.empty()) reason.text = "HDF5 gives no reason";
  return reason;
}

void throw_system_error(const std::string& action) {
  const Reason reason = find_reason();
  throw SystemError(fmt::format("cannot {} ({}){}", action, reason.text, suggest_for_errno(reason.error_number)));
}

}  // namespace percuss::hdf5
