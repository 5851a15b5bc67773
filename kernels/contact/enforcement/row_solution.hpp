#pragma once
// From touches to impulses (the paper's section 4.3): the rows of a step and the iteration of their forces, with what
// crosses ranks left to the caller.
//
// Others stands for the other ranks. Its members are called in the order of the paper's section 4.3.2: places of
// foreign nodes come before the rows are made. In each iteration all ranks whose rows touch a node, and its owner, swap
// their forces on it, while the sums that judge convergence are reduced; each of them adds the forces up for itself, in
// the order of their keys.

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/contact/enforcement/coupled_rows.hpp"
#include "kernels/contact/enforcement/enforcement.hpp"
#include "kernels/contact/enforcement/rigid_rows.hpp"
#include "kernels/contact/enforcement/springs.hpp"
#include "kernels/contact/rows/body_rows.hpp"
#include "kernels/contact/rows/row_packs.hpp"

namespace percuss {

/// One rank has all nodes: nothing is sent.
struct OneRank {
  // Whether a rank has rows that this one has a part in; if not, there is nothing to solve here.
  bool takes_part(const RowSystem& system) const { return system.num_rows > 0; }
  // Fills RowSystem::at and RowBodies::of_place at foreign places; lists the remote and the sent entries.
  void receive_nodes(const RowInputs&, const RowSources&, RowSystem&) {}
  void swap_shares(const WorkSpace&, RowSystem&) {}  // fills RowSystem::remote with shares of other ranks' rows
  void swap_shares(const WorkSpace&, RowSystem&, PassSums&) {}  // the same; reduces the sums meanwhile
  void sum_bodies(std::vector<ExactSum>&) {}                    // adds the sums of all ranks
  // Solves the rows of all ranks as one problem; impulses: of this rank's rows.
  CoupledReport solve_together(const std::vector<CoupledRow>& rows, double dt, std::vector<RowImpulse>& impulses) {
    return solve_in_key_order(rows, dt, impulses);
  }
  // Solves the rows between rigid bodies.
  RigidReport solve_rigid(const RigidRowList& list, const RigidQuery& query, std::vector<RigidImpulse>& impulses) {
    return solve_rigid_rows(list.rows, list.others, list.responses, query, impulses);
  }
};

/// S of the nodes of rigid bodies (body_rows.hpp).
template <class Others>
void weigh_bodies(const WorkSpace& space, RowSystem& system, Others& others) {
  if (system.bodies.count() == 0) return;
  std::vector<ExactSum> sums = sum_body_coefficients(space, system);
  others.sum_bodies(sums);
  spread_body_coefficients(space, sums, system);
}

/// Adds up what the impulses of the iterate do to each body: RowBodies::change.
template <class Others>
void push_bodies(const WorkSpace& space, RowSystem& system, Others& others) {
  std::vector<ExactSum> sums = sum_body_impulses(space, system);
  others.sum_bodies(sums);
  set_body_changes(sums, system);
}

/// Makes the rows of a step, which are counted, with their first guess; S and D. In: num_foreign, foreign,
/// foreign_number and remote_node of the system.
template <class Others>
void build_rows(const WorkSpace& space, const RowInputs& inputs, const RowSources& sources,
                const ContactHistory& history, RowSystem& system, Others& others) {
  start_rows(space, inputs, sources, system);
  space.fence();
  others.receive_nodes(inputs, sources, system);
  if (system.bodies.count() > 0) list_body_places(space, system);
  make_rows(space, inputs, sources, history, system);
  pack_geometry(space, system);
  share_coefficients(space, system);
  others.swap_shares(space, system);
  sum_coefficients(space, system);
  space.fence();
  weigh_bodies(space, system, others);
  sum_stiffness(space, system);
  if (system.bodies.count() > 0) hold_rows_within_bodies(space, system);
  if (system.bodies.count() > 0 && inputs.restitution >= 0) mark_rigid_rows(space, inputs, system);
}

/// Inputs of an enforcement besides the rows; each reads what it needs.
struct SolveQuery {
  double dt = 0;                             // step
  double dt_mean = 0;                        // from the middle of the last step to that of this one; springs
  double tolerance = 0;                      // share of the largest predicted penetration that is left over; kinematic
  double spring_scale = 0;                   // of the stiffness of springs
  Array<const std::int64_t> node_numbers{};  // [mesh nodes]; lagrange
};

/// Report of every enforcement: solve_kinematic(), solve_lagrange() and solve_springs() take the same arguments and
/// leave impulses in the rows and their dv in RowSystem::correction.
struct SolveReport {
  std::int64_t rows = 0;  // on all ranks; 0: nothing was done here
  int iterations = 0;
  bool converged = true;
  double complementarity = 0;  // deviation from complementarity / largest closing velocity
};

/// When the iteration has come far enough: no impulse changes by more than would close the share `tolerance` of the
/// largest predicted penetration. Where many rows share the work, ten times that is enough for the worst of them, as
/// long as the changes of all rows do little of the work of contact. A tip alone on an edge gains energy otherwise:
/// what its rows leave over has the sign of the change of its force.
struct Convergence {
  // Share of the smallest h that is enough in any case. What is left over acts on resting bodies like a small noise, so
  // that it must be far below the penetration that gravity causes in a step.
  static constexpr double absolute_tolerance = 1e-14;
  // Share of the largest way that a tied node would take from its place in the step. Ties are always at work: what they
  // leave is a noise that bodies see in every step.
  static constexpr double tie_tolerance = 1e-6;
  // Limits in tolerances: of the change of one row while others converge, and of the work of all changes over that of
  // all impulses.
  static constexpr double most_of_one = 10, most_of_work = 0.2;
  // The least tolerance that works can judge: the change of each row is counted in whole units, which lie as far below
  // the largest work of a row as EnergyUnit::after() says. Of that row they resolve a fiftieth of what may change.
  static constexpr double finest_of_work = 1e-6;
  // Factor on the tolerance where rigid bodies are among the rows: what is left of a rebound stays for good.
  static constexpr double of_rigid = 1e-3;

  double enough = 0, enough_of_one = 0, enough_tied = 0, enough_work = 0;

  Convergence(double tolerance, const PredictedGaps& gaps) {
    const double least = absolute_tolerance * gaps.smallest_size;
    const bool is_work_judged = gaps.rigid == 0 && tolerance >= finest_of_work;
    enough = std::max((gaps.rigid > 0 ? of_rigid : 1) * tolerance * gaps.deepest, least);
    enough_of_one = is_work_judged ? std::max(most_of_one * tolerance * gaps.deepest, least) : enough;
    enough_tied = std::max(tie_tolerance * gaps.farthest_tied, least);
    enough_work = most_of_work * tolerance;
  }

  bool is_reached(const PassSums& sums) const {
    if (!(sums.tie_change <= enough_tied && sums.change <= enough_of_one)) return false;
    return sums.change <= enough ||
           (sums.work > 0 && static_cast<double>(sums.changed_work) <= enough_work * static_cast<double>(sums.work));
  }
};

/// Nesterov's extrapolation, with the restart of O'Donoghue and Candes.
struct Extrapolation {
  double beta = 0, t = 1;

  void advance(bool restart) {
    const double next_t = 0.5 * (1 + std::sqrt(1 + 4 * t * t));
    beta = restart ? 0 : (t - 1) / next_t;
    t = restart ? 1 : next_t;
  }
};

/// An iteration whose changes are larger than so many iterations before diverges: straighten_gaps() says why.
struct DivergenceWatch {
  static constexpr int window = 50;
  double change_before = std::numeric_limits<double>::infinity();

  bool finds_growth(int iterations, double change) {
    if (iterations % window != 0) return false;
    const bool grows = change > change_before;
    change_before = change;
    return grows;
  }
};

/// Iterates the impulses of the rows, but for those of springs, until they have converged.
template <class Others>
SolveReport iterate_rows(const WorkSpace& space, const SolveQuery& query, RowSystem& system, RowSumMemory& memory,
                         Others& others) {
  constexpr int max_iterations = 1000;
  SolveReport report{0, 0, false};
  PredictedGaps gaps = find_predicted_gaps(space, system, memory);  // of all ranks after the first pass
  pack_rows(space, system);
  others.swap_shares(space, system);
  EnergyUnit unit{}, work_unit{};  // none before the first pass, which extrapolates nothing that could point back
  Extrapolation extrapolation;
  DivergenceWatch watch;
  for (;;) {
    // The motion that the impulses cause, on both sides of every contact.
    move_nodes(space, extrapolation.beta, system);
    if (system.bodies.count() > 0) {
      push_bodies(space, system, others);
      move_packed_body_places(space, extrapolation.beta, system);
    }
    space.fence();
    if (report.converged || report.iterations == max_iterations) break;
    PassSums sums = correct_rows(space, {extrapolation.beta, query.dt, unit, work_unit}, system, memory);
    if (report.iterations == 0) sums.gaps = gaps;
    others.swap_shares(space, system, sums);
    if (report.iterations == 0) gaps = sums.gaps;
    ++report.iterations;
    report.converged = Convergence(query.tolerance, gaps).is_reached(sums);
    const bool grows = watch.finds_growth(report.iterations, sums.change);
    if (grows) straighten_gaps(space, system);
    const bool is_blind = report.iterations > 1 && !unit.is_known();
    extrapolation.advance(report.converged || grows || sums.backwards > 0 || is_blind);
    unit = EnergyUnit::after(sums.largest_term);
    work_unit = EnergyUnit::after(sums.largest_work);
  }
  unpack_rows(space, system);
  report.rows = gaps.rows;
  return report;
}

/// RowSystem::correction of the impulses of all rows, whose shares have been swapped.
template <class Others>
void follow_impulses(const WorkSpace& space, RowSystem& system, Others& others) {
  find_corrections(space, system);
  if (system.bodies.count() > 0) {
    push_bodies(space, system, others);
    move_body_places(space, system);
  }
  space.fence();
}

/// The impulses of all rows but those of springs: first those of islands of rigid bodies, then all others by iteration.
template <class Others>
SolveReport solve_rows(const WorkSpace& space, const SolveQuery& query, RowSystem& system, RowSumMemory& memory,
                       Others& others) {
  if (system.bodies.count() == 0) return iterate_rows(space, query, system, memory, others);
  space.fence();
  const RigidRowList list = list_rigid_rows(system);
  std::vector<RigidImpulse> impulses;
  const RigidReport rigid = others.solve_rigid(
      list, {query.dt, Convergence::of_rigid * query.tolerance, query.tolerance, Convergence::absolute_tolerance},
      impulses);
  set_rigid_impulses(space, list, impulses, system);
  SolveReport report{rigid.rows, 0, true};
  if (rigid.is_all == 0) {
    report = iterate_rows(space, query, system, memory, others);
  } else {
    share_impulses(space, system);
    others.swap_shares(space, system);
    follow_impulses(space, system, others);
  }
  report.iterations = std::max(report.iterations, rigid.sweeps);
  report.converged = report.converged && rigid.converged != 0;
  return report;
}

/// contact.enforcement: kinematic.
template <class Others>
SolveReport solve_kinematic(const WorkSpace& space, const SolveQuery& query, RowSystem& system, RowSumMemory& memory,
                            Others& others) {
  if (!others.takes_part(system)) return {0, 0, false};
  return solve_rows(space, query, system, memory, others);
}

/// The impulses of springs, and of stops where a spring gives way too far (contact.enforcement: penalty, automatic).
/// Rows that none pushes are solved with the pushes of all springs: those among rigid bodies by islands, all others by
/// iteration.
template <class Others>
SolveReport solve_springs(const WorkSpace& space, const SolveQuery& query, RowSystem& system, RowSumMemory& memory,
                          Others& others) {
  constexpr int max_passes = 20;
  constexpr double settled = 1e-9;  // share of the smallest h
  if (!others.takes_part(system)) return {};
  const SpringTimes times{query.dt, query.dt_mean};
  PassSums sums;
  sums.change = push_springs(space, query.spring_scale, times, system);
  sums.gaps = find_predicted_gaps(space, system, memory);
  share_impulses(space, system);
  others.swap_shares(space, system, sums);
  const PredictedGaps gaps = sums.gaps;  // of all ranks, as are the changes
  if (gaps.springs == 0) return solve_rows(space, query, system, memory, others);
  follow_impulses(space, system, others);
  int passes = 0;
  for (; passes < max_passes && sums.change > (passes > 0 ? settled * gaps.smallest_size : 0); ++passes) {
    sums = {};
    sums.change = settle_springs(space, times, system);
    share_impulses(space, system);
    others.swap_shares(space, system, sums);
    follow_impulses(space, system, others);
  }
  SolveReport report{gaps.rows, 0, true, 0};
  if (gaps.springs < gaps.rows) report = solve_rows(space, query, system, memory, others);
  report.iterations += 1 + passes;
  book_springs(space, times, system);
  space.fence();
  return report;
}

/// The exact impulses of all rows together (contact.enforcement: lagrange).
template <class Others>
SolveReport solve_lagrange(const WorkSpace& space, const SolveQuery& query, RowSystem& system, RowSumMemory&,
                           Others& others) {
  space.fence();
  std::vector<RowImpulse> impulses;
  const CoupledReport solved = others.solve_together(list_coupled_rows(system, query.node_numbers), query.dt, impulses);
  if (solved.rows == 0) return {};
  set_impulses(space, impulses, system);
  if (!others.takes_part(system)) return {};
  share_impulses(space, system);
  others.swap_shares(space, system);
  follow_impulses(space, system, others);
  return {solved.rows, solved.sweeps, solved.converged, solved.complementarity};
}

}  // namespace percuss
