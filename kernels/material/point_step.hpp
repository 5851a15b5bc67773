#pragma once
// Input and output of a material for a step at one of its points.

#include "kernels/core/tensor.hpp"
#include "kernels/material/plastic_return.hpp"

namespace percuss {

/// Scalars of a material's history that others request by name: fields, and rules that read the records of elements.
/// remains: 0 where the law has deleted the point; damage of plies: 0 to 1. Of a law with state variables: the
/// place of the first of them, and that after the last.
enum class HistoryScalar {
  none,
  equivalent_plastic_strain,
  temperature,
  internal_energy,
  remains,
  fibre_damage,
  matrix_damage,
  void_fraction,
  first_state,
  after_states
};
inline constexpr int history_scalars = 10;

/// How J = V / V(0) changes over a step.
template <class T>
struct VolumeChange {
  T growth;   // J(n+1) - J(n)
  T inverse;  // 1 / J(n+1)
};

/// The step from n to n+1 at a point, all in the unrotated frame.
template <class T>
struct PointMotion {
  Symmetric3<T> de;  // rate of deformation times dt
  T dt;
  T volume_ratio;   // V / V(0) at n+1
  T length;         // thickness of the element at n+1
  T viscosity;      // (q(n) + q(n+1)) / 2, which heats
  double time = 0;  // at n+1
  VolumeChange<T> change{T(0), T(1)};
  bool is_apart = false;              // the point turns on its own, apart from the frame
  Vector3<T> spin{T(0), T(0), T(0)};  // then: its spin dt beyond the turn of the frame, axial vector

  /// V / V(0) at the middle of the step.
  KOKKOS_INLINE_FUNCTION T middle_volume_ratio() const { return volume_ratio - T(0.5) * change.growth; }
};

/// The state of the point, in at n and out at n+1, and what the element has to know of it.
template <class T>
struct PointStep {
  PointMotion<T> motion;
  Symmetric3<T> stress;
  T* history = nullptr;
  double density = 0;          // at the start; preset
  PlasticReturn<T> plastic{};  // out; preset to an elastic step
  T lambda{}, mu{};            // out; elastic moduli now, preset to those at the start
};

/// Output of an equation of state for laws with a temperature.
template <class T>
struct StateChange {
  T volume;     // J(n+1) - J(n)
  T by_energy;  // dp/de at n+1
};

}  // namespace percuss
