#pragma once
// HDF5 from C++: identifiers that close themselves, and errors that become exceptions instead of a printed stack.

#include <hdf5.h>

#include <stdexcept>
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

  /// Leaves the identifier open for good.
  void release() { id_ = H5I_INVALID_HID; }

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

/// An HDF5 call failed. what() is what HDF5 was to do: "write dataset velocity".
class Error : public std::runtime_error {
 public:
  /// Takes the reason from HDF5's error stack: the innermost one, or that of the system where there is one.
  explicit Error(const std::string& action);
  /// An error with a reason of our own, where HDF5 reports none.
  Error(const std::string& action, std::string why) : std::runtime_error(action), reason(std::move(why)) {}

  std::string reason;    // "No space left on device"
  int error_number = 0;  // errno, 0 if HDF5 itself objects
};

/// Passes on what an HDF5 call returned; throws Error if that is negative.
template <class T>
T check(T result, const std::string& action) {
  if (result < 0) throw Error(action);
  return result;
}

}  // namespace percuss::hdf5
