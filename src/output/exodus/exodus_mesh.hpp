#pragma once
// What fields.exo has before its first frame: the mesh, its blocks and sets, and the texts about the file.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "src/output/exodus/exodus_blocks.hpp"
#include "src/output/exodus/exodus_sets.hpp"
#include "src/output/exodus/netcdf_variables.hpp"
#include "src/output/frame/frame_fields.hpp"
#include "src/output/hdf5/durable_file.hpp"

namespace percuss {

/// Half the entries of a node of the index of each variable, which is there whole from the first frame on: in a file of
/// many blocks nodes are small, so that they take about as much as with few.
unsigned choose_chunk_index(std::size_t blocks);

/// Name of a dimension or a variable of a block, numbered from 0: "num_el_in_blk1".
std::string name_of_block(const char* kind, std::size_t block);

/// A file and what of the mesh goes into it. Calls are collective and throw hdf5::Error.
struct ExodusMesh {
  const Communicator& ranks;
  const FieldsOptions& options;
  const std::vector<ExodusBlock>& blocks;
  const ExodusSets& sets;
  hdf5::DurableFile& file;
  NetcdfDimensions& dimensions;
  std::size_t nodes, elements;  // of the whole mesh
  RowBlocks& node_rows;

  /// Most bytes that it takes.
  std::uint64_t find_bytes() const;
  /// Attributes and dimensions: first of all.
  void write_header() const;
  void write_mesh(const Mesh& mesh) const;
  void write_texts(const std::string& name, std::span<const std::string> names,
                   std::span<const std::string> texts) const;

 private:
  NetcdfFile netcdf() const { return {file.id(), dimensions}; }
  hdf5::RowBlock node_block() const { return file.complete(node_rows.block()); }
  hdf5::RowBlock block_of(const ExodusBlock& block) const { return file.complete(block.rows->block()); }

  std::size_t find_name_length() const;
  void write_attributes() const;
  void create_dimensions() const;
  void write_nodes(const Mesh& mesh) const;
  void write_elements(const Mesh& mesh) const;
  void write_connectivity(const Mesh& mesh, std::size_t block) const;
  void write_entities(const std::string& prefix, const std::string& dimension,
                      std::span<const std::string> names) const;
  void write_sets(bool are_sides) const;
  void write_records() const;
};

}  // namespace percuss
