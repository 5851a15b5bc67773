#pragma once
// Masses of a relaxation: those with which every element has about the same stable step, the largest of any. A state at
// rest does not depend on masses. With the physical ones a few small or stiff elements would set the step of the whole,
// and the slowest motion would take as many more steps.
//
// An element of mass m and stable step h counts as m (h_t / h)^2. Rotary inertias follow. Weights remain physical.
// Rigid bodies keep their masses: where a light one holds nodes of elements, these have a smaller step than the others.

#include <vector>

#include "src/mesh/ordering.hpp"
#include "src/step/mass/lumped_masses.hpp"
#include "src/step/model/action.hpp"

namespace percuss {

class FictitiousMasses : public Action {
 public:
  /// Both outlive this.
  FictitiousMasses(const ChunkedMesh& chunked, const Model& model);

  /// Bounds of the elements with their physical masses.
  const ElementBounds* asked_bounds() const override { return &bounds_; }

  /// Gives the nodes of a state these masses, by the stable steps that have been written last. Returns what the
  /// smallest step has grown by. Collective.
  double give(State& state);

  /// Gives the physical ones back.
  void take(State& state) const;

  Array<double> find_bounds(const ChunkResults& results) const override;

  /// Weights remain those of the physical masses.
  bool gives_gravity() const override { return true; }
  void predict(State& state, const StepTimes& times) override;

 private:
  /// [nodes] of elements, and over the physical ones; 0 and 1 where elements give nothing.
  struct NodeMasses {
    std::vector<double> mass, mass_ratio, inertia_ratio;
  };

  NodeMasses find_masses(const State& state, const std::vector<double>& growth);
  double find_growth(std::size_t element, const std::vector<double>& growth, const NodeMasses& nodes) const;
  std::vector<double> find_body_shares(const NodeMasses& nodes) const;
  double limit_by_bodies(std::size_t element, double growth, const std::vector<double>& shares) const;
  void set_nodes(State& state, const NodeMasses& nodes);

  const ChunkedMesh& chunked_;
  const Model& model_;
  LumpedMasses summer_;
  ElementBounds bounds_;
  std::vector<int> bodies_of_nodes_;      // rigid body of each node, or -1; empty: there are none
  Array<double> factors_;                 // [elements] of their stable steps; empty: the masses are the physical ones
  Array<double> least_;                   // [chunks] scratch
  Array<double> weights_;                 // [nodes] physical mass over that of the relaxation
  Array<double> tensor_ratios_;           // [rows of SpinTensors]
  Array<double> own_mass_, own_inertia_;  // of the run
};

}  // namespace percuss
