#pragma once
// The location phase on the surface that a rank has: candidate pairs of points and boxes, by either method. Both find
// the same pairs.

#include "kernels/contact/search/block_search.hpp"
#include "kernels/contact/search/points_in_box.hpp"

namespace percuss {

/// How pairs are found: the list is the same.
enum class SearchMethod { blocks, points_in_box };

/// Memory of list_concerned().
struct ConcernedScratch {
  Array<int> mark = Array<int>("contact::mark", 0);
  Array<int> read_nodes = Array<int>("contact::read_nodes", 0);
};

/// How to search, and memory kept between searches.
struct SearchScratch {
  SearchMethod method = SearchMethod::blocks;
  BlockScratch blocks;
  RankedListScratch lists;
  Array<int> points = Array<int>("contact::points", 0);  // [searched nodes] mesh node
  ConcernedScratch concerned;
};

/// Finds all pairs of a point and a box that holds it and is not ruled out; as find_candidate_pairs(). Rule:
/// NodeFaceRule or EdgePairRule, called with both names.
template <class Rule>
std::int64_t find_hits(const WorkSpace& space, const PointQuery& query, const Rule& rule, std::int64_t max_pairs,
                       SearchScratch& scratch, CandidateList& list);

/// Where nodes and faces are searched.
struct SearchedPlaces {
  Rows3<const double> x;  // [mesh nodes][3]
  Boxes boxes;            // [searched faces]
};

/// Finds all pairs of a searched node and a searched face whose box holds the node, that may touch (pair table) and do
/// not share an element. Fills offset, face, num_pairs of the list and returns the number of pairs; if that is above
/// max_pairs the list is not filled.
std::int64_t find_candidate_pairs(const WorkSpace& space, const ContactSurface& surface, const SearchedPlaces& places,
                                  std::int64_t max_pairs, SearchScratch& scratch, CandidateList& list);

/// Lists the nodes that have candidates and the faces that their check reads: candidates, the faces around these and
/// the nodes' own faces.
void list_concerned(const WorkSpace& space, const ContactSurface& surface, ConcernedScratch& scratch,
                    CandidateList& list);

}  // namespace percuss
