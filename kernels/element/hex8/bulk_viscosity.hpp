#pragma once
// Linear and quadratic bulk viscosity (von Neumann and Richtmyer 1950; Landshoff 1955), as a pressure.

#include "kernels/core/short_scalar.hpp"

namespace percuss {

/// Dimensionless coefficients b1 and b2.
struct BulkViscosity {
  double linear = 0.06;
  double quadratic = 1.2;
};

template <class T>
struct ViscousPressure {
  T pressure;  // q, positive in compression
  T tangent;   // |dq / d(tr D)|, for the step estimate
};

/// q = rho l (-b1 c tr D + b2^2 l (tr D)^2 in compression). The linear part acts both ways and damps ringing; the
/// quadratic part only spreads shocks. l: thickness of the element, c: dilatational wave speed.
template <class T>
PERCUSS_FORCE_INLINE ViscousPressure<T> find_viscous_pressure(const BulkViscosity& b, const T& density, const T& length,
                                                              const T& speed, const T& trace_d) {
  const T compression = larger(-trace_d, T(0));
  const T linear = number<T>(b.linear) * speed;
  const T quadratic = number<T>(b.quadratic * b.quadratic) * length * compression;
  const T scale = density * length;
  return {scale * (quadratic * compression - linear * trace_d), scale * (linear + T(2) * quadratic)};
}

}  // namespace percuss
