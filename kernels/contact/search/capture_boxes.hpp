#pragma once
// Capture boxes and the bound that lets candidate pairs be used again (the paper's location phase).
//
// A box bounds a face at its known and its predicted place, widened by what a node can move in the step, by the reach
// of the detailed check, and by a margin. As long as no node has left its place of the search by more than half of
// motion and margin, a pair that the check could accept is in the list: a guarantee, not a guess.

#include "kernels/contact/surface/contact_state.hpp"
#include "kernels/core/exact_sum.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

template <class T>
struct BoxOf {
  Vector3<T> low, high;
};

/// Box over a step of a face with corners at `x` and predicted velocities `v`, at n and at its predicted place, widened
/// by `reach`.
template <class T>
PERCUSS_FORCE_INLINE BoxOf<T> bound_corners(const FaceOf<T>& x, const FaceOf<T>& v, const T& dt, const T& reach) {
  BoxOf<T> box{};
  const auto add = [&](bool is_first, const T& known, const T& move, T& low, T& high) {
    const auto is_back = move < T(0);
    const T before = select(is_back, known + move, known), after = select(is_back, known, known + move);
    low = is_first ? before : smaller(low, before);
    high = is_first ? after : larger(high, after);
  };
  for (int i = 0; i < 4; ++i) {
    const Vector3<T>&at = x.corner[i], move = dt * v.corner[i];
    add(i == 0, at.x, move.x, box.low.x, box.high.x);
    add(i == 0, at.y, move.y, box.low.y, box.high.y);
    add(i == 0, at.z, move.z, box.low.z, box.high.z);
  }
  const Vector3<T> wider{reach, reach, reach};
  return {box.low - wider, box.high + wider};
}

/// The same of one face. corner(i): mesh node; boxes: out, at `face`.
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

/// Largest component of the displacement of any of `nodes` (mesh nodes) in the step.
template <class Space>
double find_largest_move(const Space& space, const Array<const int>& nodes, const SurfaceMotion& motion);

/// Largest component by which any of `nodes` is, at n or at its predicted place, away from its place `origin`
/// [nodes][3].
template <class Space>
double find_largest_travel(const Space& space, const Array<const int>& nodes, const SurfaceMotion& motion,
                           const Rows3<const double>& origin);

/// The same with distances in place of their largest components; in between, in the step, no node is farther away.
template <class Space>
double find_largest_distance(const Space& space, const Array<const int>& nodes, const SurfaceMotion& motion,
                             const Rows3<const double>& origin);

/// Stores the places of the nodes: origin [nodes][3].
template <class Space>
void store_places(const Space& space, const Array<const int>& nodes, const Rows3<const double>& x,
                  const Rows3<double>& origin);

/// Sum of the shortest edges of faces. corners: [faces][4] mesh nodes.
template <class Space>
ExactSum sum_shortest_edges(const Space& space, const Rows4<const int>& corners, const Rows3<const double>& x);

/// Faces whose boxes are wanted.
struct BoundedFaces {
  Rows4<const int> corners;      // [faces][4] mesh nodes
  Array<const double> offset{};  // [faces] how far from it nodes touch by thickness [length]; empty: no shells
};

/// Box of each face, widened by `margin` and the reach of the check. boxes: out, [faces].
template <class Space>
void bound_faces(const Space& space, const BoundedFaces& faces, const SurfaceMotion& motion, double margin,
                 const Boxes& boxes);

}  // namespace percuss
