#pragma once
// Elements with a corner that is turned inside out while their volume is still positive, which one point does not see:
// the shape is past what the element can stand for, and the run goes on. Counted where fields are written and at the
// end.

#include <cstdint>
#include <string>
#include <vector>

#include "src/mesh/ordering.hpp"
#include "src/step/model.hpp"
#include "src/step/state.hpp"

namespace percuss {

/// Living hexahedra of all ranks at whose worst corner the Jacobian is negative (by more than 1e-10 of the product of
/// the edges there), [parts]. Collective.
std::vector<std::int64_t> count_turned_corners(const ChunkedMesh& chunked, const Model& model, const State& state);

/// What a run has seen of them.
struct TurnedCorners {
  double first_time = -1;            // of the first state with any that was looked at; negative: none
  std::vector<std::int64_t> counts;  // [parts] in the last that was looked at

  void note(double time, std::vector<std::int64_t> now);

  /// "warning: ..." with the parts and their numbers; empty if there were none. parts: their names.
  std::string describe(const std::vector<MeshPart>& parts) const;
};

}  // namespace percuss
