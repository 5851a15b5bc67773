// Records of edge pairs in a checkpoint, by the edge A that they belong to, in the position of its home's element.

#include <algorithm>

#include "src/contact/history/contact_checkpoint.hpp"
#include "src/contact/history/edge_records.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// [edges] place among the chunks of this rank of the element behind the first face.
std::vector<std::size_t> find_chunks_of_edges(const ChunkedMesh& chunked, const std::vector<EdgeTopology>& edges) {
  std::vector<std::int64_t> first_element;
  for (const Chunk& chunk : chunked.chunks) first_element.push_back(chunked.numbering.first_element[at(chunk.number)]);
  std::vector<std::size_t> chunks;
  for (const EdgeTopology& edge : edges) {
    const auto after = std::upper_bound(first_element.begin(), first_element.end(), edge.elements[0]);
    chunks.push_back(static_cast<std::size_t>(after - first_element.begin()) - 1);
  }
  return chunks;
}

/// [chunks of this rank] sum of the sizes of its edges; negative if one is, or if they are too many for any file.
std::vector<std::int64_t> count_rows_of_chunks(const ChunkedMesh& chunked, const std::vector<EdgeTopology>& edges,
                                               const std::vector<std::int64_t>& sizes) {
  constexpr std::int64_t most = std::int64_t{1} << 60;
  const std::vector<std::size_t> chunks = find_chunks_of_edges(chunked, edges);
  std::vector<std::int64_t> counts(chunked.chunks.size(), 0);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    std::int64_t& count = counts[chunks[e]];
    const bool can_be = count >= 0 && sizes[e] >= 0 && sizes[e] <= most && count <= most;
    count = can_be ? count + sizes[e] : -1;
  }
  return counts;
}

/// `sizes[e]` rows of each edge e, by the chunk of the element behind its first face.
ChunkRows find_rows_of_edges(const ChunkedMesh& chunked, const std::vector<EdgeTopology>& edges,
                             const std::vector<std::int64_t>& sizes) {
  const std::vector<std::size_t> chunks = find_chunks_of_edges(chunked, edges);
  std::vector<std::vector<int>> places(chunked.chunks.size());
  int next = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (std::int64_t i = 0; i < sizes[e]; ++i) places[chunks[e]].push_back(next++);
  }
  ChunkRows rows;
  for (const std::vector<int>& of_chunk : places) {
    rows.counts.push_back(static_cast<std::int64_t>(of_chunk.size()));
    rows.places.insert(rows.places.end(), of_chunk.begin(), of_chunk.end());
  }
  return rows;
}

}  // namespace

void archive_edges(CheckpointArchive& archive, const ChunkedMesh& chunked, const SurfaceShare& share,
                   EdgeHistory& history) {
  if (share.total_edges == 0) return;
  const std::vector<EdgeTopology>& edges = share.edges;
  HeldRecords held;
  if (!archive.is_loading()) held = take_held(history);
  std::vector<std::int64_t> counts;
  for (const EdgeTopology& edge : edges) {
    const auto own = std::equal_range(held.a.begin(), held.a.end(), edge.number);
    counts.push_back(own.second - own.first);
  }
  archive.rows("contact/edges/records", find_rows_of_edges(chunked, edges, std::vector<std::int64_t>(edges.size(), 1)),
               1, std::span<std::int64_t>(counts));
  archive.expect_rows("contact/edges/other", count_rows_of_chunks(chunked, edges, counts), 1);
  if (archive.is_loading())
    for (std::size_t e = 0; e < edges.size(); ++e)
      held.a.insert(held.a.end(), static_cast<std::size_t>(counts[e]), edges[e].number);
  held.b.resize(held.a.size());
  held.values.resize(HeldRecords::value_count * held.a.size());
  const ChunkRows rows = find_rows_of_edges(chunked, edges, counts);
  archive.rows("contact/edges/other", rows, 1, std::span<std::int64_t>(held.b));
  archive.rows("contact/edges/values", rows, HeldRecords::value_count, std::span<double>(held.values));
  if (archive.is_loading()) history = make_edge_history(held);
}

}  // namespace percuss
