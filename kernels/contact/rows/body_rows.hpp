#pragma once
// What rigid bodies change in the system of rows: how stiff a row is, and what moves its nodes.
//
// G M^-1 G^T has the compliance of the body, 1/M + [r]^T I^-1 [r], between all entries of all rows on it, whatever
// nodes they have. The row sums of its absolute values are bounded by component: sum |c| / M over the impulses of all
// entries on the body, and sum |r| x |c| through |I^-1|. Sums over a body are exact (kernels/core/exact_sum.hpp), so
// that its nodes may lie on any ranks.
//
// Others (row_solution.hpp) adds the sums of all ranks.

#include "kernels/contact/rows/row_system.hpp"

namespace percuss {

/// Bodies of the owned places, and the compliance of these in RowNodes::inverse_mass. After the nodes are gathered.
void start_bodies(const WorkSpace& space, const BodyInputs& inputs, RowSystem& system);

/// Lists the places of each body, once RowBodies::of_place of foreign places has come.
void list_body_places(const WorkSpace& space, RowSystem& system);

/// Sums over the owned places of each body, six a body: of the absolute coefficients S and their bounds |r| x S.
std::vector<ExactSum> sum_body_coefficients(const WorkSpace& space, RowSystem& system);

/// Sets, by those sums of all ranks, S of the places of bodies such that S times the compliance is their share of D.
void spread_body_coefficients(const WorkSpace& space, const std::vector<ExactSum>& sums, RowSystem& system);

/// Rows between nodes of one body move nothing: they are held.
void hold_rows_within_bodies(const WorkSpace& space, RowSystem& system);

/// Marks the rows between rigid bodies, and of one with a wall: ContactRow::is_rigid. Those that would close in the
/// step part instead, with the share RowInputs::restitution of the velocity at which they came at n-1/2.
void mark_rigid_rows(const WorkSpace& space, const RowInputs& inputs, RowSystem& system);

/// Impulse and moment of all entries on the owned places of each body, from their shares.
std::vector<ExactSum> sum_body_impulses(const WorkSpace& space, RowSystem& system);

/// Sets, by those sums of all ranks, RowBodies::wrench and change.
void set_body_changes(const std::vector<ExactSum>& sums, RowSystem& system);

/// dv of the places of bodies: RowSystem::correction and, in packs, dv + beta (dv - dv of the iterate before).
void move_packed_body_places(const WorkSpace& space, double beta, const RowSystem& system);
void move_body_places(const WorkSpace& space, const RowSystem& system);

}  // namespace percuss
