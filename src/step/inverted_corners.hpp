#pragma once
// Elements with a corner that is turned inside out while their volume is still positive, which one point does not see:
// the shape is past what the element can stand for, and the run continues. Counted where fields are written and at the
// end.

#include <cstdint>
#include <vector>

#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"
#include "src/warning.hpp"

namespace percuss {

/// Living hexahedra of all ranks at whose worst corner the Jacobian is negative (by more than 1e-10 of the product of
/// the edges there), [parts]. Collective.
std::vector<std::int64_t> count_inverted_corners(const ChunkedMesh& chunked, const Model& model, const State& state);

/// A warning for each part that has any. counts: of count_inverted_corners(); parts: their names; time: of the state.
std::vector<Warning> describe_inverted_corners(const std::vector<std::int64_t>& counts,
                                               const std::vector<MeshPart>& parts, double time);

}  // namespace percuss
