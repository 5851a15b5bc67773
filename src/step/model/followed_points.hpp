#pragma once
// Nodes and elements that a deck names by a place or by an id, found in the mesh.

#include <cstdint>
#include <string>
#include <utility>
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
  int layer = -1;           // of an element: which of its points (find_point_stresses()); -1: their mean
  // For a material point, with the number and index of its element: nodes of this rank with their weights.
  std::vector<std::pair<int, double>> shares{};
  bool is_inside = false;  // whether it is one
};

/// Finds points: the nearest node or element centre of all ranks, lowest number among equals, or the one with the id;
/// for a material point the element that holds the place.
/// kind: what messages call a point ("history point"). Collective. Throws InputError with the deck's place, the same
/// on all ranks.
std::vector<FollowedPoint> find_points(const Deck& deck, const ChunkedMesh& chunked,
                                       const std::vector<HistoryPoint>& points, const std::string& kind);

/// The deck's history points, without whole parts. Collective; throws likewise.
std::vector<FollowedPoint> find_history_points(const Deck& deck, const ChunkedMesh& chunked);

}  // namespace percuss
