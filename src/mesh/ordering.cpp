#include "src/mesh/ordering.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::vector<Vec3> find_element_centers(const Mesh& mesh) {
  std::vector<Vec3> centers(mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (const int node : mesh.elements[e]) {
      for (std::size_t d = 0; d < 3; ++d) centers[e][d] += 0.125 * mesh.nodes[at(node)][d];
    }
  }
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
  Bisection(const std::vector<Vec3>& centers, std::vector<int>& order, std::vector<Chunk>& chunks)
      : centers_(centers), order_(order), chunks_(chunks) {}

  /// Cuts order[first, last), all of one part, into chunks.
  void cut_part(std::size_t first, std::size_t last, int part) {
    if (first == last) return;
    const std::size_t units = divide_up(last - first, chunk_granularity);
    cut(first, last, divide_up(units, max_chunk_elements / chunk_granularity), part);
  }

 private:
  static std::size_t divide_up(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

  void cut(std::size_t first, std::size_t last, std::size_t chunk_count, int part) {
    const std::span<int> run(order_.data() + first, last - first);
    if (chunk_count == 1) {
      std::sort(run.begin(), run.end());
      chunks_.push_back(
          {static_cast<int>(first), static_cast<int>(last - first), part, static_cast<int>(chunks_.size())});
      return;
    }
    const std::size_t lower = chunk_count / 2, units = divide_up(run.size(), chunk_granularity);
    const std::size_t middle = first + units * lower / chunk_count * chunk_granularity;
    const AlongAxis before{centers_, at(find_widest_axis(centers_, run))};
    std::nth_element(run.begin(), run.begin() + static_cast<std::ptrdiff_t>(middle - first), run.end(), before);
    cut(first, middle, lower, part);
    cut(middle, last, chunk_count - lower, part);
  }

  const std::vector<Vec3>& centers_;
  std::vector<int>& order_;
  std::vector<Chunk>& chunks_;
};

/// New order of the nodes: by first use, then the nodes of no element.
std::vector<int> order_nodes_by_use(const Mesh& mesh, const std::vector<int>& element_order) {
  std::vector<int> order;
  order.reserve(mesh.nodes.size());
  std::vector<char> seen(mesh.nodes.size(), 0);
  const auto visit = [&](int node) {
    if (seen[at(node)]) return;
    seen[at(node)] = 1;
    order.push_back(node);
  };
  for (const int e : element_order) {
    for (const int node : mesh.elements[at(e)]) visit(node);
  }
  for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node) visit(node);
  return order;
}

std::vector<int> invert(const std::vector<int>& order) {
  std::vector<int> position(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) position[at(order[i])] = static_cast<int>(i);
  return position;
}

template <class T>
void permute(std::vector<T>& values, const std::vector<int>& order) {
  if (values.empty()) return;
  std::vector<T> permuted(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) permuted[i] = std::move(values[at(order[i])]);
  values = std::move(permuted);
}

void permute_mesh(Mesh& mesh, const std::vector<int>& element_order) {
  const std::vector<int> node_order = order_nodes_by_use(mesh, element_order);
  const std::vector<int> old_to_new_node = invert(node_order), old_to_new_element = invert(element_order);
  permute(mesh.nodes, node_order);
  permute(mesh.node_ids, node_order);
  permute(mesh.elements, element_order);
  permute(mesh.element_ids, element_order);
  permute(mesh.element_part, element_order);
  permute(mesh.exterior, element_order);
  for (auto& element : mesh.elements) {
    for (int& node : element) node = old_to_new_node[at(node)];
  }
  for (auto& [name, nodes] : mesh.node_sets) {
    for (int& node : nodes) node = old_to_new_node[at(node)];
    std::sort(nodes.begin(), nodes.end());
  }
  for (auto& [name, faces] : mesh.side_sets) {
    for (ElementFace& face : faces) face.element = old_to_new_element[at(face.element)];
    std::sort(faces.begin(), faces.end());
  }
}

/// Numbers of elements and nodes chunk by chunk, all on rank 0. Nodes lie in the order of their first use.
Numbering number_chunks(const Mesh& mesh, const std::vector<Chunk>& chunks) {
  Numbering numbering{{0}, {0}, std::vector<int>(chunks.size(), 0)};
  std::int64_t used = 0;
  for (const Chunk& chunk : chunks) {
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e) {
      for (const int node : mesh.elements[at(e)]) used = std::max<std::int64_t>(used, node + 1);
    }
    numbering.first_element.push_back(chunk.first_element + chunk.element_count);
    numbering.first_node.push_back(used);
  }
  return numbering;
}

}  // namespace

ChunkedMesh order_chunks(Mesh mesh) {
  std::vector<int> order(mesh.elements.size());
  std::iota(order.begin(), order.end(), 0);
  const auto by_part = [&](int a, int b) { return mesh.element_part[at(a)] < mesh.element_part[at(b)]; };
  std::stable_sort(order.begin(), order.end(), by_part);

  std::vector<Chunk> chunks;
  const std::vector<Vec3> centers = find_element_centers(mesh);
  Bisection bisection(centers, order, chunks);
  for (std::size_t first = 0; first < order.size();) {
    const int part = mesh.element_part[at(order[first])];
    const auto next = std::upper_bound(order.begin() + static_cast<std::ptrdiff_t>(first), order.end(), part,
                                       [&](int p, int e) { return p < mesh.element_part[at(e)]; });
    const auto last = static_cast<std::size_t>(next - order.begin());
    bisection.cut_part(first, last, part);
    first = last;
  }
  permute_mesh(mesh, order);
  mesh.bodies = find_bodies(mesh);
  mesh.node_numbers.resize(mesh.nodes.size());
  std::iota(mesh.node_numbers.begin(), mesh.node_numbers.end(), std::int64_t{0});
  Numbering numbering = number_chunks(mesh, chunks);
  return {std::move(mesh), std::move(chunks), std::move(numbering)};
}

}  // namespace percuss
