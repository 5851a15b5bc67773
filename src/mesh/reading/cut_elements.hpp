#pragma once
// Elements of a file that become several of a part: tetrahedra of ten nodes, cut into eight of four nodes.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "src/mesh/files/mesh_file.hpp"
#include "src/mesh/topology/elements.hpp"

namespace percuss {

/// Whether the elements of a block are cut.
inline bool is_cut(const FileBlock& block) {
  return block.topology == TopologyKind::tet4 && block.nodes_per_element == static_cast<std::int64_t>(tet10_nodes);
}

/// The diagonal inside a tetrahedron of ten nodes that is shortest. Of those that are longer by no more than round-off,
/// the one that ends at the node with the lowest id: neither the order of the nodes nor the precision of the file
/// decides. nodes: places in x and in ids.
std::size_t find_shortest_diagonal(std::span<const int> nodes, const std::vector<Vec3>& x,
                                   const std::vector<std::int64_t>& ids);

/// Elements of a part that come from one that was cut. The pieces of one follow each other.
class CutElements {
 public:
  void add(int first_piece) { first_.push_back(first_piece); }
  std::size_t size() const { return first_.size(); }
  /// Whether this is the first piece of an element that was cut.
  bool has(int element) const;
  /// Elements of the part that an element of the file became, by the first of them.
  int count_pieces(int element) const { return has(element) ? static_cast<int>(tet10_pieces) : 1; }

  /// Faces of the pieces that make up a side of the element: a face of the tetrahedron below 4, then the triangles of
  /// each (tet10_sides). None: it has no such side.
  static std::vector<ElementFace> find_faces(const Elements& elements, int first_piece, int side);

 private:
  std::vector<int> first_;  // ascending
};

/// Increment of the id of an element for each of its pieces after the first: a power of ten above all ids of the file.
/// None: ids of pieces would be above the highest.
std::optional<std::int64_t> find_piece_stride(const std::vector<std::int64_t>& ids, std::int64_t highest);

}  // namespace percuss
