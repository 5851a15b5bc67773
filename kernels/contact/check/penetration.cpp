#include "kernels/contact/check/penetration.hpp"

#include "kernels/contact/surface/offset_faces.hpp"

namespace percuss {
namespace {

/// A node counts as projecting on a face up to this share of h beside it.
constexpr double beside = 1e-6;
/// Share of h behind a face beyond which the node is not said to be behind it.
constexpr double deepest = 0.5;
/// Round-off of a node that lies on the mid-surface.
constexpr double slack = 1 + 1e-9;
/// Least cosine at which a shell lies flat on itself rather than bends: neighbours of a fold are no overlap.
constexpr double flat_on_itself = 0.7;

/// How deep a node is behind a face.
struct FaceDepth {
  bool known = false;   // whether the node projects on the face from nearby
  bool opposed = true;  // whether the node can face this face: contact can hold it there
  bool flush = false;   // the node lies in its plane
  double distance = 0;  // from the face; negative: not looked at
  double depth = 0;     // negative in front
  double limit = 0;     // of what contact can hold
  double edge = 0;
};

/// Whether a node and a face of one body may overlap.
KOKKOS_INLINE_FUNCTION bool may_overlap(const ContactSurface& surface, const FaceState& faces, int node, int face,
                                        double offset) {
  return has_opposed_face(surface, faces, node, face, offset > 0 ? -flat_on_itself : contact_limits::opposing);
}

PERCUSS_NO_INLINE FaceDepth find_face_depth(const MovingSurface& moving, int node, int face) {
  const ContactSurface& surface = moving.surface;
  const SurfaceMotion& motion = moving.motion;
  const FaceState& faces = moving.faces;
  FaceDepth result;
  result.distance = -1;
  const double offset = find_offset(surface.offsets, node, face);
  if (surface.node_body(node) == surface.face_body(face) && !may_overlap(surface, faces, node, face, offset))
    return result;
  result.opposed = offset > 0 ? looks_against(surface, motion, faces, node, face)
                              : has_opposed_face(surface, faces, node, face, contact_limits::opposing);
  const RelativeFace relative = load_touched_face(moving, node, face);
  const FacePoint closest = find_closest_point(relative.start);
  const double size = faces.size(face);
  result.distance = closest.distance;
  if (closest.off > beside * size || closest.distance > larger(deepest * size, slack * offset)) return result;
  result.known = true;
  const Point3 normal = find_push_direction(surface, faces, face, closest.weight);
  result.depth = dot(normal, interpolate(relative.start, closest.weight));
  result.flush = std::abs(result.depth) <= contact_limits::overlap * size;
  result.limit = larger(contact_limits::history_depth * size, slack * offset);
  result.edge = find_shortest_edge(relative.start);
  return result;
}

/// The least depth behind the faces of the body of candidate `c`; face -1 if the node is outside.
struct BodyDepth {
  int face = -1;
  FaceDepth least;
  double nearest = -1;  // of the faces that were looked at
  double inside = 0;    // by all faces that were looked at, those of flush sides too

  KOKKOS_INLINE_FUNCTION void add(const FaceDepth& depth, int of) {
    if (depth.distance >= 0 && (nearest < 0 || depth.distance < nearest)) nearest = depth.distance;
    if (!depth.known || (least.known && depth.depth >= least.depth)) return;
    least = depth;
    face = depth.depth > 0 ? of : -1;
  }
  // Beside an edge a node projects on one face only; no node is deeper than its distance from the nearest face.
  KOKKOS_INLINE_FUNCTION void limit() {
    if (face >= 0 && least.depth > nearest) least.depth = nearest;
  }
};

/// Where sides of two bodies are flush, those that the node lies in say nothing of how deep it is: then by the faces
/// that it looks against, if it projects on one. A node of a solid that looks against none of the faces that it is
/// behind lies on the body, where that ends at a surface which is not looked at: one that is tied.
template <class Faces>
KOKKOS_INLINE_FUNCTION BodyDepth find_body_depth(const MovingSurface& moving, int node, const Faces& candidates, int c,
                                                 int last) {
  const ContactSurface& surface = moving.surface;
  BodyDepth all, opposed;
  const int body = surface.face_body(candidates(c));
  for (int i = c; i < last; ++i) {
    if (surface.face_body(candidates(i)) != body) continue;
    const FaceDepth depth = find_face_depth(moving, node, candidates(i));
    all.add(depth, candidates(i));
    if (depth.opposed) opposed.add(depth, candidates(i));
  }
  const bool is_of_shell = find_offset(surface.offsets, node, candidates(c)) > 0;
  if (!is_of_shell && !opposed.least.known) all.face = -1;
  BodyDepth& found = all.least.flush && opposed.least.known ? opposed : all;
  all.limit();
  found.limit();
  found.inside = all.face >= 0 ? all.least.depth : 0;
  return found;
}

template <class Faces>
KOKKOS_INLINE_FUNCTION bool is_first_of_body(const ContactSurface& surface, const Faces& candidates, int first, int c) {
  for (int i = first; i < c; ++i)
    if (surface.face_body(candidates(i)) == surface.face_body(candidates(c))) return false;
  return true;
}

/// find_gaps(): the node is behind the face or of the same body.
constexpr double no_gap = -1;

PERCUSS_NO_INLINE double find_gap(const MovingSurface& moving, int node, int face) {
  const ContactSurface& surface = moving.surface;
  const FaceState& faces = moving.faces;
  if (surface.node_body(node) == surface.face_body(face)) return no_gap;
  const RelativeFace relative = load_touched_face(moving, node, face);
  const FacePoint closest = find_closest_point(relative.start);
  if (closest.distance <= contact_limits::overlap * faces.size(face)) return 0;
  const double behind = dot(load_row(faces.normal, face), interpolate(relative.start, closest.weight));
  return behind <= contact_limits::overlap * faces.size(face) ? closest.distance : no_gap;
}

}  // namespace

void find_penetrations(const WorkSpace& space, const ContactSurface& surface, const SurfaceMotion& motion,
                       const CandidateList& candidates, const FaceState& faces, PenetrationTable& table) {
  reserve(table.depth, surface.num_nodes);
  reserve(table.ratio, surface.num_nodes);
  reserve(table.face, surface.num_nodes);
  reserve(table.limit, surface.num_nodes);
  const Array<double> depth = table.depth, ratio = table.ratio, limit = table.limit;
  const Array<int> face = table.face;
  const MovingSurface moving{surface, motion, faces};
  const Array<const int> offset = candidates.offset, list = candidates.face;
  parallel_for(
      "contact::penetrations", RangeOf(space, 0, surface.num_nodes), KOKKOS_LAMBDA(int node) {
        depth(node) = 0;
        ratio(node) = 0;
        limit(node) = 0;
        face(node) = -1;
        for (int c = offset(node); c < offset(node + 1); ++c) {
          if (!is_first_of_body(moving.surface, list, offset(node), c)) continue;
          const BodyDepth body = find_body_depth(moving, node, list, c, offset(node + 1));
          if (body.face < 0 || body.least.depth <= depth(node)) continue;
          depth(node) = body.least.depth;
          ratio(node) = body.inside / body.least.edge;
          limit(node) = body.least.limit;
          face(node) = body.face;
        }
      });
}

void find_gaps(const WorkSpace& space, const ContactSurface& surface, const SurfaceMotion& motion,
               const CandidateList& candidates, const FaceState& faces, Array<double>& gaps) {
  reserve(gaps, candidates.num_pairs);
  const Array<double> out = gaps;
  const MovingSurface moving{surface, motion, faces};
  const Array<const int> nodes = candidates.nodes, offset = candidates.offset, face = candidates.face;
  parallel_for(
      "contact::gaps", RangeOf(space, 0, candidates.num_nodes), KOKKOS_LAMBDA(int i) {
        for (int c = offset(nodes(i)); c < offset(nodes(i) + 1); ++c) out(c) = find_gap(moving, nodes(i), face(c));
      });
  space.fence();
}

}  // namespace percuss
