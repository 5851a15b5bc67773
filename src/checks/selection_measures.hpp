#pragma once
// What the rules need to know of the nodes that loads and conditions name, of all ranks together.

#include <array>
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

/// The nodes of an entry of `conditions`.
struct ConditionMeasures {
  Vec3 low{}, high{};                     // their box [length]
  std::array<std::int64_t, 3> between{};  // of symmetry: nodes that lie on neither face of the box across x, y, z
  friend bool operator==(const ConditionMeasures&, const ConditionMeasures&) = default;
};

struct SelectionMeasures {
  std::vector<LoadMeasures> loads;            // as Deck::nodal_loads
  std::vector<ConditionMeasures> conditions;  // as Deck::conditions
  std::vector<std::int64_t> held;             // [parts] nodes that conditions hold at their place all the run
  std::vector<std::int64_t> loose;            // [parts] of skins, nodes that nothing else has (loose_skins.hpp)
  friend bool operator==(const SelectionMeasures&, const SelectionMeasures&) = default;
};

/// owned: [nodes of the share] those that this rank counts. The same on all ranks. Collective over the mesh's ranks.
/// Throws InputError as select_nodes(), MpiError.
SelectionMeasures measure_selections(const Deck& deck, const ChunkedMesh& chunked, const std::vector<bool>& owned);

}  // namespace percuss
