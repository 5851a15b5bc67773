#pragma once
// Pairs of edges that can come into contact soon: near_pairs.hpp for edges.

#include "kernels/contact/check/edge_touches.hpp"
#include "kernels/contact/search/near_pairs.hpp"

namespace percuss {

/// Memory kept between lists.
struct NearEdgeScratch {
  Boxes boxes = Boxes("contact::near_edge_boxes", 0);           // [edges]
  Array<int> kept = Array<int>("contact::near_edge_pairs", 0);  // [near pairs] among all
  Array<int> mark = Array<int>("contact::near_edge_mark", 0);   // [edges]
};

/// EdgePairs::edges and num_edges from the pairs. mark: [num_edges] scratch.
void list_edges(const WorkSpace& space, int num_edges, const Array<int>& mark, EdgePairs& pairs);

/// Fills `near` with the pairs of `all` that the check could accept before some node has gone farther than the travel
/// from its place at n, in the same order. Returns whether there are at most `most_pairs`; otherwise they are not
/// listed. Of the inputs surface and motion are read.
bool list_near_edges(const WorkSpace& space, const EdgeCheckInputs& inputs, const EdgePairs& all,
                     const NearLimits& limits, NearEdgeScratch& scratch, EdgePairs& near);

}  // namespace percuss
