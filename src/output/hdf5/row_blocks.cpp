#include "src/output/hdf5/row_blocks.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "comm/exchange/unstructured_exchange.hpp"

namespace percuss {
namespace {

// Ranks write equal blocks: block r begins at all * r / ranks, rounded down.
std::int64_t find_block_start(std::int64_t all, int rank, int ranks) { return all * rank / ranks; }
int find_block(std::int64_t all, std::int64_t number, int ranks) {
  return static_cast<int>(((number + 1) * ranks - 1) / all);
}

// The plan for items of so many components each, sent one by one.
ExchangePlan scale(const ExchangePlan& plan, int components) {
  ExchangePlan scaled = plan;
  for (auto* runs : {&scaled.to, &scaled.from}) {
    for (PeerRun& run : *runs) {
      run.first *= components;
      run.count *= components;
    }
  }
  return scaled;
}

// Memory that is kept from one field to the next, seen as numbers. A vector's memory is aligned for any of them.
template <class T>
std::span<T> view_as(std::vector<std::byte>& memory, std::size_t count) {
  if (memory.size() < count * sizeof(T)) memory.resize(count * sizeof(T));
  return {reinterpret_cast<T*>(memory.data()), count};
}

}  // namespace

RowBlocks::RowBlocks(const Communicator& ranks, const std::vector<int>& owned, std::span<const std::int64_t> numbers,
                     std::int64_t all)
    : all_(all), count_(all) {
  if (ranks.size() == 1) return;
  first_ = find_block_start(all, ranks.rank(), ranks.size());
  count_ = find_block_start(all, ranks.rank() + 1, ranks.size()) - first_;
  owned_ = owned;
  exchange_.emplace(ranks);
  plan_exchange(ranks, numbers);
}

void RowBlocks::plan_exchange(const Communicator& ranks, std::span<const std::int64_t> numbers) {
  std::vector<PeerRun> to;
  std::vector<std::int64_t> own_numbers;
  own_numbers.reserve(owned_.size());
  for (const int item : owned_) {
    const std::int64_t number = numbers[static_cast<std::size_t>(item)];
    const int block = find_block(all_, number, ranks.size());
    if (to.empty() || to.back().rank != block) to.push_back({block, static_cast<std::int64_t>(own_numbers.size()), 0});
    ++to.back().count;
    own_numbers.push_back(number);
  }
  plan_ = UnstructuredExchange(ranks).plan(to);
  places_ = exchange_->exchange(plan_, own_numbers);
  if (static_cast<std::int64_t>(places_.size()) != count_)
    throw std::logic_error("the ranks do not bring every row of a dataset once");
  for (std::int64_t& place : places_) place -= first_;
}

hdf5::RowBlock RowBlocks::block(int rows) const {
  const auto scaled = [&](std::int64_t items) { return static_cast<hsize_t>(items * rows); };
  return {scaled(all_), scaled(first_), scaled(count_)};
}

template <class T>
std::span<const T> RowBlocks::gather(std::span<const T> local, int components) {
  if (!exchange_) return local;
  const auto width = static_cast<std::size_t>(components);
  const auto copy_row = [&](std::span<const T> from, std::size_t source, std::span<T> into, std::size_t target) {
    std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(source * width), width,
                into.begin() + static_cast<std::ptrdiff_t>(target * width));
  };
  const auto send = view_as<T>(sent_, owned_.size() * width);
  for (std::size_t i = 0; i < owned_.size(); ++i) copy_row(local, static_cast<std::size_t>(owned_[i]), send, i);
  const auto received = view_as<T>(received_, places_.size() * width);
  exchange_->begin<T>(scale(plan_, components), send, received);
  exchange_->end();
  const auto block = view_as<T>(arranged_, places_.size() * width);
  for (std::size_t i = 0; i < places_.size(); ++i) copy_row(received, i, block, static_cast<std::size_t>(places_[i]));
  return block;
}

template std::span<const double> RowBlocks::gather(std::span<const double>, int);
template std::span<const std::int64_t> RowBlocks::gather(std::span<const std::int64_t>, int);

}  // namespace percuss
