#pragma once
// The detailed check of all edge pairs: which edges touch.

#include "kernels/contact/check/edge_check.hpp"
#include "kernels/contact/check/still_items.hpp"

namespace percuss {

/// Edges in a step, of those in pairs.
struct EdgeState {
  Boxes boxes = Boxes("contact::edge_step_boxes", 0);  // [edges] over the step, each widened by half the reach of the
                                                       // check
  Array<EdgeFaces> faces = Array<EdgeFaces>("contact::edge_faces", 0);  // [edges] in scenes with offsets; empty: every
                                                                        // pair loads them
};

/// Finds the state of the edges in pairs; that of still edges stands. Counts the still ones.
void update_edges(const WorkSpace& space, const EdgeSurface& surface, const SurfaceMotion& motion,
                  const EdgePairs& pairs, StillEdges& still, const EdgeState& state);

/// Accepted touches, in the order of the pairs.
struct EdgeTouchTable {
  int count = 0;
  int num_new = 0;         // of pairs of which the check before did not find the same, at rest
  int list_of_pairs = -1;  // EdgePairs::list of the last check
  Array<EdgeTouch> by_pair = Array<EdgeTouch>("contact::edge_touches", 0);  // [pairs]
  Array<int> touches = Array<int>("contact::edge_touch_marks", 0);          // [pairs] marks of the last check
  Array<int> list = Array<int>("contact::touching_edge_pairs", 0);          // [count] pairs, ascending
  Array<int> first_record = Array<int>("contact::first_edge_record", 0);    // [edges] in pairs: of the edge as A
};

/// All that the check reads besides pairs of edges.
struct EdgeCheckInputs {
  EdgeSurface surface;
  SurfaceMotion motion;
  EdgeState state;      // of update_edges()
  EdgeHistory history;  // of the last step; only its names, marks and normals are read
};

/// Checks every pair but those that lie still and remember nothing. still: as update_edges() has left it.
void find_edge_touches(const WorkSpace& space, const EdgeCheckInputs& inputs, const EdgePairs& pairs,
                       const StillEdges& still, EdgeTouchTable& table);

/// Depth of every pair at the places of a motion with dt = 0, as gap_start of the table's touches.
void find_edge_depths(const WorkSpace& space, const EdgeSurface& surface, const SurfaceMotion& motion,
                      const EdgePairs& pairs, EdgeTouchTable& table);

}  // namespace percuss
