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

  /// The least of `least` and of what measure(item) gives of the boxes, which is at least the distance of the point
  /// from the box.
  template <class Measure>
  double find_least(const Point3& point, double least, const Measure& measure) const {
    if (!nodes_.empty()) find_least_below(0, point, measure, least);
    return least;
  }

  /// Calls visit(box, other) for each box and each of the other tree that it meets. Counted here.
  template <class Visit>
  void visit_pairs(const BoxTree& others, const Visit& visit) {
    if (!nodes_.empty() && !others.nodes_.empty()) visit_pairs_below(0, others, 0, visit);
  }

  const std::vector<HostBox>& boxes() const { return boxes_; }
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
    nodes_.push_back({{}, first, last, -1});
    if (last - first <= leaf) {
      for (std::size_t i = first; i < last; ++i) nodes_[at(place)].box.join(boxes_[i]);
      return place;
    }
    const int axis = find_widest(boxes_, first, last);
    const std::size_t middle = first + (last - first) / 2;
    const auto begin = boxes_.begin();
    std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(middle),
                     begin + static_cast<std::ptrdiff_t>(last), [axis](const HostBox& a, const HostBox& b) {
                       return find_centre(a, axis) < find_centre(b, axis);
                     });
    split(first, middle);
    const int second = split(middle, last);
    Node& node = nodes_[at(place)];
    node.second = second;
    node.box = nodes_[at(place + 1)].box;
    node.box.join(nodes_[at(second)].box);
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

  template <class Measure>
  void find_least_below(int place, const Point3& point, const Measure& measure, double& least) const {
    const Node& node = nodes_[at(place)];
    if (node.second < 0) {
      for (std::size_t i = node.first; i < node.last; ++i)
        if (boxes_[i].find_distance(point) < least) least = std::min(least, measure(boxes_[i].item));
      return;
    }
    int halves[2] = {place + 1, node.second};
    double distances[2];
    for (int k = 0; k < 2; ++k) distances[k] = nodes_[at(halves[k])].box.find_distance(point);
    const int nearer = distances[1] < distances[0] ? 1 : 0;
    for (const int k : {nearer, 1 - nearer})
      if (distances[k] < least) find_least_below(halves[k], point, measure, least);
  }

  template <class Visit>
  void visit_pairs_below(int place, const BoxTree& others, int other, const Visit& visit) {
    const Node &a = nodes_[at(place)], &b = others.nodes_[at(other)];
    ++tests_;
    if (!a.box.meets(b.box)) return;
    if (a.second >= 0 && (b.second < 0 || a.last - a.first >= b.last - b.first)) {
      visit_pairs_below(place + 1, others, other, visit);
      visit_pairs_below(a.second, others, other, visit);
    } else if (b.second >= 0) {
      visit_pairs_below(place, others, other + 1, visit);
      visit_pairs_below(place, others, b.second, visit);
    } else {
      visit_leaves(a, others, b, visit);
    }
  }

  template <class Visit>
  void visit_leaves(const Node& a, const BoxTree& others, const Node& b, const Visit& visit) {
    for (std::size_t i = a.first; i < a.last; ++i) {
      ++tests_;
      if (!boxes_[i].meets(b.box)) continue;
      tests_ += static_cast<std::int64_t>(b.last - b.first);
      for (std::size_t j = b.first; j < b.last; ++j)
        if (boxes_[i].meets(others.boxes_[j])) visit(boxes_[i], others.boxes_[j]);
    }
  }

  std::vector<HostBox> boxes_;
  std::vector<Node> nodes_;
  std::int64_t tests_ = 0;
};

}  // namespace percuss
