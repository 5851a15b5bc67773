#pragma once
// A mesh file as a reader gives it: blocks of elements, nodes with their places and ids, and sets by name. A format is
// one class behind this interface; src/mesh/reading chooses it and makes parts of what it gives.
//
// Nodes and elements are counted from 1 in the order of the file. An id is what the file calls them; it may be any
// number of 64 bits.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/mesh/mesh.hpp"
#include "src/mesh/tet10.hpp"

namespace percuss {

struct FileBlock {
  std::int64_t id = 0;
  std::string name;  // "block_7" if the file gives none
  std::string kind;  // of its elements, as the format calls it: "HEX8", "C3D8R", ...
  std::int64_t elements = 0;
  std::int64_t nodes_per_element = 0;    // more than corners of the topology: cut (src/mesh/reading/cut_elements.hpp)
  std::int64_t first_element = 1;        // its place in the file
  std::optional<TopologyKind> topology;  // none: elements of this kind cannot be run
  std::int64_t attributes = 0;           // numbers that the file has of each element besides
};

struct FileSet {
  std::int64_t id = 0;
  std::string name;  // "nodes_7", "sides_7" or "elements_7" if the file gives none, or one that another set has as well
  std::int64_t entries = 0;
};

/// An element and a side of it, both counted from 1. What a side is the file says: MeshFile::find_face().
using FileSide = std::pair<std::int64_t, std::int64_t>;

/// Errors of all members: InputError if the file is damaged or not one of its format, SystemError if it cannot be read.
class MeshFile {
 public:
  virtual ~MeshFile() = default;

  virtual int dimensions() const = 0;
  virtual std::int64_t node_count() const = 0;
  virtual std::int64_t element_count() const = 0;
  virtual const std::vector<FileBlock>& blocks() const = 0;
  virtual const std::vector<FileSet>& node_sets() const = 0;
  virtual const std::vector<FileSet>& side_sets() const = 0;
  virtual const std::vector<FileSet>& element_sets() const = 0;

  /// Coordinates of all nodes [length]; 0 in directions that the mesh has not.
  virtual std::vector<Vec3> read_coordinates() const = 0;
  /// Nodes of the elements of a block, nodes_per_element for each. They may be out of range.
  virtual std::vector<std::int64_t> read_connectivity(const FileBlock& block) const = 0;
  /// Thickness of each shell of a block, 0 where the file gives none [length]; empty: it gives none at all.
  virtual std::vector<double> read_thicknesses(const FileBlock& /*block*/) const { return {}; }
  virtual std::vector<std::int64_t> read_node_ids() const = 0;
  virtual std::vector<std::int64_t> read_element_ids() const = 0;
  /// Members of sets of this file. They may be out of range.
  virtual std::vector<std::int64_t> read_node_set(const FileSet& set) const = 0;
  virtual std::vector<FileSide> read_side_set(const FileSet& set) const = 0;
  virtual std::vector<std::int64_t> read_element_set(const FileSet& set) const = 0;

  /// Face of an element that the format calls by this side; below 0: it has none. Of tetrahedra of ten nodes also
  /// triangles of faces (tet10_sides).
  virtual int find_face(const Topology& topology, std::int64_t side) const = 0;
  /// Kinds of elements of this format that can be run: "HEX8, SHELL4, ...".
  virtual std::string list_kinds() const = 0;
  /// Notes on content of the file that is no mesh, or that is not read.
  virtual std::vector<std::string> notes() const { return {}; }
};

}  // namespace percuss
