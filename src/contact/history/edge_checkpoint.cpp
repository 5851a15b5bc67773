// Records of edge pairs in a checkpoint: by the edge A that they belong to, whose place is that of its home's element.

#include <algorithm>

#include "src/contact/history/contact_checkpoint.hpp"
#include "src/contact/history/edge_records.hpp"

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// `sizes[e]` rows of each edge e, by the chunk of the element behind its first face.
ChunkRows find_rows_of_edges(const ChunkedMesh& chunked, const std::vector<EdgeTopology>& edges,
                             const std::vector<std::int64_t>& sizes) {
  std::vector<std::int64_t> first_element;
  for (const Chunk& chunk : chunked.chunks) first_element.push_back(chunked.numbering.first_element[at(chunk.number)]);
  std::vector<std::vector<int>> places(chunked.chunks.size());
  int next = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto after = std::upper_bound(first_element.begin(), first_element.end(), edges[e].elements[0]);
    auto& of_chunk = places[static_cast<std::size_t>(after - first_element.begin()) - 1];
    for (std::int64_t i = 0; i < sizes[e]; ++i) of_chunk.push_back(next++);
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
