#pragma once
// The complementarity problem of coupled contact rows: pushes that only push, friction within Coulomb's cone.
//
// Find z with w = b + A z such that for each row, with its push p, its tangential impulse (t1, t2) and its friction mu,
//   p >= 0, w_p >= 0, p w_p = 0;   |t| <= mu p,  w_t = 0 if it sticks,  w_t = -s t, s >= 0, if it slides.
// A = H M^-1 G^T; without friction this is the linear complementarity problem of the multipliers. Solved by projected
// block Gauss-Seidel, forwards and backwards over a colouring of the rows, as the fixed-point map of Anderson's
// acceleration (Walker and Ni, SIAM J. Numer. Anal. 49, 2011, type II), with a return to the plain sweep whenever that
// leads away: on the way to the solution the active set comes to rest, and from there it is a Krylov method with the
// sweep as preconditioner.

#include <vector>

#include "kernels/core/small_space.hpp"

namespace percuss {

/// Rows of a sparse matrix, columns ascending within each.
struct SparseMatrix {
  int num_rows = 0;
  Array<const int> offset;  // [num_rows + 1]
  Array<const int> column;
  Array<const double> value;
};

struct ConeProblem {
  SparseMatrix a;                // [unknowns][unknowns] [1/mass]
  Array<const double> b;         // [unknowns] [velocity]
  int num_rows = 0;              // contact rows
  Array<const int> first;        // [num_rows + 1] first unknown of each: its push, then its friction (none or two)
  Array<const double> friction;  // [num_rows]; no_friction_limit: a tie, whose three unknowns only want w = 0
  // [num_rows] Of two rows that push the same nodes almost the same way, as a corner on a corner seen from both sides,
  // the leader has the friction of both, up to the sum of their limits, and the follower's is zero. -1: none; found by
  // the solver.
  Array<const int> leader, follower;
};

struct ConeReport {
  int sweeps = 0;
  double residual = 0;  // largest deviation from the conditions above, as a velocity
  bool converged = true;
};

/// z: in, first guess; out, solution or, if the sweeps run out, the best that was met. tolerance: of the residual
/// [velocity]. The same bits for any number of threads.
ConeReport solve_cone_problem(const ConeProblem& problem, double tolerance, const Array<double>& z);

}  // namespace percuss
