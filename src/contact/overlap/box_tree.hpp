#pragma once
// A tree of boxes on the host, in which many boxes are looked up.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "src/contact/overlap/box_list.hpp"
#include "src/index.hpp"

namespace percuss {

/// Split at the median of the centres along the axis on which they extend farthest.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::vector<HostBox> boxes) : boxes_(std::move(boxes)) {
    if (!boxes_.empty()) split(0, boxes_.size());
  }

  /// Calls visit(item) for each box that meets this one.
  template <class Visit>
  void visit_meeting(const HostBox& box, const Visit& visit) {
    if (!nodes_.empty()) visit_below(0, box, visit);
  }

  std::int64_t tests() const { return tests_; }  // of pairs of boxes so far

 private:
  static constexpr std::size_t leaf = 4;

  /// A run of boxes; with two halves, the first of which follows it in the list.
  struct Node {
    HostBox box;
    std::size_t first = 0, last = 0;
    int second = -1;  // -1: it is a leaf
  };

  static double find_centre(const HostBox& box, int axis) { return box.low[axis] + box.high[axis]; }

  static int find_widest(const std::vector<HostBox>& boxes, std::size_t first, std::size_t last) {
    HostBox centres;
    for (std::size_t i = first; i < last; ++i)
      centres.add({find_centre(boxes[i], 0), find_centre(boxes[i], 1), find_centre(boxes[i], 2)});
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (centres.high[k] - centres.low[k] > centres.high[axis] - centres.low[axis]) axis = k;
    return axis;
  }

  int split(std::size_t first, std::size_t last) {
    const int place = static_cast<int>(nodes_.size());
    Node node{{}, first, last, -1};
    for (std::size_t i = first; i < last; ++i) {
      node.box.add({boxes_[i].low[0], boxes_[i].low[1], boxes_[i].low[2]});
      node.box.add({boxes_[i].high[0], boxes_[i].high[1], boxes_[i].high[2]});
    }
    nodes_.push_back(node);
    if (last - first <= leaf) return place;
    const int axis = find_widest(boxes_, first, last);
    const std::size_t middle = first + (last - first) / 2;
    const auto begin = boxes_.begin();
    std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(middle),
                     begin + static_cast<std::ptrdiff_t>(last), [axis](const HostBox& a, const HostBox& b) {
                       return find_centre(a, axis) < find_centre(b, axis);
                     });
    split(first, middle);
    const int second = split(middle, last);
    nodes_[at(place)].second = second;
    return place;
  }

  template <class Visit>
  void visit_below(int place, const HostBox& box, const Visit& visit) {
    const Node& node = nodes_[at(place)];
    ++tests_;
    if (!node.box.meets(box)) return;
    if (node.second >= 0) {
      visit_below(place + 1, box, visit);
      visit_below(node.second, box, visit);
      return;
    }
    tests_ += static_cast<std::int64_t>(node.last - node.first);
    for (std::size_t i = node.first; i < node.last; ++i)
      if (boxes_[i].meets(box)) visit(boxes_[i].item);
  }

  std::vector<HostBox> boxes_;
  std::vector<Node> nodes_;
  std::int64_t tests_ = 0;
};

}  // namespace percuss
