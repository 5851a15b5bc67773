#include "src/mesh/decompose.hpp"

#include <algorithm>
#include <cstddef>

#include "comm/graph_partition.hpp"

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Graph make_chunk_graph(const ChunkedMesh& whole) {
  std::vector<int> first{0}, nodes, costs;
  for (const Chunk& chunk : whole.chunks) {
    const auto begin = nodes.size();
    for (int e = 0; e < chunk.element_count; ++e) {
      const auto& corners = whole.mesh.elements[at(chunk.first_element + e)];
      nodes.insert(nodes.end(), corners.begin(), corners.end());
    }
    std::sort(nodes.begin() + static_cast<std::ptrdiff_t>(begin), nodes.end());
    nodes.erase(std::unique(nodes.begin() + static_cast<std::ptrdiff_t>(begin), nodes.end()), nodes.end());
    first.push_back(static_cast<int>(nodes.size()));
    costs.push_back(chunk.element_count);
  }
  return build_chunk_graph(first, nodes, costs);
}

/// Takes the chunks of one rank out of the whole mesh.
ChunkedMesh take_share(const ChunkedMesh& whole, const Communicator& ranks) {
  const Mesh& mesh = whole.mesh;
  ChunkedMesh share;
  share.numbering = whole.numbering;
  Mesh& own = share.mesh;
  own.parts = mesh.parts;
  own.low = mesh.low;
  own.high = mesh.high;
  own.ranks = ranks;
  if (ranks.rank() == 0) own.warnings = mesh.warnings;
  std::vector<int> new_node(mesh.nodes.size(), -1), new_element(mesh.elements.size(), -1);
  for (const Chunk& chunk : whole.chunks) {
    if (whole.numbering.ranks[at(chunk.number)] != ranks.rank()) continue;
    share.chunks.push_back({static_cast<int>(own.elements.size()), chunk.element_count, chunk.part, chunk.number});
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e) {
      new_element[at(e)] = static_cast<int>(own.elements.size());
      own.elements.push_back(mesh.elements[at(e)]);
      own.element_ids.push_back(mesh.element_ids[at(e)]);
      own.element_part.push_back(mesh.element_part[at(e)]);
      own.exterior.push_back(mesh.exterior[at(e)]);
      own.bodies.push_back(mesh.bodies[at(e)]);
      for (const int n : mesh.elements[at(e)]) new_node[at(n)] = 0;
    }
  }
  for (std::size_t n = 0; n < new_node.size(); ++n) {
    if (new_node[n] < 0) continue;
    new_node[n] = static_cast<int>(own.nodes.size());
    own.nodes.push_back(mesh.nodes[n]);
    own.node_ids.push_back(mesh.node_ids[n]);
    own.node_numbers.push_back(static_cast<std::int64_t>(n));
  }
  for (auto& element : own.elements) {
    for (int& node : element) node = new_node[at(node)];
  }
  for (const auto& [name, nodes] : mesh.node_sets) {
    auto& set = own.node_sets[name];
    for (const int n : nodes) {
      if (new_node[at(n)] >= 0) set.push_back(new_node[at(n)]);
    }
  }
  for (const auto& [name, faces] : mesh.side_sets) {
    auto& set = own.side_sets[name];
    for (const ElementFace& f : faces) {
      if (new_element[at(f.element)] >= 0) set.push_back({new_element[at(f.element)], f.face});
    }
  }
  return share;
}

}  // namespace

ChunkedMesh load_mesh(const Deck& deck, const Communicator& ranks) {
  ChunkedMesh whole = order_chunks(build_mesh(deck));
  if (ranks.size() == 1) {
    whole.mesh.ranks = ranks;
    return whole;
  }
  whole.numbering.ranks = partition_for_ranks(ranks, make_chunk_graph(whole)).parts;
  return take_share(whole, ranks);
}

}  // namespace percuss
