// The bound D of what the rows of a step do to each other, a pack of rows at a time.

#include "kernels/contact/rows/row_geometry.hpp"
#include "kernels/contact/rows/row_packs.hpp"
#include "kernels/contact/rows/tie_row.hpp"

namespace percuss {
namespace {

KOKKOS_FORCEINLINE_FUNCTION Packed find_packed_abs(const Packed& a) { return select(a < Packed(0), -a, a); }
KOKKOS_FORCEINLINE_FUNCTION PackedPoint find_packed_abs(const PackedPoint& a) {
  return {find_packed_abs(a.x), find_packed_abs(a.y), find_packed_abs(a.z)};
}
KOKKOS_FORCEINLINE_FUNCTION Packed find_packed_max(const PackedPoint& a) {
  const PackedPoint b = find_packed_abs(a);
  return larger(larger(b.z, b.y), b.x);
}

KOKKOS_FORCEINLINE_FUNCTION int count_directions(const RowPack& pack) { return pack.has_friction != 0 ? 3 : 1; }
/// A unit push along direction d of the rows; of rows without friction along their normal only.
KOKKOS_FORCEINLINE_FUNCTION PackedForce make_unit_push(const RowPack& pack, int d) {
  return PackedForce(pack, d == 0 ? load_point(pack.normal) : load_point(pack.tangent[d - 1]));
}

PERCUSS_FLATTEN KOKKOS_FUNCTION void share_coefficients(const RowPack& pack, const Rows4<double>& shares) {
  PackedPoint sum[row_nodes];
  for (int d = 0; d < count_directions(pack); ++d) {
    const PackedForce push = make_unit_push(pack, d);
    for (int slot = 0; slot < row_nodes; ++slot) {
      const PackedPoint c = find_packed_abs(push.spread(pack, slot));
      sum[slot] = d == 0 ? c : sum[slot] + c;
    }
  }
  for (int slot = 0; slot < row_nodes; ++slot) store_share(pack, slot, sum[slot], shares);
}

/// D of the directions of a pack's rows; free: D of the push if no direction of their nodes were held.
struct PackedStiffness {
  LaneValues of[3], free;
};

PERCUSS_FLATTEN KOKKOS_FUNCTION PackedStiffness sum_stiffness(const RowPack& pack, const Rows3<const double>& sums,
                                                              const Rows3<const double>& inverse_mass) {
  PackedPoint s[row_nodes], w[row_nodes];
  for (int slot = 0; slot < row_nodes; ++slot) {
    s[slot] = load_points(sums, pack.place[slot]);
    w[slot] = load_points(inverse_mass, pack.place[slot]);
  }
  Packed stiffness[3] = {Packed(0), Packed(0), Packed(0)}, free(0);
  for (int d = 0; d < count_directions(pack); ++d) {
    const PackedForce push = make_unit_push(pack, d);
    for (int slot = 0; slot < row_nodes; ++slot) {
      const PackedPoint c = find_packed_abs(push.spread(pack, slot)), &by = s[slot], &m = w[slot];
      stiffness[d] = stiffness[d] + ((c.x * by.x * m.x + c.y * by.y * m.y) + c.z * by.z * m.z);
      if (d == 0) free = free + find_packed_max(m) * dot(c, by);
    }
    if (pack.turning != 0) stiffness[d] = stiffness[d] + load_pack(pack.own[d]);
  }
  return {{LaneValues(stiffness[0]), LaneValues(stiffness[1]), LaneValues(stiffness[2])}, LaneValues(free)};
}

}  // namespace

void share_coefficients(const WorkSpace& space, const RowSystem& system) {
  const RowPacks p = system.packs;
  const Rows4<double> shares = system.shares;
  parallel_for(
      "contact::share_coefficients", RangeOf(space, 0, p.count),
      KOKKOS_LAMBDA(int i) { share_coefficients(p.pack(i), shares); });
}

void sum_stiffness(const WorkSpace& space, RowSystem& system) {
  const RowPacks p = system.packs;
  const Array<ContactRow> rows = system.rows;
  const Array<int> wants = system.wants;
  const Rows3<double> sums = system.abs_sum, inverse_mass = system.at.inverse_mass;
  const int nowhere = system.num_places();
  parallel_for(
      "contact::clear_nowhere", RangeOf(space, nowhere, nowhere + 1), KOKKOS_LAMBDA(int a) {
        store_row(sums, a, Point3{});
        store_row(inverse_mass, a, Point3{});
      });
  parallel_for(
      "contact::sum_stiffness", RangeOf(space, 0, p.count), KOKKOS_LAMBDA(int i) {
        RowPack& pack = p.pack(i);
        const PackedStiffness found = sum_stiffness(pack, sums, inverse_mass);
        for (int lane = 0; lane < RowPack::lanes; ++lane) {
          if (pack.row[lane] < 0) continue;
          ContactRow& row = rows(pack.row[lane]);
          const double stiffness[3] = {found.of[0][lane], found.of[1][lane], found.of[2][lane]};
          if (is_tie(row))
            set_tie_stiffness(row, stiffness);
          else
            set_stiffness(row, stiffness, found.free[lane]);
          set_state(pack, lane, row);
          wants(pack.row[lane]) = wants_something(row) ? 1 : 0;
        }
      });
}

}  // namespace percuss
