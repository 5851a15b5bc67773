#include "kernels/contact/search/cell_travels.hpp"

#include "kernels/core/index_lists.hpp"

namespace percuss {
namespace {

/// A box that holds nothing.
KOKKOS_INLINE_FUNCTION PatchMove make_empty_move() {
  constexpr float none = 3e38F;
  PatchMove move;
  for (int i = 0; i < 4; ++i) {
    move.low[i] = move.slowest[i] = none;
    move.high[i] = move.fastest[i] = -none;
  }
  return move;
}

void store_moves(const WorkSpace& space, const MovingPoints& points, const CellTravels& travels) {
  const MovingPoints p = points;
  const Rows3<const double> origin = travels.origin;
  const Array<PatchMove> moves = travels.moves;
  const int patches = CellTravels::find_patch(points.count + CellTravels::patch_points - 1);
  parallel_for(
      "contact::store_moves", RangeOf(space, 0, patches), KOKKOS_LAMBDA(int patch) {
        PatchMove move = make_empty_move();
        const int first = CellTravels::patch_points * patch, after = first + CellTravels::patch_points;
        for (int n = first; n < after && n < p.count; ++n) {
          const int row = p.rows(n);
          for (int i = 0; i < 3; ++i) {
            const auto moved = static_cast<float>(p.motion.x(row, i) - origin(n, i));
            const auto way = static_cast<float>(p.motion.dt * p.motion.v(row, i));
            move.low[i] = smaller(move.low[i], moved);
            move.high[i] = larger(move.high[i], moved);
            move.slowest[i] = smaller(move.slowest[i], way);
            move.fastest[i] = larger(move.fastest[i], way);
          }
        }
        moves(patch) = move;
      });
}

/// How far the points of a cell have moved beside each other.
struct CellMove {
  PatchMove all = make_empty_move();

  KOKKOS_INLINE_FUNCTION CellMove(const CellTravels& travels, int cell) {
    const int* const list = &travels.watched(CellTravels::most_watched * cell);
    for (int k = 0; k < travels.num_watched(cell); ++k) {
      const PatchMove& m = travels.moves(list[k]);
      for (int i = 0; i < 4; ++i) {
        all.low[i] = smaller(all.low[i], m.low[i]);
        all.high[i] = larger(all.high[i], m.high[i]);
        all.slowest[i] = smaller(all.slowest[i], m.slowest[i]);
        all.fastest[i] = larger(all.fastest[i], m.fastest[i]);
      }
    }
  }

  /// Half of the diagonal of a box.
  KOKKOS_INLINE_FUNCTION static double find_half(const float (&low)[4], const float (&high)[4]) {
    double square = 0;
    for (int i = 0; i < 3; ++i) {
      const double side = static_cast<double>(high[i]) - static_cast<double>(low[i]);
      square += side * side;
    }
    return 0.5 * std::sqrt(square);
  }
  KOKKOS_INLINE_FUNCTION double find_way() const { return find_half(all.slowest, all.fastest); }

  /// What of a travel is used: no point has gone farther from where they all would be together, at n, or one way more
  /// at the predicted place or one step before. The rest is what a gap may be wider by ways.
  KOKKOS_INLINE_FUNCTION double find_used() const {
    constexpr double ways = 5, round_off = 1e-6;
    double most = 0;
    for (int i = 0; i < 3; ++i) most += std::fabs(all.low[i]) + std::fabs(all.high[i]);
    return find_half(all.low, all.high) + ways * find_way() + round_off * most;
  }
};

}  // namespace

void reserve_cells(int num_cells, int num_points, CellTravels& travels) {
  travels.num_cells = num_cells;
  reserve(travels.watched, CellTravels::most_watched * num_cells);
  reserve(travels.num_watched, num_cells);
  reserve(travels.allowed, num_cells);
  reserve(travels.is_due, num_cells);
  reserve(travels.due, num_cells);
  reserve(travels.origin, num_points);
  reserve(travels.moves, CellTravels::find_patch(num_points + CellTravels::patch_points - 1));
}

void restart_travels(const WorkSpace& space, const MovingPoints& points, double steps, CellTravels& travels) {
  const MovingPoints p = points;
  const CellTravels t = travels;
  parallel_for(
      "contact::store_origin", RangeOf(space, 0, points.count),
      KOKKOS_LAMBDA(int n) { store_row(t.origin, n, load_row(p.motion.x, p.rows(n))); });
  store_moves(space, points, travels);
  parallel_for(
      "contact::restart_cells", RangeOf(space, 0, travels.num_cells), KOKKOS_LAMBDA(int cell) {
        t.due(cell) = cell;
        if (t.num_watched(cell) < 0) return;
        const CellMove move(t, cell);
        t.allowed(cell) = larger(move.find_used(), steps * move.find_way());
      });
  travels.num_due = travels.num_cells;
}

void find_due_cells(const WorkSpace& space, const MovingPoints& points, double steps, double ahead,
                    CellTravels& travels) {
  store_moves(space, points, travels);
  const CellTravels t = travels;
  parallel_for(
      "contact::find_used_travels", RangeOf(space, 0, travels.num_cells), KOKKOS_LAMBDA(int cell) {
        constexpr double at_least = 1.5;
        if (t.num_watched(cell) < 0) return;
        const double used = CellMove(t, cell).find_used();
        if (used <= t.allowed(cell)) return;
        t.is_due(cell) = 1;
        t.allowed(cell) = used * larger(at_least, (steps + ahead) / steps);
      });
  travels.num_due = list_where(
      space, travels.num_cells, [t] KOKKOS_FUNCTION(int cell) { return t.is_due(cell) != 0; }, travels.due);
}

}  // namespace percuss
