#include "src/hdf5/hdf5_handle.hpp"

#include <cstdlib>
#include <cstring>

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
  auto& found = *static_cast<Error*>(data);
  if (error->desc == nullptr || found.error_number != 0) return 0;
  if (depth == 0) found.reason = error->desc;
  found.error_number = parse_errno(error->desc);
  if (found.error_number != 0) found.reason = std::strerror(found.error_number);
  return 0;
}

}  // namespace

QuietErrors::QuietErrors() {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietErrors::~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

Error::Error(const std::string& action) : std::runtime_error(action), reason("HDF5 gives no reason") {
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, look_at_error, this);
}

}  // namespace percuss::hdf5
