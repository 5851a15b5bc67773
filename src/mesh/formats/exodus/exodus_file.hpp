#pragma once
// An open Exodus II file: every call of the library wrapped, every count checked against the length of the file before
// memory is allocated.

#include <cstdint>
#include <string>
#include <vector>

#include "src/mesh/files/file_results.hpp"
#include "src/mesh/formats/exodus/exodus_container.hpp"

namespace percuss {

/// Errors of all members: InputError if the file is damaged or not one of Exodus II.
class ExodusFile : public MeshFile {
 public:
  explicit ExodusFile(const std::string& path);
  ~ExodusFile() override;
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;

  int dimensions() const override { return dimensions_; }
  std::int64_t node_count() const override { return nodes_; }
  std::int64_t element_count() const override { return elements_; }
  const std::vector<FileBlock>& blocks() const override { return blocks_; }
  const std::vector<FileSet>& node_sets() const override { return node_sets_; }
  const std::vector<FileSet>& side_sets() const override { return side_sets_; }
  const std::vector<FileSet>& element_sets() const override { return element_sets_; }

  std::vector<Vec3> read_coordinates() const override;
  std::vector<std::int64_t> read_connectivity(const FileBlock& block) const override;
  /// The first attribute of blocks of shells.
  std::vector<double> read_thicknesses(const FileBlock& block) const override;
  /// The number maps; 1, 2, 3, ... if the file has none.
  std::vector<std::int64_t> read_node_ids() const override;
  std::vector<std::int64_t> read_element_ids() const override;
  std::vector<std::int64_t> read_node_set(const FileSet& set) const override;
  std::vector<FileSide> read_side_set(const FileSet& set) const override;
  std::vector<std::int64_t> read_element_set(const FileSet& set) const override;
  int find_face(const Topology& topology, std::int64_t side) const override;
  std::string list_kinds() const override;

  /// Throws InputError, too, if it has no such time.
  FileResults read_results(const ResultsWish& wish) const;
  ResultsContents read_results_contents() const;

 private:
  void require_time_steps() const;
  std::vector<double> read_times() const;
  int find_time_step(const ResultsWish& wish) const;
  std::vector<std::string> read_variable_names(int kind) const;
  ResultsColumn read_element_variable(int step, int variable, const std::string& name) const;
  std::vector<std::int64_t> read_set(int kind, const FileSet& set, const char* what) const;
  void read_counts();
  void read_blocks();
  void require_room(std::int64_t count, std::int64_t bytes_each, const char* what) const;

  ExodusContainer container_;
  int file_ = -1;
  int dimensions_ = 0;
  std::int64_t nodes_ = 0, elements_ = 0, block_count_ = 0;
  std::vector<FileBlock> blocks_;
  std::vector<FileSet> node_sets_, side_sets_, element_sets_;
};

}  // namespace percuss
