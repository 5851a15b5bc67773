#pragma once
// Pairs of edges that can come into contact soon: near_cells.hpp for edges.

#include "kernels/contact/check/edge_touches.hpp"
#include "kernels/contact/search/cell_travels.hpp"

namespace percuss {

struct EdgeCells {
  static constexpr int cell_pairs = 32;

  CellTravels travels;                                             // of ends: end i of an edge is point 2 edge + i
  int due_pairs = 0;                                               // of the cells that are due
  bool is_new = true;                                              // nothing is listed of these pairs yet
  std::int64_t now = 0;                                            // lists so far
  Array<int> is_near = Array<int>("contact::near_edge_pairs", 0);  // [pairs]
  Array<std::int64_t> held =
      Array<std::int64_t>("contact::held_pairs", 0);                   // [pairs] last list in which it had a record
  Array<int> kept = Array<int>("contact::near_edge_pairs", 0);         // [near pairs] among all
  Array<int> kept_before = Array<int>("contact::near_edge_pairs", 0);  // likewise, of the list before
  Array<int> mark = Array<int>("contact::near_edge_mark", 0);          // [edges]
};

/// Takes the pairs of a search into use.
void watch_cells(const WorkSpace& space, const EdgeSurface& surface, const EdgePairs& all, EdgeCells& cells);

/// Begins travels at this step's places, as restart_travels().
void restart_cells(const WorkSpace& space, const EdgeCheckInputs& inputs, const EdgePairs& all, double steps,
                   EdgeCells& cells);

/// Finds which cells are to be listed, as find_due_cells() of travels.
void find_due_cells(const WorkSpace& space, const EdgeCheckInputs& inputs, const EdgePairs& all, double steps,
                    double ahead, EdgeCells& cells);

/// Fills `near` with the near pairs of all cells, of which those that are due are listed, and the pairs with a record,
/// in the same order. Where these are the same as before, `near` stays as it is.
void list_near(const WorkSpace& space, const EdgeCheckInputs& inputs, const EdgePairs& all, EdgeCells& cells,
               EdgePairs& near);

}  // namespace percuss
