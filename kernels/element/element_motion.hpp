#pragma once
// What the launchers of elements see of a step.

#include "kernels/core/precision.hpp"
#include "kernels/core/views.hpp"
#include "kernels/element/element_lives.hpp"

namespace percuss {

/// Follows how the step bounds of the elements change, for a step that is longer than they are.
struct StepWatch {
  Array<Real> bound;      // [packs x W] of each element at n; empty: not requested
  Array<Real> reference;  // [packs x W] the same when the step was estimated
  Array<double> growth;   // [chunks] largest of (reference / bound)^2 - 1, in proportion to what the element counts
  double step = 0;        // the bound that was estimated; 0: none has been yet
};

/// The motion that the elements see: positions at n+1, velocities at n+1/2, the step between n and n+1; and which of
/// them live.
struct ElementMotion {
  Rows3<const double> x;
  Rows3<const double> v;
  double dt = 0;
  bool skips_rest = false;  // chunks that rest and are settled are left as they are, which changes no bit
  double time = 0;          // at n+1
  StepWatch watch = {};
  FailingChunks failing{};
  ElementLives lives{};     // forces and work of the chunks that can fail count by these; work is added to
  Rows3<const double> w{};  // spins of the nodes at n+1/2; empty: no element of the scene turns them
  Array<double> bound{};  // [elements] out: step bounds of shells and beams, without the deck's scale; empty: not used

  /// Three numbers a node where elements want spins: those that there are, or else unused storage.
  KOKKOS_INLINE_FUNCTION const Rows3<const double>& spins() const { return w.extent(0) > 0 ? w : v; }
};

}  // namespace percuss
