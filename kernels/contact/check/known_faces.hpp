#pragma once
// What a node remembers of the faces that pushed it, as the check of its pairs asks for it.

#include "kernels/contact/check/touch.hpp"
#include "kernels/contact/surface/contact_state.hpp"

namespace percuss {

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

/// Which history slot of the node a contact with this face would continue: that of the face itself, else that of a
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
