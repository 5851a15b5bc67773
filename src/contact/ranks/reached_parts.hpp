#pragma once
// Step (5.4) of the paper for any boxes: which parts of the bisection does each reach? Which rank has a part
// AssignedParts says.

#include "comm/communicator.hpp"
#include "comm/rcb/cut_tree.hpp"
#include "kernels/contact/search/capture_boxes.hpp"

namespace percuss {

/// Boxes and the parts that they reach, by box, parts ascending.
struct ReachedParts {
  Array<int> first = Array<int>("contact::first_reached", 0);  // [boxes + 1] into the other two
  Array<int> box = Array<int>("contact::reached_box", 0), part = Array<int>("contact::reached_part", 0);
};

/// The parts that the first `num_boxes` boxes reach by the cuts. Throws RunError on all ranks if copies of boxes would
/// be absurdly many; margin, by which boxes are wider than what they bound, is for the message. Collective.
ReachedParts list_reached_parts(const Communicator& ranks, const CutTree& tree, const Boxes& boxes, int num_boxes,
                                double margin);

struct ReachCount {
  std::int64_t copies = 0;    // of this rank's boxes, one for each part that a box reaches
  bool any_unlisted = false;  // whether a box of any rank reaches another part than those listed for it
};

/// As list_reached_parts(), without the list. listed: of as many boxes.
ReachCount count_reached_parts(const Communicator& ranks, const CutTree& tree, const Boxes& boxes, int num_boxes,
                               double margin, const ReachedParts& listed);

/// How many of the first `num_boxes` boxes reach one part.
std::int64_t count_boxes_that_reach(const CutTree& tree, const Boxes& boxes, int num_boxes, int part);

}  // namespace percuss
