#pragma once
// Enforcement: the impulses that leave no predicted penetration (the paper's section 4.3), found together for all rows.
//
// The paper's iterated penalty force: forces from gaps, the motion of both sides that they cause, corrected forces,
// until they converge. Here in parallel Jacobi form with Nesterov's extrapolation, restarted when it points back
// (O'Donoghue and Candes 2015). D, the row sum of |G M^-1 G^T|, is the partition factor: it makes the correction a
// contraction however many nodes share a face, and needs no tuning. Only pushing, within Coulomb's limit.

#include "kernels/contact/row_system.hpp"

namespace percuss {

struct SolveReport {
  int iterations = 0;
  bool converged = true;
};

/// Iterates the impulses of the system. dt: step; correction is their dv on return.
template <class Space>
SolveReport solve_rows(const Space& space, const Rows3<const double>& inverse_mass, double dt, RowSystem& system);

/// What the impulses of a step did.
struct EnforcementSums {
  int pushes = 0;            // rows with a push
  double normal_work = 0;    // of the pushes
  double friction_work = 0;  // of the rubs
  double residual = 0;       // largest penetration left over / h
  double deepest = 0;        // deepest penetration at n / h beyond what was accepted at the start
  int deepest_node = -1;     // mesh node of it
};

/// Adds the correction to v, fills impulse at the touched nodes, sums up. v_before: velocity at n-1/2.
template <class Space>
EnforcementSums apply_impulses(const Space& space, const Rows3<const double>& v_before, double dt, RowSystem& system,
                               const Rows3<double>& v, const Rows3<double>& impulse);

/// Writes the history for the next step: rows that push, or that hold an overlap accepted at the start.
template <class Space>
void write_history(const Space& space, const CandidateList& candidates, const WallPairs& walls, double dt,
                   const RowSystem& system, const ContactHistory& history);

/// Forgets the history of nodes that are no longer near any face.
template <class Space>
void drop_history(const Space& space, const ContactSurface& surface, const CandidateList& candidates,
                  const ContactHistory& history);

/// Zeroes the impulse of the nodes of the system's rows.
template <class Space>
void clear_impulses(const Space& space, const RowSystem& system, const Rows3<double>& impulse);

}  // namespace percuss
