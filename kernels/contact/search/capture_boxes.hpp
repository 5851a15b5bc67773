#pragma once
// Capture boxes (the paper's section 4.1.1) and the bound that lets candidate pairs be used again.
//
// A box bounds a face at its known and its predicted place, widened by what a node can move in the step, by the reach
// of the detailed check, and by a margin. As long as no node has left its place of the search by more than a third of
// motion and margin, a pair that the check could accept is in the list: a guarantee, not a guess. (Node and face may
// each travel by that third, and the reach grows with the face by the last one: src/contact/search/reuse_bound.cpp.)

#include "kernels/contact/surface/contact_state.hpp"
#include "kernels/contact/surface/edge_surface.hpp"
#include "kernels/core/exact_sum.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

/// The box of bound_corners() of one face. corner(i): mesh node; boxes: out, at `face`.
template <class Corner>
KOKKOS_INLINE_FUNCTION void bound_face(const SurfaceMotion& motion, const Corner& corner, double reach,
                                       const Boxes& boxes, int face) {
  FacePoints x, v;
  for (int i = 0; i < 4; ++i) {
    x.corner[i] = load_row(motion.x, corner(i));
    v.corner[i] = load_row(motion.v, corner(i));
  }
  const BoxOf<double> box = bound_corners(x, v, motion.dt, reach);
  boxes(face, 0) = box.low.x, boxes(face, 1) = box.low.y, boxes(face, 2) = box.low.z;
  boxes(face, 3) = box.high.x, boxes(face, 4) = box.high.y, boxes(face, 5) = box.high.z;
}

/// No pair is accepted that is farther apart: the size h of an edge is at most its length.
KOKKOS_INLINE_FUNCTION double find_edge_reach(const Rows2<const int>& ends, const Rows3<const double>& x, int edge) {
  return contact_limits::capture * norm(load_row(x, ends(edge, 1)) - load_row(x, ends(edge, 0)));
}

/// Box of an edge over the step.
KOKKOS_INLINE_FUNCTION void bound_edge(const Rows2<const int>& ends, const SurfaceMotion& motion, int edge,
                                       const Point3& reach, const Boxes& boxes) {
  const double wider[3] = {reach.x, reach.y, reach.z};
  for (int axis = 0; axis < 3; ++axis) {
    double low = 0, high = 0;
    for (int i = 0; i < 2; ++i) {
      const int a = ends(edge, i);
      const double known = motion.x(a, axis), move = motion.dt * motion.v(a, axis);
      const double before = move < 0 ? known + move : known, after = move < 0 ? known : known + move;
      low = i == 0 || before < low ? before : low;
      high = i == 0 || after > high ? after : high;
    }
    boxes(edge, axis) = low - wider[axis];
    boxes(edge, axis + 3) = high + wider[axis];
  }
}

/// Largest component of the displacement of any of `nodes` (mesh nodes) in the step.
double find_largest_move(const WorkSpace& space, const Array<const int>& nodes, const SurfaceMotion& motion);

/// Largest component by which any of `nodes` is, at n or at its predicted place, away from its place `origin`
/// [nodes][3].
double find_largest_travel(const WorkSpace& space, const Array<const int>& nodes, const SurfaceMotion& motion,
                           const Rows3<const double>& origin);

/// As find_largest_travel(), with distances in place of their largest components. Within the step no node is farther
/// away.
double find_largest_distance(const WorkSpace& space, const Array<const int>& nodes, const SurfaceMotion& motion,
                             const Rows3<const double>& origin);

/// The largest distance that a node goes in the step.
double find_largest_step(const WorkSpace& space, const Array<const int>& nodes, const SurfaceMotion& motion);

/// Stores the places of the nodes: origin [nodes][3].
void store_places(const WorkSpace& space, const Array<const int>& nodes, const Rows3<const double>& x,
                  const Rows3<double>& origin);

/// Sum of the shortest edges of faces. corners: [faces][4] mesh nodes.
ExactSum sum_shortest_edges(const WorkSpace& space, const Rows4<const int>& corners, const Rows3<const double>& x);

/// Faces whose boxes are wanted.
struct BoundedFaces {
  Rows4<const int> corners;      // [faces][4] mesh nodes
  Array<const double> offset{};  // [faces] how far from it nodes touch by thickness [length]; empty: no shells
};

/// Box of each face, widened by `margin` and the reach of the check. boxes: out, [faces].
void bound_faces(const WorkSpace& space, const BoundedFaces& faces, const SurfaceMotion& motion, double margin,
                 const Boxes& boxes);

}  // namespace percuss
