#pragma once
// Erosion rebuilds the contact surface: carries the contact history from the old surface to the new one.

#include <vector>

#include "src/contact/surface/surface_share.hpp"

namespace percuss {

/// Who the rows of a history belong to.
struct HistoryOwners {
  std::vector<std::int64_t> nodes;       // numbers of the contact nodes of this rank, ascending
  std::vector<std::int64_t> faces;       // numbers of the faces of this rank's elements, ascending
  std::vector<std::int64_t> wall_pairs;  // wall * nodes of the scene + number of the node, in the order of the records
  std::vector<std::int64_t> ties;        // keys of the rows of this rank's ties, ascending
  std::vector<EdgeTopology> edges;       // whose home this rank is, ascending
};

/// An empty history.
ContactHistory make_history(const SurfaceShare& share, const WallPairs& walls, const ContactDeck& contact);

HistoryOwners list_history_owners(const ChunkedMesh& chunked, const SurfaceShare& share, const WallPairs& walls,
                                  const std::vector<std::int64_t>& tie_keys);

/// The history of the new surface, which is empty, with the records of all that both surfaces have. Edges have new
/// numbers and may have another home: their records are known by the ends. Collective.
ContactHistory carry_history(const Communicator& ranks, const ContactHistory& old, const HistoryOwners& before,
                             const HistoryOwners& now, ContactHistory history);

/// As carry_history(), for edges alone, where all else is unchanged. before, now: edges whose home is this rank.
/// Collective.
EdgeHistory carry_edges(const Communicator& ranks, const EdgeHistory& old, const std::vector<EdgeTopology>& before,
                        const std::vector<EdgeTopology>& now);

}  // namespace percuss
