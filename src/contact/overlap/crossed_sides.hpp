#pragma once
// How deep a part is beyond the surface that it crosses: its nodes fall into those on the one side and those on the
// other, between which its edges go through the surface.

#include <vector>

#include "src/contact/overlap/face_index.hpp"
#include "src/contact/overlap/pierced_faces.hpp"

namespace percuss {

/// A side of a face, or a beam, of a part.
struct PartLine {
  int part = 0;
  std::int64_t ends[2]{};  // numbers of its nodes, ascending
  Point3 x[2];
};

/// The node that is deepest.
struct DeepNode {
  double depth = 0;  // distance from the surface [length]
  Point3 x{};
};

/// Division of the surface of a body by edges of one part that are joined with each other.
struct CrossedSides {
  std::vector<std::size_t> edges;  // of `piercing`, those that go through an odd number of times
  std::vector<Point3> nodes[2];    // of either side, by their numbers
  int inner = -1;                  // of solids: which side is inside

  /// Deepest node: of solids the one deepest inside, of sheets the one on the side that is less deep. Collective.
  DeepNode find_depth(const Communicator& ranks, FaceIndex& index, const PiercingEdge& edge) const;
};

/// lines: of a part, of all ranks. piercing: of its edges those that go through a body, by their ends. What the surface
/// does not divide, since it ends in between, is left out.
std::vector<CrossedSides> divide_part(const std::vector<PartLine>& lines, const std::vector<PiercingEdge>& piercing);

}  // namespace percuss
