#pragma once
// The pairs that points-in-box finds, by blocks of sixteen points against a tree of blocks of sixteen boxes.
//
// Points and boxes lie in the order of kd trees, the recursive bisection of the contact decomposition carried on down
// to sixteen. The order is kept from search to search and made anew when the number of tests has grown by a half, or
// many of the points or boxes are others; the boxes of the tree are fitted to each search. A block of points walks the
// tree by comparisons of sixteen boxes at once in float; what is left is decided in double. The list of pairs is
// sorted: it depends neither on the order, and so the past, nor on the number of threads.

#include <cstdint>
#include <vector>

#include "kernels/contact/search/block_tree.hpp"
#include "kernels/contact/surface/pair_query.hpp"

namespace percuss {

/// A box and which points of a block it holds.
struct BlockHit {
  int box = 0;               // its name
  std::uint32_t points = 0;  // a bit each
};

/// Hits of one block of points, in a chain of chunks.
struct HitChunk {
  static constexpr int capacity = 62;
  int next = -1;
  int count = 0;
  BlockHit hit[capacity];
};

/// An order of points or boxes, and what they are over all searches.
struct NumberedOrder {
  std::vector<std::int64_t> numbers;  // ascending; empty: not given
  std::vector<int> order;             // places in the query; empty: to be made
};

/// Scratch memory of a search, reused by the next one.
struct BlockScratch {
  BlockTree tree;
  NumberedOrder point_order, box_order;
  bool is_other = false;                                              // points or boxes, as given to identify()
  Array<int> names = Array<int>("contact::ordered_names", 0);         // [points] in the order of their kd tree
  Array<int> rows = Array<int>("contact::ordered_rows", 0);           // [points] likewise
  Array<int> point_names = Array<int>("contact::ordered_points", 0);  // [points] whose order it is
  Array<int> point_rows = Array<int>("contact::rows_of_points", 0);   // [points] likewise
  Array<int> box_names = Array<int>("contact::ordered_boxes", 0);     // [boxes] likewise
  double first_tests = 0;                                             // boxes against blocks, when last ordered
  bool is_worn = false;                                               // to be ordered anew
  Array<int> tests = Array<int>("contact::block_tests", 0);           // [blocks of points]
  Array<HitChunk> chunks = Array<HitChunk>("contact::hit_chunks", 0);
  Array<int> num_chunks = Array<int>("contact::hit_chunk_count", 1);
  Array<int> first_chunk = Array<int>("contact::first_hit_chunk", 0);  // [blocks of points]
  Array<int> count = Array<int>("contact::hits_of_name", 0);           // [names]
};

/// Tells what the points and boxes of the next search are, by numbers that they have in every search, in the order of
/// its query, ascending. Where few are others, the order continues instead of being made anew.
void identify(const std::vector<std::int64_t>& points, const std::vector<std::int64_t>& boxes, BlockScratch& scratch);

/// find_hits() of pair_search.hpp by blocks.
template <class Rule>
std::int64_t find_hits_by_blocks(const WorkSpace& space, const PointQuery& query, const Rule& rule,
                                 std::int64_t max_pairs, BlockScratch& scratch, CandidateList& list);

}  // namespace percuss
