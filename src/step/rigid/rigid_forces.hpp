#pragma once
// Forces at n on rigid bodies: of loads, and of elements that share nodes with them.

#include <vector>

#include "src/step/model/state.hpp"

namespace percuss {

/// Holds the memory of the sums.
class RigidForces {
 public:
  /// Force and moment about its centre of each body, without gravity, from the slots. The same on all ranks.
  /// Collective.
  std::vector<Wrench> operator()(const Model& model, const State& state);

 private:
  ExactSums<6> memory_{"percuss::rigid_forces"};
  std::vector<ExactSum> sums_;
};

}  // namespace percuss
