#pragma once
// Rows that springs push: the impulse is that of a spring on the penetration at n (ContactRow::has_spring).
//
// Node by node a stiffness s of the material in front of its faces, a quarter of M A^2 / V of each (M = lambda + 2 mu,
// A face, V element; after Hallquist, Goudreau and Benson, Comput. Methods Appl. Mech. Eng. 51, 1985, who take the bulk
// modulus, which is too soft by the shear that a pressed layer has). A row has the two sides
// in series, each with its weights: 1 / k = 1 / s_a + 1 / s_b. Rubs are springs on the slip of the contact, shortened
// to Coulomb's limit. The frequency that the springs add is at most max k D, D the row sum of |G M^-1 G^T|.

#include "kernels/contact/rows/row_system.hpp"

namespace percuss {

/// Stiffness of a row [force/length]. s: [places] of its nodes.
KOKKOS_INLINE_FUNCTION double find_spring(const ContactRow& row, const Array<const double>& s) {
  double front = 0, back = 0;
  for (int slot = 0; slot < count_nodes(row); ++slot) {
    const double share = row.weight[slot] * s(row.place[slot]);
    (share > 0 ? front : back) += share > 0 ? share : -share;
  }
  if (count_nodes(row) == 1) return front;
  return front + back > 0 ? front * back / (front + back) : 0;
}

/// Durations of the step; the middle of the last step is dt_mean before that of this one.
struct SpringTimes {
  double dt = 0, dt_mean = 0;
  KOKKOS_INLINE_FUNCTION double before() const { return 2 * dt_mean - dt; }  // the last step
};

/// Impulses of the rows that springs push. scale: of the stiffness.
/// Returns by how much the most unsettled row would leave its cushion, or its spring is not pressed throughout
/// [length], 0: none.
double push_springs(const WorkSpace& space, double scale, const SpringTimes& times, const RowSystem& system);

/// A pass over the rows with RowSystem::correction: springs that begin or end in the step, and those of friction whose
/// slip changes sign, push as energy asks; rows that end it beyond their cushion push more, or less, never less than
/// their spring. D counts the rows beside each, so that none is thrown back. Returns the largest change [length]; a
/// change of slip below 1e-6 h counts as none.
double settle_springs(const WorkSpace& space, const SpringTimes& times, const RowSystem& system);

/// Books what the springs hold at n+1/2, with RowSystem::correction of all pushes: ContactRow::held.
void book_springs(const WorkSpace& space, const SpringTimes& times, const RowSystem& system);

}  // namespace percuss
