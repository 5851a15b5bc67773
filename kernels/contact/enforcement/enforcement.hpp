#pragma once
// Enforcement: the impulses that leave no predicted penetration (the paper's section 4.3), found together for all rows.
//
// The paper's iterated penalty force: forces from gaps, the motion of both sides that they cause, corrected forces,
// until they converge. Here in parallel Jacobi form with Nesterov's extrapolation, restarted when it points back
// (O'Donoghue and Candes 2015). D, the row sum of |G M^-1 G^T|, is the partition factor: it makes the correction a
// contraction however many nodes share a face, and needs no tuning. Only pushing, within Coulomb's limit.
//
// Here is what comes before and after; row_packs.hpp has the passes, row_solution.hpp is the iteration.

#include "kernels/contact/rows/energy_unit.hpp"
#include "kernels/contact/rows/row_system.hpp"
#include "kernels/contact/rows/wall_sums.hpp"

namespace percuss {

/// What the rows ask for before the iteration.
struct PredictedGaps {
  double deepest = 0;        // largest penetration to be closed [length]
  double farthest_tied = 0;  // largest distance of a tied node from its place, by component [length]
  double smallest_size = 0;  // smallest h of a row, 0: no rows
  std::int64_t rows = 0;

  KOKKOS_INLINE_FUNCTION void merge(const PredictedGaps& other) {
    deepest = other.deepest > deepest ? other.deepest : deepest;
    farthest_tied = other.farthest_tied > farthest_tied ? other.farthest_tied : farthest_tied;
    if (other.rows > 0 && (rows == 0 || other.smallest_size < smallest_size)) smallest_size = other.smallest_size;
    rows += other.rows;
  }
};

/// What one pass over the rows says about convergence.
struct PassSums {
  PredictedGaps gaps;          // before the first pass only
  double change = 0;           // largest change of an impulse as a displacement: |p' - y| dt D [length]
  double tie_change = 0;       // the same of ties
  std::int64_t backwards = 0;  // sum of D dt^2 (y - p') (p' - p): positive when the extrapolation points back [units]
  double largest_term = 0;     // of that sum, without its sign [energy time^2]

  KOKKOS_INLINE_FUNCTION void merge(const PassSums& other) {
    gaps.merge(other.gaps);
    change = other.change > change ? other.change : change;
    tie_change = other.tie_change > tie_change ? other.tie_change : tie_change;
    backwards += other.backwards;
    largest_term = other.largest_term > largest_term ? other.largest_term : largest_term;
  }
};

/// What the impulses of a step did.
struct EnforcementSums {
  std::int64_t pushes = 0;        // rows with a push; ties
  ExactSum normal_work;           // of the pushes
  ExactSum friction_work;         // of the rubs
  ExactSum stored;                // energy in the springs of penalty rows at n+1
  double rate = 0;                // bound of the square of the frequency that these springs add [1/time^2]
  double residual = 0;            // largest penetration, or way of a tied node to its place, left over / h
  double deepest = 0;             // deepest penetration at n / h beyond what was accepted at the start
  std::int64_t deepest_key = -1;  // of the row that has it, lowest of equals
  double torn = 0;                // largest ContactRow::torn / h
  std::int64_t torn_key = -1;     // of the row that has it, lowest of equals

  KOKKOS_INLINE_FUNCTION void add_depth(double depth, std::int64_t key) {
    if (!(depth > deepest) && !(depth == deepest && depth > 0 && key < deepest_key)) return;
    deepest = depth;
    deepest_key = key;
  }
  KOKKOS_INLINE_FUNCTION void add_torn(double way, std::int64_t key) {
    if (!(way > torn) && !(way == torn && way > 0 && key < torn_key)) return;
    torn = way;
    torn_key = key;
  }
  KOKKOS_INLINE_FUNCTION void merge(const EnforcementSums& other) {
    pushes += other.pushes;
    normal_work.merge(other.normal_work);
    friction_work.merge(other.friction_work);
    stored.merge(other.stored);
    rate = other.rate > rate ? other.rate : rate;
    residual = other.residual > residual ? other.residual : residual;
    add_depth(other.deepest, other.deepest_key);
    add_torn(other.torn, other.torn_key);
  }
};

/// Work of the rows of one pair of surfaces.
struct PairWork {
  ExactSum normal, friction;

  KOKKOS_INLINE_FUNCTION void merge(const PairWork& other) {
    normal.merge(other.normal);
    friction.merge(other.friction);
  }
};

/// Memory of the sums over rows.
struct RowSumMemory {
  Array<PredictedGaps> gaps = Array<PredictedGaps>("contact::gap_sums", 0);
  Array<PassSums> pass = Array<PassSums>("contact::pass_sums", 0);
  Array<EnforcementSums> outcome = Array<EnforcementSums>("contact::outcome_sums", 0);
  Array<PairWork> pair = Array<PairWork>("contact::pair_sums", 0);
  Array<WallSums> wall = Array<WallSums>("contact::wall_sums", 0);
};

template <class Space>
PredictedGaps find_predicted_gaps(const Space& space, const RowSystem& system, RowSumMemory& memory);

/// dv of the owned nodes from the shares of their entries, once: RowSystem::correction.
template <class Space>
void find_corrections(const Space& space, const RowSystem& system);

/// Adds the correction to v and fills impulse at the owned nodes. v, impulse: [mesh nodes][3].
template <class Space>
void apply_impulses(const Space& space, const RowSystem& system, const Rows3<double>& v, const Rows3<double>& impulse);

/// Sums up what the impulses did.
template <class Space>
EnforcementSums sum_outcome(const Space& space, double dt, const RowSystem& system, RowSumMemory& memory);

/// Work of this rank's rows of one pair.
template <class Space>
PairWork sum_pair_work(const Space& space, int pair, const RowSystem& system, RowSumMemory& memory);

/// Sums up the rows from first_row on that are walls'. x: [mesh nodes] at n; center: what moments are taken about.
template <class Space>
WallSums sum_wall_impulses(const Space& space, int first_row, const Rows3<const double>& x, const Point3& center,
                           const RowSystem& system, RowSumMemory& memory);

/// Writes the history for the next step: rows that push, or that hold an overlap accepted at the start. All else is
/// forgotten.
template <class Space>
void write_history(const Space& space, double dt, RowSystem& system, ContactHistory& history);

/// Zeroes the impulse of the first num_nodes of a list of nodes.
template <class Space>
void clear_impulses(const Space& space, const Array<const int>& nodes, int num_nodes, const Rows3<double>& impulse);

}  // namespace percuss
