#pragma once
// The largest eigenvalue of a symmetric operator from the Lanczos iteration: the tridiagonal matrix that it leaves, and
// how far below the truth its largest eigenvalue can lie.
//
// Ritz values come from below. With a random start the share eps by which they fall short is bounded in probability
// (Kuczynski and Wozniakowski, SIAM J. Matrix Anal. Appl. 13, 1992, theorem 4.2): over k steps in n dimensions
//   P(1 - theta / lambda > eps) <= 1.648 sqrt(n) exp(-sqrt(eps) (2k - 1)),
// whatever the spectrum.

#include <cstdint>
#include <vector>

namespace percuss {

/// Matrix of the iteration so far: alpha_j on the diagonal, beta_j beside it (one less).
struct Tridiagonal {
  std::vector<double> diagonal, beside;
};

/// The largest eigenvalue, by bisection with Sturm's counts; not below it by more than rounding. 0 for an empty matrix.
double find_largest_eigenvalue(const Tridiagonal& matrix);

/// The chance that is taken that a margin is too small, with the worst spectrum there is.
inline constexpr double lanczos_failure_chance = 1e-4;

/// eps after k >= 1 steps in n dimensions; 1 or more: nothing is known.
double find_lanczos_margin(std::int64_t n, int k);

/// The least number of steps whose margin is at most eps.
int count_lanczos_steps(std::int64_t n, double eps);

}  // namespace percuss
