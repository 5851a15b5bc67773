#pragma once
// Element blocks of Exodus II: the elements of a part, of one kind each.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/hdf5/row_blocks.hpp"

namespace percuss {

/// Elements of a block are in ascending global number. Blocks are in the order of the parts, of a part in that of the
/// topologies. They are numbered from 1.
struct ExodusBlock {
  std::string name;  // the part's; where it has several kinds of elements, with the kind: "can quad4"
  TopologyKind topology{};
  std::int64_t elements = 0;         // of all ranks
  std::vector<int> local;            // this rank's, ascending
  std::vector<std::int64_t> places;  // [local] among all of the block, from 0
  std::unique_ptr<RowBlocks> rows;   // their way into the file

  std::size_t corners() const { return static_cast<std::size_t>(find_topology(topology).corner_count); }
  /// "HEX8", "SHELL4"
  std::string element_type() const;

  /// Values of this rank's elements of the block. values: [local elements of the mesh][components]
  template <class T>
  std::vector<T> pick(std::span<const T> values, int components, int component) const {
    std::vector<T> picked;
    picked.reserve(local.size());
    for (const int e : local)
      picked.push_back(values[static_cast<std::size_t>(e) * static_cast<std::size_t>(components) +
                              static_cast<std::size_t>(component)]);
    return picked;
  }
};

/// Blocks that have elements. Collective. Throws MpiError.
std::vector<ExodusBlock> list_exodus_blocks(const ChunkedMesh& chunked, const Communicator& ranks);

/// Corners of this rank's elements of a block as nodes of the file: [local][corners], from 1.
std::vector<std::int64_t> list_connectivity(const Mesh& mesh, const ExodusBlock& block);

}  // namespace percuss
