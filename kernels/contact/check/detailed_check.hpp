#pragma once
// The detailed check of all candidate pairs, node-parallel (the paper's section 4.2): which node touches which face.

#include "kernels/contact/check/still_items.hpp"
#include "kernels/contact/check/touch.hpp"
#include "kernels/contact/search/capture_boxes.hpp"
#include "kernels/contact/surface/pair_query.hpp"

namespace percuss {

/// Accepted touches, sorted by (node, face), and what tells which of them the next check would find again.
struct TouchTable {
  int count = 0;
  int num_new = 0;                  // of nodes for which the check before did not find the same, all of it still
  std::int64_t num_kept_pairs = 0;  // candidates of nodes that were not checked, for what was found still holds
  Array<NodeTouches> by_node = Array<NodeTouches>("contact::touches", 0);  // [contact nodes]
  Array<int> first = Array<int>("contact::first_touch", 0);  // [CandidateList::num_nodes] place of the node's first one

  // Where still faces are watched.
  Array<std::int64_t> checked_at =
      Array<std::int64_t>("contact::checked_at", 0);             // [contact nodes] StillFaces::now() of its last check
  Array<int> known = Array<int>("contact::known_faces", 0);      // [3 contact nodes] history_face of then
  Array<int> is_still = Array<int>("contact::still_nodes", 0);   // [contact nodes] so are the node and its faces
  Array<int> near_moved = Array<int>("contact::near_moved", 0);  // [faces] whether some face around its corners moved
  Array<int> checked = Array<int>("contact::checked_nodes", 0);  // places in CandidateList::nodes
};

/// Normals at the predicted place and sizes at n of the faces that the check reads; those of still faces stand.
void update_faces(const WorkSpace& space, const ContactSurface& surface, const SurfaceMotion& motion,
                  const CandidateList& candidates, const StillFaces& still, const FaceState& faces);

/// Checks every candidate pair but those of nodes that lie still, with all around them. still: as update_faces() has
/// left it.
void find_touches(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& candidates, StillFaces& still,
                  TouchTable& table);

}  // namespace percuss
