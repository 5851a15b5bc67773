#pragma once
// The elements of a mesh: their blocks, and the corners of each.
//
// A block is what elements have in common: topology, part, material, section. Elements of several blocks may lie in any
// order, because chunks of shells mix triangles with quadrilaterals. Nodes belong to the mesh: blocks may share them.

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "src/mesh/topology/topologies.hpp"

namespace percuss {

/// Cross section of a surface element or a beam.
struct Section {
  double thickness = 0;      // of surfaces, the largest where elements have their own [length]; else 0
  int points = 0;            // across the thickness; 0: by the material
  bool is_membrane = false;  // a surface that does not bend
  double area = 0;           // of the cross section of beams [length^2]; else 0
};

struct ElementBlock {
  TopologyKind topology = TopologyKind::hex8;
  int part = 0;      // index into Mesh::parts
  int material = 0;  // index into Deck::materials
  Section section;
  std::string name;  // in the file that it is from
};

/// A face as a side set names it.
struct ElementFace {
  int element = 0;
  int face = 0;  // place among the faces of its topology
  friend auto operator<=>(const ElementFace&, const ElementFace&) = default;
};

/// The corners of one element by value.
class Corners {
 public:
  Corners() = default;
  Corners(std::initializer_list<int> nodes) : count_(nodes.size()) {
    std::copy(nodes.begin(), nodes.end(), at_.begin());
  }
  template <std::size_t N>
  Corners(const std::array<int, N>& nodes) : count_(N) {
    std::copy(nodes.begin(), nodes.end(), at_.begin());
  }

  const int* begin() const { return at_.data(); }
  const int* end() const { return at_.data() + count_; }
  std::size_t size() const { return count_; }
  int operator[](std::size_t i) const { return at_[i]; }

 private:
  std::array<int, most_corners> at_{};
  std::size_t count_ = 0;
};

class Elements {
 public:
  std::vector<ElementBlock> blocks;
  std::vector<double> own_thickness;  // [elements] of surfaces [length]; empty: all have that of their block

  std::size_t size() const { return blocks_.size(); }
  bool empty() const { return blocks_.empty(); }

  /// Nodes of an element's corners, in the order of its topology.
  std::span<const int> corners(std::size_t element) const {
    return {corners_.data() + first_[element], corners_.data() + first_[element + 1]};
  }
  std::span<int> corners(std::size_t element) {
    return {corners_.data() + first_[element], corners_.data() + first_[element + 1]};
  }

  int block_index(std::size_t element) const { return blocks_[element]; }
  const ElementBlock& block_of(std::size_t element) const { return blocks[static_cast<std::size_t>(blocks_[element])]; }
  const Topology& topology_of(std::size_t element) const { return find_topology(block_of(element).topology); }
  /// Thickness of a surface element [length]; 0 of others.
  double thickness_of(std::size_t element) const {
    return own_thickness.empty() ? block_of(element).section.thickness : own_thickness[element];
  }

  /// Nodes of a face as contact and loads take them: four, of a triangle one twice.
  std::array<int, 4> face_nodes(const ElementFace& face) const {
    const auto e = static_cast<std::size_t>(face.element);
    const std::span<const int> nodes = corners(e);
    std::array<int, 4> four = topology_of(e).face_table[static_cast<std::size_t>(face.face)].four;
    for (int& corner : four) corner = nodes[static_cast<std::size_t>(corner)];
    return four;
  }

  /// A key that is equal for two faces with the same nodes: ascending, each once, beyond the last the largest int.
  std::array<int, 4> face_key(const ElementFace& face) const {
    const auto e = static_cast<std::size_t>(face.element);
    const std::span<const int> nodes = corners(e);
    std::array<int, 4> key;
    key.fill(std::numeric_limits<int>::max());
    std::size_t count = 0;
    for (const int c : topology_of(e).face_table[static_cast<std::size_t>(face.face)].corners())
      key[count++] = nodes[static_cast<std::size_t>(c)];
    std::sort(key.begin(), key.end());
    return key;
  }

  /// Nodes of an element as kernels see it (Topology::kernel_corners).
  std::array<int, kernel_corner_count> kernel_nodes(std::size_t element) const {
    const std::span<const int> nodes = corners(element);
    std::array<int, kernel_corner_count> corners = topology_of(element).kernel_corners;
    for (int& corner : corners) corner = nodes[static_cast<std::size_t>(corner)];
    return corners;
  }

  /// nodes: as many as the topology of the block has corners.
  void add(int block, std::span<const int> nodes) {
    blocks_.push_back(block);
    corners_.insert(corners_.end(), nodes.begin(), nodes.end());
    first_.push_back(corners_.size());
  }
  void add(int block, std::initializer_list<int> nodes) {
    add(block, std::span<const int>(nodes.begin(), nodes.size()));
  }

  /// A copy of the blocks with these elements alone, in their order.
  Elements select(std::span<const int> elements) const {
    Elements selected;
    selected.blocks = blocks;
    for (const int e : elements) {
      const auto element = static_cast<std::size_t>(e);
      selected.add(block_index(element), corners(element));
      if (!own_thickness.empty()) selected.own_thickness.push_back(own_thickness[element]);
    }
    return selected;
  }

 private:
  std::vector<int> blocks_;            // [elements] index into blocks
  std::vector<std::size_t> first_{0};  // [elements + 1] into corners_
  std::vector<int> corners_;
};

}  // namespace percuss
