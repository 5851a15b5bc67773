#pragma once
// Stress of foams whose principal stretches have no lateral coupling, and its release by the stored energy.

#include "kernels/material/radial_return.hpp"
#include "kernels/material/stretch.hpp"

namespace percuss {

/// What is left of the stress of a curve f on the way back, and its change with the stored energy W:
/// d stress_i = share d f_i + steepness f_i dW.
template <class T>
struct FoamRelease {
  T share, steepness;
};

/// g = 1 - (1 - left) (1 - (W / W_max)^shape), a pseudo-elastic release (Ogden and Roxburgh, Proc. R. Soc. A 455, 1999;
/// the form in W is that of foams in DYNA3D's line of codes). most: W_max, updated.
template <class T>
KOKKOS_INLINE_FUNCTION FoamRelease<T> find_foam_release(const T& energy, T& most, double left, double shape) {
  most = larger(most, energy);
  const T part = select(most > T(0), power(energy / larger(most, T(1e-300)), shape), T(1));
  const double lost = 1 - left;
  return {T(1) - T(lost) * (T(1) - part), T(lost * shape) * part / larger(energy, T(1e-300))};
}

/// Sums stresses of the principal directions, and their bound on waves.
template <class T>
struct FoamStress {
  T over_j;
  T stiffest = T(0), largest = T(0), coupling = T(0);
  Symmetric3<T> stress{T(0), T(0), T(0), T(0), T(0), T(0)};

  KOKKOS_INLINE_FUNCTION explicit FoamStress(const T& volume_ratio) : over_j(T(1) / volume_ratio) {}

  /// nominal: stress and slope by the stretch; curve: the part of the stress that is released.
  KOKKOS_INLINE_FUNCTION void add(const Vector3<T>& n, const T& stretch, const ValueAndSlope<T>& nominal,
                                  const T& curve, const FoamRelease<T>& release) {
    const T cauchy = nominal.value * stretch * over_j;
    stress = stress + cauchy * Symmetric3<T>{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
    stiffest = larger(stiffest, nominal.slope * stretch * stretch * over_j);
    largest = larger(largest, larger(cauchy, -cauchy));
    coupling = coupling + release.steepness * (curve * stretch) * (curve * stretch) * over_j;
  }

  /// The stiffest direction bounds |sym L|; what stresses do to shear is bounded by the largest of them.
  KOKKOS_INLINE_FUNCTION void set(PointStep<T>& step) const {
    step.stress = stress;
    step.lambda = T(0);
    step.mu = T(0.5) * (stiffest + coupling) + largest;
  }
};

}  // namespace percuss
