#include "src/mesh/files/text_lookup.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/error.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

constexpr std::size_t most_problems = 10;

/// Sets that name sets that name sets end somewhere.
constexpr int most_depth = 20;

}  // namespace

void TextLookup::add_problem(TextPlace place, const std::string& text) {
  ++problem_count_;
  if (problems_.size() < most_problems) problems_.push_back(from_.names.at(place) + text);
}

void TextLookup::stop_at_problems() const {
  if (problem_count_ == 0) return;
  std::string text;
  for (const std::string& problem : problems_) text += (text.empty() ? "" : "\n") + problem;
  if (problem_count_ > problems_.size()) text += fmt::format("\nand {} more", problem_count_ - problems_.size());
  throw InputError(text);
}

void TextLookup::number_nodes() {
  for (std::size_t n = 0; n < from_.node_ids_.size(); ++n)
    node_numbers_.push_back({from_.node_ids_[n], IdSpace::elements, static_cast<std::int64_t>(n) + 1});
  std::sort(node_numbers_.begin(), node_numbers_.end());
  for (std::size_t i = 1; i < node_numbers_.size(); ++i) {
    if (node_numbers_[i].id != node_numbers_[i - 1].id) continue;
    const std::size_t first = at(node_numbers_[i - 1].number - 1), second = at(node_numbers_[i].number - 1);
    if (from_.nodes_[first] == from_.nodes_[second]) continue;  // the same node, twice
    add_problem(from_.node_places_[second], fmt::format("node {} stands elsewhere in line {}", node_numbers_[i].id,
                                                        from_.node_places_[first].line));
  }
  to_.nodes = std::move(from_.nodes_);
  to_.node_ids = std::move(from_.node_ids_);
}

std::int64_t TextLookup::find_node(std::int64_t id) const {
  const auto found = std::lower_bound(node_numbers_.begin(), node_numbers_.end(), IdPlace{id, IdSpace::elements, 0});
  return found != node_numbers_.end() && found->id == id ? found->number : 0;
}

std::int64_t TextLookup::find_element(ElementId id) const {
  const auto found = std::lower_bound(element_numbers_.begin(), element_numbers_.end(), IdPlace{id.id, id.ids, 0});
  return found != element_numbers_.end() && found->id == id.id && found->ids == id.ids ? found->number : 0;
}

bool TextLookup::find_nodes(std::span<std::int64_t> nodes, TextPlace place) {
  bool are_known = true;
  for (std::int64_t& node : nodes) {
    const std::int64_t number = find_node(node);
    if (number == 0) add_problem(place, fmt::format("there is no node {}", node));
    are_known = are_known && number != 0;
    node = number;
  }
  return are_known;
}

/// Blocks of elements in their order; shells of surfaces come last.
void TextLookup::fill_blocks() {
  for (TextBuilder::Block& block : from_.blocks_) {
    const std::size_t corners = block.ids.empty() ? 0 : block.nodes.size() / block.ids.size();
    for (std::size_t e = 0; e < block.ids.size(); ++e)
      find_nodes(std::span(block.nodes).subspan(e * corners, corners), block.places[e]);
    if (!block.thicknesses.empty()) block.thicknesses.resize(block.ids.size(), 0);
    to_.add_block(block.head, block.ids, std::move(block.nodes), block.thicknesses);
  }
}

void TextLookup::number_elements() {
  element_numbers_.clear();
  for (std::size_t b = 0; b < from_.blocks_.size(); ++b) {
    const TextBuilder::Block& block = from_.blocks_[b];
    for (std::size_t e = 0; e < block.ids.size(); ++e)
      element_numbers_.push_back(
          {block.ids[e], block.kind.ids, to_.blocks[b].first_element + static_cast<std::int64_t>(e)});
  }
  std::sort(element_numbers_.begin(), element_numbers_.end());
}

std::size_t TextLookup::find_block(std::int64_t element) const {
  const auto behind = std::upper_bound(to_.blocks.begin(), to_.blocks.end(), element,
                                       [](std::int64_t e, const FileBlock& block) { return e < block.first_element; });
  return static_cast<std::size_t>(behind - to_.blocks.begin()) - 1;
}

const Topology* TextLookup::topology_of(std::int64_t element) const {
  const auto& kind = to_.blocks[find_block(element)].topology;
  return kind ? &find_topology(*kind) : nullptr;
}

std::span<const std::int64_t> TextLookup::corners_of(std::int64_t element) const {
  const std::size_t block = find_block(element);
  const std::size_t count = at(to_.blocks[block].nodes_per_element);
  return std::span(to_.corners[block]).subspan(at(element - to_.blocks[block].first_element) * count, count);
}

std::array<std::int64_t, 4> TextLookup::make_key(std::array<std::int64_t, 4> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// Faces of which all nodes are requested.
void TextLookup::list_faces(const std::vector<char>& on_faces) {
  faces_.clear();
  for (const FileBlock& block : to_.blocks) {
    if (!block.topology) continue;
    const Topology& topology = find_topology(*block.topology);
    for (std::int64_t e = block.first_element; e < block.first_element + block.elements; ++e) {
      const std::span<const std::int64_t> corners = corners_of(e);
      for (int f = 0; f < topology.face_count; ++f) {
        const std::span<const int> places = topology.face_table[at(f)].corners();
        std::array<std::int64_t, 4> nodes{};
        bool is_asked = true;
        for (std::size_t i = 0; i < places.size(); ++i) {
          nodes[i] = corners[at(places[i])];
          is_asked = is_asked && on_faces[at(nodes[i])] != 0;
        }
        if (is_asked) faces_.push_back({make_key(nodes), e, f});
      }
      if (block.nodes_per_element == std::int64_t{tet10_nodes}) list_triangles(e, on_faces);
    }
  }
  std::sort(faces_.begin(), faces_.end());
}

/// Lists the triangles into which faces of a tetrahedron of ten nodes are cut.
void TextLookup::list_triangles(std::int64_t element, const std::vector<char>& on_faces) {
  const std::span<const std::int64_t> nodes_of = corners_of(element);
  for (int side = tet4_topology.face_count; side < tet10_sides; ++side) {
    const int behind = side - tet4_topology.face_count;
    std::array<std::int64_t, 4> nodes{};
    bool is_asked = true;
    for (std::size_t i = 0; i < 3; ++i) {
      nodes[i] = nodes_of[at(cut_tet10_face(behind / 4)[at(behind % 4)][i])];
      is_asked = is_asked && on_faces[at(nodes[i])] != 0;
    }
    if (is_asked) faces_.push_back({make_key(nodes), element, side});
  }
}

/// [nodes + 1]
std::vector<char> TextLookup::mark_nodes_of_faces() const {
  std::vector<char> marks(to_.nodes.size() + 1, 0);
  for (const auto& [name, sides] : from_.side_sets_) {
    for (const TextBuilder::Side& side : sides) {
      for (std::size_t i = 0; i < side.count; ++i) marks[at(find_node(side.nodes[i]))] = 1;
    }
  }
  for (const auto& [name, surface] : from_.surfaces_) {
    for (const TextBuilder::SurfaceElement& element : surface.elements) {
      for (std::size_t i = 0; i < element.count; ++i) marks[at(find_node(element.nodes[i]))] = 1;
    }
  }
  return marks;
}

/// Finds, of the two faces of a shell, the one around which the nodes run in the same sense.
FileSide TextLookup::find_face(const std::array<std::int64_t, 4>& nodes) const {
  const std::array<std::int64_t, 4> key = make_key(nodes);
  const auto found = std::lower_bound(faces_.begin(), faces_.end(), FacePlace{key, 0, 0});
  if (found == faces_.end() || found->key != key) return {0, 0};
  const Topology& topology = *topology_of(found->element);
  if (!topology.is_surface()) return {found->element, found->face + 1};
  const std::span<const std::int64_t> corners = corners_of(found->element);
  const auto first = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), nodes[0]) - corners.begin());
  const bool is_alike = corners[(first + 1) % corners.size()] == nodes[1];
  return {found->element, (is_alike ? top_face : bottom_face) + 1};
}

/// Surfaces on solids are side sets, the others blocks of shells.
void TextLookup::sort_surfaces() {
  for (auto& [name, surface] : from_.surfaces_) {
    const bool is_side_set = std::all_of(surface.elements.begin(), surface.elements.end(), [&](const auto& element) {
      std::array<std::int64_t, 4> nodes{};
      for (std::size_t i = 0; i < element.count; ++i) nodes[i] = find_node(element.nodes[i]);
      return find_face(nodes).first != 0;
    });
    for (const TextBuilder::SurfaceElement& element : surface.elements) {
      const std::span nodes(element.nodes.data(), element.count);
      if (is_side_set)
        from_.add_set_face(name, nodes, element.place);
      else
        from_.add_element(from_.find_block(name, surface.id, element.kind), element.id.id,
                          element.kind.topology ? nodes : nodes.first(0), element.place);
    }
    if (is_side_set) from_.number_set(name, surface.id);
  }
  from_.surfaces_.clear();
}

void TextLookup::add_members(const std::string& set, const std::vector<Member>& members, bool of_nodes, int depth,
                             std::vector<std::int64_t>& numbers) {
  const std::vector<IdPlace>& known = of_nodes ? node_numbers_ : element_numbers_;
  const char* const noun = of_nodes ? "node" : "element";
  for (const Member& member : members) {
    if (member.what == Member::What::one) {
      const std::int64_t number = of_nodes ? find_node(member.id) : find_element({member.id, member.ids});
      if (number == 0) add_problem(member.place, fmt::format("there is no {} {}", noun, member.id));
      if (number != 0) numbers.push_back(number);
    } else if (member.what == Member::What::range) {
      for (auto i = std::lower_bound(known.begin(), known.end(), IdPlace{member.id, IdSpace::elements, 0});
           i != known.end() && i->id <= member.last; ++i) {
        const std::uint64_t above = static_cast<std::uint64_t>(i->id) - static_cast<std::uint64_t>(member.id);
        if (i->ids == member.ids && above % static_cast<std::uint64_t>(member.step) == 0) numbers.push_back(i->number);
      }
    } else if (member.what == Member::What::block) {
      bool is_known = false;
      for (const FileBlock& block : to_.blocks) {
        if (block.id != member.id) continue;
        is_known = true;
        for (std::int64_t e = 0; e < block.elements; ++e) numbers.push_back(block.first_element + e);
      }
      if (!is_known) add_problem(member.place, fmt::format("no elements are of part {}", member.id));
    } else {
      const auto& sets = of_nodes ? from_.node_sets_ : from_.element_sets_;
      const auto other = sets.find(member.set);
      if (!of_nodes && add_blocks(member.set, numbers) && other == sets.end()) continue;
      if (other == sets.end())
        add_problem(member.place, fmt::format("there is no {} set '{}'", noun, member.set));
      else if (depth == most_depth)
        add_problem(member.place, fmt::format("{} set '{}' names itself, or sets too deep in each other", noun, set));
      else
        add_members(set, other->second, of_nodes, depth + 1, numbers);
    }
    if (numbers.size() > 100 * (known.size() + 1000)) {  // of sets of sets, which grow without end
      add_problem(member.place, fmt::format("{} set '{}' has too many members", noun, set));
      return;
    }
  }
}

bool TextLookup::add_blocks(const std::string& name, std::vector<std::int64_t>& numbers) const {
  bool are_there = false;
  for (const FileBlock& block : to_.blocks) {
    if (block.name != name) continue;
    are_there = true;
    for (std::int64_t e = 0; e < block.elements; ++e) numbers.push_back(block.first_element + e);
  }
  return are_there;
}

FileSet TextLookup::describe_set(const std::string& name, std::size_t entries) const {
  const auto id = from_.set_ids_.find(name);
  return {id == from_.set_ids_.end() ? 0 : id->second, name, static_cast<std::int64_t>(entries)};
}

void TextLookup::fill_node_sets() {
  for (const auto& [name, members] : from_.node_sets_) {
    std::vector<std::int64_t>& nodes = to_.nodes_of_sets[name];
    add_members(name, members, true, 0, nodes);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    to_.node_sets.push_back(describe_set(name, nodes.size()));
  }
}

void TextLookup::fill_element_sets() {
  for (const auto& [name, members] : from_.element_sets_) {
    std::vector<std::int64_t>& elements = to_.elements_of_sets[name];
    add_members(name, members, false, 0, elements);
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
    to_.element_sets.push_back(describe_set(name, elements.size()));
  }
}

void TextLookup::add_sides(const TextBuilder::Side& side, std::vector<FileSide>& sides) {
  const auto add = [&](std::int64_t element) {
    const Topology* topology = topology_of(element);
    if (topology == nullptr) return;  // of a kind that cannot be run
    const int face = side.face.find(*topology);
    if (face >= 0 && face < topology->face_count) sides.emplace_back(element, face + 1);
    if (face == TextSide::missing)
      add_problem(side.place, fmt::format("element {} has no such side (it is a {})", to_.element_ids[at(element - 1)],
                                          topology->noun));
  };
  if (side.count > 0) {
    std::array<std::int64_t, 4> nodes = side.nodes;
    if (!find_nodes(std::span(nodes.data(), side.count), side.place)) return;
    const FileSide face = find_face(nodes);
    if (face.first == 0 && !has_other_kinds()) add_problem(side.place, "no element has a face with these nodes");
    if (face.first == 0) ++lost_faces_;
    if (face.first != 0) sides.push_back(face);
  } else if (!side.set.empty()) {
    std::vector<std::int64_t> elements;
    add_members(side.set, {{Member::What::set, 0, 0, 1, {}, side.set, side.place}}, false, 0, elements);
    std::for_each(elements.begin(), elements.end(), add);
  } else {
    const std::int64_t element = find_element(side.element);
    if (element == 0) add_problem(side.place, fmt::format("there is no element {}", side.element.id));
    if (element != 0) add(element);
  }
}

/// Gives shells the mean thickness of their corners, where each has one.
void TextLookup::average_thicknesses() {
  if (from_.averaged_.empty()) return;
  std::vector<double> of_node(to_.nodes.size() + 1, 0);
  std::vector<std::int64_t> members;
  for (const TextBuilder::NodeThickness& given : from_.node_thicknesses_) {
    members.clear();
    add_members("", given.nodes, true, 0, members);
    for (const std::int64_t node : members) of_node[at(node)] = given.thickness;
  }
  members.clear();
  add_members("", from_.averaged_, false, 0, members);
  for (const std::int64_t element : members) {
    const Topology* topology = topology_of(element);
    if (topology == nullptr || !topology->is_surface()) continue;
    double sum = 0;
    bool are_given = true;
    for (const std::int64_t node : corners_of(element)) {
      sum += of_node[at(node)];
      are_given = are_given && of_node[at(node)] > 0;
    }
    const std::size_t block = find_block(element);
    to_.thicknesses[block].resize(static_cast<std::size_t>(to_.blocks[block].elements), 0);
    if (are_given) to_.thicknesses[block][at(element - to_.blocks[block].first_element)] = sum / topology->corner_count;
  }
}

bool TextLookup::has_other_kinds() const {
  return std::any_of(to_.blocks.begin(), to_.blocks.end(), [](const FileBlock& block) { return !block.topology; });
}

void TextLookup::fill_side_sets() {
  for (const auto& [name, sides] : from_.side_sets_) {
    std::vector<FileSide>& found = to_.sides_of_sets[name];
    for (const TextBuilder::Side& side : sides) add_sides(side, found);
    to_.side_sets.push_back(describe_set(name, found.size()));
  }
}

TextContents TextLookup::look_up() {
  number_nodes();
  const std::vector<char> on_faces = mark_nodes_of_faces();
  const auto fill = [&] {
    to_.blocks.clear();
    to_.corners.clear();
    to_.thicknesses.clear();
    to_.element_ids.clear();
    fill_blocks();
    stop_at_problems();
    list_faces(on_faces);
  };
  if (!from_.surfaces_.empty()) {
    const std::vector<TextBuilder::Block> solids = from_.blocks_;
    fill();
    from_.blocks_ = solids;
    sort_surfaces();
  }
  fill();
  number_elements();
  fill_node_sets();
  fill_element_sets();
  fill_side_sets();
  average_thicknesses();
  stop_at_problems();
  to_.notes = from_.notes_;
  if (lost_faces_ > 0)
    to_.notes.push_back(
        fmt::format("{} faces of side sets are ignored (they may belong to unsupported elements)", lost_faces_));
  return std::move(to_);
}

}  // namespace percuss
