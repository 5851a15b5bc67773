#include "src/output/checkpoint/chunk_blocks.hpp"

#include <algorithm>
#include <numeric>

#include "comm/all_reduce.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

int find_block_start(int chunks, int rank, int ranks) {
  return static_cast<int>(static_cast<std::int64_t>(chunks) * rank / ranks);
}

void add_to_run(std::vector<PeerRun>& runs, int rank, std::int64_t count) {
  if (count == 0) return;
  if (runs.empty() || runs.back().rank != rank) {
    runs.push_back({rank, runs.empty() ? 0 : runs.back().first + runs.back().count, 0});
  }
  runs.back().count += count;
}

}  // namespace

std::vector<std::int64_t> find_first_rows(const Communicator& ranks, const ChunkedMesh& mesh,
                                          std::span<const std::int64_t> counts) {
  std::vector<std::int64_t> first(at(mesh.numbering.chunk_count()) + 1, 0);
  for (std::size_t c = 0; c < mesh.chunks.size(); ++c) first[at(mesh.chunks[c].number) + 1] = counts[c];
  all_reduce(ranks, Reduce::sum, first);
  std::partial_sum(first.begin(), first.end(), first.begin());
  return first;
}

ChunkBlocks::ChunkBlocks(const Communicator& ranks, const ChunkedMesh& mesh)
    : ranks_(ranks), mesh_(mesh), exchange_(ranks) {
  const int chunks = mesh.numbering.chunk_count();
  first_ = find_block_start(chunks, ranks.rank(), ranks.size());
  end_ = find_block_start(chunks, ranks.rank() + 1, ranks.size());
  by_source_.resize(at(end_ - first_));
  std::iota(by_source_.begin(), by_source_.end(), first_);
  std::stable_sort(by_source_.begin(), by_source_.end(),
                   [&](int a, int b) { return mesh.numbering.ranks[at(a)] < mesh.numbering.ranks[at(b)]; });
}

/// The rank whose block a chunk lies in.
int ChunkBlocks::find_writer(int chunk) const {
  return static_cast<int>(((static_cast<std::int64_t>(chunk) + 1) * ranks_.size() - 1) / mesh_.numbering.chunk_count());
}

ExchangePlan ChunkBlocks::plan(std::span<const std::int64_t> first_rows, int components) const {
  const auto count = [&](int chunk) { return (first_rows[at(chunk) + 1] - first_rows[at(chunk)]) * components; };
  ExchangePlan plan;
  for (const Chunk& chunk : mesh_.chunks) add_to_run(plan.to, find_writer(chunk.number), count(chunk.number));
  for (const int chunk : by_source_) add_to_run(plan.from, mesh_.numbering.ranks[at(chunk)], count(chunk));
  return plan;
}

hdf5::RowBlock ChunkBlocks::block(std::span<const std::int64_t> first_rows, int components) const {
  const auto scaled = [&](std::int64_t rows) { return static_cast<hsize_t>(rows * components); };
  const std::int64_t begin = first_rows[at(first_)];
  return {scaled(first_rows.back()), scaled(begin), scaled(first_rows[at(end_)] - begin)};
}

template <class T>
std::vector<T> ChunkBlocks::gather(std::span<const std::int64_t> first_rows, int components,
                                   std::span<const T> values) {
  if (ranks_.size() == 1) return {values.begin(), values.end()};
  const ExchangePlan moves = plan(first_rows, components);
  std::vector<T> received(at(moves.receive_count()));
  exchange_.begin<T>(moves, values, received);
  exchange_.end();
  std::vector<T> arranged(received.size());
  auto next = received.begin();
  for (const int chunk : by_source_) {
    const std::int64_t count = (first_rows[at(chunk) + 1] - first_rows[at(chunk)]) * components;
    std::copy_n(next, count, arranged.begin() + (first_rows[at(chunk)] - first_rows[at(first_)]) * components);
    next += count;
  }
  return arranged;
}

template std::vector<double> ChunkBlocks::gather(std::span<const std::int64_t>, int, std::span<const double>);
template std::vector<std::int64_t> ChunkBlocks::gather(std::span<const std::int64_t>, int,
                                                       std::span<const std::int64_t>);

// --- rows of chunks

ChunkRows find_element_rows(const ChunkedMesh& mesh) {
  ChunkRows rows;
  for (const Chunk& chunk : mesh.chunks) rows.counts.push_back(chunk.element_count);
  return rows;
}

ChunkRows find_owned_node_rows(const ChunkedMesh& mesh) {
  const ChunkRows rows = find_rows_of_nodes(mesh, mesh.mesh.node_numbers);
  const auto& numbers = mesh.mesh.node_numbers;
  std::vector<int> places;
  for (std::size_t c = 0; c < mesh.chunks.size(); ++c) {
    const std::int64_t node = mesh.numbering.first_node[at(mesh.chunks[c].number)];
    const auto first = std::lower_bound(numbers.begin(), numbers.end(), node) - numbers.begin();
    for (std::int64_t i = 0; i < rows.counts[c]; ++i) places.push_back(static_cast<int>(first + i));
  }
  return {rows.counts, places};
}

ChunkRows find_rows_of_nodes(const ChunkedMesh& mesh, std::span<const std::int64_t> numbers) {
  ChunkRows rows;
  for (const Chunk& chunk : mesh.chunks) {
    const auto first = std::lower_bound(numbers.begin(), numbers.end(), mesh.numbering.first_node[at(chunk.number)]);
    const auto end = std::lower_bound(first, numbers.end(), mesh.numbering.first_node[at(chunk.number) + 1]);
    rows.counts.push_back(end - first);
  }
  return rows;
}

}  // namespace percuss
