#include "src/mesh/pieces/chunk_pieces.hpp"

#include <algorithm>
#include <span>

namespace percuss {
namespace {

/// Adds chunks to pieces one by one.
class PieceMaker {
 public:
  explicit PieceMaker(ChunkPieces& pieces) : pieces_(pieces) {}

  void begin(int chunk, int part) {
    pieces_.chunks.push_back(chunk);
    pieces_.parts.push_back(part);
    keys_.clear();
  }

  /// nodes: corners, which count from `first_key`. Returns the place of the element in the pieces.
  int add_element(int block, std::span<const int> nodes, std::int64_t first_key, std::int64_t id, int body) {
    for (const int node : nodes) keys_.push_back(first_key + node);
    pieces_.first_corner.push_back(pieces_.first_corner.back() + nodes.size());
    pieces_.blocks.push_back(block);
    pieces_.element_ids.push_back(id);
    pieces_.bodies.push_back(body);
    pieces_.exterior.push_back(0);
    pieces_.thicknesses.push_back(0);
    return static_cast<int>(pieces_.element_ids.size()) - 1;
  }

  void mark_exterior(int element, int face) {
    std::uint8_t& mask = pieces_.exterior[static_cast<std::size_t>(element)];
    mask = static_cast<std::uint8_t>(mask | (1U << face));
  }

  void add_face(int element, int set, int face) { pieces_.face_members.push_back({element, set, face}); }

  /// Numbers the nodes of the chunk by first use; add_node(key, place in the pieces) fills in the rest of each.
  template <class AddNode>
  void end(const AddNode& add_node) {
    sorted_ = keys_;
    std::sort(sorted_.begin(), sorted_.end());
    sorted_.erase(std::unique(sorted_.begin(), sorted_.end()), sorted_.end());
    local_.assign(sorted_.size(), -1);
    int count = 0;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      int& local = local_[static_cast<std::size_t>(std::lower_bound(sorted_.begin(), sorted_.end(), keys_[i]) -
                                                   sorted_.begin())];
      if (local < 0) {
        local = count++;
        pieces_.keys.push_back(keys_[i]);
        add_node(keys_[i], static_cast<int>(pieces_.keys.size()) - 1);
      }
      pieces_.corners.push_back(static_cast<std::uint16_t>(local));
    }
    pieces_.first_element.push_back(static_cast<int>(pieces_.element_ids.size()));
    pieces_.first_node.push_back(static_cast<int>(pieces_.keys.size()));
  }

  ChunkPieces& pieces() { return pieces_; }

 private:
  ChunkPieces& pieces_;
  std::vector<std::int64_t> keys_, sorted_;
  std::vector<int> local_;
};

void make_generated_chunk(const ScenePart& part, int part_index, int chunk, PieceMaker& maker) {
  const ShapeSource& source = *part.generated->source;
  const auto nodes = std::int64_t{source.node_count()}, elements = std::int64_t{source.element_count()};
  maker.begin(part.first_chunk + chunk, part_index);
  for (const SourceElement& e : part.generated->tiling.list_elements(chunk)) {
    const std::int64_t id = part.first_element_id + e.copy * elements + e.element;
    const int added = maker.add_element(part.first_block, source.corners(e.element), part.first_key + e.copy * nodes,
                                        id, part.first_body + e.copy);
    const ShapeSource::FaceSides sides = source.face_sides(e.element);
    for (int face = 0; face < find_topology(source.topology()).face_count; ++face) {
      const int side = sides[static_cast<std::size_t>(face)];
      if (side == ShapeSource::interior) continue;
      maker.mark_exterior(added, face);
      maker.add_face(added, part.first_side_set + side, face);
    }
  }
  maker.end([&](std::int64_t key, int node) {
    const std::int64_t in_part = key - part.first_key;
    const int index = static_cast<int>(in_part % nodes);
    ChunkPieces& pieces = maker.pieces();
    pieces.node_ids.push_back(part.first_node_id + in_part);
    pieces.places.push_back(part.generated->place(source.place(index), static_cast<int>(in_part / nodes)));
    const unsigned sides = source.node_sides(index);
    for (int side = 0; sides >> side != 0; ++side) {
      if ((sides >> side & 1) != 0) pieces.node_members.push_back({node, part.first_node_set + side, 0});
    }
  });
}

/// Sets of each item (compressed rows): who is in what, the other way round than a file has it.
struct SetsOfItems {
  std::vector<int> first;
  std::vector<SetMember> members;

  std::span<const SetMember> of(std::size_t item) const {
    return {members.data() + first[item], members.data() + first[item + 1]};
  }
};

SetsOfItems sort_by_item(std::vector<SetMember> members, std::size_t items) {
  SetsOfItems sets;
  std::stable_sort(members.begin(), members.end(), [](const auto& a, const auto& b) { return a.item < b.item; });
  sets.first.assign(items + 1, 0);
  for (const SetMember& m : members) ++sets.first[static_cast<std::size_t>(m.item) + 1];
  for (std::size_t i = 0; i < items; ++i) sets.first[i + 1] += sets.first[i];
  sets.members = std::move(members);
  return sets;
}

void make_file_chunks(const ScenePart& part, int part_index, PieceMaker& maker) {
  const FilePart& file = *part.file;
  const PartMesh& mesh = file.mesh;
  std::vector<SetMember> in_sets;
  int set = part.first_node_set;
  for (const auto& [name, nodes] : mesh.node_sets) {
    for (const int n : nodes) in_sets.push_back({n, set, 0});
    ++set;
  }
  const SetsOfItems node_sets = sort_by_item(std::move(in_sets), mesh.nodes.size());
  in_sets.clear();
  set = part.first_side_set;
  for (const auto& [name, faces] : mesh.side_sets) {
    for (const ElementFace& f : faces) in_sets.push_back({f.element, set, f.face});
    ++set;
  }
  const SetsOfItems face_sets = sort_by_item(std::move(in_sets), mesh.elements.size());

  for (int chunk = 0; chunk < part.chunks; ++chunk) {
    maker.begin(part.first_chunk + chunk, part_index);
    const auto at = static_cast<std::size_t>(chunk);
    for (int e = file.first_of_chunk[at]; e < file.first_of_chunk[at + 1]; ++e) {
      const auto element = static_cast<std::size_t>(e);
      const int added =
          maker.add_element(part.first_block + mesh.elements.block_index(element), mesh.elements.corners(element),
                            part.first_key, mesh.element_ids[element], part.first_body + file.bodies[element]);
      maker.pieces().exterior.back() = file.exterior[element];
      if (!mesh.elements.own_thickness.empty())
        maker.pieces().thicknesses.back() = mesh.elements.own_thickness[element];
      for (const SetMember& m : face_sets.of(element)) maker.add_face(added, m.set, m.face);
    }
    maker.end([&](std::int64_t key, int node) {
      const auto in_part = static_cast<std::size_t>(key - part.first_key);
      ChunkPieces& pieces = maker.pieces();
      pieces.node_ids.push_back(mesh.node_ids[in_part]);
      pieces.places.push_back(mesh.nodes[in_part]);
      for (const SetMember& m : node_sets.of(in_part)) pieces.node_members.push_back({node, m.set, 0});
    });
  }
}

}  // namespace

ChunkPieces make_pieces(const SceneParts& scene, int rank, int size) {
  ChunkPieces pieces;
  PieceMaker maker(pieces);
  std::int64_t generated = 0, passed = 0;
  for (const ScenePart& part : scene.parts) generated += part.generated ? part.chunks : 0;
  const std::int64_t first = generated * rank / size, last = generated * (rank + 1) / size;
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    const ScenePart& part = scene.parts[p];
    if (part.file) make_file_chunks(part, static_cast<int>(p), maker);
    if (!part.generated) continue;
    const auto begin = std::clamp<std::int64_t>(first - passed, 0, part.chunks);
    const auto end = std::clamp<std::int64_t>(last - passed, 0, part.chunks);
    for (std::int64_t chunk = begin; chunk < end; ++chunk) {
      make_generated_chunk(part, static_cast<int>(p), static_cast<int>(chunk), maker);
    }
    passed += part.chunks;
  }
  return pieces;
}

}  // namespace percuss
