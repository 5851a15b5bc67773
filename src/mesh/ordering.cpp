#include "src/mesh/ordering.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>

#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

std::vector<Vec3> find_element_centers(const PartMesh& mesh) {
  std::vector<Vec3> centers(mesh.elements.size());
  for (std::size_t e = 0; e < centers.size(); ++e)
    centers[e] = find_center(gather_corners(mesh.elements, e, mesh.nodes));
  return centers;
}

int find_widest_axis(const std::vector<Vec3>& centers, std::span<const int> elements) {
  Vec3 low = centers[at(elements.front())], high = low;
  for (const int e : elements) {
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], centers[at(e)][d]);
      high[d] = std::max(high[d], centers[at(e)][d]);
    }
  }
  int widest = 0;
  for (int d = 1; d < 3; ++d) {
    if (high[at(d)] - low[at(d)] > high[at(widest)] - low[at(widest)]) widest = d;
  }
  return widest;
}

/// Strict total order of elements along an axis, so that a cut has one answer whatever algorithm finds it.
struct AlongAxis {
  const std::vector<Vec3>& centers;
  std::size_t axis;
  bool operator()(int a, int b) const {
    const Vec3 &x = centers[at(a)], &y = centers[at(b)];
    for (const std::size_t d : {axis, (axis + 1) % 3, (axis + 2) % 3}) {
      if (x[d] != y[d]) return x[d] < y[d];
    }
    return a < b;
  }
};

class Bisection {
 public:
  Bisection(const std::vector<Vec3>& centers, ElementOrder& order) : centers_(centers), order_(order) {}

  /// Cuts elements [first, last) of the order into so many chunks.
  void cut(std::size_t first, std::size_t last, std::size_t chunk_count) {
    const std::span<int> run(order_.elements.data() + first, last - first);
    if (chunk_count == 1) {
      std::sort(run.begin(), run.end());
      order_.first_of_chunk.push_back(static_cast<int>(last));
      return;
    }
    const std::size_t lower = chunk_count / 2, units = divide_up(run.size(), chunk_granularity);
    const std::size_t middle = first + units * lower / chunk_count * chunk_granularity;
    const AlongAxis before{centers_, at(find_widest_axis(centers_, run))};
    std::nth_element(run.begin(), run.begin() + static_cast<std::ptrdiff_t>(middle - first), run.end(), before);
    cut(first, middle, lower);
    cut(middle, last, chunk_count - lower);
  }

  static std::size_t divide_up(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

 private:
  const std::vector<Vec3>& centers_;
  ElementOrder& order_;
};

}  // namespace

std::vector<std::int64_t> list_element_numbers(const ChunkedMesh& chunked) {
  std::vector<std::int64_t> numbers(chunked.mesh.elements.size());
  for (const Chunk& chunk : chunked.chunks) {
    const auto first = numbers.begin() + chunk.first_element;
    std::iota(first, first + chunk.element_count,
              chunked.numbering.first_element[static_cast<std::size_t>(chunk.number)]);
  }
  return numbers;
}

ElementOrder bisect_elements(const PartMesh& mesh, const std::vector<int>& groups) {
  ElementOrder order{std::vector<int>(mesh.elements.size()), {0}};
  std::iota(order.elements.begin(), order.elements.end(), 0);
  const auto kind_of = [&](int e) {
    return std::pair(mesh.elements.topology_of(at(e)).family, groups.empty() ? 0 : groups[at(e)]);
  };
  std::stable_sort(order.elements.begin(), order.elements.end(), [&](int a, int b) { return kind_of(a) < kind_of(b); });
  const std::vector<Vec3> centers = find_element_centers(mesh);
  Bisection bisection(centers, order);
  for (std::size_t first = 0, last = 0; first < order.elements.size(); first = last) {
    const auto kind = kind_of(order.elements[first]);
    while (last < order.elements.size() && kind_of(order.elements[last]) == kind) ++last;
    const auto limit = static_cast<std::size_t>(find_chunk_limit(static_cast<std::int64_t>(last - first)));
    const std::size_t units = Bisection::divide_up(last - first, chunk_granularity);
    bisection.cut(first, last, Bisection::divide_up(units, limit / chunk_granularity));
  }
  return order;
}

}  // namespace percuss
