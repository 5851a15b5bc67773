#pragma once
// Arrays that lie chunk after chunk on their way into a file: from the ranks that hold the chunks to equal blocks of
// whole chunks, one a rank. Why they are moved first: src/output/hdf5/row_blocks.hpp.

#include <cstdint>
#include <span>
#include <vector>

#include "comm/exchange/data_exchange.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/output/hdf5/hdf5_table.hpp"

namespace percuss {

/// [chunks + 1] first row of each chunk of the whole mesh. counts: [chunks of this rank] rows of each. Collective.
/// Throws MpiError.
std::vector<std::int64_t> find_first_rows(const Communicator& ranks, const ChunkedMesh& mesh,
                                          std::span<const std::int64_t> counts);

class ChunkBlocks {
 public:
  /// `mesh` outlives this. Collective. Throws MpiError.
  ChunkBlocks(const Communicator& ranks, const ChunkedMesh& mesh);

  /// Values of the block that this rank writes, from the values of the chunks that each rank holds. first_rows: of
  /// find_first_rows(). values: [rows of this rank's chunks][components]. Collective. Throws MpiError.
  template <class T>
  std::vector<T> gather(std::span<const std::int64_t> first_rows, int components, std::span<const T> values);

  /// Part of the array that this rank writes, in values.
  hdf5::RowBlock block(std::span<const std::int64_t> first_rows, int components) const;

 private:
  ExchangePlan plan(std::span<const std::int64_t> first_rows, int components) const;
  int find_writer(int chunk) const;

  Communicator ranks_;
  const ChunkedMesh& mesh_;
  DataExchange exchange_;
  int first_ = 0, end_ = 0;     // chunks that this rank writes
  std::vector<int> by_source_;  // these chunks, by the rank that holds them
};

}  // namespace percuss
