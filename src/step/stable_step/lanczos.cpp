#include "src/step/stable_step/lanczos.hpp"

#include <algorithm>
#include <cmath>

namespace percuss {
namespace {

/// sqrt(eps) (2k - 1) at which the chance of failure is what is taken.
double find_exponent(std::int64_t n) {
  return std::log(1.648 * std::sqrt(static_cast<double>(std::max<std::int64_t>(n, 1))) / lanczos_failure_chance);
}

/// Whether every eigenvalue is below x: all pivots of x I - T are positive (Sylvester's law of inertia).
bool is_above(const Tridiagonal& t, double x) {
  double pivot = 1;
  for (std::size_t i = 0; i < t.diagonal.size(); ++i) {
    const double beside = i > 0 ? t.beside[i - 1] : 0;
    pivot = x - t.diagonal[i] - beside * beside / pivot;
    if (!(pivot > 0)) return false;
  }
  return true;
}

}  // namespace

double find_largest_eigenvalue(const Tridiagonal& t) {
  if (t.diagonal.empty()) return 0;
  double low = t.diagonal[0], high = t.diagonal[0];
  for (std::size_t i = 0; i < t.diagonal.size(); ++i) {
    const double left = i > 0 ? std::abs(t.beside[i - 1]) : 0;
    const double right = i + 1 < t.diagonal.size() ? std::abs(t.beside[i]) : 0;
    low = std::max(low, t.diagonal[i]);
    high = std::max(high, t.diagonal[i] + left + right);  // Gershgorin
  }
  for (int halvings = 0; halvings < 60 && high > low; ++halvings) {
    const double middle = low + 0.5 * (high - low);
    (is_above(t, middle) ? high : low) = middle;
  }
  return high;
}

double find_lanczos_margin(std::int64_t n, int k) {
  const double root = find_exponent(n) / (2 * k - 1);
  return root * root;
}

int count_lanczos_steps(std::int64_t n, double eps) {
  return static_cast<int>(std::ceil(0.5 * (find_exponent(n) / std::sqrt(eps) + 1)));
}

}  // namespace percuss
