#pragma once
// Nodes of skins that nothing else has, of all ranks together.

#include <cstdint>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// Counts, for each part that is a skin, the nodes that no other element has, and no rigid set, condition, constraint,
/// tie, spring or solid around embedded nodes; of others 0. owned: [nodes of the share] those that this rank counts.
/// Collective over the mesh's ranks. Throws InputError as select_nodes(), MpiError.
std::vector<std::int64_t> count_loose_nodes(const Deck& deck, const ChunkedMesh& chunked,
                                            const std::vector<bool>& owned);

}  // namespace percuss
