#pragma once
// The mesh of a text file in memory, all ids looked up (src/mesh/files/text_builder.hpp makes it).

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/mesh/files/mesh_file.hpp"

namespace percuss {

/// Content of the file. Nodes, elements and blocks count from 1, as MeshFile has them.
struct TextContents {
  std::string kinds;  // of elements that can be run
  std::vector<Vec3> nodes;
  std::vector<std::int64_t> node_ids, element_ids;
  std::vector<FileBlock> blocks;
  std::vector<std::vector<std::int64_t>> corners;  // [blocks]
  std::vector<std::vector<double>> thicknesses;    // [blocks][elements] 0: none; a block without any is empty
  std::vector<FileSet> node_sets, side_sets, element_sets;
  std::map<std::string, std::vector<std::int64_t>> nodes_of_sets, elements_of_sets;
  std::map<std::string, std::vector<FileSide>> sides_of_sets;  // sides are faces of the topology, from 1
  std::vector<std::string> notes;

  /// Adds a block behind the others, with its elements by their ids.
  void add_block(FileBlock block, const std::vector<std::int64_t>& ids, std::vector<std::int64_t> own_corners,
                 std::vector<double> own_thicknesses) {
    block.elements = static_cast<std::int64_t>(ids.size());
    block.first_element = static_cast<std::int64_t>(element_ids.size()) + 1;
    element_ids.insert(element_ids.end(), ids.begin(), ids.end());
    blocks.push_back(std::move(block));
    corners.push_back(std::move(own_corners));
    thicknesses.push_back(std::move(own_thicknesses));
  }

  /// Its place among the blocks; their number: none is like it.
  std::size_t find_block(const FileBlock& block) const {
    const auto is_same = [&](const FileBlock& other) {
      return other.first_element == block.first_element && other.elements == block.elements;
    };
    return static_cast<std::size_t>(std::find_if(blocks.begin(), blocks.end(), is_same) - blocks.begin());
  }
};

class TextMesh : public MeshFile {
 public:
  explicit TextMesh(TextContents contents) : of_(std::move(contents)) {}

  int dimensions() const override { return 3; }
  std::int64_t node_count() const override { return static_cast<std::int64_t>(of_.nodes.size()); }
  std::int64_t element_count() const override { return static_cast<std::int64_t>(of_.element_ids.size()); }
  const std::vector<FileBlock>& blocks() const override { return of_.blocks; }
  const std::vector<FileSet>& node_sets() const override { return of_.node_sets; }
  const std::vector<FileSet>& side_sets() const override { return of_.side_sets; }
  const std::vector<FileSet>& element_sets() const override { return of_.element_sets; }
  std::vector<Vec3> read_coordinates() const override { return of_.nodes; }
  std::vector<std::int64_t> read_connectivity(const FileBlock& block) const override {
    const std::size_t b = of_.find_block(block);
    return b < of_.blocks.size() ? of_.corners[b] : std::vector<std::int64_t>{};
  }
  std::vector<double> read_thicknesses(const FileBlock& block) const override {
    const std::size_t b = of_.find_block(block);
    return b < of_.blocks.size() ? of_.thicknesses[b] : std::vector<double>{};
  }
  std::vector<std::int64_t> read_node_ids() const override { return of_.node_ids; }
  std::vector<std::int64_t> read_element_ids() const override { return of_.element_ids; }
  std::vector<std::int64_t> read_node_set(const FileSet& set) const override { return of_.nodes_of_sets.at(set.name); }
  std::vector<FileSide> read_side_set(const FileSet& set) const override { return of_.sides_of_sets.at(set.name); }
  std::vector<std::int64_t> read_element_set(const FileSet& set) const override {
    return of_.elements_of_sets.at(set.name);
  }
  int find_face(const Topology& topology, std::int64_t side) const override {
    const bool is_tet = topology.family == ElementFamily::tetrahedra;  // which may have had ten nodes
    return side >= 1 && side <= (is_tet ? tet10_sides : topology.face_count) ? static_cast<int>(side) - 1 : -1;
  }
  std::string list_kinds() const override { return of_.kinds; }
  std::vector<std::string> notes() const override { return of_.notes; }

 private:
  TextContents of_;
};

}  // namespace percuss
