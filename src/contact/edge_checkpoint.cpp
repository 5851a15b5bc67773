// Records of edge pairs in a checkpoint: by the edge A that they belong to, whose place is that of its home's element.

#include <algorithm>

#include "kernels/core/host_copy.hpp"
#include "src/contact/contact_checkpoint.hpp"

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

/// The records that count, on the host.
struct HeldRecords {
  std::vector<std::int64_t> a, b;
  std::vector<double> values;  // normal, impulse, slip, reference of each
  static constexpr int value_count = 10;
};

HeldRecords take_held(const EdgeHistory& history) {
  const auto a = to_host(history.a), b = to_host(history.b);
  const auto holds = to_host(history.holds);
  const auto normal = to_host(history.normal), impulse = to_host(history.impulse), slip = to_host(history.slip);
  const auto reference = to_host(history.reference);
  HeldRecords held;
  for (int r = 0; r < history.count; ++r) {
    if (holds(r) == 0) continue;
    held.a.push_back(a(r));
    held.b.push_back(b(r));
    for (const auto& rows : {normal, impulse, slip})
      for (int k = 0; k < 3; ++k) held.values.push_back(rows(r, k));
    held.values.push_back(reference(r));
  }
  return held;
}

EdgeHistory make_edge_history(const HeldRecords& held) {
  std::vector<std::array<double, 3>> rows[3];
  std::vector<double> reference;
  for (std::size_t r = 0; r < held.a.size(); ++r) {
    const double* const v = held.values.data() + HeldRecords::value_count * r;
    for (std::size_t i = 0; i < 3; ++i) rows[i].push_back({v[3 * i], v[3 * i + 1], v[3 * i + 2]});
    reference.push_back(v[9]);
  }
  EdgeHistory history;
  history.count = static_cast<int>(held.a.size());
  history.a = to_view("contact::edge_history_a", held.a);
  history.b = to_view("contact::edge_history_b", held.b);
  history.holds = to_view("contact::edge_history_holds", std::vector<int>(held.a.size(), 1));
  history.normal = to_rows("contact::edge_history_normal", rows[0]);
  history.impulse = to_rows("contact::edge_history_impulse", rows[1]);
  history.slip = to_rows("contact::edge_history_slip", rows[2]);
  history.reference = to_view("contact::edge_history_reference", reference);
  return history;
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
