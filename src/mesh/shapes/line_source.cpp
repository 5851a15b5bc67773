// A straight line of beams.

#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/shapes/shape_source.hpp"

namespace percuss {
namespace {

class LineSource final : public ShapeSource {
 public:
  explicit LineSource(const LineShape& shape) : shape_(shape) {}

  TopologyKind topology() const override { return TopologyKind::line2; }
  int node_count() const override { return shape_.cells + 1; }
  int element_count() const override { return shape_.cells; }
  Corners corners(int element) const override { return {element, element + 1}; }

  Vec3 place(int node) const override {
    const double share = double(node) / shape_.cells;
    Vec3 x;
    for (std::size_t k = 0; k < 3; ++k)  // both ends to the last bit
      x[k] = node == shape_.cells ? shape_.to[k] : shape_.from[k] + share * (shape_.to[k] - shape_.from[k]);
    return x;
  }

  FaceSides face_sides(int /*element*/) const override {
    FaceSides none;
    none.fill(interior);
    return none;
  }

  unsigned node_sides(int node) const override {
    return (node == 0 ? 0b01U : 0U) | (node == shape_.cells ? 0b10U : 0U);
  }

  std::vector<CellBlock> blocks() const override {
    const double edge = find_distance(shape_.from, shape_.to) / shape_.cells;
    return {{0, {shape_.cells, 1, 1}, {1, shape_.cells, shape_.cells}, {edge, edge, edge}}};
  }

 private:
  LineShape shape_;
};

}  // namespace

std::unique_ptr<ShapeSource> make_line_source(const LineShape& shape) { return std::make_unique<LineSource>(shape); }

}  // namespace percuss
