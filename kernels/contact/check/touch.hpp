#pragma once
// What the detailed check finds, and what a node remembers of the faces that pushed it. How it finds it is in
// pair_check.hpp and node_check.hpp, which few need.

#include "kernels/contact/surface/contact_state.hpp"

namespace percuss {

/// One node on one face, begun by start_touch(). Without initial values: lists of them are made for every node.
struct Touch {
  int face;
  int record;       // history slot of the node (0 to 2) that this contact continues; -1: new
  bool same_face;   // the record is of this very face
  bool opposed;     // whether the normal of some face of the node opposes this one
  bool beside;      // behind the face since the start, but beside it then: it came in through another face
  bool is_kept;     // the predicted place is beside the face that pushed the node: seen where it was at n
  bool owes_start;  // gap_start is still to be found: nothing but the row of an obeyed touch requests it
  float offset;     // distance that the node keeps from the face of the mesh by thickness, for limits
  double weight[4];
  Point3 normal;     // push direction of the node: how the gap changes with its place
  double gap_start;  // distance along the normal at n, negative behind the face [length]; see owes_start
  double gap_end;    // gap at the predicted place
  double off;        // distance beside the face
  double tau;        // when a new contact begins, share of the step; 0: touching since the start
  double size;       // h of the face
  double way;        // longest way of a corner of the face relative to the node in the step
};

KOKKOS_INLINE_FUNCTION void start_touch(int face, double size, double offset, Touch& touch) {
  touch.face = face;
  touch.record = -1;
  touch.opposed = true;
  touch.same_face = touch.beside = touch.is_kept = touch.owes_start = false;
  touch.offset = static_cast<float>(offset);
  touch.gap_start = touch.gap_end = touch.off = touch.tau = 0;
  touch.size = size;
  touch.way = 0;
}

/// Up to three touches that the node obeys.
struct NodeTouches {
  int count = 0;
  Touch touch[contact_limits::max_touches];
};

/// The faces that pushed a node in the last step and are still in its reach, loaded once for all its pairs.
struct KnownFaces {
  int face[contact_limits::max_touches];  // -1: none
  Point3 normal[contact_limits::max_touches];
};

/// history_face: [3 contact nodes] the faces that pushed in the last step, -1: none.
KOKKOS_INLINE_FUNCTION KnownFaces load_known_faces(const FaceState& faces, const Array<const int>& history_face,
                                                   const CheckedNode& node) {
  KnownFaces known;
  for (int slot = 0; slot < contact_limits::max_touches; ++slot) {
    const int face = history_face(node.node * contact_limits::max_touches + slot);
    const bool is_near = face >= 0 && is_in_box(node, faces.box, face);
    known.face[slot] = is_near ? face : -1;
    known.normal[slot] = is_near ? load_row(faces.normal, face) : Point3{};
  }
  return known;
}

/// The history slot of the node that a contact with this face would continue: that of the face itself, else that of a
/// smooth neighbour.
KOKKOS_INLINE_FUNCTION void find_record(const ContactSurface& surface, const FaceState& faces, const KnownFaces& known,
                                        Touch& touch) {
  for (int slot = 0; slot < contact_limits::max_touches; ++slot) {
    const int old = known.face[slot];
    if (old < 0) continue;
    if (old == touch.face) {
      touch.record = slot;
      touch.same_face = true;
      return;
    }
    if (touch.record < 0 && dot(known.normal[slot], load_row(faces.normal, touch.face)) > contact_limits::inherited &&
        share_corner(surface, old, touch.face))
      touch.record = slot;
  }
}

}  // namespace percuss
