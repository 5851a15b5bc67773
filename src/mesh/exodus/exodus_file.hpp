#pragma once
// An open Exodus II file: every call of the library wrapped, every count checked against the length of the file before
// memory is allocated. Indexes are 1-based as in the file.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "src/mesh/exodus/exodus_container.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

struct ExodusBlock {
  std::int64_t id = 0;
  std::string name;      // "block_7" if the file gives none
  std::string topology;  // "HEX8", "TETRA", ...
  std::int64_t elements = 0;
  std::int64_t nodes_per_element = 0;
  std::int64_t first_element = 1;  // index in the file
};

struct ExodusSet {
  std::int64_t id = 0;
  std::string name;  // "nodes_7" or "sides_7" if the file gives none, or one that another set has as well
  std::int64_t entries = 0;
};

/// Errors of all members: InputError if the file is damaged or not one of Exodus II.
class ExodusFile {
 public:
  explicit ExodusFile(const std::string& path);
  ~ExodusFile();
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;

  int dimensions() const { return dimensions_; }
  std::int64_t node_count() const { return nodes_; }
  std::int64_t element_count() const { return elements_; }
  const std::vector<ExodusBlock>& blocks() const { return blocks_; }
  const std::vector<ExodusSet>& node_sets() const { return node_sets_; }
  const std::vector<ExodusSet>& side_sets() const { return side_sets_; }

  /// Of all nodes; 0 in directions that the mesh has not.
  std::vector<Vec3> read_coordinates() const;
  /// Node indexes, nodes_per_element for each element.
  std::vector<std::int64_t> read_connectivity(const ExodusBlock& block) const;
  /// The number maps; 1, 2, 3, ... if the file has none.
  std::vector<std::int64_t> read_node_ids() const;
  std::vector<std::int64_t> read_element_ids() const;
  /// Node indexes.
  std::vector<std::int64_t> read_node_set(const ExodusSet& set) const;
  /// Element indexes and side numbers (1 to 6).
  std::vector<std::pair<std::int64_t, std::int64_t>> read_side_set(const ExodusSet& set) const;

 private:
  void read_counts();
  void read_blocks();
  void require_room(std::int64_t count, std::int64_t bytes_each, const char* what) const;

  ExodusContainer container_;
  int file_ = -1;
  int dimensions_ = 0;
  std::int64_t nodes_ = 0, elements_ = 0, block_count_ = 0;
  std::vector<ExodusBlock> blocks_;
  std::vector<ExodusSet> node_sets_, side_sets_;
};

}  // namespace percuss
