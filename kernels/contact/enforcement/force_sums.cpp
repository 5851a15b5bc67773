#include "kernels/contact/enforcement/force_sums.hpp"

#include "kernels/core/small_space.hpp"

namespace percuss {
namespace {

/// Where the nodes of rows lie: their number in the whole mesh and the chunk that they belong to.
struct RowNodeChunks {
  Array<const int> nodes;
  Array<const std::int64_t> foreign_number, node_numbers, first_node;
  int num_nodes = 0;

  KOKKOS_INLINE_FUNCTION std::int64_t find_number(int place) const {
    return place < num_nodes ? node_numbers(nodes(place)) : foreign_number(place - num_nodes);
  }

  KOKKOS_INLINE_FUNCTION int find_chunk(int place) const {
    const std::int64_t number = find_number(place);
    int low = 0, high = static_cast<int>(first_node.extent(0)) - 1;  // the first beyond it is in (low, high]
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      if (first_node(middle) <= number)
        low = middle;
      else
        high = middle;
    }
    return low;
  }
};

/// Slots of the pushed point.
KOKKOS_INLINE_FUNCTION int count_pushed_slots(const ContactRow& row) { return row.kind == RowKind::edges ? 2 : 1; }

KOKKOS_INLINE_FUNCTION RowSides find_sides(const ContactRow& row, const ForceSides& sides,
                                           const RowNodeChunks& chunks) {
  const int pushed = chunks.find_chunk(row.place[0]);
  if (row.kind == RowKind::wall) return {sides.one(pushed) & sides.walls(find_key_wall(row.key)), 0};
  const int pushing = chunks.find_chunk(row.place[count_pushed_slots(row)]);
  return {sides.one(pushed) & sides.other(pushing), sides.one(pushing) & sides.other(pushed)};
}

KOKKOS_INLINE_FUNCTION void add(const Point3& v, ExactSum (&sums)[3]) {
  sums[0].add(v.x);
  sums[1].add(v.y);
  sums[2].add(v.z);
}

KOKKOS_INLINE_FUNCTION void add_row(const ContactRow& row, const RowSides& mark, std::uint32_t bit, const Point3& about,
                                    const Rows3<const double>& x, ForceSums& sums) {
  // The impulses of a row and their moments sum to zero: the pushing side gets the opposite of the pushed one, which of
  // two edges is P less what the couple gives it.
  Point3 impulse{}, moment{};
  for (int slot = 0; slot < count_pushed_slots(row); ++slot) {
    const Point3 share = spread_impulse(row, slot, row.force, row.couple);
    impulse = impulse + share;
    moment = moment + cross(load_row(x, row.place[slot]) - about, share);
  }
  if ((mark.forward & bit) != 0) {
    add(impulse, sums.impulse);
    add(moment, sums.moment);
  }
  if ((mark.backward & bit) != 0) {
    add(-impulse, sums.impulse);
    add(-moment, sums.moment);
  }
  if (is_tie(row)) return;
  sums.normal.add(row.impulse.push);
  if (!(row.friction > 0)) return;
  const double* rub = row.impulse.rub;
  sums.tangential.add(std::sqrt(rub[0] * rub[0] + rub[1] * rub[1]));
}

}  // namespace

template <class Space>
void mark_rows(const Space& space, const ForceSides& sides, const Array<const std::int64_t>& node_numbers,
               const RowSystem& system, Array<RowSides>& marks) {
  reserve(marks, system.num_rows);
  const Array<const ContactRow> rows = system.rows;
  const Array<RowSides> out = marks;
  const RowNodeChunks chunks{system.nodes, system.foreign_number, node_numbers, sides.first_node, system.num_nodes};
  const ForceSides given = sides;
  Kokkos::parallel_for(
      "contact::mark_rows", RangeOf<Space>(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        const ContactRow& row = rows(r);
        const bool acts = row.force.x != 0 || row.force.y != 0 || row.force.z != 0;
        out(r) = acts ? find_sides(row, given, chunks) : RowSides{};
      });
}

template <class Space>
ForceSums sum_contact_force(const Space& space, int f, const Point3& about, const RowSystem& system,
                            const Array<const RowSides>& marks, Array<ForceSums>& partial) {
  const Array<const ContactRow> rows = system.rows;
  const Rows3<const double> x = system.at.x;
  const std::uint32_t bit = std::uint32_t{1} << f;
  return sum_rows<ForceSums>(space, system.num_rows, partial,
                             [rows, x, marks, bit, about] KOKKOS_FUNCTION(int r, ForceSums& sums) {
                               const RowSides mark = marks(r);
                               if (((mark.forward | mark.backward) & bit) == 0) return;
                               add_row(rows(r), mark, bit, about, x, sums);
                             });
}

#define PERCUSS_INSTANTIATE(Space)                                                                             \
  template void mark_rows(const Space&, const ForceSides&, const Array<const std::int64_t>&, const RowSystem&, \
                          Array<RowSides>&);                                                                   \
  template ForceSums sum_contact_force(const Space&, int, const Point3&, const RowSystem&,                     \
                                       const Array<const RowSides>&, Array<ForceSums>&);
PERCUSS_INSTANTIATE(ExecSpace)
#if defined(PERCUSS_SMALL_SPACE)
PERCUSS_INSTANTIATE(SmallSpace)
#endif
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
