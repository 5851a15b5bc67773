#pragma once
// Step (5.4) of the paper's Figure 5 for any boxes: which ranks does each reach?

#include <vector>

#include "comm/communicator.hpp"
#include "comm/cut_tree.hpp"
#include "kernels/contact/capture_boxes.hpp"

namespace percuss {

/// Boxes and the ranks that they reach, by box, ranks ascending.
struct ReachedRanks {
  std::vector<int> box, rank;
};

/// The ranks that the first `num_boxes` boxes reach by the cuts. first: memory. Throws RunError on all ranks if copies
/// of boxes would be absurdly many; margin, by which boxes are wider than what they bound, is for the message.
/// Collective.
ReachedRanks list_reached_ranks(const Communicator& ranks, const CutTree& tree, const Boxes& boxes, int num_boxes,
                                double margin, Array<int>& first);

}  // namespace percuss
