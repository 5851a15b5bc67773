#include "kernels/contact/rows/body_rows.hpp"

#include "kernels/contact/rows/row_geometry.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/index_lists.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/rigid/rigid_nodes.hpp"

namespace percuss {
namespace {

/// Six sums over the owned places of each body: add_place(place, response, values).
template <class Add>
std::vector<ExactSum> sum_places(const WorkSpace& space, RowSystem& system, const Add& add_place) {
  RowBodies& bodies = system.bodies;
  std::vector<ExactSum> sums(6 * static_cast<std::size_t>(bodies.count()));
  const Array<const int> places = bodies.places;
  const Array<const BodyResponse> responses = bodies.inputs.responses;
  const int owned = system.num_nodes;
  for (int b = 0; b < bodies.count(); ++b) {
    const auto place = static_cast<std::size_t>(b);
    const int first = bodies.first[place];
    const auto totals =
        bodies.memory(space, bodies.first[place + 1] - first, [=] KOKKOS_FUNCTION(const int i, const ExactAdder& add) {
          if (places(first + i) >= owned) return;  // its owner counts it
          double values[6];
          add_place(places(first + i), responses(b), values);
          for (int k = 0; k < 6; ++k) add(k, values[k]);
        });
    for (std::size_t k = 0; k < 6; ++k) sums[6 * place + k] = totals[k];
  }
  return sums;
}

KOKKOS_INLINE_FUNCTION void store(const Wrench& w, double (&values)[6]) {
  const double all[6] = {w.impulse.x, w.impulse.y, w.impulse.z, w.moment.x, w.moment.y, w.moment.z};
  for (int k = 0; k < 6; ++k) values[k] = all[k];
}

/// Change of velocity of a place by that of its body.
struct PlaceChange {
  Array<const int> of_place;
  Array<const BodyResponse> responses;
  Array<const BodyChange> change;
  Rows3<const double> x;

  explicit PlaceChange(const RowSystem& system)
      : of_place(system.bodies.of_place),
        responses(system.bodies.inputs.responses),
        change(system.bodies.change),
        x(system.at.x) {}
  KOKKOS_FUNCTION Point3 operator()(int place) const {
    const int body = of_place(place);
    return change(body).at(load_row(x, place) - responses(body).center);
  }
};

KOKKOS_INLINE_FUNCTION bool is_of_bodies(const ContactRow& row, const Array<const int>& of_place) {
  if (is_tie(row) || row.is_held) return false;
  for (int slot = 0; slot < count_nodes(row); ++slot)
    if (of_place(row.place[slot]) < 0) return false;
  return true;
}

/// How fast the gap opened at n-1/2; what moves a wall moved it likewise.
KOKKOS_INLINE_FUNCTION double find_gap_rate_before(const ContactRow& row, const RowNodes& at, double dt) {
  const double predicted = dot(row.gap_gradient, find_work_velocity(row, TouchedVelocity{at.v, row}));
  const double before = dot(row.gap_gradient, find_work_velocity(row, TouchedVelocity{at.v_before, row}));
  return before + ((row.gap - row.gap_start) / dt - predicted);
}

KOKKOS_INLINE_FUNCTION double divide(double a, double b) { return b > 0 ? a / b : 0; }

}  // namespace

void start_bodies(const WorkSpace& space, const BodyInputs& inputs, RowSystem& system) {
  RowBodies& bodies = system.bodies;
  bodies.inputs = inputs;
  if (inputs.count == 0) return;
  reserve(bodies.of_place, system.num_places());
  reserve(bodies.change, inputs.count);
  const Array<int> of_place = bodies.of_place;
  const BodyInputs in = inputs;
  const Array<const int> nodes = system.nodes;
  const RowNodes at = system.at;
  parallel_for(
      "contact::mark_bodies", RangeOf(space, 0, system.num_nodes), KOKKOS_LAMBDA(int a) {
        const int body = in.of_node(nodes(a));
        of_place(a) = body;
        if (body < 0) return;
        const BodyResponse& response = in.responses(body);
        store_row(at.inverse_mass, a, find_compliance(response, load_row(at.x, a) - response.center));
        if (at.growth.extent(0) > 0) at.growth(a) = response.growth;
      });
}

void list_body_places(const WorkSpace& space, RowSystem& system) {
  RowBodies& bodies = system.bodies;
  const int num_places = system.num_places(), count = bodies.count();
  for (Array<int>* list : {&bodies.places, &bodies.key, &bodies.index}) reserve(*list, num_places);
  reserve(bodies.size, count);
  reserve(bodies.offset, count + 1);
  const Array<int> key = bodies.key, index = bodies.index;
  const Array<const int> of_place = bodies.of_place;
  parallel_for(
      "contact::list_body_places", RangeOf(space, 0, num_places), KOKKOS_LAMBDA(int a) {
        key(a) = of_place(a) < 0 ? count : of_place(a);
        index(a) = a;
      });
  group_by_key(space, {num_places, key, index, count}, {bodies.size, bodies.offset, bodies.places});
  space.fence();
  const auto offset = to_host(bodies.offset);
  bodies.first.assign(offset.data(), offset.data() + count + 1);
}

std::vector<ExactSum> sum_body_coefficients(const WorkSpace& space, RowSystem& system) {
  const Rows3<const double> sum = system.abs_sum, x = system.at.x;
  return sum_places(space, system, [=] KOKKOS_FUNCTION(int a, const BodyResponse& body, double(&values)[6]) {
    const Point3 s = load_row(sum, a);
    store({s, bound_cross(find_abs(load_row(x, a) - body.center), s)}, values);
  });
}

void spread_body_coefficients(const WorkSpace& space, const std::vector<ExactSum>& sums, RowSystem& system) {
  RowBodies& bodies = system.bodies;
  std::vector<Wrench> totals;
  totals.reserve(static_cast<std::size_t>(bodies.count()));
  for (int b = 0; b < bodies.count(); ++b) totals.push_back(round_wrench(sums, static_cast<std::size_t>(b)));
  const Array<const Wrench> total = to_view("contact::body_coefficients", totals);
  const Array<const int> places = bodies.places, of_place = bodies.of_place;
  const Array<const BodyResponse> responses = bodies.inputs.responses;
  const Rows3<double> sum = system.abs_sum;
  const Rows3<const double> x = system.at.x, compliance = system.at.inverse_mass;
  parallel_for(
      "contact::spread_body_coefficients", RangeOf(space, 0, bodies.first.back()), KOKKOS_LAMBDA(int i) {
        const int a = places(i), b = of_place(a);
        const BodyResponse& body = responses(b);
        const Point3 w = load_row(compliance, a), m = body.inverse_mass, s = total(b).impulse;
        const Point3 turned = bound_cross(find_abs(load_row(x, a) - body.center),
                                          find_abs_tensor(body.inverse_inertia) * total(b).moment);
        const Point3 share = Point3{m.x * s.x, m.y * s.y, m.z * s.z} + turned;
        store_row(sum, a, Point3{divide(share.x, w.x), divide(share.y, w.y), divide(share.z, w.z)});
      });
  space.fence();
}

void hold_rows_within_bodies(const WorkSpace& space, RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const Array<const int> of_place = system.bodies.of_place;
  const Array<int> wants = system.wants;
  parallel_for(
      "contact::hold_rows_within_bodies", RangeOf(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        ContactRow& row = rows(r);
        const int body = of_place(row.place[0]);
        if (body < 0 || row.kind == RowKind::wall) return;
        for (int slot = 1; slot < count_nodes(row); ++slot)
          if (of_place(row.place[slot]) != body) return;
        row.slide[0] = row.slide[1] = 0;
        if (is_tie(row)) row.gap = 0;
        hold_row(row);
        wants(r) = 0;
      });
}

void mark_rigid_rows(const WorkSpace& space, const RowInputs& inputs, RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const Array<const int> of_place = system.bodies.of_place;
  const RowNodes at = system.at;
  const double dt = inputs.motion.dt, restitution = inputs.restitution;
  parallel_for(
      "contact::mark_rigid_rows", RangeOf(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        ContactRow& row = rows(r);
        if (!is_of_bodies(row, of_place)) return;
        row.is_rigid = true;
        if (!(row.gap < row.target)) return;
        const double parting = -restitution * find_gap_rate_before(row, at, dt);
        const double reflected = row.gap_start + dt * parting;
        if (parting > 0 && reflected > row.target) row.target = reflected;
      });
}

std::vector<ExactSum> sum_body_impulses(const WorkSpace& space, RowSystem& system) {
  const ShareSums impulses(system);
  const Rows3<const double> x = system.at.x;
  return sum_places(space, system, [=] KOKKOS_FUNCTION(int a, const BodyResponse& body, double(&values)[6]) {
    store(find_wrench(load_row(x, a) - body.center, impulses(a)), values);
  });
}

void set_body_changes(const std::vector<ExactSum>& sums, RowSystem& system) {
  RowBodies& bodies = system.bodies;
  const auto count = static_cast<std::size_t>(bodies.count());
  const auto responses = to_host(bodies.inputs.responses);
  const auto change = Kokkos::create_mirror_view(bodies.change);
  bodies.wrench.resize(count);
  for (std::size_t b = 0; b < count; ++b) {
    bodies.wrench[b] = round_wrench(sums, b);
    change(b) = find_change(responses(b), bodies.wrench[b]);
  }
  copy_values(bodies.change, change);
}

void move_packed_body_places(const WorkSpace& space, double beta, const RowSystem& system) {
  const RowPacks p = system.packs;
  const Array<const int> places = system.bodies.places;
  const PlaceChange change(system);
  const Rows3<double> correction = system.correction;
  parallel_for(
      "contact::move_packed_body_places", RangeOf(space, 0, system.bodies.first.back()), KOKKOS_LAMBDA(int i) {
        const int a = places(i);
        const Point3 before = load_row(correction, a), dv = change(a);
        store_row(correction, a, dv);
        set_dv(p, a, extrapolate(dv, before, beta));
      });
}

void move_body_places(const WorkSpace& space, const RowSystem& system) {
  const Array<const int> places = system.bodies.places;
  const PlaceChange change(system);
  const Rows3<double> correction = system.correction;
  parallel_for(
      "contact::move_body_places", RangeOf(space, 0, system.bodies.first.back()), KOKKOS_LAMBDA(int i) {
        const int a = places(i);
        store_row(correction, a, change(a));
      });
}

}  // namespace percuss
