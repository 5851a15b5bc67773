#include "src/mesh/parts/mirrored_order.hpp"

#include <set>
#include <utility>

#include "src/index.hpp"
#include "src/mesh/topology/topologies.hpp"

namespace percuss {
namespace {

/// Corners of each kind; lines have no hand.
std::array<int, most_corners> order_corners(const Topology& topology) {
  if (topology.is_line()) return {0, 1};
  if (topology.is_surface())
    return topology.corner_count == 3 ? std::array<int, most_corners>{0, 2, 1}
                                      : std::array<int, most_corners>{0, 3, 2, 1};
  switch (topology.corner_count) {
    case 4:
      return {0, 2, 1, 3};
    case 5:
      return {0, 3, 2, 1, 4};
    case 6:
      return {0, 2, 1, 3, 5, 4};
    default:
      return {0, 3, 2, 1, 4, 7, 6, 5};
  }
}

class MirroredSource final : public ShapeSource {
 public:
  explicit MirroredSource(std::unique_ptr<ShapeSource> source)
      : source_(std::move(source)), order_(find_mirrored_order(find_topology(source_->topology()))) {}

  int node_count() const override { return source_->node_count(); }
  int element_count() const override { return source_->element_count(); }
  TopologyKind topology() const override { return source_->topology(); }
  Corners corners(int element) const override {
    const Corners before = source_->corners(element);
    std::array<int, most_corners> after{};
    for (std::size_t c = 0; c < before.size(); ++c) after[c] = before[at(order_.corner[c])];
    return with_size(after, before.size());
  }
  Vec3 place(int node) const override { return source_->place(node); }
  FaceSides face_sides(int element) const override {
    const FaceSides before = source_->face_sides(element);
    FaceSides after = before;
    const auto faces = at(find_topology(topology()).face_count);
    for (std::size_t f = 0; f < faces; ++f) after[at(order_.face[f])] = before[f];
    return after;
  }
  unsigned node_sides(int node) const override { return source_->node_sides(node); }
  std::vector<CellBlock> blocks() const override { return source_->blocks(); }

 private:
  template <std::size_t N>
  static Corners take(const std::array<int, most_corners>& nodes) {
    std::array<int, N> some{};
    std::copy_n(nodes.begin(), N, some.begin());
    return Corners(some);
  }
  static Corners with_size(const std::array<int, most_corners>& nodes, std::size_t count) {
    switch (count) {
      case 2:
        return take<2>(nodes);
      case 3:
        return take<3>(nodes);
      case 4:
        return take<4>(nodes);
      case 5:
        return take<5>(nodes);
      case 6:
        return take<6>(nodes);
      default:
        return take<8>(nodes);
    }
  }

  std::unique_ptr<ShapeSource> source_;
  MirroredOrder order_;
};

}  // namespace

MirroredOrder find_mirrored_order(const Topology& topology) {
  MirroredOrder order;
  order.corner = order_corners(topology);
  for (std::size_t f = 0; f < at(topology.face_count); ++f) order.face[f] = static_cast<int>(f);
  if (!topology.is_solid()) return order;  // the sides of a shell go with its normal
  for (std::size_t f = 0; f < at(topology.face_count); ++f) {
    std::set<int> places;  // of the corners of the old face in the new order, which is its own inverse
    for (const int c : topology.face_table[f].corners()) places.insert(order.corner[at(c)]);
    for (std::size_t g = 0; g < at(topology.face_count); ++g) {
      const auto corners = topology.face_table[g].corners();
      if (std::set<int>(corners.begin(), corners.end()) == places) order.face[f] = static_cast<int>(g);
    }
  }
  return order;
}

std::unique_ptr<ShapeSource> mirror_corners(std::unique_ptr<ShapeSource> source) {
  return std::make_unique<MirroredSource>(std::move(source));
}

}  // namespace percuss
