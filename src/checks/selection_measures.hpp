#pragma once
// What the rules need to know of the nodes that loads and conditions name, of all ranks together.

#include <cstdint>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// The nodes of an entry of `loads.nodal`.
struct LoadMeasures {
  std::int64_t selected = 0;  // nodes that it names
  std::int64_t held = 0;      // of these, nodes that conditions hold in every direction of its force
  bool turns = false;         // whether any of them has rotations
  friend bool operator==(const LoadMeasures&, const LoadMeasures&) = default;
};

/// The box of the nodes of an entry of `conditions` [length].
struct ConditionMeasures {
  Vec3 low{}, high{};
  friend bool operator==(const ConditionMeasures&, const ConditionMeasures&) = default;
};

struct SelectionMeasures {
  std::vector<LoadMeasures> loads;            // as Deck::nodal_loads
  std::vector<ConditionMeasures> conditions;  // as Deck::conditions
  friend bool operator==(const SelectionMeasures&, const SelectionMeasures&) = default;
};

/// owned: [nodes of the share] those that this rank counts. The same on all ranks. Collective over the mesh's ranks.
/// Throws InputError as select_nodes(), MpiError.
SelectionMeasures measure_selections(const Deck& deck, const ChunkedMesh& chunked, const std::vector<bool>& owned);

}  // namespace percuss
