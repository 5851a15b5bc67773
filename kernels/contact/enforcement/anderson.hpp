#pragma once
// Anderson's acceleration of a fixed-point map z -> g(z) over a window of steps (Walker and Ni 2011, type II).
//
// With f = g - z, the coefficients minimise |f_k - sum gamma_i (f_i+1 - f_i)| in a weighted norm, and the next point is
// g_k - sum gamma_i (g_i+1 - g_i). Each dot product is summed by one thread in the order of the unknowns: the same bits
// for any number of threads.

#include <vector>

#include "kernels/core/small_space.hpp"

namespace percuss {

class AndersonWindow {
 public:
  /// n: unknowns; weight: [n] of the norm.
  AndersonWindow(int n, const Array<const double>& weight);

  void clear() {
    count_ = 0;
    has_last_ = false;
  }

  /// g: in, g(z); out, the accelerated point, or g itself without a window. z: [n]. Returns the norm of f.
  double accelerate(const Array<const double>& z, const Array<double>& g);

 private:
  static constexpr int width = 24;
  using Vectors = Kokkos::View<double**, Kokkos::LayoutRight, MemSpace>;

  void store_difference(const Array<const double>& f, const Array<const double>& g);
  std::vector<double> solve_coefficients(std::vector<double> right) const;

  int n_ = 0, count_ = 0, next_ = 0;
  bool has_last_ = false;
  Array<const double> weight_;
  Vectors df_, dg_;
  Array<double> f_, f_last_, g_last_, dots_;
  std::vector<double> gram_;  // [width][width] dots of df
};

}  // namespace percuss
