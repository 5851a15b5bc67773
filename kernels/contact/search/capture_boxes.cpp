#include "kernels/contact/search/capture_boxes.hpp"

#include <cstdint>

namespace percuss {
namespace {

KOKKOS_INLINE_FUNCTION FacePoints load_face(const Rows4<const int>& corners, const Rows3<const double>& x, int face) {
  FacePoints points;
  for (int i = 0; i < 4; ++i) points.corner[i] = load_row(x, corners(face, i));
  return points;
}

/// Largest value(i) of the first `count`; 0 of none.
template <class Value>
double find_largest_value(const char* name, const WorkSpace& space, std::size_t count, const Value& value) {
  double largest = 0;
  parallel_reduce(
      name, RangeOf(space, 0, static_cast<int>(count)),
      KOKKOS_LAMBDA(int i, double& most) { most = larger(most, value(i)); }, Kokkos::Max<double>(largest));
  return larger(largest, 0.0);
}

/// Displacement of node i of `nodes` from its place in `origin`, at n and at its predicted place.
struct Travels {
  Array<const int> nodes;
  SurfaceMotion motion;
  Rows3<const double> origin;

  template <class Measure>
  KOKKOS_INLINE_FUNCTION double find_larger(int i, const Measure& measure) const {
    const int a = nodes(i);
    const Point3 moved = load_row(motion.x, a) - load_row(origin, i);
    return larger(measure(moved), measure(moved + motion.dt * load_row(motion.v, a)));
  }
};

}  // namespace

double find_largest_move(const WorkSpace& space, const Array<const int>& nodes, const SurfaceMotion& motion) {
  const SurfaceMotion m = motion;
  const Array<const int> list = nodes;
  return find_largest_value("contact::largest_move", space, list.extent(0),
                            [m, list] KOKKOS_FUNCTION(int n) { return m.dt * max_component(load_row(m.v, list(n))); });
}

double find_largest_travel(const WorkSpace& space, const Array<const int>& nodes, const SurfaceMotion& motion,
                           const Rows3<const double>& origin) {
  const Travels travels{nodes, motion, origin};
  return find_largest_value("contact::largest_travel", space, nodes.extent(0), [travels] KOKKOS_FUNCTION(int n) {
    return travels.find_larger(n, [](const Point3& travel) { return max_component(travel); });
  });
}

double find_largest_distance(const WorkSpace& space, const Array<const int>& nodes, const SurfaceMotion& motion,
                             const Rows3<const double>& origin) {
  const Travels travels{nodes, motion, origin};
  return std::sqrt(
      find_largest_value("contact::largest_distance", space, nodes.extent(0), [travels] KOKKOS_FUNCTION(int n) {
        return travels.find_larger(n, [](const Point3& travel) { return dot(travel, travel); });
      }));
}

double find_largest_step(const WorkSpace& space, const Array<const int>& nodes, const SurfaceMotion& motion) {
  const SurfaceMotion m = motion;
  const Array<const int> list = nodes;
  return std::sqrt(
      find_largest_value("contact::largest_step", space, nodes.extent(0), [m, list] KOKKOS_FUNCTION(int n) {
        const Point3 way = m.dt * load_row(m.v, list(n));
        return dot(way, way);
      }));
}

void store_places(const WorkSpace& space, const Array<const int>& nodes, const Rows3<const double>& x,
                  const Rows3<double>& origin) {
  const Array<const int> list = nodes;
  const Rows3<double> out = origin;
  const Rows3<const double> places = x;
  parallel_for(
      "contact::store_places", RangeOf(space, 0, static_cast<int>(list.extent(0))),
      KOKKOS_LAMBDA(int n) { store_row(out, n, load_row(places, list(n))); });
}

ExactSum sum_shortest_edges(const WorkSpace& space, const Rows4<const int>& corners, const Rows3<const double>& x) {
  // Exact, because it sets the width of the boxes, and with it when the next search comes and what it lists.
  const Rows4<const int> list = corners;
  const Rows3<const double> places = x;
  ExactSums<1> sum("contact::edge_sums");
  return sum(space, static_cast<int>(list.extent(0)), [list, places] KOKKOS_FUNCTION(int f, const ExactAdder& add) {
    add(0, find_shortest_edge(load_face(list, places, f)));
  })[0];
}

void bound_faces(const WorkSpace& space, const BoundedFaces& faces, const SurfaceMotion& motion, double margin,
                 const Boxes& boxes) {
  const Rows4<const int> list = faces.corners;
  const Array<const double> offset = faces.offset;
  const bool has_offsets = offset.extent(0) > 0;
  const SurfaceMotion m = motion;
  const Boxes out = boxes;
  parallel_for(
      "contact::capture_boxes", RangeOf(space, 0, static_cast<int>(list.extent(0))), KOKKOS_LAMBDA(int face) {
        const double wider = has_offsets ? margin + offset(face) : margin;
        const double reach = wider + contact_limits::capture * find_shortest_edge(load_face(list, m.x, face));
        bound_face(
            m, [&](int i) { return list(face, i); }, reach, out, face);
      });
}

}  // namespace percuss
