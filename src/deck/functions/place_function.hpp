#pragma once
// A scalar function of the place as a deck gives it: an expression of x, y and z.

#include <array>
#include <memory>
#include <string>

namespace percuss {

/// Copyable, cheap to copy, const after reading.
class PlaceFunction {
 public:
  PlaceFunction() = default;  // zero

  /// An expression of `x`, `y` and `z` with the functions and constants of Curve::expression(). Throws
  /// std::invalid_argument with the parser's reason.
  static PlaceFunction expression(const std::string& text);

  double operator()(const std::array<double, 3>& at) const;

  class Function;

 private:
  std::shared_ptr<const Function> function_;
};

}  // namespace percuss
