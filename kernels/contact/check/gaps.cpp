#include "kernels/contact/check/gaps.hpp"

#include "kernels/contact/surface/offset_faces.hpp"

namespace percuss {
namespace {

constexpr double no_gap = -1;

KOKKOS_INLINE_FUNCTION double find_gap(const ContactSurface& surface, const SurfaceMotion& motion,
                                       const FaceState& faces, int node, int face) {
  if (surface.node_body(node) == surface.face_body(face)) return no_gap;
  const RelativeFace relative = load_touched_face(surface, motion, faces, node, face);
  const FacePoint closest = find_closest_point(relative.start);
  if (closest.distance <= contact_limits::overlap * faces.size(face)) return 0;
  const double behind = dot(load_row(faces.normal, face), interpolate(relative.start, closest.weight));
  return behind <= contact_limits::overlap * faces.size(face) ? closest.distance : no_gap;
}

}  // namespace

template <class Space>
void find_gaps(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion,
               const CandidateList& candidates, const FaceState& faces, Array<double>& gaps) {
  reserve(gaps, candidates.num_pairs);
  const Array<double> out = gaps;
  const ContactSurface s = surface;
  const SurfaceMotion m = motion;
  const FaceState f = faces;
  const Array<const int> nodes = candidates.nodes, offset = candidates.offset, face = candidates.face;
  Kokkos::parallel_for(
      "contact::gaps", RangeOf<Space>(space, 0, candidates.num_nodes), KOKKOS_LAMBDA(int i) {
        for (int c = offset(nodes(i)); c < offset(nodes(i) + 1); ++c) out(c) = find_gap(s, m, f, nodes(i), face(c));
      });
  space.fence();
}

#define PERCUSS_INSTANTIATE(Space)                                                                         \
  template void find_gaps(const Space&, const ContactSurface&, const SurfaceMotion&, const CandidateList&, \
                          const FaceState&, Array<double>&);
PERCUSS_INSTANTIATE(ExecSpace)
#if defined(PERCUSS_SMALL_SPACE)
PERCUSS_INSTANTIATE(SmallSpace)
#endif
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
