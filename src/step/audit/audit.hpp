#pragma once
// The audit of a state: energies and momentum at consistent times.
//
// With velocities at n-1/2 and forces at n, the energy that central differences conserve has the kinetic part
// sum m v(n-1/2) . v*(n+1/2) / 2, v* the velocity predicted without contact; held directions have m v(n-1/2)^2 / 2,
// since the forces on them move nothing. Work terms are those of books.hpp; internal, hourglass and viscous energy come
// from the elements' own stresses and rates, so that the balance is a check and not an identity.

#include <array>

#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/output/summary.hpp"
#include "src/step/model/owned_sums.hpp"
#include "src/step/model/state.hpp"
#include "src/step/rigid/rigid_sums.hpp"

namespace percuss {

struct AuditResult {
  EnergySummary energy;
  MomentumSummary momentum;
  ErodedSummary eroded;

  void archive(CheckpointArchive& archive);
};

/// Everything that an audit sums over nodes, then over chunks, then over the steps so far.
struct AuditSum {
  enum : int {
    kinetic,
    half_steps,  // at time 0 only: what T(0) lacks of sum m v(0)^2 / 2, since v(-1/2) and v(1/2) differ by the forces
    potential,
    momentum,
    angular = momentum + 3,
    momentum_size = angular + 3,
    moment_size,
    count_of_nodes,
    work = count_of_nodes,  // by WorkKind
    damping = work + work_kinds,
    external,
    impulse,
    moment_impulse = impulse + 3,
    eroded_work = moment_impulse + 3,
    eroded_kinetic = eroded_work + work_kinds,
    eroded_mass,
    vanished_mass,
    count
  };
};

class Audit {
 public:
  explicit Audit(const Model& model);

  /// Energies and momentum of the state, of all ranks, the same on each. wall_energy: kinetic, of walls with a mass.
  /// The first call sets what later ones are compared with. One message a rank. Collective.
  AuditResult operator()(const State& state, double wall_energy = 0);

  /// Sets the scale of a scene that begins at rest under loads, whose balances of momentum are round-off: momentum and
  /// moment that it would have if so much energy moved it. reach: of its nodes from its mass centre [length].
  void note_scale(double energy, double reach);

  /// The largest energy that was held in any state so far, by which errors are measured.
  double largest_energy() const { return largest_energy_; }

  /// The largest energy that elements held in stress and hourglass modes at an audit so far.
  double largest_strain_energy() const { return largest_strain_energy_; }

  /// What the kinetic energy at time 0 lacks because velocities are those half a step before and after: work of the
  /// forces at the start, which contacts that hold from the start take part in.
  double start_half_steps() const { return start_half_steps_; }

  /// Reads or writes the values that audits compare with.
  void archive(CheckpointArchive& archive);

 private:
  using Totals = std::array<double, AuditSum::count>;

  Totals sum_all(const State& state);
  static double sum_gone(const Totals& totals);
  void note_start(const State& state, const Totals& totals, double held);
  EnergySummary balance_energy(const State& state, const Totals& totals, double wall_energy);
  MomentumSummary balance_momentum(const Totals& totals);

  const Model& model_;
  OwnedNodeSums<AuditSum::count_of_nodes> node_sums_{"percuss::audit"};
  BodyForceFinder rigid_forces_;
  bool started_ = false;
  double initial_energy_ = 0, start_half_steps_ = 0;
  double largest_strain_energy_ = 0;
  double largest_energy_ = 0;  // largest of the initial and any later kinetic, or kinetic plus stored, energy
  Vec3 initial_momentum_{}, initial_moment_{};
  double momentum_scale_ = 0, moment_scale_ = 0;  // largest sums of magnitudes so far
};

}  // namespace percuss
