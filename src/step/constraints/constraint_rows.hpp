#pragma once
// The linear equations of constraints, from the deck to rows of the model.

#include <array>
#include <cstdint>
#include <vector>

#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Nodes of the whole mesh that an entry of the deck makes equal: those of each list.
using EqualLists = std::vector<std::vector<std::int64_t>>;

/// A factor times a displacement of a node, by its number in the whole mesh.
struct NodeTerm {
  std::int64_t number = 0;
  std::size_t direction = 0;
  double factor = 0;
};

/// Equations of an entry of the deck, one for each node of its first term.
using NodeEquations = std::vector<std::vector<NodeTerm>>;

/// [Deck::constraints] those of each; none of entries that make nodes equal. Collective. Throws InputError with the
/// deck's place, the same on all ranks: sides that are no counterparts.
std::vector<NodeEquations> find_equations(const Deck& deck, const ChunkedMesh& chunked);

/// Rows of all constraints. lists: [constraints] of those that make nodes equal. Call when model.constraints.nodes is
/// there.
std::vector<ConstraintRow> make_constraint_rows(const std::vector<EqualLists>& lists,
                                                const std::vector<NodeEquations>& equations,
                                                const ConstraintModel& constraints);

/// Place of a node in ConstraintModel::nodes.
int find_place(const ConstraintModel& constraints, std::int64_t number);

}  // namespace percuss
