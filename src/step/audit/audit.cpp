#include "src/step/audit/audit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/index.hpp"
#include "src/step/model/moving_nodes.hpp"
#include "src/step/rigid/rigid_sums.hpp"

namespace percuss {

namespace {

using S = AuditSum;

double find_length(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

void take_out(ExactSum& from, const ExactSum& sum) {
  for (int i = 0; i < ExactSum::limb_count; ++i) from.limb[i] -= sum.limb[i];
  from.normalize();
}

using AuditSums = ExactSums<AuditSum::count_of_nodes>;

AuditSums::Totals sum_audited_nodes(OwnedNodeSums<AuditSum::count_of_nodes>& sums, const Model& model,
                                    const State& state) {
  const MovingNodes nodes = find_translations(model, state);
  const auto x = state.x, v = state.v, start = model.start;
  const auto mass = state.mass;
  const auto inverse_mass = state.inverse_mass;
  const Gravity gravity = find_constant_gravity(model);
  const Array<const int> body_of_node = model.rigid.body_of_node;
  const double first_dt = state.step == 0 ? state.next_dt : 0.0;
  const Kokkos::Array<double, 3> center{{model.mass_center[0], model.mass_center[1], model.mass_center[2]}};
  return sums(
      ExecSpace(), model.owned_nodes, KOKKOS_LAMBDA(const int n, Kokkos::Array<double, S::count_of_nodes>& sum) {
        if (RigidModel::holds(body_of_node, n)) return;
        double f[3];
        nodes.find_force(n, f);
        const double m = mass(n);
        const double p[3] = {m * v(n, 0), m * v(n, 1), m * v(n, 2)};
        const double r[3] = {x(n, 0) - center[0], x(n, 1) - center[1], x(n, 2) - center[2]};
        for (int k = 0; k < 3; ++k) {
          sum[S::kinetic] += nodes.find_energy(n, k, f[k]);
          sum[S::half_steps] += 0.125 * inverse_mass(n, k) * (first_dt * f[k]) * (first_dt * f[k]);
          sum[S::potential] += m * gravity.g[k] * (x(n, k) - start(n, k));
          sum[S::momentum + k] += p[k];
        }
        const double l[3] = {r[1] * p[2] - r[2] * p[1], r[2] * p[0] - r[0] * p[2], r[0] * p[1] - r[1] * p[0]};
        for (int k = 0; k < 3; ++k) sum[S::angular + k] += l[k];
        sum[S::momentum_size] += sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        sum[S::moment_size] +=
            sqrt((r[0] * r[0] + r[1] * r[1] + r[2] * r[2]) * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
      });
}

/// Adds what the rotations of the nodes of shells hold to the same sums.
void add_spins(OwnedNodeSums<AuditSum::count_of_nodes>& sums, const Model& model, const State& state,
               AuditSums::Totals& totals) {
  if (!model.has_rotations) return;
  const MovingNodes nodes = find_rotations(model, state);
  const auto w = state.w;
  const SpinInertia inertia = state.spin_inertia();
  const double first_dt = state.step == 0 ? state.next_dt : 0.0, half = state.step == 0 ? 0.0 : 0.5 * state.dt;
  const Array<const int> body_of_node = model.rigid.body_of_node;
  const auto of_spins = sums(
      ExecSpace(), model.owned_nodes, KOKKOS_LAMBDA(const int n, Kokkos::Array<double, S::count_of_nodes>& sum) {
        if (RigidModel::holds(body_of_node, n)) return;
        double size = 0, moment[3];
        nodes.find_force(n, moment);
        const Vector3<double> answer =
            inertia.find_change(n, {first_dt * moment[0], first_dt * moment[1], first_dt * moment[2]});
        const Vector3<double> momentum = inertia.find_momentum(n, {w(n, 0), w(n, 1), w(n, 2)}, half);
        for (int k = 0; k < 3; ++k) {
          const double spin = get(momentum, k);
          sum[S::kinetic] += nodes.find_energy(n, k, moment[k]);
          sum[S::half_steps] += 0.125 * get(answer, k) * (first_dt * moment[k]);
          sum[S::angular + k] += spin;
          size += spin * spin;
        }
        sum[S::moment_size] += sqrt(size);
      });
  for (std::size_t i = 0; i < totals.size(); ++i) totals[i].merge(of_spins[i]);
}

/// Share of the forces that hold each other: a scene at rest has no momentum and no energy, and its balances are
/// round-off of what they amount to.
constexpr double rest_share = 1e-6;

/// Sums of the magnitudes of the forces of joints.
struct JointScale {
  double force = 0, moment = 0;  // the latter about the mass centre of the scene
};

JointScale find_joint_scale(const Model& model, const State& state, const std::vector<BodyForces>& forces) {
  JointScale scale;
  for (std::size_t b = 0; b < forces.size(); ++b) {
    const double arm = norm(state.bodies[b].center - to_vector(model.mass_center)) + model.rigid.bodies[b].radius;
    scale.force += rest_share * norm(forces[b].joint.impulse);
    scale.moment += rest_share * (norm(forces[b].joint.impulse) * arm + norm(forces[b].joint.moment));
  }
  return scale;
}

/// Adds the rigid bodies, which every rank knows, on the first one. forces: on each.
void add_rigid_bodies(const std::vector<BodyForces>& forces, const Model& model, const State& state,
                      AuditSums::Totals& totals) {
  if (model.ranks.rank() != 0) return;
  for (std::size_t b = 0; b < forces.size(); ++b) {
    const RigidSums body = sum_rigid_body(model, state, b, forces[b]);
    totals[S::kinetic].add(body.kinetic);
    totals[S::half_steps].add(body.half_steps);
    totals[S::potential].add(body.fallen);
    for (int k = 0; k < 3; ++k) {
      totals[at(S::momentum + k)].add(get(body.momentum, k));
      totals[at(S::angular + k)].add(get(body.angular, k));
    }
    totals[S::momentum_size].add(body.momentum_size);
    totals[S::moment_size].add(body.angular_size);
  }
}

/// Mass of the nodes of this rank that have vanished: where they may, masses are the state's own.
ExactSum sum_vanished_mass(const Model& model, const State& state) {
  if (state.mass.data() == model.mass.data()) return {};
  const auto left = state.mass, before = state.lumped_mass;
  return OwnedNodeSums<1>("percuss::vanished_mass")(
      ExecSpace(), model.owned_nodes,
      KOKKOS_LAMBDA(const int n, Kokkos::Array<double, 1>& mass) { mass[0] += before(n) - left(n); })[0];
}

}  // namespace

void AuditResult::archive(CheckpointArchive& archive) {
  EnergySummary& e = energy;
  double energies[] = {e.initial, e.kinetic, e.contact, e.friction, e.damping, e.external, e.error};
  archive.numbers("audited/energy", energies);
  archive.numbers("audited/work", e.work);
  e = {energies[0], energies[1], e.work, energies[2], energies[3], energies[4], energies[5], energies[6]};
  archive.numbers("audited/linear", momentum.linear);
  archive.numbers("audited/angular", momentum.angular);
  archive.number("audited/linear_error", momentum.linear_error);
  archive.number("audited/angular_error", momentum.angular_error);
  archive.number("audited/eroded_elements", eroded.elements);
  archive.number("audited/eroded_mass", eroded.mass);
  archive.number("audited/eroded_energy", eroded.energy);
  archive.number("audited/vanished_mass", eroded.vanished_mass);
}

Audit::Audit(const Model& model) : model_(model), rigid_forces_(model) {}

Audit::Totals Audit::sum_all(const State& state) {
  std::array<ExactSum, S::count> sums{};
  auto of_nodes = sum_audited_nodes(node_sums_, model_, state);
  add_spins(node_sums_, model_, state, of_nodes);
  if (model_.rigid.any()) {
    const std::vector<BodyForces> forces = rigid_forces_(state);
    add_rigid_bodies(forces, model_, state, of_nodes);
    const JointScale scale = find_joint_scale(model_, state, forces);
    largest_energy_ = std::max(largest_energy_, scale.moment);
    momentum_scale_ = std::max(momentum_scale_, scale.force * state.time);
    moment_scale_ = std::max(moment_scale_, scale.moment * state.time);
  }
  const double* g = state.gravity.g;
  const double weight = rest_share * state.total_mass * find_length(g[0], g[1], g[2]);
  momentum_scale_ = std::max(momentum_scale_, weight * state.time);
  moment_scale_ = std::max(moment_scale_, weight * state.time * model_.half_extent);
  std::copy(of_nodes.begin(), of_nodes.end(), sums.begin());
  const auto work = to_host(state.results.work);
  for (std::size_t c = 0; c < work.extent(0); ++c) {
    for (std::size_t k = 0; k < work_kinds; ++k) sums[S::work + k].add(work(c, k));
  }
  constexpr int first_work = S::work;
  if (model_.ranks.rank() == 0) {  // what all ranks know
    for (const double work : state.books.stored_by_actions()) sums[at(first_work + WorkKind::internal)].add(work);
    for (const double work : state.books.taken_by_actions()) sums[at(first_work + WorkKind::viscous)].add(work);
  }
  sums[S::damping] = state.books.damping_work;
  sums[S::external] = state.books.external_work;
  std::copy_n(state.books.impulse, 3, sums.begin() + S::impulse);
  std::copy_n(state.books.moment_impulse, 3, sums.begin() + S::moment_impulse);
  const Books& books = state.books;
  std::copy_n(books.eroded_work, work_kinds, sums.begin() + S::eroded_work);
  sums[S::eroded_kinetic] = books.eroded_kinetic;
  sums[S::eroded_mass] = books.eroded_mass;
  for (std::size_t k = 0; k < work_kinds; ++k) take_out(sums[S::work + k], books.eroded_work[k]);
  sums[S::vanished_mass] = sum_vanished_mass(model_, state);
  sum_over_ranks(model_.ranks, sums);
  Totals totals{};
  for (std::size_t i = 0; i < S::count; ++i) totals[i] = sums[i].round();
  return totals;
}

void Audit::note_scale(double energy, double reach) {
  const double momentum = std::sqrt(2 * model_.total_mass * std::max(energy, 0.0));
  momentum_scale_ = std::max(momentum_scale_, momentum);
  moment_scale_ = std::max(moment_scale_, momentum * reach);
}

/// Energy that left with eroded elements and nodes.
double Audit::sum_gone(const Totals& totals) {
  double gone = 0;
  for (std::size_t k = 0; k < work_kinds; ++k) gone += totals[S::eroded_work + k];
  return gone + totals[S::eroded_kinetic];
}

void Audit::note_start(const State& state, const Totals& totals, double held) {
  if (started_) return;
  started_ = true;
  start_half_steps_ = totals[S::half_steps];
  initial_energy_ = held - totals[S::external] - totals[S::potential] - totals[S::damping] - state.books.contact_work -
                    state.books.friction_work;
  for (std::size_t k = 0; k < 3; ++k) {
    initial_momentum_[k] = totals[S::momentum + k] - totals[S::impulse + k];
    initial_moment_[k] = totals[S::angular + k] - totals[S::moment_impulse + k];
  }
}

EnergySummary Audit::balance_energy(const State& state, const Totals& totals, double wall_energy) {
  EnergySummary e;
  e.kinetic = totals[S::kinetic] + wall_energy;
  std::copy_n(totals.begin() + S::work, work_kinds, e.work.begin());
  e.contact = state.books.contact_work;
  e.friction = state.books.friction_work;
  e.damping = totals[S::damping];
  e.external = totals[S::external] + totals[S::potential];
  const double gone = sum_gone(totals);
  const double held = std::accumulate(e.work.begin(), e.work.end(), e.kinetic) + gone;
  const double balanced = held - totals[S::half_steps];
  note_start(state, totals, balanced);
  e.initial = initial_energy_;
  // A gas that expands gives its energy away: then what moves is more than what is held besides.
  largest_energy_ = std::max({largest_energy_, std::abs(initial_energy_), held, e.kinetic});
  largest_strain_energy_ = std::max(largest_strain_energy_, e.internal() + e.hourglass());
  if (largest_energy_ > 0) {
    e.error = (balanced - e.external - e.contact - e.friction - e.damping - initial_energy_) / largest_energy_;
  }
  return e;
}

MomentumSummary Audit::balance_momentum(const Totals& totals) {
  MomentumSummary m;
  double linear[3], moment[3];
  for (std::size_t k = 0; k < 3; ++k) {
    m.linear[k] = totals[S::momentum + k];
    m.angular[k] = totals[S::angular + k];
    linear[k] = totals[S::momentum + k] - totals[S::impulse + k] - initial_momentum_[k];
    moment[k] = totals[S::angular + k] - totals[S::moment_impulse + k] - initial_moment_[k];
  }
  momentum_scale_ = std::max(momentum_scale_, totals[S::momentum_size]);
  moment_scale_ = std::max(moment_scale_, totals[S::moment_size]);
  if (momentum_scale_ > 0) m.linear_error = find_length(linear[0], linear[1], linear[2]) / momentum_scale_;
  if (moment_scale_ > 0) m.angular_error = find_length(moment[0], moment[1], moment[2]) / moment_scale_;
  return m;
}

void Audit::archive(CheckpointArchive& archive) {
  archive.integer("audit/started", started_);
  archive.number("audit/initial_energy", initial_energy_);
  archive.number("audit/start_half_steps", start_half_steps_);
  archive.number("audit/largest_energy", largest_energy_);
  archive.number("audit/largest_strain_energy", largest_strain_energy_);
  archive.numbers("audit/initial_momentum", initial_momentum_);
  archive.numbers("audit/initial_moment", initial_moment_);
  archive.number("audit/momentum_scale", momentum_scale_);
  archive.number("audit/moment_scale", moment_scale_);
}

AuditResult Audit::operator()(const State& state, double wall_energy) {
  const Totals totals = sum_all(state);
  AuditResult result;
  result.energy = balance_energy(state, totals, wall_energy);
  result.momentum = balance_momentum(totals);
  result.eroded = {state.books.eroded_elements, totals[S::eroded_mass], sum_gone(totals), totals[S::vanished_mass]};
  return result;
}

}  // namespace percuss
