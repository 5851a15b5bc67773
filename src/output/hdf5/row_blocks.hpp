#pragma once
// Rows of nodes or elements on their way into a file: from the ranks that own them to equal blocks of the whole.
//
// The rows of a rank are many short runs of a dataset, one a chunk of the mesh. They are moved first, so that every
// rank writes one block without gaps: a collective write of many runs takes several times as long as the move
// (docs/output.md), and some MPI libraries lose data where ranks write between each other (Open MPI issue 12718).

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "comm/exchange/data_exchange.hpp"
#include "src/output/hdf5/hdf5_table.hpp"

namespace percuss {

class RowBlocks {
 public:
  /// `owned`: the local items that this rank brings, ascending; `numbers`: [local items] place of each in the whole,
  /// ascending; `all`: items of the whole, each brought by one rank. Collective. Throws MpiError.
  RowBlocks(const Communicator& ranks, const std::vector<int>& owned, std::span<const std::int64_t> numbers,
            std::int64_t all);

  /// Rows that this rank writes of a dataset that holds `rows` rows for an item.
  hdf5::RowBlock block(int rows = 1) const;

  /// The rows of the block, from the local rows [local items][components] of every rank. The answer is valid until the
  /// next call; one rank alone gets its own rows back. T: double or std::int64_t. Collective. Throws MpiError.
  template <class T>
  std::span<const T> gather(std::span<const T> local, int components);

 private:
  void plan_exchange(const Communicator& ranks, std::span<const std::int64_t> numbers);

  std::int64_t all_ = 0, first_ = 0, count_ = 0;
  std::vector<int> owned_;
  std::optional<DataExchange> exchange_;  // none: one rank
  ExchangePlan plan_;
  std::vector<std::int64_t> places_;  // [received items] row within the block
  std::vector<std::byte> sent_, received_, arranged_;
};

}  // namespace percuss
