#pragma once
// Capture boxes and the bound that lets candidate pairs be used again (the paper's location phase).
//
// A box bounds a face at its known and its predicted place, widened by what a node can move in the step, by the reach
// of the detailed check, and by a margin. As long as no node has left its place of the search by more than half of
// motion and margin, a pair that the check could accept is in the list: a guarantee, not a guess.

#include "kernels/contact/contact_state.hpp"
#include "kernels/contact/points_in_box.hpp"

namespace percuss {

/// Box of a face at n and at its predicted place, widened by `reach`.
KOKKOS_INLINE_FUNCTION void bound_face(const ContactSurface& surface, const SurfaceMotion& motion, int face,
                                       double reach, const Boxes& boxes) {
  for (int axis = 0; axis < 3; ++axis) {
    double low = 0, high = 0;
    for (int corner = 0; corner < 4; ++corner) {
      const int a = surface.nodes(surface.face_corners(face, corner));
      const double known = motion.x(a, axis), move = motion.dt * motion.v(a, axis);
      const double before = move < 0 ? known + move : known, after = move < 0 ? known : known + move;
      low = corner == 0 || before < low ? before : low;
      high = corner == 0 || after > high ? after : high;
    }
    boxes(face, axis) = low - reach;
    boxes(face, axis + 3) = high + reach;
  }
}

/// Largest component of any contact node's displacement in the step.
template <class Space>
double find_largest_move(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion);

/// Largest component by which any contact node is, at n or in the step, away from its place `origin` [contact
/// nodes][3].
template <class Space>
double find_largest_travel(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion,
                           const Rows3<const double>& origin);

/// Stores the places of the contact nodes.
template <class Space>
void store_places(const Space& space, const ContactSurface& surface, const Rows3<const double>& x,
                  const Rows3<double>& origin);

/// Mean of the shortest edges of all contact faces, the measure of the margin.
template <class Space>
double find_mean_edge(const Space& space, const ContactSurface& surface, const Rows3<const double>& x);

/// Box of each searched face, widened by `margin` and the reach of the check.
template <class Space>
void bound_faces(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion, double margin,
                 const Boxes& boxes);

}  // namespace percuss
