#include "kernels/rigid/rigid_nodes.hpp"

#include "kernels/core/small_space.hpp"

namespace percuss {
namespace {

template <class Rows>
KOKKOS_INLINE_FUNCTION Vector3<double> get_row(const Rows& rows, int i) {
  return {rows(i, 0), rows(i, 1), rows(i, 2)};
}

KOKKOS_INLINE_FUNCTION void set_row(const Rows3<double>& rows, int i, const Vector3<double>& a) {
  rows(i, 0) = a.x;
  rows(i, 1) = a.y;
  rows(i, 2) = a.z;
}

KOKKOS_INLINE_FUNCTION Vector3<double> sum_slots(const NodeSlots& nodes_to_slots, const Rows3<const double>& slots,
                                                 int n) {
  Vector3<double> sum{0, 0, 0};
  for (int i = nodes_to_slots.first(n); i < nodes_to_slots.first(n + 1); ++i)
    sum = sum + get_row(slots, nodes_to_slots.slots(i));
  return sum;
}

}  // namespace

void set_rigid_velocities(const ExecSpace& space, const RigidNodes& nodes, const Array<const BodyStep>& bodies,
                          const Rows3<double>& v) {
  const RigidNodes of = nodes;
  parallel_for(
      "percuss::set_rigid_velocities", RangeOf(space, 0, nodes.count), KOKKOS_LAMBDA(const int i) {
        const BodyStep& body = bodies(of.body(i));
        const Vector3<double> arm = get_row(of.arm, i);
        const Vector3<double> middle = 0.5 * (body.rotation * arm + body.next_rotation * arm);
        set_row(v, of.node(i), body.velocity + cross(body.spin, middle));
      });
}

void place_rigid_nodes(const ExecSpace& space, const RigidNodes& nodes, const Array<const BodyStep>& bodies,
                       const Rows3<double>& x) {
  const RigidNodes of = nodes;
  parallel_for(
      "percuss::place_rigid_nodes", RangeOf(space, 0, nodes.count), KOKKOS_LAMBDA(const int i) {
        const BodyStep& body = bodies(of.body(i));
        set_row(x, of.node(i), body.next_center + body.next_rotation * get_row(of.arm, i));
      });
}

void set_rigid_spins(const ExecSpace& space, const RigidNodes& nodes, const Array<const BodyStep>& bodies,
                     const Rows3<double>& w) {
  const RigidNodes of = nodes;
  parallel_for(
      "percuss::set_rigid_spins", RangeOf(space, 0, nodes.count),
      KOKKOS_LAMBDA(const int i) { set_row(w, of.node(i), bodies(of.body(i)).spin); });
}

void sum_rigid_forces(const ExecSpace& space, const RigidLoads& loads, const NodalForces& forces,
                      const std::vector<Vector3<double>>& centers, ExactSums<6>& memory, std::vector<ExactSum>& sums) {
  sums.assign(6 * centers.size(), ExactSum{});
  const Array<const int> node = loads.node;
  const NodalForces of = forces;
  const bool has_moments = forces.moment.extent(0) > 0;
  for (std::size_t b = 0; b < centers.size(); ++b) {
    const int first = loads.first[b];
    const Vector3<double> center = centers[b];
    const auto totals = memory(
        space, loads.first[b + 1] - first, KOKKOS_LAMBDA(const int i, const ExactAdder& add) {
          const int n = node(first + i);
          const Vector3<double> f = sum_slots(of.nodes_to_slots, of.force, n);
          Vector3<double> m = cross(get_row(of.x, n) - center, f);
          if (has_moments) m = m + sum_slots(of.nodes_to_slots, of.moment, n);
          const double values[6] = {f.x, f.y, f.z, m.x, m.y, m.z};
          for (int k = 0; k < 6; ++k) add(k, values[k]);
        });
    for (std::size_t k = 0; k < 6; ++k) sums[6 * b + k] = totals[k];
  }
}

Wrench round_wrench(const std::vector<ExactSum>& sums, std::size_t body) {
  double v[6];
  for (std::size_t k = 0; k < 6; ++k) v[k] = sums[6 * body + k].round();
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

}  // namespace percuss
