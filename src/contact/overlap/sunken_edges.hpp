#pragma once
// Sharp edges that lie inside another body, wherever its nodes are: measured by points on the edges and the distance of
// each from the closest face, without the searches and checks of contact.

#include <cstdint>
#include <vector>

#include "comm/communicator.hpp"
#include "src/contact/surface/surface_share.hpp"

namespace percuss {

/// The deepest point of an edge in another body.
struct SunkenEdge {
  std::int64_t edge = -1;           // number
  std::int64_t ends[2] = {-1, -1};  // numbers of its nodes
  int part = -1, other = -1;        // index into Mesh::parts: of the edge, of the body
  double depth = 0, size = 0;       // of the point; shortest edge of the closest face [length]
  double x[3] = {0, 0, 0};          // [length]

  double ratio() const { return depth / size; }
};

struct SunkenEdges {
  std::vector<SunkenEdge> found;  // edges whose home is this rank
  std::int64_t tests = 0;         // of points and boxes, the most of a rank: what it has cost
};

/// The feature edges and folds that are inside another body of solids, which they may touch, by more than `least` of an
/// element. Of shells the distance from their mid-surface is less by half their thickness. Collective.
SunkenEdges find_sunken_edges(const Communicator& ranks, const SurfaceShare& share, const Rows3<const double>& places,
                              double least);

}  // namespace percuss
