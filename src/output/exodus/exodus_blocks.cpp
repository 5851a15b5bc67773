#include "src/output/exodus/exodus_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "comm/all_reduce.hpp"
#include "src/index.hpp"
#include "src/output/frame/frame_fields.hpp"

namespace percuss {
namespace {

/// The elements of each chunk of the whole mesh by topology, and the part of each chunk: the same on every rank.
struct ChunkKinds {
  std::vector<std::int64_t> counts;  // [chunks][topologies]
  std::vector<std::int64_t> parts;   // [chunks]
};

ChunkKinds count_kinds(const ChunkedMesh& chunked, const Communicator& ranks) {
  const std::size_t chunks = at(chunked.numbering.chunk_count());
  ChunkKinds kinds{std::vector<std::int64_t>(chunks * topology_count), std::vector<std::int64_t>(chunks)};
  for (const Chunk& chunk : chunked.chunks) {
    kinds.parts[at(chunk.number)] = chunk.part;
    for (int i = 0; i < chunk.element_count; ++i) {
      const TopologyKind kind = chunked.mesh.block_of(at(chunk.first_element + i)).topology;
      ++kinds.counts[topology_count * at(chunk.number) + static_cast<std::size_t>(kind)];
    }
  }
  all_reduce(ranks, Reduce::sum, kinds.counts);
  all_reduce(ranks, Reduce::sum, kinds.parts);
  return kinds;
}

/// Elements of one kind of a part.
struct PartKind {
  std::int64_t part = 0;
  std::size_t kind = 0;
};

/// This rank's elements of them, and the place of each among all of them.
struct PlacedElements {
  std::vector<int> local;
  std::vector<std::int64_t> places;
  std::int64_t all = 0;
};

PlacedElements place_elements(const ChunkedMesh& chunked, const ChunkKinds& kinds, const PartKind& of) {
  std::vector<std::int64_t> first(kinds.parts.size());
  PlacedElements placed;
  for (std::size_t c = 0; c < first.size(); ++c) {
    first[c] = placed.all;
    if (kinds.parts[c] == of.part) placed.all += kinds.counts[topology_count * c + of.kind];
  }
  for (const Chunk& chunk : chunked.chunks) {
    if (chunk.part != of.part) continue;
    std::int64_t place = first[at(chunk.number)];
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e) {
      if (static_cast<std::size_t>(chunked.mesh.block_of(at(e)).topology) != of.kind) continue;
      placed.local.push_back(e);
      placed.places.push_back(place++);
    }
  }
  return placed;
}

}  // namespace

std::string ExodusBlock::element_type() const {
  const Topology& of = find_topology(topology);
  return fmt::format("{}{}", of.exodus_names[0], of.corner_count);
}

std::vector<ExodusBlock> list_exodus_blocks(const ChunkedMesh& chunked, const Communicator& ranks) {
  const ChunkKinds kinds = count_kinds(chunked, ranks);
  const std::size_t parts = chunked.mesh.parts.size();
  std::vector<std::array<std::int64_t, topology_count>> totals(parts);
  for (std::size_t c = 0; c < kinds.parts.size(); ++c) {
    for (std::size_t k = 0; k < topology_count; ++k)
      totals[at(kinds.parts[c])][k] += kinds.counts[topology_count * c + k];
  }
  std::vector<ExodusBlock> blocks;
  for (std::size_t p = 0; p < parts; ++p) {
    const auto several = std::count_if(totals[p].begin(), totals[p].end(), [](std::int64_t n) { return n > 0; }) > 1;
    for (std::size_t k = 0; k < topology_count; ++k) {
      if (totals[p][k] == 0) continue;
      PlacedElements placed = place_elements(chunked, kinds, {static_cast<std::int64_t>(p), k});
      const std::string& part = chunked.mesh.parts[p].name;
      auto rows = std::make_unique<RowBlocks>(ranks, count_up(placed.local.size()), placed.places, placed.all);
      blocks.push_back({several ? fmt::format("{} {}", part, topologies[k].name) : part, static_cast<TopologyKind>(k),
                        placed.all, std::move(placed.local), std::move(placed.places), std::move(rows)});
    }
  }
  return blocks;
}

std::vector<std::int64_t> list_connectivity(const Mesh& mesh, const ExodusBlock& block) {
  std::vector<std::int64_t> nodes;
  nodes.reserve(block.local.size() * block.corners());
  for (const int e : block.local) {
    for (const int node : mesh.corners(at(e))) nodes.push_back(mesh.node_numbers[at(node)] + 1);
  }
  return nodes;
}

}  // namespace percuss
