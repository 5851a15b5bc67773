#pragma once
// Step (5.4) of the paper's Figure 5 for any boxes: which ranks does each reach?

#include "comm/communicator.hpp"
#include "comm/cut_tree.hpp"
#include "kernels/contact/capture_boxes.hpp"

namespace percuss {

/// Boxes and the ranks that they reach, by box, ranks ascending.
struct ReachedRanks {
  Array<int> first = Array<int>("contact::first_reached", 0);  // [boxes + 1] into the other two
  Array<int> box = Array<int>("contact::reached_box", 0), rank = Array<int>("contact::reached_rank", 0);
};

/// The ranks that the first `num_boxes` boxes reach by the cuts. Throws RunError on all ranks if copies of boxes would
/// be absurdly many; margin, by which boxes are wider than what they bound, is for the message. Collective.
ReachedRanks list_reached_ranks(const Communicator& ranks, const CutTree& tree, const Boxes& boxes, int num_boxes,
                                double margin);

struct ReachCount {
  std::int64_t copies = 0;    // of this rank's boxes, one for each rank that a box reaches
  bool any_unlisted = false;  // whether a box of any rank reaches another rank than those listed for it
};

/// As list_reached_ranks(), without the list. listed: of as many boxes.
ReachCount count_reached_ranks(const Communicator& ranks, const CutTree& tree, const Boxes& boxes, int num_boxes,
                               double margin, const ReachedRanks& listed);

/// How many of the first `num_boxes` boxes reach one rank.
std::int64_t count_boxes_that_reach(const CutTree& tree, const Boxes& boxes, int num_boxes, int rank);

}  // namespace percuss
