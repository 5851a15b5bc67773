#pragma once
// A scalar function of time as a deck gives it: a constant, a table or an expression.

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace percuss {

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

  /// From `start` on, for a duration T, the sum of two pulses p (1 - t/T) exp(-b t/T), each with its peak p and its
  /// decay b (Friedlander); zero before and after. A negative phase follows if it is wanted: the same formula goes on
  /// where b > 0.
  static Curve pulse(double start, double duration, const std::array<std::array<double, 2>, 2>& peaks_and_decays,
                     bool has_negative_phase = false);

  /// Value at time t [s].
  double operator()(double t) const;

  /// Whether the curve is the same at all times.
  bool is_constant() const;

  /// The rows of a table; none of other kinds.
  std::vector<std::pair<double, double>> rows() const;

  class Function;

 private:
  explicit Curve(std::shared_ptr<const Function> function) : function_(std::move(function)) {}
  std::shared_ptr<const Function> function_;
};

}  // namespace percuss
