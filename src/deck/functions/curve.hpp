#pragma once
// A scalar function of time as a deck gives it: a constant, a table, an expression or a pulse.

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace percuss {

struct Pulse;  // kernels/node/pulse.hpp

/// A scalar function of time. Copyable, cheap to copy, const after reading.
class Curve {
 public:
  Curve() = default;  // zero
  static Curve constant(double value);

  /// Piecewise linear through (time in s, value), times strictly ascending, held constant before and after.
  /// Throws std::invalid_argument with a reason if the table is empty or not ascending or not finite.
  static Curve table(std::vector<std::pair<double, double>> points);

  /// An expression of `t` (time in s) with the usual functions and the constants pi and e.
  /// Throws std::invalid_argument with the parser's reason and position in the text.
  static Curve expression(const std::string& text);

  static Curve pulse(const Pulse& pulse);

  /// Value at time t [s].
  double operator()(double t) const;

  /// Whether the curve is the same at all times.
  bool is_constant() const;

  /// The rows of a table; none of other kinds.
  std::vector<std::pair<double, double>> rows() const;

  /// The pulse, for kernels; null of other kinds. Lives as long as a copy of the curve.
  const Pulse* as_pulse() const;

  class Function;

 private:
  explicit Curve(std::shared_ptr<const Function> function) : function_(std::move(function)) {}
  std::shared_ptr<const Function> function_;
};

}  // namespace percuss
