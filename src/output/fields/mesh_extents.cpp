#include "src/output/fields/mesh_extents.hpp"

#include <algorithm>

#include "comm/all_reduce.hpp"

namespace percuss {

std::vector<MeshExtent> find_part_extents(const ChunkedMesh& chunked, const Communicator& ranks) {
  const Mesh& mesh = chunked.mesh;
  std::vector<std::int64_t> counts(3 * mesh.parts.size());  // elements, shells, triangles of each part
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    std::int64_t* of_part = &counts[3 * static_cast<std::size_t>(mesh.element_part[e])];
    ++of_part[0];
    of_part[1] += is_shell(mesh.elements[e]) ? 1 : 0;
    of_part[2] += is_triangle(mesh.elements[e]) ? 1 : 0;
  }
  all_reduce(ranks, Reduce::sum, counts);
  const Numbering& numbering = chunked.numbering;
  std::vector<MeshExtent> extents(mesh.parts.size());
  MeshExtent before;
  for (std::size_t p = 0; p < extents.size(); ++p) {
    MeshExtent& part = extents[p];
    part.first_element = before.first_element + before.elements;
    part.first_node = before.first_node + before.nodes;
    part.first_corner = before.first_corner + before.corners();
    part.elements = counts[3 * p];
    part.shells = counts[3 * p + 1];
    part.triangles = counts[3 * p + 2];
    // The first chunk of the next part begins where this one ends.
    const auto& first = numbering.first_element;
    const auto end = std::lower_bound(first.begin(), first.end(), part.first_element + part.elements) - first.begin();
    part.nodes = numbering.first_node[static_cast<std::size_t>(end)] - part.first_node;
    before = part;
  }
  return extents;
}

MeshExtent join_extents(const std::vector<MeshExtent>& parts) {
  MeshExtent all;
  for (const MeshExtent& part : parts) {
    all.nodes += part.nodes;
    all.elements += part.elements;
    all.shells += part.shells;
    all.triangles += part.triangles;
  }
  return all;
}

}  // namespace percuss
