#pragma once
// How far points have moved beside each other, by cells of a few points: a body that flies, and a fold that grows
// elsewhere, use up nothing. Each cell has a travel of its own for which what was found of it holds.

#include "kernels/contact/surface/contact_state.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

/// Boxes of how far the points of a patch have moved from where travels begin, and of their ways in the step.
struct alignas(64) PatchMove {
  float low[4], high[4], slowest[4], fastest[4];
};

/// Points come in patches of eight, one after the other.
struct CellTravels {
  static constexpr int patch_points = 8, most_watched = 96;

  int num_cells = 0, num_due = 0;
  Array<int> watched = Array<int>("contact::watched_patches", 0);        // [cells][most_watched]
  Array<int> num_watched = Array<int>("contact::num_watched", 0);        // [cells] -1: too many, nothing holds for long
  Array<double> allowed = Array<double>("contact::cell_travel", 0);      // [cells]
  Array<int> is_due = Array<int>("contact::due_cells", 0);               // [cells]
  Array<int> due = Array<int>("contact::due_cells", 0);                  // [num_due] ascending
  Rows3<double> origin = Rows3<double>("contact::cell_origin", 0);       // [points] where travels begin
  Array<PatchMove> moves = Array<PatchMove>("contact::patch_moves", 0);  // [patches]

  KOKKOS_INLINE_FUNCTION static constexpr int find_patch(int point) { return point / patch_points; }
};

/// The motion of points: rows(point) of it.
struct MovingPoints {
  SurfaceMotion motion;
  Array<const int> rows;
  int count = 0;
};

/// Numbers, each once, in the order in which they come.
struct NumberSet {
  static constexpr int places = 1024;  // a power of two, far more than there is room for
  int table[places];
  int* list;
  int room, count = 0;  // room: -1 once they are too many

  KOKKOS_INLINE_FUNCTION NumberSet(int* numbers, int most) : list(numbers), room(most) {
    for (int& place : table) place = -1;
  }
  KOKKOS_INLINE_FUNCTION void add(int number) {
    unsigned place = static_cast<unsigned>(number) * 2654435761U >> 22U;
    for (; table[place] >= 0; place = (place + 1) % places)
      if (table[place] == number) return;
    if (count >= room) {
      room = -1;
      return;
    }
    table[place] = number;
    list[count++] = number;
  }
  KOKKOS_INLINE_FUNCTION int find_count() const { return room < 0 ? -1 : count; }
};

/// Makes room for cells.
void reserve_cells(int num_cells, int num_points, CellTravels& travels);

/// Begins travels at this step's places: all cells are due, and their travels last for the way of so many steps as
/// this.
void restart_travels(const WorkSpace& space, const MovingPoints& points, double steps, CellTravels& travels);

/// Adds the cells whose travels are used up to those that are marked as due, and lists them. steps: since travels
/// began; ahead: for which longer travels are to last besides.
void find_due_cells(const WorkSpace& space, const MovingPoints& points, double steps, double ahead,
                    CellTravels& travels);

}  // namespace percuss
