#pragma once
// The passes of the iteration over packs of rows (row_pack.hpp) and over the nodes that they touch.

#include "kernels/contact/rows/pass_sums.hpp"
#include "kernels/contact/rows/row_system.hpp"

namespace percuss {

/// Packs what rows are from the start: those that want something first.
void pack_geometry(const WorkSpace& space, RowSystem& system);

/// Sums of the absolute coefficients of each entry: RowSystem::shares. In: packs.
void share_coefficients(const WorkSpace& space, const RowSystem& system);

/// D of each row: sum over its nodes of |c| S / m, a bound of the row sum of |G M^-1 G^T|; RowSystem::wants. Packs what
/// rows ask for, with their first guess. In: S at all places, packs.
void sum_stiffness(const WorkSpace& space, RowSystem& system);

/// Begins the iteration: shares of all entries by the first guess. In: what sum_stiffness() left in the packs.
void pack_rows(const WorkSpace& space, RowSystem& system);

/// New dv of all places from the shares: RowSystem::correction, and dv + beta (dv - dv of the iterate before) in
/// RowPacks::dv.
void move_nodes(const WorkSpace& space, double beta, const RowSystem& system);

/// Parameters of a pass, and units of its sums.
struct PassQuery {
  double beta = 0, dt = 0;
  EnergyUnit unit{};       // of PassSums::backwards
  EnergyUnit work_unit{};  // of PassSums::changed_work and work
};

/// Corrects the impulses of all rows from their extrapolated iterate; new shares. Packs of rows that have no push, need
/// none as things lie, and none of whose nodes was ever moved stay as they are.
PassSums correct_rows(const WorkSpace& space, const PassQuery& query, const RowSystem& system, RowSumMemory& memory);

/// Lets the gap of every row change along its push direction only. Where the gradient of a gap is another, as of a node
/// that slides around a cylinder or a sphere, what rows do to each other is not symmetric and the iteration may
/// diverge; with this it is symmetric and contracts. The price is the square of the angle, which the next steps recover
/// like any penetration.
void straighten_gaps(const WorkSpace& space, const RowSystem& system);

/// Brings the impulses of the packs back to the rows.
void unpack_rows(const WorkSpace& space, const RowSystem& system);

}  // namespace percuss
