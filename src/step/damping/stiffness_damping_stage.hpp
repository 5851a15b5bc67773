#pragma once
// Damping in proportion to stiffness in a step: forces beside those of the elements.

#include "src/step/model/state.hpp"

namespace percuss {

/// What the stage needs of a step besides the state: as for elements, for shells and for beams.
struct DampedMotions {
  ElementMotion solids;
  ShellMotion shells;
  BeamStep beams;
};

class StiffnessDampingStage {
 public:
  /// The model outlives this.
  explicit StiffnessDampingStage(const Model& model);

  /// Adds the forces at n+1 to the slots of the chunks that other ranks wait for, or of the others, and their work to
  /// the viscous work of the chunks. Call after the internal forces of the same chunks.
  void damp_sending(const State& state, const DampedMotions& motions) const;
  void damp_others(const State& state, const DampedMotions& motions) const;

  /// The step that a chunk allows with its damping. bounds: [chunks] without it.
  double find_step(std::size_t chunk, double bound) const { return find_damped_step(bound, factor_(chunk)); }

 private:
  SpinDampingFields find_fields(const State& state) const;

  const Model& model_;
  HostMirror<Array<double>> factor_;
};

}  // namespace percuss
