#include "src/step/audit.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/core/host_copy.hpp"

namespace percuss {

namespace {

enum Sum { kinetic, potential, px, py, pz, lx, ly, lz, momentum_size, moment_size };

/// Sum over chunks, in their order, of the element energies.
std::array<double, 3> sum_element_work(const State& state) {
  const auto work = to_host(state.results.work);
  std::array<double, 3> sum{};
  for (std::size_t c = 0; c < work.extent(0); ++c) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += work(c, k);
  }
  return sum;
}

double find_length(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

}  // namespace

Audit::Audit(const Model& model) : model_(model), sum_("percuss::audit", model.node_count) {}

AuditResult Audit::operator()(const State& state) {
  const auto x = state.x, v = state.v, slot_force = state.slot_force, start = model_.start;
  const auto nodes_to_slots = model_.nodes_to_slots;
  const auto mass = model_.mass;
  const auto inverse_mass = model_.inverse_mass;
  const auto gravity = model_.gravity;
  const double dt_mean = state.step == 0 ? 0.0 : 0.5 * (state.dt + state.next_dt);
  const Kokkos::Array<double, 3> center{{model_.mass_center[0], model_.mass_center[1], model_.mass_center[2]}};
  const auto sums = sum_(
      ExecSpace(), KOKKOS_LAMBDA(const int n, Kokkos::Array<double, 10>& sum) {
        double f[3] = {mass(n) * gravity.g[0], mass(n) * gravity.g[1], mass(n) * gravity.g[2]};
        for (int i = nodes_to_slots.first(n); i < nodes_to_slots.first(n + 1); ++i) {
          for (int k = 0; k < 3; ++k) f[k] += slot_force(nodes_to_slots.slots(i), k);
        }
        const double m = mass(n);
        const double p[3] = {m * v(n, 0), m * v(n, 1), m * v(n, 2)};
        const double r[3] = {x(n, 0) - center[0], x(n, 1) - center[1], x(n, 2) - center[2]};
        for (int k = 0; k < 3; ++k) {
          const double change = inverse_mass(n, k) > 0 ? dt_mean * f[k] : 0;  // a held direction goes its own way
          sum[kinetic] += 0.5 * v(n, k) * (p[k] + change);
          sum[potential] += m * gravity.g[k] * (x(n, k) - start(n, k));
          sum[px + k] += p[k];
        }
        const double l[3] = {r[1] * p[2] - r[2] * p[1], r[2] * p[0] - r[0] * p[2], r[0] * p[1] - r[1] * p[0]};
        for (int k = 0; k < 3; ++k) sum[lx + k] += l[k];
        sum[momentum_size] += sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        sum[moment_size] += sqrt((r[0] * r[0] + r[1] * r[1] + r[2] * r[2]) * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
      });
  const auto work = sum_element_work(state);
  AuditResult result;
  EnergySummary& e = result.energy;
  e.kinetic = sums[kinetic];
  e.internal = work[0];
  e.hourglass = work[1];
  e.viscous = work[2];
  e.contact = state.books.contact_work;
  e.friction = state.books.friction_work;
  e.external = state.books.external_work + sums[potential];
  const double held = e.kinetic + e.internal + e.hourglass + e.viscous;
  if (!started_) {
    started_ = true;
    initial_energy_ = held - e.external - e.contact - e.friction;
    for (std::size_t k = 0; k < 3; ++k) {
      initial_momentum_[k] = sums[px + k] - state.books.impulse[k];
      initial_moment_[k] = sums[lx + k] - state.books.moment_impulse[k];
    }
  }
  e.initial = initial_energy_;
  largest_energy_ = std::max({largest_energy_, std::abs(initial_energy_), held});
  if (largest_energy_ > 0) {
    e.error = (held - e.external - e.contact - e.friction - initial_energy_) / largest_energy_;
  }

  MomentumSummary& m = result.momentum;
  double linear[3], angular[3];
  for (std::size_t k = 0; k < 3; ++k) {
    m.linear[k] = sums[px + k];
    m.angular[k] = sums[lx + k];
    linear[k] = sums[px + k] - state.books.impulse[k] - initial_momentum_[k];
    angular[k] = sums[lx + k] - state.books.moment_impulse[k] - initial_moment_[k];
  }
  momentum_scale_ = std::max(momentum_scale_, sums[momentum_size]);
  moment_scale_ = std::max(moment_scale_, sums[moment_size]);
  if (momentum_scale_ > 0) m.linear_error = find_length(linear[0], linear[1], linear[2]) / momentum_scale_;
  if (moment_scale_ > 0) m.angular_error = find_length(angular[0], angular[1], angular[2]) / moment_scale_;
  return result;
}

}  // namespace percuss
