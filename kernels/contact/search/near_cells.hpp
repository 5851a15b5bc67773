#pragma once
// Candidate pairs that can come into contact soon, by how far nodes move beside each other.
//
// Eight contact nodes with candidates are a cell. Whether one of its nodes can be in contact with one of its candidate
// faces depends on the motion of the nodes of these faces, and of those around them, relative to each other: a body
// that flies, and a fold that grows elsewhere, change nothing in it. Each cell has a travel of its own for which its
// list of near pairs holds, and is listed again when that is used up.

#include "kernels/contact/search/cell_travels.hpp"
#include "kernels/contact/search/moved_shape.hpp"
#include "kernels/contact/search/pair_search.hpp"

namespace percuss {

struct NearCells {
  static constexpr int cell_nodes = 8, most_around = 12;

  CellTravels travels;                                        // of contact nodes
  int due_pairs = 0;                                          // candidates of the cells that are due
  Array<int> known = Array<int>("contact::cell_history", 0);  // [3 nodes] history_face as lists have it

  Array<int> around = Array<int>("contact::patches_around", 0);  // [contact nodes][most_around] -1: no more

  // Faces where travels begin.
  Rows4<double> slabs = Rows4<double>("contact::face_slabs", 0);             // [5 faces]
  Rows3<double> normal = Rows3<double>("contact::origin_normals", 0);        // [faces]
  Array<double> turn = Array<double>("contact::face_turns", 0);              // [faces] FaceSlabs::turn
  Array<int> is_bounded = Array<int>("contact::bounded_faces", 0);           // [faces] 1: to be, 2: is
  Array<int> to_bound = Array<int>("contact::bounded_faces", 0);             // list
  Array<OutwardBound> outward = Array<OutwardBound>("contact::outward", 0);  // [faces]

  Array<int> nearness = Array<int>("contact::nearness", 0);  // [pairs] of the last listing
  Array<int> near_face =
      Array<int>("contact::near_faces", 0);                 // [pairs] a node's near ones, where its candidates begin
  Array<int> count = Array<int>("contact::near_count", 0);  // [contact nodes] of these
  ConcernedScratch concerned;
};

/// Takes the pairs of a search into use.
void watch_cells(const WorkSpace& space, const ContactSurface& surface, const CandidateList& all, NearCells& cells);

/// Begins travels at this step's places: all cells are to be listed, for the way of so many steps as this one.
void restart_cells(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& all, double steps,
                   NearCells& cells);

/// Finds which cells are to be listed, because their travels are used up or a node has another history. steps, ahead:
/// as find_due_cells() of travels has them.
void find_due_cells(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& all, double steps,
                    double ahead, NearCells& cells);

/// Lists the near pairs of the cells that are due, and fills `near` with those of all cells.
void list_near(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& all, NearCells& cells,
               CandidateList& near);

}  // namespace percuss
