#include "src/contact/history/contact_checkpoint.hpp"

#include <fmt/format.h>

#include "comm/halo/node_copies.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {
namespace {

/// Items [first, end) of a view of any rank.
auto take(const Array<double>& view, std::size_t first, std::size_t end) {
  return Kokkos::subview(view, std::pair(first, end));
}
auto take(const Rows3<double>& view, std::size_t first, std::size_t end) {
  return Kokkos::subview(view, std::pair(first, end), Kokkos::ALL);
}

/// Values of a record that not every run has. All ranks have the same ones, with or without contact nodes.
struct RecordParts {
  bool held, to_push;
};

/// Records [first, end) of the history, `size` of them a row.
struct RecordRange {
  std::size_t first, end;
  int size;
};

void archive_records(CheckpointArchive& archive, const std::string& name, const ChunkRows& rows,
                     const RecordParts& parts, const ContactHistory& history, const RecordRange& range) {
  const auto [first, end, size] = range;
  archive.rows(name + "/impulse", rows, 3 * size, take(history.impulse, first, end));
  archive.rows(name + "/slip", rows, 3 * size, take(history.slip, first, end));
  archive.rows(name + "/reference", rows, size, take(history.reference, first, end));
  if (parts.held) archive.rows(name + "/held", rows, size, take(history.held, first, end));
  if (parts.to_push) archive.rows(name + "/to_push", rows, size, take(history.to_push, first, end));
}

/// The pairs of a wall follow each other, ascending in their nodes.
void archive_walls(CheckpointArchive& archive, const ChunkedMesh& chunked, const WallPairs& walls,
                   const RecordParts& parts, const ContactHistory& history, std::size_t first_record) {
  const auto wall = to_host(walls.wall), node = to_host(walls.node);
  std::size_t begin = 0;
  for (std::size_t w = 0; w < walls.walls.extent(0); ++w) {
    std::vector<std::int64_t> numbers;
    std::size_t end = begin;
    for (; end < wall.extent(0) && wall(end) == static_cast<int>(w); ++end) {
      numbers.push_back(chunked.mesh.node_numbers[static_cast<std::size_t>(node(end))]);
    }
    archive_records(archive, fmt::format("contact/wall_{}", w), find_rows_of_nodes(chunked, numbers), parts, history,
                    {first_record + begin, first_record + end, 1});
    begin = end;
  }
}

}  // namespace

void archive_history(CheckpointArchive& archive, const ChunkedMesh& chunked, const SurfaceShare& share,
                     const WallPairs& walls, const ContactDeck& contact, const ContactHistory& history) {
  const ChunkRows rows = find_rows_of_nodes(chunked, share.nodes.numbers);
  const int touches = contact_limits::max_touches;
  const std::size_t records = history.face.extent(0);
  archive.rows("contact/nodes/face", rows, touches, history.face);
  const RecordParts parts{share.springs != SpringRows::none, contact.overlap == ContactDeck::Overlap::push_out};
  archive_records(archive, "contact/nodes", rows, parts, history, {0, records, touches});
  archive_walls(archive, chunked, walls, parts, history, records);
}

void archive_ties(CheckpointArchive& archive, const ChunkedMesh& chunked, const std::vector<std::int64_t>& keys,
                  bool has_rotations, const ContactHistory& history) {
  std::vector<std::int64_t> places, rotations;
  for (const std::int64_t key : keys) (is_turning_row_key(key) ? rotations : places).push_back(find_key_node(key));
  archive.rows("contact/ties/impulse", find_rows_of_nodes(chunked, places), 3, take(history.ties, 0, places.size()));
  if (!has_rotations) return;
  archive.rows("contact/ties/moment", find_rows_of_nodes(chunked, rotations), 3,
               take(history.ties, places.size(), places.size() + rotations.size()));
}

Rows3<double> spread_to_mesh(const Communicator& ranks, const ChunkedMesh& chunked, const SurfaceShare& share,
                             const Rows3<double>& values) {
  const Mesh& mesh = chunked.mesh;
  const Rows3<double> spread("contact::rows_of_mesh", mesh.nodes.size());
  const auto host = Kokkos::create_mirror_view(spread);
  const auto own = to_host(values);
  for (std::size_t n = 0; n < share.nodes.mesh_nodes.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) host(static_cast<std::size_t>(share.nodes.mesh_nodes[n]), k) = own(n, k);
  }
  copy_values(spread, host);
  if (ranks.size() == 1) return spread;
  UnstructuredExchange exchange(ranks);
  SharedNodes shared = find_shared_nodes(exchange, mesh.node_numbers);
  for (std::size_t n = 0; n < shared.owners.size(); ++n) {
    shared.owners[n] = chunked.numbering.find_node_owner(mesh.node_numbers[n]);
  }
  NodeCopies copies(ranks, shared);
  copies.begin(ExecSpace(), spread);
  copies.end(ExecSpace(), spread);
  return spread;
}

}  // namespace percuss
