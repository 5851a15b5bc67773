#pragma once
// Forces of contact between sides that a deck names: the impulses of the rows of a step, added up by pair of sides.

#include <cstdint>

#include "kernels/contact/rows/row_system.hpp"

namespace percuss {

/// What one side got from the other in a step.
struct ForceSums {
  ExactSum impulse[3], moment[3];  // on the first side [force x time], and its moment
  ExactSum normal, tangential;     // magnitudes of the rows' pushes and of their friction; ties have neither

  KOKKOS_INLINE_FUNCTION void merge(const ForceSums& other) {
    for (int k = 0; k < 3; ++k) {
      impulse[k].merge(other.impulse[k]);
      moment[k].merge(other.moment[k]);
    }
    normal.merge(other.normal);
    tangential.merge(other.tangential);
  }
};

/// The sides of each force: bit f of a word says that nodes of a chunk, or a wall, belong to that side of force f.
struct ForceSides {
  Array<const std::int64_t> first_node;  // [chunks + 1] of the whole mesh: Numbering::first_node
  Array<const std::uint32_t> one;        // [chunks] the side that the force acts on
  Array<const std::uint32_t> other;      // [chunks] the side that it comes from
  Array<const std::uint32_t> walls;      // [walls] likewise
};

/// To which forces a row adds: bit f. Forward: its pushed point is of the first side.
struct RowSides {
  std::uint32_t forward = 0, backward = 0;
};

/// marks: out, [rows]. node_numbers: [mesh nodes].
template <class Space>
void mark_rows(const Space& space, const ForceSides& sides, const Array<const std::int64_t>& node_numbers,
               const RowSystem& system, Array<RowSides>& marks);

/// Force f of this rank's rows, after they are solved; moments about `about`, with the places at n.
template <class Space>
ForceSums sum_contact_force(const Space& space, int f, const Point3& about, const RowSystem& system,
                            const Array<const RowSides>& marks, Array<ForceSums>& partial);

}  // namespace percuss
