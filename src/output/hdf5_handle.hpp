#pragma once
// HDF5 from C++: identifiers that close themselves, and errors that become exceptions instead of a printed stack.

#include <hdf5.h>

#include <string>
#include <utility>

namespace percuss::hdf5 {

/// An HDF5 identifier that is closed with the function that belongs to it.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      reset();
      id_ = std::exchange(other.id_, H5I_INVALID_HID);
      close_ = other.close_;
    }
    return *this;
  }
  ~Handle() { reset(); }

  hid_t get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

  /// Closes now; negative if HDF5 could not (the handle is empty all the same).
  herr_t reset() {
    const hid_t id = std::exchange(id_, H5I_INVALID_HID);
    return id >= 0 ? close_(id) : 0;
  }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// Keeps HDF5 from printing its error stack while it lives; what was set before (netCDF sets its own) comes back after.
class QuietErrors {
 public:
  QuietErrors();
  ~QuietErrors();
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// The innermost reason on HDF5's error stack: "No space left on device" where the system gave one.
struct Reason {
  std::string text;
  int error_number = 0;  // errno, 0 if HDF5 itself objects
};
Reason find_reason();

/// Throws SystemError "cannot ACTION (REASON) SUGGESTION" from the error stack.
[[noreturn]] void throw_system_error(const std::string& action);

/// Passes on what an HDF5 call returned, or throws as throw_system_error does if that is negative.
template <class T>
T check(T result, const std::string& action) {
  if (result < 0) throw_system_error(action);
  return result;
}

}  // namespace percuss::hdf5
