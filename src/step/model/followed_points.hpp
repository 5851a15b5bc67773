#pragma once
// Nodes and elements that a deck names by a place or by an id, found in the mesh.

#include <cstdint>
#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// A node or element that the deck follows.
struct FollowedPoint {
  std::string name;
  bool is_element = false;
  std::int64_t number = 0;  // of the node or element in the whole mesh
  int index = -1;           // in this rank's share, if it owns the node or has the element; else -1
};

/// Finds points: the nearest node or element centre of all ranks, lowest number among equals, or the one with the id.
/// kind: what messages call a point ("history point"). Collective. Throws InputError with the deck's place, the same
/// on all ranks.
std::vector<FollowedPoint> find_points(const Deck& deck, const ChunkedMesh& chunked,
                                       const std::vector<HistoryPoint>& points, const std::string& kind);

/// The deck's history points, without whole parts. Collective; throws likewise.
std::vector<FollowedPoint> find_history_points(const Deck& deck, const ChunkedMesh& chunked);

}  // namespace percuss
