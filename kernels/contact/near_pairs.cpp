#include "kernels/contact/near_pairs.hpp"

namespace percuss {
namespace {

/// By how much node and face can come nearer to the reach of the check, in travels: each by one, and the reach grows
/// with the edges of the face, which grow by two.
constexpr double approach_in_travel = 2 * (1 + contact_limits::capture);
/// Room for round-off.
constexpr double near_slack = 1e-3;

/// How near a pair can come. A node has its histories from faces that it comes near ever, and they pass from face to
/// face by common corners: where no such way leads, a pair is unlinked and never near.
enum Nearness { never, unlinked, with_history, linked_now, ever };

/// Adds an axis in which a face is seen: any unit vector, or none.
KOKKOS_INLINE_FUNCTION void set_axis(const FacePoints& face, int k, const Point3& axis, SeenFace& seen) {
  seen.axis[k] = axis;
  for (int i = 0; i < 4; ++i) {
    const double height = dot(axis, face.corner[i]);
    seen.low[k] = i == 0 || height < seen.low[k] ? height : seen.low[k];
    seen.high[k] = i == 0 || height > seen.high[k] ? height : seen.high[k];
  }
}

/// face: relative to its first corner, which is at `origin`; size: h; travel: how far each corner may move.
KOKKOS_INLINE_FUNCTION SeenFace see_face(const Point3& origin, const FacePoints& face, double size, double travel) {
  const Point3 a = face.corner[2] - face.corner[0], b = face.corner[3] - face.corner[1], area = cross(a, b),
               along = (face.corner[1] - face.corner[0]) + (face.corner[2] - face.corner[3]);
  const double whole = norm(area), length = norm(along);
  const Point3 normal = whole > 0 ? (1 / whole) * area : Point3{}, first = length > 0 ? (1 / length) * along : Point3{};
  SeenFace seen;
  seen.origin = origin;
  seen.capture = contact_limits::capture * size;
  set_axis(face, 0, normal, seen);
  set_axis(face, 1, first, seen);
  set_axis(face, 2, cross(normal, first), seen);
  // Each diagonal changes by twice the travel at most.
  const double change = 2 * travel * (norm(a) + norm(b) + 2 * travel);
  seen.turn = change < whole ? change / whole : 1;
  return seen;
}

/// How near a pair can come while each side moves by what `capture` has for it. Without a history, a node is accepted
/// within the capture of the face moved outward by thickness; with one, by the offset farther behind it as well.
KOKKOS_INLINE_FUNCTION Nearness find_nearness(const SeenFace& seen, const Point3& place, double capture,
                                              double offset) {
  const Point3 from = place - seen.origin;
  const double reach = capture + (1 + longest_mitre) * offset;
  double low = 0, high = 0;  // of the face over the node
  for (int k = 2; k >= 0; --k) {
    const double height = dot(seen.axis[k], from);
    low = seen.low[k] - height;
    high = seen.high[k] - height;
    if (low > reach || high < -reach) return never;
  }
  // The moved face is higher by the offset along a normal that turns, and its corners by as much along it at most.
  const double least = offset * (1 - 2 * seen.turn), most = offset * (1 + seen.turn);
  const bool is_apart = offset > 0 && seen.turn < 0.5 && (low + least > capture || high + most < -capture);
  return is_apart ? unlinked : ever;
}

/// Whether the face pushed the node in the last step.
KOKKOS_INLINE_FUNCTION bool is_in_history(const Array<const int>& history_face, int node, int face) {
  for (int slot = 0; slot < contact_limits::max_touches; ++slot)
    if (history_face(contact_limits::max_touches * node + slot) == face) return true;
  return false;
}

/// Links what shares a corner with candidate `b`.
KOKKOS_INLINE_FUNCTION void link_to(const ContactSurface& surface, const Array<const int>& face,
                                    const Array<int>& nearness, int b, int first, int last) {
  for (int c = first; c < last; ++c)
    if (nearness(c) == unlinked && share_corner(surface, face(b), face(c))) nearness(c) = linked_now;
}

/// Follows these ways from the pairs that are near ever, from each pair once.
KOKKOS_INLINE_FUNCTION void link_histories(const ContactSurface& surface, const Array<const int>& face,
                                           const Array<int>& nearness, int first, int last) {
  for (int b = first; b < last; ++b)
    if (nearness(b) == ever) link_to(surface, face, nearness, b, first, last);
  for (bool any = true; any;) {
    any = false;
    for (int b = first; b < last; ++b) {
      if (nearness(b) != linked_now) continue;
      nearness(b) = with_history;
      link_to(surface, face, nearness, b, first, last);
      any = true;
    }
  }
}

}  // namespace

template <class Space>
bool list_near_pairs(const Space& space, const ContactSurface& surface, const Rows3<const double>& x,
                     const FaceState& faces, const Array<const int>& history_face, const CandidateList& all,
                     double travel, double most, NearScratch& scratch, CandidateList& near) {
  reserve(scratch.count, surface.num_nodes);
  reserve(scratch.nearness, all.num_pairs);
  reserve(scratch.seen, surface.num_faces);
  reserve(near.offset, surface.num_nodes + 1);
  const ContactSurface s = surface;
  const Rows3<const double> places = x;
  const Array<const double> size = faces.size;
  const Array<const int> history = history_face, offset = all.offset, face = all.face;
  const Array<const int> seen_faces = all.faces, is_candidate = all.is_boxed;
  const Array<int> count = scratch.count, nearness = scratch.nearness, near_offset = near.offset;
  const Array<SeenFace> seen = scratch.seen;
  const double approach = approach_in_travel * travel;
  Kokkos::parallel_for(
      "contact::see_faces", RangeOf<Space>(space, 0, all.num_faces), KOKKOS_LAMBDA(int i) {
        if (is_candidate(i) == 0) return;
        const int seen_face = seen_faces(i);
        const Point3 origin = load_row(places, s.nodes(s.face_corners(seen_face, 0)));
        FacePoints corners;
        for (int k = 0; k < 4; ++k)
          corners.corner[k] = load_row(places, s.nodes(s.face_corners(seen_face, k))) - origin;
        seen(seen_face) = see_face(origin, corners, size(seen_face), travel);
      });
  Kokkos::parallel_for(
      "contact::find_near_pairs", RangeOf<Space>(space, 0, surface.num_nodes), KOKKOS_LAMBDA(int node) {
        const int first = offset(node), last = offset(node + 1);
        bool any = false, any_unlinked = false;
        const Point3 place = first < last ? load_row(places, s.nodes(node)) : Point3{};
        for (int c = first; c < last; ++c) {
          const SeenFace& one = seen(face(c));
          const double capture = one.capture + approach, apart = find_offset(s.offsets, node, face(c));
          const Nearness own = find_nearness(one, place, capture + near_slack * (capture + apart), apart);
          nearness(c) = own != ever && is_in_history(history, node, face(c)) ? ever : own;
          any = any || nearness(c) == ever;
          any_unlinked = any_unlinked || nearness(c) == unlinked;
        }
        if (any && any_unlinked) link_histories(s, face, nearness, first, last);
        count(node) = 0;
        for (int c = first; c < last; ++c) count(node) += nearness(c) >= with_history ? 1 : 0;
      });
  Kokkos::parallel_scan(
      "contact::near_offset", RangeOf<Space>(space, 0, surface.num_nodes + 1),
      KOKKOS_LAMBDA(int n, int& place, bool final_pass) {
        if (final_pass) near_offset(n) = place;
        if (n < s.num_nodes) place += count(n);
      },
      near.num_pairs);
  if (near.num_pairs > most) return false;
  const bool has_thickness = surface.offsets.largest > 0;
  reserve(near.face, near.num_pairs);
  if (has_thickness) reserve(near.with_history, near.num_pairs);
  const Array<int> near_face = near.face, flag = near.with_history;
  Kokkos::parallel_for(
      "contact::list_near_pairs", RangeOf<Space>(space, 0, surface.num_nodes), KOKKOS_LAMBDA(int node) {
        int place = near_offset(node);
        for (int c = offset(node); c < offset(node + 1); ++c) {
          if (nearness(c) < with_history) continue;
          if (has_thickness) flag(place) = nearness(c) == with_history ? 1 : 0;
          near_face(place++) = face(c);
        }
      });
  list_concerned(space, surface, scratch.concerned, near);
  return true;
}

#define PERCUSS_INSTANTIATE(Space)                                                                                 \
  template bool list_near_pairs(const Space&, const ContactSurface&, const Rows3<const double>&, const FaceState&, \
                                const Array<const int>&, const CandidateList&, double, double, NearScratch&,       \
                                CandidateList&);
PERCUSS_INSTANTIATE(ExecSpace)
#if defined(PERCUSS_SMALL_SPACE)
PERCUSS_INSTANTIATE(SmallSpace)
#endif
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
