#pragma once
// Ties that fail by the stress between a tied node and its face.

#include "kernels/contact/geometry/connection_strength.hpp"
#include "kernels/contact/rows/row_system.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

/// Strengths of the tied nodes of a rank.
struct TieStrengths {
  Array<const int> law;                    // [ties] -1: does not fail
  Array<const ConnectionStrength> laws{};  // by law, of stresses
  Array<const double> area{};              // [ties] of the node in the tied surface
  Array<const int> side{};                 // [ties] of the face on which the node lies: 1 or -1; 0: either
};

/// Tension of a push along the outward normal of the face, on a node at this side of it. At neither side either
/// direction pulls.
KOKKOS_INLINE_FUNCTION double find_tension(double push, int side) {
  if (side == 0) return push < 0 ? -push : push;
  return -push * side;
}

/// find_strength_use() of the forces of this rank's tie rows, which are solved. dt_mean: from the middle of the last
/// step to that of this one. use: out, [ties]; of those that do not fail 0.
inline void find_tie_uses(const WorkSpace& space, const RowSystem& system, const TieStrengths& strengths,
                          double dt_mean, const Array<double>& use) {
  const Array<const ContactRow> rows = system.rows;
  const TieStrengths of = strengths;
  const Array<double> out = use;
  parallel_for(
      "contact::clear_tie_uses", RangeOf(space, 0, static_cast<int>(of.law.extent(0))),
      KOKKOS_LAMBDA(int t) { out(t) = 0; });
  parallel_for(
      "contact::find_tie_uses", RangeOf(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        const ContactRow& row = rows(r);
        if (!is_tie(row) || ties_rotation(row) || of.law(row.record) < 0) return;
        const Point3 normal = normalize(cross(row.rho[3] - row.rho[1], row.rho[4] - row.rho[2]));
        const Point3 stress = (1 / (dt_mean * of.area(row.record))) * row.force;
        const double push = dot(stress, normal);
        const double tension = find_tension(push, of.side(row.record));
        out(row.record) = find_strength_use(of.laws(of.law(row.record)), tension, norm(stress - push * normal));
      });
}

}  // namespace percuss
