#pragma once
// The ties of a scene, as the surface and the rows know them: which nodes are tied where.

#include <array>
#include <cstdint>
#include <vector>

#include "kernels/contact/geometry/tie_geometry.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// A node of side a, tied to a face of side b.
struct TiedNode {
  std::int64_t node = -1;     // number
  std::int64_t face = -1;     // number
  std::int64_t corners[4]{};  // of the face: node numbers
  int tie = 0;                // index into ContactDeck::ties
  int side = 1;               // on which the node lies of a face: 1 outside, -1 behind a shell; 0: in a shell's middle
  TieGeometry geometry;
  double own_share = 0;  // of the thickness of the shells between both meshes: that of the node's
  double area = 0;       // that it holds, of a late tie that may fail [area]
};

/// Counts of tied and other nodes of one tie's side a, on all ranks.
struct TieCounts {
  std::int64_t tied = 0;
  std::int64_t apart = 0;    // farther from the surface of side b than the tie's distance
  std::int64_t joined = 0;   // nodes of side b as well: the mesh joins them already
  std::int64_t earlier = 0;  // tied by an earlier tie
  double farthest = 0;       // largest distance of a tied node from its face [length]
  double widest = 0;         // largest part of it beyond the thickness of shells [length]
};

struct TiedSurfaces {
  std::vector<TiedNode> nodes;  // tied nodes that this rank owns, ascending
  // [ties] exterior faces of this rank, ascending: those of side a with a node in reach, and side b; of shells both
  // sides of each.
  std::vector<std::array<std::vector<ElementFace>, 2>> faces;
  std::vector<std::vector<std::int64_t>> known;       // [ties] numbers of tied nodes in this rank's mesh, ascending
  std::vector<TieCounts> counts;                      // [ties]
  std::vector<std::vector<std::int64_t>> released{};  // [ties] numbers of released nodes, of all ranks, ascending
  // [ties] of late ones: numbers of nodes, of all ranks, that are not tied though a face of theirs is, ascending
  std::vector<std::vector<std::int64_t>> untied{};

  bool any() const { return !counts.empty(); }
};

}  // namespace percuss
