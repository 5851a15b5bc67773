#include "kernels/contact/check/edge_cells.hpp"

#include "kernels/contact/check/near_edges.hpp"
#include "kernels/contact/geometry/contact_limits.hpp"
#include "kernels/contact/geometry/edge_distance.hpp"
#include "kernels/core/index_lists.hpp"

namespace percuss {
namespace {

/// Pairs first to last - 1 are a cell.
struct CellOfPairs {
  int first, last;
  KOKKOS_INLINE_FUNCTION CellOfPairs(int cell, int num_pairs) : first(EdgeCells::cell_pairs * cell) {
    last = first + EdgeCells::cell_pairs < num_pairs ? first + EdgeCells::cell_pairs : num_pairs;
  }
};

MovingPoints list_points(const EdgeCheckInputs& inputs) {
  const int ends = 2 * inputs.surface.num_edges;
  return {inputs.motion, Array<const int>(inputs.surface.ends.data(), static_cast<std::size_t>(ends)), ends};
}

/// The first i for which an ascending answer is(i) is true; n if there is none.
template <class Answer>
KOKKOS_INLINE_FUNCTION int find_first(int n, const Answer& is) {
  int first = 0;
  while (first < n) {
    const int middle = first + (n - first) / 2;
    if (is(middle))
      n = middle;
    else
      first = middle + 1;
  }
  return first;
}

/// Whether a pair without a record is certainly not in contact before an end has gone farther than the travel. Lines of
/// sheets are then at most the row gap from what they keep, or at the ends of beams a little more; edges of solids may
/// have crossed by a quarter of h, and over a warped face by its dip besides.
KOKKOS_INLINE_FUNCTION bool stays_apart(const EdgeSurface& surface, const EdgePair& pair, int a, int b, double travel) {
  constexpr double of_sheets = 0.03, of_solids = 0.28, of_dips = 0.6, of_joints = 1.01, slack = 1e-3;
  const double of_a = find_edge_offset(surface, a), of_b = find_edge_offset(surface, b);
  const double along_a = norm(pair.a[1] - pair.a[0]), along_b = norm(pair.b[1] - pair.b[0]);
  double size = smaller(along_a, along_b), share = of_a + of_b > 0 ? of_sheets : of_solids;
  if (of_a > 0) size = smaller(size, 2 * of_a);
  if (of_b > 0) size = smaller(size, 2 * of_b);
  if (find_bluntness(surface, a) == warped_ridge || find_bluntness(surface, b) == warped_ridge) {
    size = larger(along_a, along_b);
    share = of_dips;
  }
  const double reach = of_joints * (of_a + of_b) + share * (size + 2 * travel) + 2 * travel;
  return (1 - slack) * find_edge_distance(pair) - reach > slack * slack * (along_a + along_b);
}

/// Finds which pairs of the cells that are due are near.
void list_due_cells(const WorkSpace& space, const EdgeSurface& surface, const EdgePairs& all, const EdgeCells& cells) {
  const EdgeSurface s = surface;
  const CellTravels travels = cells.travels;
  const Array<const int> of_a = all.a, of_b = all.b;
  const Array<int> is_near = cells.is_near;
  const int num_pairs = all.num_pairs;
  parallel_for(
      "contact::list_edge_cells", RangeOf(space, 0, travels.num_due), KOKKOS_LAMBDA(int k) {
        const CellOfPairs cell(travels.due(k), num_pairs);
        for (int i = cell.first; i < cell.last; ++i) {
          const int a = of_a(i), b = of_b(i);
          const Point3 origin = load_row(travels.origin, 2 * a);
          EdgePair pair;
          for (int end = 0; end < 2; ++end) {
            pair.a[end] = load_row(travels.origin, 2 * a + end) - origin;
            pair.b[end] = load_row(travels.origin, 2 * b + end) - origin;
          }
          is_near(i) = stays_apart(s, pair, a, b, travels.allowed(travels.due(k))) ? 0 : 1;
        }
      });
}

/// Marks the pairs that have a record.
void mark_held_pairs(const WorkSpace& space, const EdgeCheckInputs& inputs, const EdgePairs& all, EdgeCells& cells) {
  const std::int64_t now = ++cells.now;
  const EdgeHistory past = inputs.history;
  const Array<const std::int64_t> numbers = inputs.surface.numbers;
  const Array<const int> of_a = all.a, of_b = all.b;
  const Array<std::int64_t> held = cells.held;
  const int num_edges = inputs.surface.num_edges, num_pairs = all.num_pairs;
  parallel_for(
      "contact::mark_held_pairs", RangeOf(space, 0, past.count), KOKKOS_LAMBDA(int r) {
        if (past.holds(r) == 0) return;
        const int a = find_first(num_edges, [&](int e) { return numbers(e) >= past.a(r); });
        const int b = find_first(num_edges, [&](int e) { return numbers(e) >= past.b(r); });
        const int i = find_first(num_pairs, [&](int k) { return of_a(k) > a || (of_a(k) == a && of_b(k) >= b); });
        if (a == num_edges || b == num_edges || i == num_pairs || of_a(i) != a || of_b(i) != b) return;
        if (numbers(a) == past.a(r) && numbers(b) == past.b(r)) held(i) = now;
      });
}

/// Whether the pairs that are kept are those of the list before.
bool are_same(const WorkSpace& space, const EdgeCells& cells, int count, int count_before) {
  if (cells.is_new || count != count_before) return false;
  const Array<const int> kept = cells.kept, before = cells.kept_before;
  int others = 0;
  parallel_reduce(
      "contact::compare_edge_pairs", RangeOf(space, 0, count),
      KOKKOS_LAMBDA(int i, int& differ) { differ += kept(i) != before(i) ? 1 : 0; }, others);
  return others == 0;
}

}  // namespace

void watch_cells(const WorkSpace& space, const EdgeSurface& surface, const EdgePairs& all, EdgeCells& cells) {
  const int num_pairs = all.num_pairs, num_edges = surface.num_edges;
  reserve_cells((num_pairs + EdgeCells::cell_pairs - 1) / EdgeCells::cell_pairs, 2 * num_edges, cells.travels);
  for (Array<int>* of_pairs : {&cells.is_near, &cells.kept, &cells.kept_before}) reserve(*of_pairs, num_pairs);
  cells.is_new = true;
  reserve(cells.held, num_pairs);
  reserve(cells.mark, num_edges);
  Kokkos::deep_copy(cells.held, std::int64_t{-1});
  const Array<const int> a = all.a, b = all.b;
  const Array<int> watched = cells.travels.watched, num_watched = cells.travels.num_watched;
  parallel_for(
      "contact::watch_edge_cells", RangeOf(space, 0, cells.travels.num_cells), KOKKOS_LAMBDA(int k) {
        const CellOfPairs cell(k, num_pairs);
        NumberSet ends(&watched(CellTravels::most_watched * k), CellTravels::most_watched);
        for (int i = cell.first; i < cell.last; ++i)
          for (int end = 0; end < 2; ++end) {
            ends.add(CellTravels::find_patch(2 * a(i) + end));
            ends.add(CellTravels::find_patch(2 * b(i) + end));
          }
        num_watched(k) = ends.find_count();
      });
}

void restart_cells(const WorkSpace& space, const EdgeCheckInputs& inputs, const EdgePairs& all, double steps,
                   EdgeCells& cells) {
  restart_travels(space, list_points(inputs), steps, cells.travels);
  cells.due_pairs = all.num_pairs;
}

void find_due_cells(const WorkSpace& space, const EdgeCheckInputs& inputs, const EdgePairs& /*all*/, double steps,
                    double ahead, EdgeCells& cells) {
  const Array<int> is_due = cells.travels.is_due;
  parallel_for(
      "contact::clear_due_cells", RangeOf(space, 0, cells.travels.num_cells),
      KOKKOS_LAMBDA(int cell) { is_due(cell) = 0; });
  find_due_cells(space, list_points(inputs), steps, ahead, cells.travels);
  cells.due_pairs = EdgeCells::cell_pairs * cells.travels.num_due;
}

void list_near(const WorkSpace& space, const EdgeCheckInputs& inputs, const EdgePairs& all, EdgeCells& cells,
               EdgePairs& near) {
  list_due_cells(space, inputs.surface, all, cells);
  mark_held_pairs(space, inputs, all, cells);
  std::swap(cells.kept, cells.kept_before);
  const Array<const int> is_near = cells.is_near;
  const Array<const std::int64_t> held = cells.held;
  const std::int64_t now = cells.now;
  const int count = list_where(
      space, all.num_pairs, [=] KOKKOS_FUNCTION(int i) { return is_near(i) != 0 || held(i) == now; }, cells.kept);
  const bool is_same = are_same(space, cells, count, near.num_pairs);
  cells.is_new = false;
  if (is_same) return;
  near.list = (near.list < -1 ? near.list : -1) - 1;  // no search has such numbers
  near.num_pairs = count;
  reserve(near.a, count);
  reserve(near.b, count);
  reserve(near.edges, inputs.surface.num_edges);
  const Array<const int> a = all.a, b = all.b, kept = cells.kept;
  const Array<int> near_a = near.a, near_b = near.b;
  parallel_for(
      "contact::keep_near_edges", RangeOf(space, 0, count), KOKKOS_LAMBDA(int i) {
        near_a(i) = a(kept(i));
        near_b(i) = b(kept(i));
      });
  list_edges(space, inputs.surface.num_edges, cells.mark, near);
}

}  // namespace percuss
