#pragma once
// Rows between rigid bodies, and of these with walls, as the small dense problem that they are.
//
// Bodies that such rows connect are an island, if no other row (of a node that deforms, of a tie) touches one of them.
// Its rows are met one after the other with all others as they are, forth and back in the order of their keys
// (projected Gauss-Seidel on the velocities of the bodies), along conjugate directions of such sweeps
// (Silcowitz-Hansen, Niebe and Erleben, The Visual Computer 26, 2010). The rows of all ranks are solved in one place,
// so that the impulses are the same bits on any number of them. All other rows are iterated (row_solution.hpp).

#include <vector>

#include "kernels/contact/rows/row_system.hpp"

namespace percuss {

/// A row between rigid bodies as it can be solved anywhere.
struct RigidRow {
  static constexpr int most_bodies = 2;  // bodies that it pushes; rows on more bodies are iterated

  std::int64_t key = 0;
  int body[most_bodies] = {-1, -1};
  Wrench push[3][most_bodies];  // that unit impulses along the normal and the tangents are to the bodies
  Wrench gap[most_bodies];      // whose product with the changes of velocity is that of the gap's rate
  double missing = 0;           // gap - target
  double slide[2] = {0, 0}, friction = 0, size = 0;
  RowImpulse guess;
};

/// The rows of a rank that islands may have, and what else there is.
struct RigidRowList {
  std::vector<RigidRow> rows;
  std::vector<int> index;  // of each in RowSystem::rows
  // By body how many other rows touch it; then the number of other rows that are to be iterated, and that of all rows.
  std::vector<int> others;
  std::vector<BodyResponse> responses;  // of all bodies
};

/// Solution of a row of the list.
struct RigidImpulse {
  RowImpulse impulse;
  int is_solved = 0;  // 0: it is iterated with the others
};

struct RigidReport {
  std::int64_t rows = 0;  // of all kinds
  int sweeps = 0;
  int converged = 1;
  int is_all = 0;  // whether no row is left to be iterated
};

struct RigidQuery {
  double dt = 0;         // step
  double tolerance = 0;  // largest change of a row in a sweep / largest predicted penetration of its island
  double accepted = 0;   // the same where many sweeps have not brought it to `tolerance`
  double least = 0;      // largest change of a row in a sweep / smallest h
};

/// The rows of all ranks, in any order, with the sums of RigidRowList::others. impulses: out, [rows].
RigidReport solve_rigid_rows(const std::vector<RigidRow>& rows, const std::vector<int>& others,
                             const std::vector<BodyResponse>& responses, const RigidQuery& query,
                             std::vector<RigidImpulse>& impulses);

RigidRowList list_rigid_rows(const RowSystem& system);

/// Gives solved rows their impulses: ContactRow::is_solved.
void set_rigid_impulses(const WorkSpace& space, const RigidRowList& list, const std::vector<RigidImpulse>& impulses,
                        const RowSystem& system);

}  // namespace percuss
