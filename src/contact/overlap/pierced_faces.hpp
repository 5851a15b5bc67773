#pragma once
// Edges that go through a sheet, or through the surface of their own body: every side of every face, sharp or not,
// where it meets a face that it has no element in common with. By the places of a moment alone, without the searches,
// checks and history of contact.

#include <cstdint>
#include <utility>
#include <vector>

#include "src/contact/overlap/sunken_edges.hpp"

namespace percuss {

/// An edge that goes through faces of a body.
struct PiercingEdge {
  SunkenEdge edge;         // depth: what would have to go back, of the less deep side; size: shortest edge of the face
  int body = -1, in = -1;  // of the edge, of the faces

  std::pair<int, int> bodies() const { return {body, in}; }
};

struct PiercingEdges {
  std::vector<PiercingEdge> found;  // of all ranks, in the same order on each
  std::int64_t tests = 0;           // of boxes, the most of a rank: what it has cost
};

/// Whose edges and faces count.
enum class PiercedPairs { that_may_touch, all };

/// The sides of faces that go through a shell of any body, or through another place of their own body. Collective.
PiercingEdges find_piercing_edges(const Communicator& ranks, const SurfaceShare& share,
                                  const Rows3<const double>& places, PiercedPairs pairs);

}  // namespace percuss
