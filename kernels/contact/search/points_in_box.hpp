#pragma once
// Points-in-box: which contact nodes lie in which capture boxes (the paper's location phase, section 4.1.1).
//
// The nodes are ranked along each axis once: three lists and three ranks. For each box a binary search finds its
// run in each list; the shortest run is walked and the other two axes are tested by rank. With the counts by node
// that is 7 words a node; time n log n and a walk. Exact in double. pair_search.hpp chooses between this and the search
// by blocks.

#include "kernels/contact/search/point_order.hpp"
#include "kernels/contact/surface/pair_query.hpp"

namespace percuss {

/// Memory kept between searches.
struct RankedListScratch {
  Array<int> order[3] = {Array<int>("contact::order_x", 0), Array<int>("contact::order_y", 0),
                         Array<int>("contact::order_z", 0)};
  Array<int> rank[3] = {Array<int>("contact::rank_x", 0), Array<int>("contact::rank_y", 0),
                        Array<int>("contact::rank_z", 0)};
  SortScratch sort;
  Array<int> hit_node = Array<int>("contact::hit_node", 0), hit_face = Array<int>("contact::hit_face", 0);
  Array<std::int64_t> total = Array<std::int64_t>("contact::hit_total", 1);
  Array<int> count = Array<int>("contact::count", 0);
};

/// find_hits() of pair_search.hpp by ranked lists.
template <class Rule>
std::int64_t find_hits_by_points_in_box(const WorkSpace& space, const PointQuery& query, const Rule& rule,
                                        std::int64_t max_pairs, RankedListScratch& scratch, CandidateList& list);

}  // namespace percuss
