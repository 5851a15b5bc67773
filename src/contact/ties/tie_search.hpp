#pragma once
// The face of a surface that is closest to each of some nodes, on any rank. For set-up: a sweep along one axis.

#include <limits>
#include <optional>
#include <vector>

#include "comm/exchange/item_exchange.hpp"
#include "src/contact/ties/ties.hpp"

namespace percuss {

/// Result of a search for a node.
struct ClosestFace {
  double distance = std::numeric_limits<double>::infinity();  // from the mesh [length]
  double gap = 0;                                             // beyond the thickness of shells between [length]
  double key = std::numeric_limits<double>::infinity();       // the distance, as faces are compared by it
  int facing = 0;                                             // -4: it faces side a at the node; 4: it looks away
  int joined = 0;                                             // 1: the node is a corner of the surface
  TiedNode found;                                             // found.face is -1 if no face is in reach

  bool is_better_than(const ClosestFace& other) const {
    if (key != other.key) return key < other.key;
    return facing != other.facing ? facing < other.facing : found.face < other.found.face;
  }
};

/// Inputs of a search for nodes of side a on faces of side b.
struct TieSearch {
  const std::vector<Vec3>& places;        // [mesh nodes] of now
  const std::vector<int>& nodes;          // mesh nodes of this rank, ascending
  const std::vector<double>& thickness;   // [nodes] half that of shells (tie_thickness.hpp) [length]; empty: no shells
  const std::vector<ElementFace>& faces;  // of this rank
  const std::optional<double>& distance;  // in reach [length]; default: default_tie_distance of each face
  const std::vector<ElementFace>* facing = nullptr;  // of side a: of faces equally close to a node, that which faces it
};

/// The closest face of all ranks for each node, by the distance from its mesh. If two are equally close, as at the rim
/// of bodies that lie flush: with `facing` that which looks at side a, else the lower face number. In reach are faces
/// whose surface, half the thickness of shells off the mesh on both sides, is within the distance. Faces of elements
/// that have the node are passed over. Collective. Throws MpiError.
std::vector<ClosestFace> find_closest_faces(const ChunkedMesh& chunked, const TieSearch& search,
                                            ItemExchange& exchange);

}  // namespace percuss
