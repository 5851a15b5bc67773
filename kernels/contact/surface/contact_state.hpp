#pragma once
// What the detailed check reads besides the surface: the motion of the step, the faces' normals and sizes, history.

#include "kernels/contact/geometry/boxes.hpp"
#include "kernels/contact/geometry/contact_limits.hpp"
#include "kernels/contact/geometry/face_geometry.hpp"
#include "kernels/contact/surface/contact_surface.hpp"

namespace percuss {

/// The motion of a step, one row a mesh node.
struct SurfaceMotion {
  Rows3<const double> x;  // position at n
  Rows3<const double> v;  // velocity predicted from n to n+1
  double dt = 0;
};

/// A count to which other threads add by atomics at the same time: any value that it has had. Kokkos 3.4 has no such
/// load.
KOKKOS_FORCEINLINE_FUNCTION int load_count(const int& count) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__)
  return __atomic_load_n(&count, __ATOMIC_RELAXED);
#else
  return *static_cast<const volatile int*>(&count);
#endif
}

/// Directions at the corners of a face.
struct CornerDirections {
  Point3 of[4]{};
};

/// Directions by which a face is moved outward for an offset of 1, at n and at the predicted place.
struct OutwardDirections {
  CornerDirections start, end;
};

/// Geometry of faces in this step: normals of those listed in CandidateList::faces, the rest of those that are boxed.
struct FaceState {
  Rows3<double> normal;  // outward unit normal at the predicted place
  Array<double> size;    // h of contact_limits.hpp at n
  Boxes box;             // of the face over the step, widened by the reach of the check

  // in scenes with shells; empty in others
  Array<FaceSlab> slab = Array<FaceSlab>("contact::face_slab", 0);
  // Directions of faces that the check before read, as those that a node touches; pairs find those of others by
  // themselves, to the same bits. Empty: those of all faces.
  Array<int> is_prepared = Array<int>("contact::prepared_faces", 0);  // [faces] 1: these are of this step
  Array<int> reads = Array<int>("contact::face_reads", 0);            // [faces] of this check, up to worth_preparing()
  Array<CornerDirections> vertex = Array<CornerDirections>("contact::vertex_normals", 0);
  Array<OutwardDirections> outward = Array<OutwardDirections>("contact::outward_directions", 0);  // as slab

  /// Reads of a face in a check from which on it is prepared for the next. One pair alone finds what it needs of a
  /// face of shells for less.
  KOKKOS_INLINE_FUNCTION int worth_preparing() const { return outward.extent(0) > 0 ? 2 : 1; }

  /// Whether the face is prepared; called once for each reading of its directions.
  KOKKOS_INLINE_FUNCTION bool has_prepared(int face) const {
    if (face >= static_cast<int>(is_prepared.extent(0))) return false;
    // Other threads count at the same time: a few beyond the limit, which decides nothing.
    if (load_count(reads(face)) < worth_preparing()) Kokkos::atomic_add(&reads(face), 1);
    return is_prepared(face) != 0;
  }
};

/// A surface in its motion of the step, as the detailed check reads it.
struct MovingSurface {
  ContactSurface surface;
  SurfaceMotion motion;
  FaceState faces;
};

/// All that the detailed check reads besides candidate pairs.
struct CheckInputs : MovingSurface {
  Array<const int> history_face;  // [3 contact nodes] faces that pushed each node in the last step, -1: none
};

/// A node as the check of its candidate faces sees it, loaded once.
struct CheckedNode {
  int node = -1;  // contact node
  Point3 x{}, v{};
  Point3 low{}, high{};  // box of the node over the step
};

/// History of contacts of two edges, in the FE decomposition with the home of edge A, the one of the lower number: one
/// record a row of the last step, by (a, b).
struct EdgeHistory {
  int count = 0;
  Array<std::int64_t> a = Array<std::int64_t>("contact::edge_history_a", 0);      // [count] numbers of edges
  Array<std::int64_t> b = Array<std::int64_t>("contact::edge_history_b", 0);      // [count]
  Array<int> holds = Array<int>("contact::edge_history_holds", 0);                // [count] 0: nothing to remember
  Rows3<double> normal = Rows3<double>("contact::edge_history_normal", 0);        // [count] push direction of A
  Rows3<double> impulse = Rows3<double>("contact::edge_history_impulse", 0);      // as in ContactHistory
  Rows3<double> slip = Rows3<double>("contact::edge_history_slip", 0);            // likewise
  Array<double> reference = Array<double>("contact::edge_history_reference", 0);  // likewise
  Array<double> held = Array<double>("contact::edge_history_held", 0);            // likewise
  Array<double> to_push = Array<double>("contact::edge_history_to_push", 0);      // likewise
};

/// History of contacts from one step to the next, in the FE decomposition with the owner of the node. Record 3 n + i
/// belongs to push i of contact node n, the records after those to pairs of a wall and a node. Part of the state: a
/// checkpoint must keep it.
struct ContactHistory {
  Array<std::int64_t> face;  // [3 contact nodes] number of the face of this record; -1: none
  Rows3<double> impulse;     // [records] impulse on the node in the last step
  Rows3<double> slip;        // [records] tangential displacement that sticking still owes
  Array<double> reference;   // [records] overlap accepted at the start, >= 0
  EdgeHistory edges{};
  Rows3<double> ties{};     // [ties] impulse on the tied node in the last step
  Array<double> held{};     // [records] energy of the spring along the push, 0: not known; empty: no springs
  Array<double> to_push{};  // [records] overlap that is to be pushed out; reference: what is left of it; empty: none
};

/// One record of the history.
struct LastContact {
  Point3 impulse{}, slip{};
  double reference = 0, held = 0, to_push = 0;
};

template <class History>
KOKKOS_INLINE_FUNCTION LastContact load_record(const History& history, int record) {
  return {load_row(history.impulse, record), load_row(history.slip, record), history.reference(record),
          history.held.extent(0) > 0 ? history.held(record) : 0,
          history.to_push.extent(0) > 0 ? history.to_push(record) : 0};
}

/// Corners at n relative to the node and their displacement over the step relative to the node's.
template <class T>
struct RelativeFaceOf {
  FaceOf<T> start, move;
};
using RelativeFace = RelativeFaceOf<double>;

KOKKOS_INLINE_FUNCTION RelativeFace load_relative_face(const ContactSurface& surface, const SurfaceMotion& motion,
                                                       const Point3& x, const Point3& v, int face) {
  RelativeFace relative;
  for (int i = 0; i < 4; ++i) {
    const int a = surface.nodes(surface.face_corners(face, i));
    relative.start.corner[i] = load_row(motion.x, a) - x;
    relative.move.corner[i] = motion.dt * (load_row(motion.v, a) - v);
  }
  return relative;
}

KOKKOS_INLINE_FUNCTION RelativeFace load_relative_face(const ContactSurface& surface, const SurfaceMotion& motion,
                                                       int node, int face) {
  const int s = surface.nodes(node);
  return load_relative_face(surface, motion, load_row(motion.x, s), load_row(motion.v, s), face);
}

KOKKOS_INLINE_FUNCTION CheckedNode load_checked_node(const ContactSurface& surface, const SurfaceMotion& motion,
                                                     int node) {
  CheckedNode n;
  n.node = node;
  n.x = load_row(motion.x, surface.nodes(node));
  n.v = load_row(motion.v, surface.nodes(node));
  const Point3 end = n.x + motion.dt * n.v;
  n.low = {end.x < n.x.x ? end.x : n.x.x, end.y < n.x.y ? end.y : n.x.y, end.z < n.x.z ? end.z : n.x.z};
  n.high = {end.x > n.x.x ? end.x : n.x.x, end.y > n.x.y ? end.y : n.x.y, end.z > n.x.z ? end.z : n.x.z};
  return n;
}

/// Whether the boxes of node and face over the step meet.
KOKKOS_INLINE_FUNCTION bool is_in_box(const CheckedNode& n, const Boxes& box, int face) {
  return n.high.x >= box(face, 0) && n.high.y >= box(face, 1) && n.high.z >= box(face, 2) && n.low.x <= box(face, 3) &&
         n.low.y <= box(face, 4) && n.low.z <= box(face, 5);
}

template <class T>
PERCUSS_FORCE_INLINE FaceOf<T> find_end(const RelativeFaceOf<T>& face) {
  FaceOf<T> end;
  for (int i = 0; i < 4; ++i) end.corner[i] = face.start.corner[i] + face.move.corner[i];
  return end;
}

/// Whether the normal of some face of the node opposes that of the face: the cosine between them is at most `most`. A
/// node without faces, a free particle, looks everywhere.
KOKKOS_INLINE_FUNCTION bool has_opposed_face(const ContactSurface& surface, const FaceState& faces, int node, int face,
                                             double most) {
  const Point3 normal = load_row(faces.normal, face);
  const int first = surface.nodes_to_faces_offset(node), last = surface.nodes_to_faces_offset(node + 1);
  for (int j = first; j < last; ++j)
    if (dot(load_row(faces.normal, surface.nodes_to_faces(j)), normal) <= most) return true;
  return first == last;
}

/// Where a node of shells looks besides along their normals: away from them in their plane, at a free edge or a fold.
/// Mean of the unit vectors from the middles of its faces to the node, at n: about 0 inside a flat shell.
KOKKOS_INLINE_FUNCTION Point3 find_outlook(const ContactSurface& surface, const SurfaceMotion& motion, int node) {
  const Point3 x = load_row(motion.x, surface.nodes(node));
  const int first = surface.nodes_to_faces_offset(node), last = surface.nodes_to_faces_offset(node + 1);
  Point3 sum{};
  for (int j = first; j < last; ++j) {
    Point3 corners{};
    for (int i = 0; i < 4; ++i)
      corners = corners + (load_row(motion.x, surface.nodes(surface.face_corners(surface.nodes_to_faces(j), i))) - x);
    sum = sum - normalize(corners);
  }
  return (1.0 / (last - first)) * sum;
}

/// Whether a node can face a face: the normal of one of its faces opposes it, or it is a shell node on its outer side.
KOKKOS_INLINE_FUNCTION bool looks_against(const ContactSurface& surface, const SurfaceMotion& motion,
                                          const FaceState& faces, int node, int face) {
  if (has_opposed_face(surface, faces, node, face, contact_limits::opposing)) return true;
  return find_node_offset(surface.offsets, node) > 0 &&
         dot(find_outlook(surface, motion, node), load_row(faces.normal, face)) <= contact_limits::opposing;
}

/// Vertex normals of a face: at each corner that is requested the mean of the faces of one smooth surface, as a unit
/// vector.
template <class Asked>
KOKKOS_INLINE_FUNCTION CornerDirections find_vertex_normals(const ContactSurface& surface, const FaceState& faces,
                                                            int face, const Asked& is_asked) {
  const Point3 own = load_row(faces.normal, face);
  double vertices[3][4] = {};
  for (int i = 0; i < 4; ++i) {
    if (!is_asked(i)) continue;
    const int corner = surface.face_corners(face, i);
    Point3 vertex{};
    for (int j = surface.nodes_to_faces_offset(corner); j < surface.nodes_to_faces_offset(corner + 1); ++j) {
      const Point3 other = load_row(faces.normal, surface.nodes_to_faces(j));
      if (dot(other, own) > contact_limits::smooth) vertex = vertex + other;
    }
    vertices[0][i] = vertex.x, vertices[1][i] = vertex.y, vertices[2][i] = vertex.z;
  }
  normalize_four(vertices);
  CornerDirections normals;
  for (int i = 0; i < 4; ++i) normals.of[i] = {vertices[0][i], vertices[1][i], vertices[2][i]};
  return normals;
}

/// Vertex normals at a node of all faces that hold it, as find_vertex_normals() finds them: FaceState::vertex.
KOKKOS_INLINE_FUNCTION void set_vertex_normals_at(const ContactSurface& surface, const FaceState& faces, int node) {
  constexpr int at_once = 4;
  const Array<const int>& held_by = surface.nodes_to_faces;
  const int first = surface.nodes_to_faces_offset(node), last = surface.nodes_to_faces_offset(node + 1);
  for (int m = first; m < last; m += at_once) {
    double own[3][at_once], vertices[3][at_once];
    for (int k = 0; k < at_once; ++k)
      for (int axis = 0; axis < 3; ++axis) own[axis][k] = faces.normal(held_by(m + k < last ? m + k : m), axis);
    for (int k = 0; k < at_once; k += fan_lanes) {
      const FanPoint normal = {load_fan(own[0] + k), load_fan(own[1] + k), load_fan(own[2] + k)};
      const FanPack zero(0);
      FanPoint vertex = {zero, zero, zero};
      for (int j = first; j < last; ++j) {
        const FanPoint other = spread_to_fan(load_row(faces.normal, held_by(j)));
        const auto is_smooth = dot(other, normal) > FanPack(contact_limits::smooth);
        vertex = vertex + FanPoint{select(is_smooth, other.x, zero), select(is_smooth, other.y, zero),
                                   select(is_smooth, other.z, zero)};
      }
      store_fan(vertices[0] + k, vertex.x);
      store_fan(vertices[1] + k, vertex.y);
      store_fan(vertices[2] + k, vertex.z);
    }
    normalize_four(vertices);
    for (int k = 0; k < at_once && m + k < last; ++k)
      for (int i = 0; i < 4; ++i)
        if (surface.face_corners(held_by(m + k), i) == node)
          faces.vertex(held_by(m + k)).of[i] = {vertices[0][k], vertices[1][k], vertices[2][k]};
  }
}

/// The push direction at a point of a face: vertex normals, averaged over the faces of one smooth surface, weighted.
/// Continuous from face to face of a smooth surface, the face's own normal at a crease.
KOKKOS_INLINE_FUNCTION Point3 find_push_direction(const ContactSurface& surface, const FaceState& faces, int face,
                                                  const double weight[4]) {
  const auto add_up = [weight](const CornerDirections& vertex) {
    Point3 sum{};
    for (int i = 0; i < 4; ++i)
      if (weight[i] != 0) sum = sum + weight[i] * vertex.of[i];
    return normalize(sum);
  };
  if (faces.has_prepared(face)) {
    const CornerDirections& vertex = faces.vertex(face);
    Point3 sum{};
    for (int i = 0; i < 4; ++i) sum = sum + weight[i] * vertex.of[i];  // of corners without weight +0: the same bits
    return normalize(sum);
  }
  return add_up(find_vertex_normals(surface, faces, face, [weight](int i) { return weight[i] != 0; }));
}

}  // namespace percuss
