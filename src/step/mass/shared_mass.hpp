#pragma once
// Mass that solids lack which share the mass of their nodes (mixed tetrahedra, wedges and pyramids).
//
// The bound of such an element rises with the mass of its nodes, of which it has some twentieth: with what it lacks by
// itself it would hardly rise. So each node gets what the neediest element there asks, from all elements there that
// lack some, in proportion to what they lack.

#include "src/mesh/ordering.hpp"
#include "src/step/mass/lumped_masses.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

class SharedMass {
 public:
  /// The model outlives this.
  SharedMass(const ChunkedMesh& chunked, const Model& model);

  /// Sums by node: mass of the elements that share; what they lack by themselves; 16th powers of that over their
  /// masses.
  enum Column { mass, lacking, need };

  bool is_any() const { return shares_.extent(0) > 0; }

  /// element_mass: [elements]; missing: [elements] in: what each lacks by itself; out: what raises the bounds of all as
  /// if each had its nodes for itself. Collective.
  void spread(const Array<const double>& element_mass, LumpedMasses& summer, const Array<double>& missing);

  // Kernels of its own: nvcc takes none in a private function.
  template <class Value>
  void sum(Column column, LumpedMasses& summer, const Value& value);

 private:
  const Model& model_;
  Array<int> shares_;     // [chunks] 1: its elements do; empty: none of any rank
  Array<double> values_;  // [elements]
  Rows3<double> nodes_;   // [nodes] by Column
};

}  // namespace percuss
