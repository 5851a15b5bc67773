// Books of mass that comes and goes: nodes that vanish as elements die, and mass that is added during the run.

#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/step/audit/books.hpp"
#include "src/step/model/impulses.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// Momentum and energy that nodes with added mass bring: m' - m moves with their velocity, and so does rotary inertia.
struct AddedToNodes {
  Rows3<double> lumped, x, v, start, inverse_mass, w;
  Array<double> mass;
  SpinInertia inertia;
  Gravity gravity, constant_gravity;
  MomentCenter center;
  double dt;
  bool has_spins;

  AddedToNodes(const Model& model, const Rows3<double>& lumped_now, const State& state)
      : lumped(lumped_now),
        x(state.x),
        v(state.v),
        start(model.start),
        inverse_mass(state.inverse_mass),
        w(state.w),
        mass(state.mass),
        inertia(state.spin_inertia()),
        gravity(state.gravity),
        constant_gravity(find_constant_gravity(model)),
        center(model.mass_center),
        dt(state.dt),
        has_spins(model.has_rotations) {}

  /// The kinetic energy is that of the audit (moving_nodes.hpp), in which gravity moves a free direction on. What
  /// gravity did to the node so far, the new mass has not taken part in.
  KOKKOS_INLINE_FUNCTION void add_to(int n, Kokkos::Array<double, AddedMassSum::count>& sum) const {
    using A = AddedMassSum;
    if (mass(n) == 0) return;  // it has vanished
    const double added = lumped(n, 0) - mass(n);
    if (added == 0) return;
    double j[3], r[3], kinetic = 0, fallen = 0;
    for (int k = 0; k < 3; ++k) {
      const double g = gravity.g[k], gained = inverse_mass(n, k) > 0 ? dt * g : 0;
      kinetic += 0.5 * added * v(n, k) * (v(n, k) + gained);
      fallen += added * constant_gravity.g[k] * (x(n, k) - start(n, k));
      j[k] = added * v(n, k);
      r[k] = x(n, k) - center.at[k];
      sum[A::first_moment + k] += added * r[k];
    }
    add_impulse(r, j, A::impulse, [&](int k, double value) { sum[k] += value; });
    const double turning = has_spins && inertia.number(n) > 0 ? lumped(n, 1) / inertia.number(n) - 1 : 0;
    if (turning != 0) {
      const Vector3<double> spin{w(n, 0), w(n, 1), w(n, 2)}, gained = turning * inertia.find_momentum(n, spin);
      kinetic += 0.5 * dot(gained, spin);
      for (int k = 0; k < 3; ++k) sum[A::moment + k] += get(gained, k);
    }
    sum[A::mass] += added;
    sum[A::kinetic] += kinetic;
    sum[A::work] += kinetic - fallen;
  }
};

}  // namespace

/// The rotation of a node that vanishes: its energy, and its angular momentum as a moment impulse without a lever.
void Bookkeeper::book_vanished_spins(const ChunkedMesh& chunked, const std::vector<int>& nodes, State& state) const {
  if (!model_.has_rotations) return;
  const auto inertia = to_host(state.inertia);
  const auto w = to_host(state.w);
  for (const int node : nodes) {
    if (!owns_node(chunked, node)) continue;
    const auto n = static_cast<std::size_t>(node);
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      square += w(n, k) * w(n, k);
      state.books.moment_impulse[k].add(-inertia(n) * w(n, k));
    }
    state.books.eroded_kinetic.add(0.5 * inertia(n) * square);
  }
}

void Bookkeeper::book_vanished(const ChunkedMesh& chunked, const std::vector<int>& nodes, State& state) {
  const auto mass = to_host(state.mass);
  const auto x = to_host(state.x), v = to_host(state.v), inverse_mass = to_host(state.inverse_mass);
  const auto start = to_host(model_.start);
  std::array<ExactSum, 6> impulse{};
  std::array<ExactSum, 4> moved{};  // mass and its first moment
  const Gravity constant_gravity = find_constant_gravity(model_);
  for (const int node : nodes) {
    if (!owns_node(chunked, node)) continue;
    const auto n = static_cast<std::size_t>(node);
    double j[3], r[3], kinetic = 0, fallen = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double g = state.gravity.g[k], gained = inverse_mass(n, k) > 0 ? state.dt * g : 0;
      kinetic += 0.5 * mass(n) * v(n, k) * (v(n, k) + gained);
      fallen += mass(n) * constant_gravity.g[k] * (x(n, k) - start(n, k));
      j[k] = -mass(n) * v(n, k);
      r[k] = x(n, k) - model_.mass_center[k];
      moved[1 + k].add(mass(n) * r[k]);
    }
    moved[0].add(mass(n));
    state.books.eroded_kinetic.add(kinetic);
    state.books.external_work.add(fallen);  // what gravity did stays booked
    add_impulse(r, j, 0, [&](int k, double value) { impulse[static_cast<std::size_t>(k)].add(value); });
  }
  book_vanished_spins(chunked, nodes, state);
  add_to_books(impulse, 0, state.books);
  state.books.eroded_kinetic.normalize();
  state.books.external_work.normalize();
  sum_over_ranks(model_.ranks, moved);
  const double before = state.total_mass;
  state.total_mass = before - moved[0].round();
  if (!(state.total_mass > 0)) return;
  for (std::size_t k = 0; k < 3; ++k) {
    center_shift_[k] = (before * center_shift_[k] - moved[1 + k].round()) / state.total_mass;
  }
}

void Bookkeeper::book_added(const Rows3<double>& lumped, State& state) {
  using A = AddedMassSum;
  if (!added_sums_) added_sums_.emplace("percuss::added_mass_sums");
  const AddedToNodes nodes(model_, lumped, state);
  auto sums = (*added_sums_)(
      ExecSpace(), model_.owned_nodes,
      KOKKOS_LAMBDA(const int n, Kokkos::Array<double, A::count>& sum) { nodes.add_to(n, sum); });
  add_work(sums[A::work], state.books);
  add_to_books(sums, A::impulse, state.books);
  auto shared = std::to_array(
      {sums[A::kinetic], sums[A::mass], sums[A::first_moment], sums[A::first_moment + 1], sums[A::first_moment + 2]});
  sum_over_ranks(model_.ranks, shared);
  const double before = state.total_mass, added = shared[1].round();
  state.books.added_energy += shared[0].round();
  state.books.added_mass += added;
  state.total_mass = before + added;
  for (std::size_t k = 0; k < 3; ++k) {
    center_shift_[k] = (before * center_shift_[k] + shared[2 + k].round()) / state.total_mass;
  }
}

}  // namespace percuss
