#pragma once
// Boxes on the host, in which points are looked up a few times.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernels/contact/geometry/point3.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/index.hpp"

namespace percuss {

/// Places of nodes on the host.
using HostPlaces = decltype(to_host(Rows3<const double>()));

/// A box with the place of what it bounds.
struct HostBox {
  double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
  int item = 0;

  void add(const Point3& p) {
    const double x[3] = {p.x, p.y, p.z};
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  }
  void join(const HostBox& other) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  void widen(double by) {
    for (int k = 0; k < 3; ++k) {
      low[k] -= by;
      high[k] += by;
    }
  }
  bool meets(const HostBox& other) const {
    for (int k = 0; k < 3; ++k)
      if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
    return true;
  }
  double find_distance(const Point3& p) const {
    const double x[3] = {p.x, p.y, p.z};
    double square = 0;
    for (int k = 0; k < 3; ++k) {
      const double beyond = std::max({low[k] - x[k], x[k] - high[k], 0.0});
      square += beyond * beyond;
    }
    return std::sqrt(square);
  }
  bool holds(const Point3& p) const {
    return p.x > low[0] && p.x < high[0] && p.y > low[1] && p.y < high[1] && p.z > low[2] && p.z < high[2];
  }
};

/// Sorted along the axis on which they extend farthest.
class BoxList {
 public:
  explicit BoxList(std::vector<HostBox> boxes) : boxes_(std::move(boxes)) {
    HostBox all;
    for (const HostBox& box : boxes_) all.join(box);
    for (int k = 1; k < 3; ++k)
      if (all.high[k] - all.low[k] > all.high[axis_] - all.low[axis_]) axis_ = k;
    std::sort(boxes_.begin(), boxes_.end(), [this](const HostBox& a, const HostBox& b) {
      return a.low[axis_] != b.low[axis_] ? a.low[axis_] < b.low[axis_] : a.item < b.item;
    });
    for (const HostBox& box : boxes_) widest_ = std::max(widest_, box.high[axis_] - box.low[axis_]);
  }

  /// Calls visit(item) for each box that holds the point.
  template <class Visit>
  void visit_around(const Point3& p, const Visit& visit) {
    const double x[3] = {p.x, p.y, p.z};
    const auto first = std::lower_bound(boxes_.begin(), boxes_.end(), x[axis_] - widest_,
                                        [this](const HostBox& box, double low) { return box.low[axis_] < low; });
    for (auto box = first; box != boxes_.end() && box->low[axis_] < x[axis_]; ++box) {
      ++tests_;
      if (box->holds(p)) visit(box->item);
    }
  }

  std::int64_t tests() const { return tests_; }  // of points and boxes so far

 private:
  std::vector<HostBox> boxes_;
  int axis_ = 0;
  double widest_ = 0;
  std::int64_t tests_ = 0;
};

}  // namespace percuss
