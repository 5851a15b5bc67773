#pragma once
// Which face of a surface is closest to each of some nodes, on any rank. For set-up: a sweep along one axis.

#include <limits>
#include <optional>
#include <vector>

#include "comm/item_exchange.hpp"
#include "src/contact/ties.hpp"

namespace percuss {

/// What a search found for a node.
struct ClosestFace {
  double distance = std::numeric_limits<double>::infinity();  // [length]
  int joined = 0;                                             // 1: the node is a corner of the surface
  TiedNode found;                                             // found.face is -1 if no face is in reach

  bool is_better_than(const ClosestFace& other) const {
    return distance != other.distance ? distance < other.distance : found.face < other.found.face;
  }
};

/// The closest face among `selected` of all ranks for each of `nodes` (mesh nodes of this rank, ascending), within
/// `distance` [length] or, without one, default_tie_distance of the face's shortest edge; the lower face number if two
/// are equally close. Faces of elements that have the node are passed over. Collective. Throws MpiError.
std::vector<ClosestFace> find_closest_faces(const ChunkedMesh& chunked, const std::vector<ElementFace>& selected,
                                            const std::optional<double>& distance, const std::vector<int>& nodes,
                                            ItemExchange& exchange);

}  // namespace percuss
