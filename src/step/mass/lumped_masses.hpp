#pragma once
// Masses and rotary inertias of the nodes from those of all elements, in the order in which forces are added.

#include "comm/halo/halo_swap.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

class LumpedMasses {
 public:
  /// The model outlives this.
  explicit LumpedMasses(const Model& model);

  /// [nodes] mass, then rotary inertia; without what the deck adds to nodes. Until the next call. Collective.
  const Rows3<double>& sum(const Array<const double>& element_mass);

 private:
  const Model& model_;
  Rows3<double> slots_;  // by slot
  Rows3<double> nodes_;
  HaloSwap halo_;
};

}  // namespace percuss
