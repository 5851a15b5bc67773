#include "kernels/contact/enforcement/force_sums.hpp"

#include "kernels/core/contract.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {
namespace {

/// The chunk that a node belongs to. first_node: [chunks + 1].
KOKKOS_INLINE_FUNCTION int find_chunk_of_node(const Array<const std::int64_t>& first_node, std::int64_t number) {
  int low = 0, high = static_cast<int>(first_node.extent(0)) - 1;  // the first beyond it is in (low, high]
  PERCUSS_EXPECT(first_node(low) <= number && number < first_node(high));
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    if (first_node(middle) <= number)
      low = middle;
    else
      high = middle;
  }
  return low;
}

/// Where the nodes of rows lie: their number in the whole mesh and the chunk that they belong to.
struct RowNodeChunks {
  Array<const int> nodes;
  Array<const std::int64_t> foreign_number, node_numbers, first_node;
  int num_nodes = 0;

  KOKKOS_INLINE_FUNCTION std::int64_t find_number(int place) const {
    return place < num_nodes ? node_numbers(nodes(place)) : foreign_number(place - num_nodes);
  }

  KOKKOS_INLINE_FUNCTION int find_chunk(int place) const { return find_chunk_of_node(first_node, find_number(place)); }
};

/// Slots of the pushed point.
KOKKOS_INLINE_FUNCTION int count_pushed_slots(const ContactRow& row) { return row.kind == RowKind::edges ? 2 : 1; }

/// Sides of one side of a row: those of its chunk and those of the surface that it lies on.
KOKKOS_INLINE_FUNCTION SideBits join_sides(const ForceSides& sides, int chunk, const SideBits& surface) {
  const std::uint32_t one = sides.one(chunk) | surface.one;
  return {one, sides.other(chunk) | surface.other | (sides.from_all & ~one)};
}

KOKKOS_INLINE_FUNCTION RowSides find_sides(const ContactRow& row, const ForceSides& sides, const RowSurfaces& surfaces,
                                           const RowNodeChunks& chunks) {
  const SideBits pushed = join_sides(sides, chunks.find_chunk(row.place[0]), surfaces.pushed);
  if (row.kind == RowKind::wall) return {pushed.one & sides.walls(find_key_wall(row.key)), 0};
  const int place = row.place[count_pushed_slots(row)];
  const SideBits pushing = join_sides(sides, chunks.find_chunk(place), surfaces.pushing);
  return {pushed.one & pushing.other, pushing.one & pushed.other};
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
  if (ties_rotation(row)) moment = row.lever * row.force;
  if ((mark.forward & bit) != 0) {
    add(impulse, sums.impulse);
    add(moment, sums.moment);
  }
  if ((mark.backward & bit) != 0) {
    add(-impulse, sums.impulse);
    add(-moment, sums.moment);
  }
  if (is_tie(row)) return;
  sums.normal.add(row.impulse.normal);
  if (!(row.friction > 0)) return;
  const double* t = row.impulse.tangential;
  sums.tangential.add(std::sqrt(t[0] * t[0] + t[1] * t[1]));
}

/// Push of a row on the node of a slot; zero for ties.
KOKKOS_INLINE_FUNCTION NormalPush find_push(const ContactRow& row, const RowSides& mark, int slot) {
  const std::uint32_t forces = slot < count_pushed_slots(row) ? mark.forward : mark.backward;
  if (forces == 0 || is_tie(row) || row.impulse.normal == 0) return {};
  const Point3 push = row.impulse.normal * row.normal;
  return {spread_impulse(row, slot, push, find_couple(row, push)), forces};
}

/// The entries of places (RowSystem::entry) as pushes.
struct PlacePushes {
  Array<const ContactRow> rows;
  Array<const RowSides> marks;
  Array<const NormalPush> remote;
  Array<const int> offset, entry;
  int first_remote;

  explicit PlacePushes(const MarkedRows& of)
      : rows(of.system.rows),
        marks(of.marks),
        remote(of.remote),
        offset(of.system.offset),
        entry(of.system.entry),
        first_remote(of.system.num_rows * row_nodes) {}

  KOKKOS_INLINE_FUNCTION NormalPush find(int i) const {
    const int e = entry(i);
    if (e >= first_remote) return remote(e - first_remote);
    return find_push(rows(e / row_nodes), marks(e / row_nodes), e % row_nodes);
  }
  KOKKOS_INLINE_FUNCTION std::uint32_t find_forces(int a) const {
    std::uint32_t forces = 0;
    for (int i = offset(a); i < offset(a + 1); ++i) {
      const int e = entry(i);
      if (e >= first_remote) {
        forces |= remote(e - first_remote).forces;
      } else {
        const RowSides mark = marks(e / row_nodes);
        forces |= mark.forward | mark.backward;
      }
    }
    return forces;
  }
  KOKKOS_INLINE_FUNCTION Point3 sum(int a, std::uint32_t bit) const {
    Point3 sum{};
    for (int i = offset(a); i < offset(a + 1); ++i) {
      const NormalPush push = find(i);
      if ((push.forces & bit) != 0) sum = sum + push.impulse;
    }
    return sum;
  }
};

/// Adds a node of the books. place: in them, -1: it has none.
KOKKOS_INLINE_FUNCTION void add_area(const AreaNodes& nodes, int i, const PushBooks& books, int place, AreaSums& sums) {
  if (place < 0 || books.sums(place, 3) == 0) return;
  double area = 0;
  const Point3 impulse{books.sums(place, 0), books.sums(place, 1), books.sums(place, 2)};
  const double press = find_press(nodes.around, i, impulse, area);
  sums.area.add(area * books.sums(place, 3));
  sums.press = press > sums.press ? press : sums.press;
}

KOKKOS_INLINE_FUNCTION bool is_zero(const Point3& p) { return p.x == 0 && p.y == 0 && p.z == 0; }

}  // namespace

void mark_pushes(const WorkSpace& space, const RowSystem& system, Array<RowSides>& marks) {
  reserve(marks, system.num_rows);
  const Array<RowSides> out = marks;
  parallel_for(
      "contact::mark_pushes", RangeOf(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        out(r) = {1, 1};
      });
}

void list_sent_pushes(const WorkSpace& space, const RowSystem& system, const Array<const RowSides>& marks,
                      Array<NormalPush>& sent) {
  reserve(sent, system.num_sent);
  const Array<const ContactRow> rows = system.rows;
  const Array<const int> entry = system.sent;
  const Array<NormalPush> out = sent;
  parallel_for(
      "contact::sent_pushes", RangeOf(space, 0, system.num_sent), KOKKOS_LAMBDA(int k) {
        out(k) = find_push(rows(entry(k) / row_nodes), marks(entry(k) / row_nodes), entry(k) % row_nodes);
      });
}

void book_pushes(const WorkSpace& space, const MarkedRows& rows, const ForceSides& sides,
                 const Array<const std::int64_t>& node_numbers, double time, const PushBooks& books) {
  const RowSystem& system = rows.system;
  const PlacePushes pushes(rows);
  const RowNodeChunks chunks{system.nodes, system.foreign_number, node_numbers, sides.first_node, system.num_nodes};
  const ForceSides given = sides;
  const PushBooks into = books;
  parallel_for(
      "contact::book_pushes", RangeOf(space, 0, system.num_nodes), KOKKOS_LAMBDA(int a) {
        const std::uint32_t forces = pushes.find_forces(a);
        if (forces == 0) return;
        const int chunk = chunks.find_chunk(a);
        for (int f = 0; f < into.forces; ++f) {
          const std::uint32_t bit = std::uint32_t{1} << f;
          const int place = (forces & bit) == 0 ? -1 : into.find_place(given, chunk, chunks.find_number(a), f);
          if (place < 0) continue;
          const Point3 sum = pushes.sum(a, bit);
          if (is_zero(sum)) continue;
          into.sums(place, 0) += sum.x;
          into.sums(place, 1) += sum.y;
          into.sums(place, 2) += sum.z;
          into.sums(place, 3) += time;
        }
      });
}

AreaSums sum_areas(const WorkSpace& space, int f, const AreaNodes& nodes, const ForceSides& sides,
                   const PushBooks& books, Array<AreaSums>& partial) {
  constexpr int at_once = 64;  // nodes: of one or two chunks, which are looked up once
  const AreaNodes given = nodes;
  const ForceSides of = sides;
  const PushBooks from = books;
  const int count = static_cast<int>(nodes.numbers.extent(0));
  return sum_rows<AreaSums>(space, (count + at_once - 1) / at_once, partial,
                            [given, of, from, f, count] KOKKOS_FUNCTION(int group, AreaSums& sums) {
                              const int first = group * at_once,
                                        end = first + at_once < count ? first + at_once : count;
                              int chunk = find_chunk_of_node(of.first_node, given.numbers(first));
                              for (int i = first; i < end; ++i) {
                                const std::int64_t number = given.numbers(i);
                                if (number >= of.first_node(chunk + 1))
                                  chunk = find_chunk_of_node(of.first_node, number);
                                add_area(given, i, from, from.find_place(of, chunk, number, f), sums);
                              }
                            });
}

void sum_pushes(const WorkSpace& space, const MarkedRows& rows, const Rows3<double>& sums) {
  const PlacePushes pushes(rows);
  const Array<const int> nodes = rows.system.nodes;
  const Rows3<double> out = sums;
  parallel_for(
      "contact::sum_pushes", RangeOf(space, 0, rows.system.num_nodes),
      KOKKOS_LAMBDA(int a) { store_row(out, nodes(a), pushes.sum(a, 1)); });
}

void mark_rows(const WorkSpace& space, const GivenSides& sides, const Array<const std::int64_t>& node_numbers,
               const RowSystem& system, Array<RowSides>& marks) {
  reserve(marks, system.num_rows);
  const Array<const ContactRow> rows = system.rows;
  const Array<RowSides> out = marks;
  const ForceSides given = sides.chunks;
  const Array<const RowSurfaces> surfaces = sides.rows;
  const bool has_surfaces = surfaces.extent(0) > 0;
  const RowNodeChunks chunks{system.nodes, system.foreign_number, node_numbers, given.first_node, system.num_nodes};
  parallel_for(
      "contact::mark_rows", RangeOf(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        const ContactRow& row = rows(r);
        const bool acts = row.force.x != 0 || row.force.y != 0 || row.force.z != 0;
        out(r) = acts ? find_sides(row, given, has_surfaces ? surfaces(r) : RowSurfaces{}, chunks) : RowSides{};
      });
}

ForceSums sum_contact_force(const WorkSpace& space, int f, const Point3& about, const RowSystem& system,
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

}  // namespace percuss
