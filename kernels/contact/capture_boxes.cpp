#include "kernels/contact/capture_boxes.hpp"

#include <cstdint>

namespace percuss {
namespace {

KOKKOS_INLINE_FUNCTION FacePoints load_face(const ContactSurface& surface, const Rows3<const double>& x, int face) {
  FacePoints points;
  for (int i = 0; i < 4; ++i) points.corner[i] = load_row(x, surface.nodes(surface.face_corners(face, i)));
  return points;
}

}  // namespace

template <class Space>
double find_largest_move(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion) {
  double largest = 0;
  const ContactSurface s = surface;
  const SurfaceMotion m = motion;
  Kokkos::parallel_reduce(
      "contact::largest_move", RangeOf<Space>(space, 0, s.num_nodes),
      KOKKOS_LAMBDA(int n, double& move) { move = larger(move, m.dt * max_component(load_row(m.v, s.nodes(n)))); },
      Kokkos::Max<double>(largest));
  return larger(largest, 0.0);
}

template <class Space>
double find_largest_travel(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion,
                           const Rows3<const double>& origin) {
  double largest = 0;
  const ContactSurface s = surface;
  const SurfaceMotion m = motion;
  Kokkos::parallel_reduce(
      "contact::largest_travel", RangeOf<Space>(space, 0, s.num_nodes),
      KOKKOS_LAMBDA(int n, double& travel) {
        const int a = s.nodes(n);
        const Point3 moved = load_row(m.x, a) - load_row(origin, n);
        travel = larger(travel, max_component(moved) + m.dt * max_component(load_row(m.v, a)));
      },
      Kokkos::Max<double>(largest));
  return larger(largest, 0.0);
}

template <class Space>
void store_places(const Space& space, const ContactSurface& surface, const Rows3<const double>& x,
                  const Rows3<double>& origin) {
  const ContactSurface s = surface;
  Kokkos::parallel_for(
      "contact::store_places", RangeOf<Space>(space, 0, s.num_nodes),
      KOKKOS_LAMBDA(int n) { store_row(origin, n, load_row(x, s.nodes(n))); });
}

template <class Space>
double find_mean_edge(const Space& space, const ContactSurface& surface, const Rows3<const double>& x) {
  // In a fixed order: it sets the width of the boxes, and with it when the next search comes and what it lists.
  constexpr int runs = 64;
  const ContactSurface s = surface;
  if (s.num_faces == 0) return 0;
  const Array<double> partial(Kokkos::view_alloc("contact::edge_sums", Kokkos::WithoutInitializing), runs);
  Kokkos::parallel_for(
      "contact::mean_edge", RangeOf<Space>(space, 0, runs), KOKKOS_LAMBDA(int run) {
        const int first = static_cast<int>(static_cast<std::int64_t>(s.num_faces) * run / runs);
        const int last = static_cast<int>(static_cast<std::int64_t>(s.num_faces) * (run + 1) / runs);
        double edges = 0;
        for (int f = first; f < last; ++f) edges += find_shortest_edge(load_face(s, x, f));
        partial(run) = edges;
      });
  space.fence();
  const auto on_host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), partial);
  double sum = 0;
  for (int run = 0; run < runs; ++run) sum += on_host(run);
  return sum / s.num_faces;
}

template <class Space>
void bound_faces(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion, double margin,
                 const Boxes& boxes) {
  const ContactSurface s = surface;
  const SurfaceMotion m = motion;
  const Boxes out = boxes;
  Kokkos::parallel_for(
      "contact::capture_boxes", RangeOf<Space>(space, 0, static_cast<int>(s.searched_faces.extent(0))),
      KOKKOS_LAMBDA(int i) {
        const int face = s.searched_faces(i);
        const FacePoints points = load_face(s, m.x, face);
        const double reach = margin + contact_limits::capture * find_shortest_edge(points);
        bound_face(s, m, face, reach, out);
      });
}

#define PERCUSS_INSTANTIATE(Space)                                                                                   \
  template double find_largest_move(const Space&, const ContactSurface&, const SurfaceMotion&);                      \
  template double find_largest_travel(const Space&, const ContactSurface&, const SurfaceMotion&,                     \
                                      const Rows3<const double>&);                                                   \
  template void store_places(const Space&, const ContactSurface&, const Rows3<const double>&, const Rows3<double>&); \
  template double find_mean_edge(const Space&, const ContactSurface&, const Rows3<const double>&);                   \
  template void bound_faces(const Space&, const ContactSurface&, const SurfaceMotion&, double, const Boxes&);
PERCUSS_INSTANTIATE(ExecSpace)
#if defined(PERCUSS_SMALL_SPACE)
PERCUSS_INSTANTIATE(SmallSpace)
#endif
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
