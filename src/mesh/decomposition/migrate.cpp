#include "src/mesh/decomposition/migrate.hpp"

#include <algorithm>
#include <utility>

#include "comm/exchange/item_exchange.hpp"

namespace percuss {
namespace {

// Items that are sent. Numbers are those of the whole mesh.

struct ElementItem {
  std::int64_t number = 0, id = 0;
  std::array<std::int64_t, most_corners> corners{};  // as many as its topology has
  int block = 0, body = 0;
  std::uint8_t exterior = 0;
  double thickness = 0;  // of its own
};

struct NodeItem {
  std::int64_t number = 0, id = 0;
  Vec3 place{};
};

struct SetItem {
  std::int64_t number = 0;  // of a node or an element
  int set = 0, face = 0;
  friend auto operator<=>(const SetItem&, const SetItem&) = default;
};

/// Items, each with the rank that it goes to.
template <class T>
struct Parcels {
  std::vector<int> destinations;
  std::vector<T> items;

  void add(int destination, const T& item) {
    destinations.push_back(destination);
    items.push_back(item);
  }
};

/// Packs pieces by what travels.
class Packer {
 public:
  Packer(const Numbering& numbering, const ChunkPieces& pieces, const std::vector<std::int64_t>& numbers)
      : numbering_(numbering), pieces_(pieces), numbers_(numbers) {
    for (std::size_t c = 0; c < pieces.chunks.size(); ++c) {
      const int elements = pieces.first_element[c + 1] - pieces.first_element[c];
      const int nodes = pieces.first_node[c + 1] - pieces.first_node[c];
      element_chunk_.insert(element_chunk_.end(), static_cast<std::size_t>(elements), c);
      node_chunk_.insert(node_chunk_.end(), static_cast<std::size_t>(nodes), c);
    }
  }

  Parcels<ElementItem> pack_elements() const {
    Parcels<ElementItem> parcels;
    for (std::size_t e = 0; e < element_chunk_.size(); ++e) {
      const std::size_t c = element_chunk_[e];
      ElementItem item{find_number(e),      pieces_.element_ids[e], {}, pieces_.blocks[e], pieces_.bodies[e],
                       pieces_.exterior[e], pieces_.thicknesses[e]};
      for (std::size_t i = 0; i < pieces_.count_corners(e); ++i) item.corners[i] = numbers_[pieces_.find_node(c, e, i)];
      parcels.add(find_rank(c), item);
    }
    return parcels;
  }

  /// Each node once to each rank.
  Parcels<NodeItem> pack_nodes() const {
    std::vector<std::pair<int, int>> order;  // destination, node
    for (std::size_t n = 0; n < node_chunk_.size(); ++n) {
      order.emplace_back(find_rank(node_chunk_[n]), static_cast<int>(n));
    }
    const auto number_of = [&](const auto& entry) { return numbers_[static_cast<std::size_t>(entry.second)]; };
    std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : number_of(a) < number_of(b);
    });
    Parcels<NodeItem> parcels;
    for (const auto& entry : order) {
      if (!parcels.items.empty() && parcels.destinations.back() == entry.first &&
          parcels.items.back().number == number_of(entry)) {
        continue;
      }
      const auto n = static_cast<std::size_t>(entry.second);
      parcels.add(entry.first, {numbers_[n], pieces_.node_ids[n], pieces_.places[n]});
    }
    return parcels;
  }

  Parcels<SetItem> pack_node_members() const {
    Parcels<SetItem> parcels;
    for (const SetMember& m : pieces_.node_members) {
      const auto node = static_cast<std::size_t>(m.item);
      parcels.add(find_rank(node_chunk_[node]), {numbers_[node], m.set, 0});
    }
    return parcels;
  }

  Parcels<SetItem> pack_face_members() const {
    Parcels<SetItem> parcels;
    for (const SetMember& m : pieces_.face_members) {
      const auto element = static_cast<std::size_t>(m.item);
      parcels.add(find_rank(element_chunk_[element]), {find_number(element), m.set, m.face});
    }
    return parcels;
  }

 private:
  int find_rank(std::size_t c) const { return numbering_.ranks[static_cast<std::size_t>(pieces_.chunks[c])]; }

  std::int64_t find_number(std::size_t element) const {
    const std::size_t c = element_chunk_[element];
    return numbering_.first_element[static_cast<std::size_t>(pieces_.chunks[c])] +
           (static_cast<std::int64_t>(element) - pieces_.first_element[c]);
  }

  const Numbering& numbering_;
  const ChunkPieces& pieces_;
  const std::vector<std::int64_t>& numbers_;
  std::vector<std::size_t> element_chunk_, node_chunk_;  // place of its chunk in the pieces
};

template <class T>
void sort_by_number(std::vector<T>& items) {
  std::sort(items.begin(), items.end(), [](const T& a, const T& b) { return a.number < b.number; });
}

int find_place(const std::vector<std::int64_t>& numbers, std::int64_t number) {
  return static_cast<int>(std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin());
}

void fill_nodes(Mesh& mesh, std::vector<NodeItem> items) {
  sort_by_number(items);
  for (const NodeItem& item : items) {
    if (!mesh.node_numbers.empty() && mesh.node_numbers.back() == item.number) continue;
    mesh.node_numbers.push_back(item.number);
    mesh.node_ids.push_back(item.id);
    mesh.nodes.push_back(item.place);
  }
}

void fill_elements(Mesh& mesh, std::vector<ElementItem> items) {
  sort_by_number(items);
  std::vector<int> corners;
  for (const ElementItem& item : items) {
    const ElementBlock& block = mesh.elements.blocks[static_cast<std::size_t>(item.block)];
    corners.resize(static_cast<std::size_t>(find_topology(block.topology).corner_count));
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = find_place(mesh.node_numbers, item.corners[i]);
    mesh.elements.add(item.block, corners);
    mesh.elements.own_thickness.push_back(item.thickness);
    mesh.element_ids.push_back(item.id);
    mesh.bodies.push_back(item.body);
    mesh.exterior.push_back(item.exterior);
  }
}

void list_chunks(ChunkedMesh& share, int rank) {
  const Numbering& numbering = share.numbering;
  int next = 0;
  for (std::size_t c = 0; c < numbering.ranks.size(); ++c) {
    if (numbering.ranks[c] != rank) continue;
    const auto count = static_cast<int>(numbering.first_element[c + 1] - numbering.first_element[c]);
    share.chunks.push_back({next, count, share.mesh.part_of(static_cast<std::size_t>(next)), static_cast<int>(c)});
    next += count;
  }
}

/// Place in the share of an element of one of its chunks.
int find_element(const ChunkedMesh& share, std::int64_t number) {
  const auto chunk = static_cast<int>(Numbering::find_chunk(share.numbering.first_element, number));
  const auto own = std::lower_bound(share.chunks.begin(), share.chunks.end(), chunk,
                                    [](const Chunk& c, int wanted) { return c.number < wanted; });
  return own->first_element + static_cast<int>(number - share.numbering.first_element[static_cast<std::size_t>(chunk)]);
}

/// Every set of the scene, those without a member here empty.
template <class Members>
std::vector<Members*> name_sets(const SceneParts& scene, std::vector<std::string> ScenePart::*names,
                                std::map<std::string, Members>& sets) {
  std::vector<Members*> by_place;
  for (const ScenePart& part : scene.parts) {
    for (const std::string& name : part.*names) by_place.push_back(&sets[part.name + "/" + name]);
  }
  return by_place;
}

/// Members come once for each chunk that has them.
void sort_members(std::vector<SetItem>& members) {
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
}

/// Nodes of the elements of each part. Elements lie part after part.
void add_nodes_of_parts(Mesh& mesh, const SceneParts& scene) {
  std::vector<std::vector<int>*> sets;
  for (const ScenePart& part : scene.parts) sets.push_back(&mesh.node_sets[part.name]);
  std::vector<int> last_part(mesh.nodes.size(), -1);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const int part = mesh.part_of(e);
    for (const int n : mesh.corners(e)) {
      if (std::exchange(last_part[static_cast<std::size_t>(n)], part) != part)
        sets[static_cast<std::size_t>(part)]->push_back(n);
    }
  }
  for (std::vector<int>* set : sets) {
    std::sort(set->begin(), set->end());
    set->erase(std::unique(set->begin(), set->end()), set->end());  // joined nodes had them before
  }
}

void fill_node_sets(Mesh& mesh, const SceneParts& scene, std::vector<SetItem> members) {
  auto sets = name_sets(scene, &ScenePart::node_sets, mesh.node_sets);
  for (const ScenePart& part : scene.parts)
    sets.push_back(&mesh.node_sets[part.name]);  // as join_pieces() numbers them
  sort_members(members);
  for (const SetItem& m : members) {
    sets[static_cast<std::size_t>(m.set)]->push_back(find_place(mesh.node_numbers, m.number));
  }
  add_nodes_of_parts(mesh, scene);
}

void fill_side_sets(ChunkedMesh& share, const SceneParts& scene, std::vector<SetItem> members) {
  const auto sets = name_sets(scene, &ScenePart::side_sets, share.mesh.side_sets);
  sort_members(members);
  for (const SetItem& m : members) {
    sets[static_cast<std::size_t>(m.set)]->push_back({find_element(share, m.number), m.face});
  }
}

}  // namespace

ChunkedMesh migrate_chunks(const Communicator& ranks, const SceneParts& scene, Numbering numbering,
                           const ChunkPieces& pieces, const std::vector<std::int64_t>& numbers) {
  ChunkedMesh share;
  share.numbering = std::move(numbering);
  for (const ScenePart& part : scene.parts) {
    share.mesh.parts.push_back({part.name});
    std::vector<ElementBlock>& blocks = share.mesh.elements.blocks;
    blocks.insert(blocks.end(), part.blocks.begin(), part.blocks.end());
  }
  ItemExchange exchange(ranks);
  const Packer packer(share.numbering, pieces, numbers);
  const auto send = [&](const auto& parcels) { return exchange.send(parcels.destinations, parcels.items); };
  fill_nodes(share.mesh, send(packer.pack_nodes()));
  fill_elements(share.mesh, send(packer.pack_elements()));
  list_chunks(share, ranks.rank());
  fill_node_sets(share.mesh, scene, send(packer.pack_node_members()));
  fill_side_sets(share, scene, send(packer.pack_face_members()));
  return share;
}

}  // namespace percuss
