#include "kernels/contact/detailed_check.hpp"

#include "kernels/contact/node_check.hpp"

namespace percuss {
namespace {

/// A box that meets nothing, for faces of which only the normal is read.
KOKKOS_INLINE_FUNCTION void set_empty_box(const Boxes& boxes, int face) {
  constexpr double beyond = 1e300;
  for (int axis = 0; axis < 3; ++axis) {
    boxes(face, axis) = beyond;
    boxes(face, axis + 3) = -beyond;
  }
}

/// Distance from the middle of a face to that of the opposite side of its element.
KOKKOS_INLINE_FUNCTION double find_thickness(const ContactSurface& surface, const Rows3<const double>& x, int face) {
  const double offset = find_face_offset(surface.offsets, face);
  if (offset > 0) return 2 * offset;
  Point3 sum{};
  for (int i = 0; i < 4; ++i)
    sum = sum + (load_row(x, surface.nodes(surface.face_corners(face, i))) - load_row(x, surface.face_backs(face, i)));
  return 0.25 * norm(sum);
}

/// By how much more the box of a face reaches for the thickness of shells.
KOKKOS_INLINE_FUNCTION double find_box_offset(const SurfaceOffsets& offsets, int face) {
  return find_offset_reach(find_face_offset(offsets, face), offsets.largest);
}

/// The candidate faces of a node.
struct NodeCandidates {
  Array<const int> face, with_history;
  bool leaves_out = false;  // those that only a node with a history is checked against

  /// -1: left out.
  KOKKOS_INLINE_FUNCTION int operator()(int c) const { return leaves_out && with_history(c) != 0 ? -1 : face(c); }
};

KOKKOS_INLINE_FUNCTION bool has_history(const Array<const int>& history_face, int node) {
  for (int slot = 0; slot < contact_limits::max_touches; ++slot)
    if (history_face(contact_limits::max_touches * node + slot) >= 0) return true;
  return false;
}

/// Flattened: a pair is checked by some fifty small functions.
template <Thickness thickness>
PERCUSS_FLATTEN KOKKOS_FUNCTION void check_node_flat(const ContactSurface& surface, const SurfaceMotion& motion,
                                                     const FaceState& faces, const Array<const int>& history_face,
                                                     int node, const NodeCandidates& candidates, int first, int last,
                                                     NodeTouches& accepted) {
  check_node<thickness>(surface, motion, faces, history_face, node, candidates, first, last, accepted);
}

/// The first of the candidates first to last - 1 whose box the node meets in the step, or `last`: for most nodes, in
/// most steps, there is none.
KOKKOS_INLINE_FUNCTION int find_first_near(const ContactSurface& surface, const SurfaceMotion& motion,
                                           const FaceState& faces, int node, const NodeCandidates& candidates,
                                           int first, int last) {
  const CheckedNode checked = load_checked_node(surface, motion, node);
  for (; first < last; ++first)
    if (const int face = candidates(first); face >= 0 && is_in_box(checked, faces.box, face)) break;
  return first;
}

}  // namespace

template <class Space>
void update_faces(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion,
                  const CandidateList& candidates, const FaceState& faces) {
  const ContactSurface s = surface;
  const SurfaceMotion m = motion;
  const FaceState out = faces;
  const Array<const int> list = candidates.faces, is_boxed = candidates.is_boxed;
  Kokkos::parallel_for(
      "contact::update_faces", RangeOf<Space>(space, 0, candidates.num_faces), KOKKOS_LAMBDA(int i) {
        const int face = list(i);
        // Relative to the first corner, so that nothing degrades far from the origin of the coordinates.
        const RelativeFace relative = load_relative_face(s, m, s.face_corners(face, 0), face);
        store_row(out.normal, face, find_face_normal(find_end(relative)));
        if (is_boxed(i) == 0) {
          set_empty_box(out.box, face);
          return;
        }
        const double edge = find_shortest_edge(relative.start), thickness = find_thickness(s, m.x, face);
        out.size(face) = edge < thickness ? edge : thickness;
        bound_face(
            m, [&](int corner) { return s.nodes(s.face_corners(face, corner)); },
            contact_limits::capture * out.size(face) + find_box_offset(s.offsets, face), out.box, face);
        if (s.offsets.largest > 0)
          out.slab(face) = find_slab(m, s.nodes(s.face_corners(face, 0)), relative, load_row(out.normal, face));
      });
}

namespace {

template <Thickness thickness, class Space>
void check_nodes(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion,
                 const CandidateList& candidates, const FaceState& faces, const Array<const int>& history_face,
                 const Array<NodeTouches>& by_node) {
  const ContactSurface s = surface;
  const SurfaceMotion m = motion;
  const FaceState f = faces;
  const Array<const int> h = history_face;
  const Array<const int> nodes = candidates.nodes, offset = candidates.offset, face = candidates.face;
  const Array<const int> with_history = candidates.with_history;
  const bool has_marks = with_history.extent(0) > 0;
  Kokkos::parallel_for(
      "contact::detailed_check", RangeOf<Space>(space, 0, candidates.num_nodes), KOKKOS_LAMBDA(int i) {
        const int node = nodes(i);
        const NodeCandidates own{face, with_history, has_marks && !has_history(h, node)};
        const int last = offset(node + 1), first = find_first_near(s, m, f, node, own, offset(node), last);
        if (first == last)
          by_node(i).count = 0;
        else
          check_node_flat<thickness>(s, m, f, h, node, own, first, last, by_node(i));
      });
}

}  // namespace

template <class Space>
void find_touches(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion,
                  const CandidateList& candidates, const FaceState& faces, const Array<const int>& history_face,
                  TouchTable& table) {
  reserve(table.by_node, candidates.num_nodes);
  reserve(table.first, candidates.num_nodes);
  if (surface.offsets.largest > 0)
    check_nodes<Thickness::of_shells>(space, surface, motion, candidates, faces, history_face, table.by_node);
  else
    check_nodes<Thickness::none>(space, surface, motion, candidates, faces, history_face, table.by_node);
  const Array<NodeTouches> by_node = table.by_node;
  const Array<int> place_of_first = table.first;
  Kokkos::parallel_scan(
      "contact::first_touch", RangeOf<Space>(space, 0, candidates.num_nodes),
      KOKKOS_LAMBDA(int i, int& place, bool final_pass) {
        if (final_pass) place_of_first(i) = place;
        place += by_node(i).count;
      },
      table.count);
}

#define PERCUSS_INSTANTIATE(Space)                                                                            \
  template void update_faces(const Space&, const ContactSurface&, const SurfaceMotion&, const CandidateList&, \
                             const FaceState&);                                                               \
  template void find_touches(const Space&, const ContactSurface&, const SurfaceMotion&, const CandidateList&, \
                             const FaceState&, const Array<const int>&, TouchTable&);
PERCUSS_INSTANTIATE(ExecSpace)
#if defined(PERCUSS_SMALL_SPACE)
PERCUSS_INSTANTIATE(SmallSpace)
#endif
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
