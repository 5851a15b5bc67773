#include "src/output/frame/field_region.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/exchange/data_exchange.hpp"
#include "comm/exchange/unstructured_exchange.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

constexpr std::int64_t no_number = -1;

/// Nodes of this rank's share that the region uses, here or on another rank, and their numbers in it.
class RegionNodes {
 public:
  RegionNodes(const ChunkedMesh& whole, std::span<const RegionCell> cells, const Communicator& ranks)
      : whole_(whole), used_(whole.mesh.nodes.size(), 0), numbers_(used_.size(), no_number), exchange_(ranks) {
    for (const RegionCell& cell : cells) {
      for (const int node : cell.nodes()) used_[at(node)] = 1;
    }
    NodeOwners owners(whole.numbering);
    owners_ = owners.find(whole.mesh.node_numbers);
    ask_owners(ranks);
  }

  bool is_owned(std::size_t node, int rank) const { return owners_[node] == rank && used_[node] != 0; }

  /// first: [chunks + 1] number of the first node of each chunk. Collective.
  void number(const std::vector<std::int64_t>& first, int rank) {
    const std::vector<std::int64_t>& all = whole_.numbering.first_node;
    std::size_t chunk = 0;
    std::int64_t next = 0;
    for (std::size_t n = 0; n < used_.size(); ++n) {
      if (!is_owned(n, rank)) continue;
      const std::int64_t number = whole_.mesh.node_numbers[n];
      if (number >= all[chunk + 1] || next == 0) {
        chunk = Numbering::find_chunk(all, number);
        next = first[chunk];
      }
      numbers_[n] = next++;
    }
    std::vector<std::int64_t> answers;
    for (const int node : asked_) answers.push_back(numbers_[at(node)]);
    const std::vector<std::int64_t> received = exchange_.exchange(reverse(plan_), answers);
    for (std::size_t i = 0; i < received.size(); ++i) numbers_[at(foreign_[i])] = received[i];
  }

  /// Number of each node in the region; negative where the region does not use it.
  const std::vector<std::int64_t>& numbers() const { return numbers_; }

 private:
  /// Tells the owners of nodes that elements here use them.
  void ask_owners(const Communicator& ranks) {
    std::vector<int> destinations, wanted;
    for (std::size_t n = 0; n < used_.size(); ++n) {
      if (used_[n] == 0 || owners_[n] == ranks.rank()) continue;
      wanted.push_back(static_cast<int>(n));
      destinations.push_back(owners_[n]);
    }
    const SendOrder order = order_by_destination(destinations);
    std::vector<std::int64_t> numbers;
    for (const int item : order.items) {
      foreign_.push_back(wanted[at(item)]);
      numbers.push_back(whole_.mesh.node_numbers[at(foreign_.back())]);
    }
    plan_ = UnstructuredExchange(ranks).plan(order.to);
    const std::vector<std::int64_t>& own = whole_.mesh.node_numbers;
    for (const std::int64_t number : exchange_.exchange(plan_, numbers)) {
      asked_.push_back(static_cast<int>(std::lower_bound(own.begin(), own.end(), number) - own.begin()));
      used_[at(asked_.back())] = 1;
    }
  }

  const ChunkedMesh& whole_;
  std::vector<char> used_;
  std::vector<std::int64_t> numbers_;
  std::vector<int> owners_;   // [nodes]
  std::vector<int> foreign_;  // [sent] nodes whose owners were asked
  std::vector<int> asked_;    // [received] own nodes that others use
  DataExchange exchange_;
  ExchangePlan plan_;
};

/// Counts by chunk, as numbers of the first of each.
std::vector<std::int64_t> sum_up(std::span<const std::int64_t> counts) {
  std::vector<std::int64_t> first{0};
  for (const std::int64_t count : counts) first.push_back(first.back() + count);
  return first;
}

/// The chunk of this rank that each cell is in.
std::vector<std::size_t> find_chunks(const std::vector<Chunk>& chunks, std::span<const RegionCell> cells) {
  std::vector<std::size_t> of_cells;
  std::size_t chunk = 0;
  for (const RegionCell& cell : cells) {
    while (chunks[chunk].first_element + chunks[chunk].element_count <= cell.element) ++chunk;
    of_cells.push_back(chunk);
  }
  return of_cells;
}

Numbering number_region(const ChunkedMesh& whole, std::span<const RegionCell> cells, RegionNodes& nodes,
                        const Communicator& ranks) {
  const std::size_t chunks = at(whole.numbering.chunk_count());
  std::vector<std::int64_t> counts(2 * chunks);  // nodes, then elements
  for (std::size_t n = 0; n < whole.mesh.nodes.size(); ++n) {
    if (nodes.is_owned(n, ranks.rank()))
      ++counts[Numbering::find_chunk(whole.numbering.first_node, whole.mesh.node_numbers[n])];
  }
  for (const std::size_t chunk : find_chunks(whole.chunks, cells)) ++counts[chunks + at(whole.chunks[chunk].number)];
  all_reduce(ranks, Reduce::sum, counts);
  const std::span<const std::int64_t> all(counts);
  Numbering numbering{sum_up(all.subspan(chunks)), sum_up(all.first(chunks)), whole.numbering.ranks};
  nodes.number(numbering.first_node, ranks.rank());
  return numbering;
}

/// [parts of the whole mesh] place among those of the region; negative: it has none of the cells of any rank.
std::vector<int> choose_parts(const Mesh& mesh, std::span<const RegionCell> cells, const Communicator& ranks) {
  std::vector<int> has(mesh.parts.size(), 0), places;
  for (const RegionCell& cell : cells) has[at(mesh.part_of(at(cell.element)))] = 1;
  all_reduce(ranks, Reduce::largest, has);
  int next = 0;
  for (const int has_some : has) places.push_back(has_some != 0 ? next++ : -1);
  return places;
}

void add_nodes(const Mesh& mesh, const std::vector<std::int64_t>& numbers, FieldRegion& region) {
  Mesh& part = region.chunked.mesh;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    if (numbers[n] == no_number) continue;
    region.nodes.push_back(static_cast<int>(n));
    part.nodes.push_back(mesh.nodes[n]);
    part.node_ids.push_back(mesh.node_ids[n]);
    part.node_numbers.push_back(numbers[n]);
  }
}

/// local: [nodes of the whole mesh's share] place in the region.
void add_elements(const Mesh& mesh, std::span<const RegionCell> cells, const std::vector<int>& parts,
                  const std::vector<int>& local, FieldRegion& region) {
  Mesh& part = region.chunked.mesh;
  std::map<std::pair<int, TopologyKind>, int> blocks;  // of the region, by block of the whole mesh and topology
  for (const RegionCell& cell : cells) {
    const std::size_t element = at(cell.element);
    const auto [block, is_new] = blocks.try_emplace({mesh.elements.block_index(element), cell.topology},
                                                    static_cast<int>(part.elements.blocks.size()));
    if (is_new) {
      part.elements.blocks.push_back(mesh.block_of(element));
      part.elements.blocks.back().topology = cell.topology;
      part.elements.blocks.back().part = parts[at(mesh.part_of(element))];
    }
    std::vector<int> corners;
    for (const int node : cell.nodes()) corners.push_back(local[at(node)]);
    part.elements.add(block->second, corners);
    part.element_ids.push_back(mesh.element_ids[element]);
    region.elements.push_back(cell.element);
    region.are_faces = region.are_faces || cell.topology != mesh.block_of(element).topology;
  }
}

void add_chunks(const ChunkedMesh& whole, std::span<const RegionCell> cells, const std::vector<int>& parts,
                FieldRegion& region) {
  const std::vector<std::size_t> of_cells = find_chunks(whole.chunks, cells);
  for (std::size_t i = 0; i < of_cells.size(); ++i) {
    if (i == 0 || of_cells[i] != of_cells[i - 1]) {
      const Chunk& chunk = whole.chunks[of_cells[i]];
      region.chunked.chunks.push_back({static_cast<int>(i), 0, parts[at(chunk.part)], chunk.number});
    }
    ++region.chunked.chunks.back().element_count;
  }
}

/// Parts and sets, what of them is in the region.
void add_names(const Mesh& mesh, const std::vector<int>& parts, const std::vector<int>& local, FieldRegion& region) {
  Mesh& part = region.chunked.mesh;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (parts[p] >= 0) part.parts.push_back(mesh.parts[p]);
  }
  // Also those with parts that are not in the region: nodes may then belong to chunks of these.
  for (const PartJoint& joint : mesh.joints) {
    if (parts[at(joint.part)] >= 0 || parts[at(joint.other)] >= 0) part.joints.push_back(joint);
  }
  for (const auto& [name, members] : mesh.node_sets) {
    std::vector<int>& set = part.node_sets[name];
    for (const int node : members) {
      if (local[at(node)] >= 0) set.push_back(local[at(node)]);
    }
  }
  std::vector<int> elements(mesh.elements.size(), -1);
  for (std::size_t e = 0; e < region.elements.size(); ++e) elements[at(region.elements[e])] = static_cast<int>(e);
  for (const auto& [name, members] : mesh.side_sets) {
    std::vector<ElementFace>& set = part.side_sets[name];
    for (const ElementFace& face : members) {
      if (!region.are_faces && elements[at(face.element)] >= 0) set.push_back({elements[at(face.element)], face.face});
    }
  }
}

}  // namespace

std::vector<RegionCell> list_marked_cells(const Mesh& mesh, std::span<const char> marks) {
  std::vector<RegionCell> cells;
  for (std::size_t e = 0; e < marks.size(); ++e) {
    if (marks[e] == 0) continue;
    cells.push_back({static_cast<int>(e), mesh.block_of(e).topology, {}});
    std::copy(mesh.corners(e).begin(), mesh.corners(e).end(), cells.back().corners.begin());
  }
  return cells;
}

std::vector<RegionCell> list_face_cells(const Mesh& mesh, std::span<const ElementFace> faces) {
  std::vector<RegionCell> cells;
  for (const ElementFace& face : faces) {
    const std::size_t e = at(face.element);
    const Topology& topology = mesh.topology_of(e);
    const bool is_surface = topology.is_surface();
    if (is_surface && !cells.empty() && cells.back().element == face.element) continue;
    const std::span<const int> of_element = mesh.corners(e);
    cells.push_back({face.element, mesh.block_of(e).topology, {}});
    RegionCell& cell = cells.back();
    if (is_surface) {
      std::copy(of_element.begin(), of_element.end(), cell.corners.begin());
      continue;
    }
    const std::span<const int> corners = topology.face_table[at(face.face)].corners();
    cell.topology = corners.size() == 4 ? TopologyKind::quad4 : TopologyKind::tri3;
    std::transform(corners.begin(), corners.end(), cell.corners.begin(), [&](int c) { return of_element[at(c)]; });
  }
  return cells;
}

std::unique_ptr<FieldRegion> make_field_region(const ChunkedMesh& whole, std::span<const RegionCell> cells,
                                               const Communicator& ranks) {
  auto region = std::make_unique<FieldRegion>();
  RegionNodes nodes(whole, cells, ranks);
  region->chunked.numbering = number_region(whole, cells, nodes, ranks);
  add_nodes(whole.mesh, nodes.numbers(), *region);
  std::vector<int> local(whole.mesh.nodes.size(), -1);
  for (std::size_t n = 0; n < region->nodes.size(); ++n) local[at(region->nodes[n])] = static_cast<int>(n);
  const std::vector<int> parts = choose_parts(whole.mesh, cells, ranks);
  add_elements(whole.mesh, cells, parts, local, *region);
  add_chunks(whole, cells, parts, *region);
  int are_faces = region->are_faces ? 1 : 0;
  all_reduce(ranks, Reduce::largest, are_faces);
  region->are_faces = are_faces != 0;
  add_names(whole.mesh, parts, local, *region);
  return region;
}

}  // namespace percuss
