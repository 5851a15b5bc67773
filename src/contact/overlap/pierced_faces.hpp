#pragma once
// Edges that go through a sheet, through the surface of their own body, or of any other: every side of every face,
// sharp or not, where it meets a face that it has no element in common with. By the places of a moment alone, without
// the searches, checks and history of contact.

#include <cstdint>
#include <utility>
#include <vector>

#include "src/contact/overlap/face_index.hpp"
#include "src/contact/overlap/sunken_edges.hpp"

namespace percuss {

/// An edge that goes through faces of a body.
struct PiercingEdge {
  SunkenEdge edge;         // depth: what would have to go back, of the less deep side; size: shortest edge of the face
  int body = -1, in = -1;  // of the edge, of the faces
  // What follows is about the first face that the edge goes through, and is filled with PiercedPairs::all_surfaces
  // alone:
  std::int64_t corners[4]{};     // node numbers
  int classes[2]{};              // of the edge and of the face, as FaceTopology::surface_class
  bool is_of_solid = false;      // the face: it has an inside
  bool is_odd = false;           // one end is on the other side: it goes through an odd number of times
  int inner = 0;                 // of a solid, which end that is
  double length = 0, away[2]{};  // of the edge; of each end from the faces, if is_odd [length]

  std::pair<int, int> bodies() const { return {body, in}; }
};

struct PiercingEdges {
  std::vector<PiercingEdge> found;  // of all ranks, in the same order on each
  std::int64_t tests = 0;           // of boxes, the most of a rank: what it has cost
};

/// Whose edges and faces count. all_surfaces: faces of other bodies' solids, too; what lies in the plane of a face does
/// not go through it.
enum class PiercedPairs { that_may_touch, all, all_surfaces };

/// The sides of faces, and the beams of this rank, that go through a shell of any body, or through another place of
/// their own body. beams: with any `in`. Collective.
PiercingEdges find_piercing_edges(const Communicator& ranks, const SurfaceShare& share,
                                  const Rows3<const double>& places, PiercedPairs pairs,
                                  const std::vector<TravellingEdge>& beams = {});

}  // namespace percuss
