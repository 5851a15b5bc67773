#pragma once
// Enforcement: the impulses that leave no predicted penetration (the paper's section 4.3), found together for all rows.
//
// The paper's iterated penalty force: forces from gaps, the motion of both sides that they cause, corrected forces,
// until they converge. Here in parallel Jacobi form with Nesterov's extrapolation, restarted when it points back
// (O'Donoghue and Candes 2015). D, the row sum of |G M^-1 G^T|, is the partition factor: it makes the correction a
// contraction however many nodes share a face, and needs no tuning. Only pushing, within Coulomb's limit.
//
// The iteration is solve_kinematic() in row_solution.hpp, its passes are in row_packs.hpp. Here is what comes before it
// and after.

#include "kernels/contact/rows/pass_sums.hpp"
#include "kernels/contact/rows/row_system.hpp"

namespace percuss {

PredictedGaps find_predicted_gaps(const WorkSpace& space, const RowSystem& system, RowSumMemory& memory);

/// dv of all places from the shares of their entries, once: RowSystem::correction.
void find_corrections(const WorkSpace& space, const RowSystem& system);

/// Adds the correction to v and fills impulse at the owned nodes. v, impulse: [mesh nodes][3].
void apply_impulses(const WorkSpace& space, const RowSystem& system, const Rows3<double>& v,
                    const Rows3<double>& impulse);

/// Adds what rows that tie rotations give to the spins of the owned nodes, and fills in their moments.
void apply_moments(const WorkSpace& space, const RowSystem& system, const SpinInputs& spins);

/// Sums up what the impulses did.
EnforcementSums sum_outcome(const WorkSpace& space, double dt, const RowSystem& system, RowSumMemory& memory);

/// Work of this rank's rows of one pair.
PairWork sum_pair_work(const WorkSpace& space, int pair, const RowSystem& system, RowSumMemory& memory);

/// Sums up the rows from first_row on that are walls'. x: [mesh nodes] at n; center: what moments are taken about.
WallSums sum_wall_impulses(const WorkSpace& space, int first_row, const Rows3<const double>& x, const Point3& center,
                           const RowSystem& system, RowSumMemory& memory);

/// Pushes of the rows of one wall, from first_row on. direction: in which it moves; zero: along its normal.
WallPush sum_wall_push(const WorkSpace& space, int first_row, int wall, const Point3& direction,
                       const RowSystem& system, RowSumMemory& memory);

/// Sums over the nodes that a wall would meet in the step at its speed, if only it pushed them: their masses, and their
/// masses times the speed at which each would just touch the wall. looks_inside: as RowInputs has it.
WallMeeting sum_wall_meeting(const WorkSpace& space, int wall, const WallPairs& walls, const RowInputs& inputs,
                             RowSumMemory& memory);

/// Writes the history for the next step: rows that push, that hold an overlap accepted at the start, or that are
/// caught; and ties. All else is forgotten.
void write_history(const WorkSpace& space, double dt, RowSystem& system, ContactHistory& history);

/// Zeroes the impulse of the first num_nodes of a list of nodes.
void clear_impulses(const WorkSpace& space, const Array<const int>& nodes, int num_nodes, const Rows3<double>& impulse);

}  // namespace percuss
