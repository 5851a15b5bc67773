#pragma once
// The detailed check of all candidate pairs, node-parallel (the paper's section 4.2): which node touches which face.

#include "kernels/contact/capture_boxes.hpp"
#include "kernels/contact/points_in_box.hpp"
#include "kernels/contact/touch.hpp"

namespace percuss {

/// Accepted touches, sorted by (node, face).
struct TouchTable {
  int count = 0;
  Array<NodeTouches> by_node = Array<NodeTouches>("contact::touches", 0);  // [CandidateList::num_nodes]
  Array<int> first = Array<int>("contact::first_touch", 0);                // [num_nodes] place of the node's first one
};

/// Normals at the predicted place and sizes at n of the faces that the check reads.
template <class Space>
void update_faces(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion,
                  const CandidateList& candidates, const FaceState& faces);

/// Checks every candidate pair. history_face: [3 contact nodes] faces that pushed each node in the last step, -1: none.
template <class Space>
void find_touches(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion,
                  const CandidateList& candidates, const FaceState& faces, const Array<const int>& history_face,
                  TouchTable& table);

}  // namespace percuss
