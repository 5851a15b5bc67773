#include "src/mesh/formats/keyword_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "src/mesh/files/text_builder.hpp"
#include "src/mesh/files/text_numbers.hpp"
#include "src/mesh/files/unread_words.hpp"
#include "src/mesh/formats/keyword_cards.hpp"
#include "src/mesh/topology/collapsed_hexahedron.hpp"

namespace percuss {
namespace {

constexpr std::array<int, 6> node_widths = {8, 16, 16, 16, 8, 8};
constexpr std::array<int, 10> element_widths = {8, 8, 8, 8, 8, 8, 8, 8, 8, 8};
constexpr std::array<int, 5> thickness_widths = {16, 16, 16, 16, 16};  // of the corners, and an angle
constexpr std::array<int, 8> card_widths = {10, 10, 10, 10, 10, 10, 10, 10};

/// Takes a word off the end of a keyword, with the underscore before it.
bool take_suffix(std::string& keyword, std::string_view suffix) {
  if (!keyword.ends_with(suffix) || keyword.size() <= suffix.size()) return false;
  keyword.resize(keyword.size() - suffix.size());
  return true;
}

std::size_t count_different(std::vector<std::int64_t> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return static_cast<std::size_t>(std::unique(nodes.begin(), nodes.end()) - nodes.begin());
}

/// The corners of a tetrahedron: those of n1 n2 n3 n4 n4 n4 n4 n4, which may end with the first n4, or of
/// n1 n2 n3 n3 n4 n4 n4 n4. Empty: it is none.
std::vector<std::int64_t> find_tetrahedron(const std::vector<std::int64_t>& nodes) {
  if (count_different(nodes) != 4 || (nodes.size() != 4 && nodes.size() != 8)) return {};
  const std::size_t apex = nodes[2] == nodes[3] ? 4 : 3;
  if (std::any_of(nodes.begin() + static_cast<std::ptrdiff_t>(apex), nodes.end(),
                  [&](std::int64_t node) { return node != nodes[apex]; }))
    return {};
  return {nodes[0], nodes[1], nodes[2], nodes[apex]};
}

class KeywordReader {
 public:
  explicit KeywordReader(const std::string& path) : cards_(path, builder_.names) {}

  std::unique_ptr<MeshFile> read() {
    while (cards_.next_keyword()) read_keyword(cards_.keyword());
    for (const auto& [id, title] : titles_) builder_.rename_blocks(id, title);
    if (!unread_.empty()) builder_.add_note(describe_unread(unread_, "*"));
    return std::make_unique<TextMesh>(
        builder_.finish("hexahedra, wedges, pyramids and tetrahedra of four or ten nodes, shells of three and four "
                        "nodes, beams of two nodes"));
  }

 private:
  void read_keyword(const std::string& keyword) {
    if (keyword == "NODE") return read_nodes();
    if (keyword == "ELEMENT_SOLID") return read_solids();
    if (keyword == "ELEMENT_SHELL") return read_shells(false);
    if (keyword == "ELEMENT_SHELL_THICKNESS") return read_shells(true);
    if (keyword == "ELEMENT_BEAM") return read_beams();
    if (keyword == "PART") return read_parts();
    if (keyword == "INCLUDE") return read_includes();
    if (keyword.starts_with("SET_")) return read_set(keyword);
    refuse_changes(keyword);
    if (keyword.starts_with("ELEMENT_")) return read_other_elements(keyword);
    if (keyword != "KEYWORD" && keyword != "TITLE") unread_.insert(keyword);
  }

  /// Refuses cards that would change the mesh that is read.
  void refuse_changes(const std::string& keyword) const {
    for (const char* word :
         {"INCLUDE_", "NODE_TRANSFORM", "NODE_MERGE", "NODE_SCALAR", "ELEMENT_SOLID_", "ELEMENT_SHELL_",
          "ELEMENT_BEAM_", "ELEMENT_GENERATE", "DEFINE_TRANSFORMATION", "--BEGIN", "-----BEGIN"}) {
      if (keyword.starts_with(word)) cards_.refuse(fmt::format("*{} is not read (it changes the mesh)", keyword));
    }
  }

  void read_nodes() {
    while (cards_.next_line()) {
      if (strip_blanks(cards_.line()).empty()) continue;
      cards_.cut(node_widths);
      builder_.add_node(cards_.integer(0), {cards_.real(1), cards_.real(2), cards_.real(3)}, cards_.place());
      if (cards_.integer(4) != 0 || cards_.integer(5) != 0) unread_.insert("NODE (constraints TC, RC)");
    }
  }

  std::string name_part(std::int64_t part) const { return fmt::format("block_{}", part); }

  /// Reads solids: on one line, or with the nodes on a second one.
  void read_solids() {
    std::vector<std::int64_t> nodes;
    while (cards_.next_line()) {
      if (strip_blanks(cards_.line()).empty()) continue;
      cards_.cut(element_widths);
      const TextPlace place = cards_.place();
      const std::int64_t id = cards_.integer(0), part = cards_.integer(1);
      std::size_t first = 2;
      if (cards_.integer(2) == 0) {
        if (!cards_.next_line()) cards_.refuse(fmt::format("solid {} has no nodes", id));
        cards_.cut(element_widths);
        first = 0;
      }
      nodes.clear();
      for (std::size_t i = first; i < first + 10 && cards_.integer(i) != 0; ++i) nodes.push_back(cards_.integer(i));
      add_solid(id, part, nodes, place);
    }
  }

  void add_solid(std::int64_t id, std::int64_t part, const std::vector<std::int64_t>& nodes, TextPlace place) {
    const std::size_t different = count_different(nodes);
    if (nodes.size() == 8 && different == 8) {
      const TextKind kind{"ELEMENT_SOLID", TopologyKind::hex8, 8, IdSpace::elements};
      return builder_.add_element(builder_.find_block(name_part(part), part, kind), id, nodes, place);
    }
    if (nodes.size() == tet10_nodes && different == tet10_nodes) {
      const TextKind kind{"ELEMENT_SOLID, tetrahedron of ten nodes", TopologyKind::tet4, std::int64_t{tet10_nodes},
                          IdSpace::elements};
      return builder_.add_element(builder_.find_block(name_part(part), part, kind), id, nodes, place);
    }
    const std::vector<std::int64_t> corners = find_tetrahedron(nodes);
    const auto solid = corners.empty() ? collapse_hexahedron(nodes) : SolidOfNodes{TopologyKind::tet4, corners};
    if (!solid) return add_other("ELEMENT_SOLID", fmt::format("degenerate, of {} nodes", different), id, part, place);
    const Topology& topology = find_topology(solid->kind);
    const TextKind kind{fmt::format("ELEMENT_SOLID, {}", topology.noun), solid->kind, topology.corner_count,
                        IdSpace::elements};
    builder_.add_element(builder_.find_block(name_part(part), part, kind), id, solid->nodes, place);
  }

  /// Elements that cannot be run, by the line of their first.
  void add_other(const std::string& keyword, const std::string& shape, std::int64_t id, std::int64_t part,
                 TextPlace place) {
    const auto [kind, is_new] = other_kinds_.emplace(std::pair(keyword + shape, part), std::string());
    if (is_new)
      kind->second = fmt::format("*{}{}{} (first {})", keyword, shape.empty() ? "" : ", ", shape,
                                 builder_.names.at(place).substr(0, builder_.names.at(place).size() - 2));
    builder_.add_element(builder_.find_block(name_part(part), part, {kind->second, {}, 0, IdSpace::elements}), id, {},
                         place);
  }

  /// Thicknesses of the corners stand on a second line; the shell has their mean.
  double read_thickness(std::int64_t id, std::size_t corners) {
    if (!cards_.next_line()) cards_.refuse(fmt::format("shell {} has no line of thicknesses", id));
    cards_.cut(thickness_widths);
    double sum = 0, first = 0;
    int given = 0;
    bool are_equal = true;
    for (std::size_t i = 0; i < corners; ++i) {
      const double thickness = cards_.real(i);
      if (thickness == 0) continue;
      if (given++ == 0) first = thickness;
      are_equal = are_equal && thickness == first;
      sum += thickness;
    }
    return are_equal ? first : sum / given;
  }

  void read_shells(bool with_thickness) {
    while (cards_.next_line()) {
      if (strip_blanks(cards_.line()).empty()) continue;
      cards_.cut(element_widths);
      const std::int64_t id = cards_.integer(0), part = cards_.integer(1);
      std::array<std::int64_t, 4> nodes{};
      for (std::size_t i = 0; i < 4; ++i) nodes[i] = cards_.integer(i + 2);
      if (cards_.integer(6) != 0) {
        if (with_thickness) cards_.refuse(fmt::format("shell {} has nodes on its edges and thicknesses", id));
        add_other("ELEMENT_SHELL", "with nodes on its edges", id, part, cards_.place());
        continue;
      }
      const bool is_triangle = nodes[3] == 0 || nodes[3] == nodes[2];
      const TextKind kind{"ELEMENT_SHELL", is_triangle ? TopologyKind::tri3 : TopologyKind::quad4, is_triangle ? 3 : 4,
                          IdSpace::shells};
      TextKind named = kind;
      if (is_triangle) named.name += ", triangle";
      const std::size_t corners = is_triangle ? 3 : 4;
      const int block = builder_.find_block(name_part(part), part, named);
      builder_.add_element(block, id, std::span(nodes.data(), corners), cards_.place());
      if (with_thickness) builder_.set_thickness(block, read_thickness(id, corners));
    }
  }

  /// The third node, which says how the section is turned, is not read.
  void read_beams() {
    while (cards_.next_line()) {
      if (strip_blanks(cards_.line()).empty()) continue;
      cards_.cut(element_widths);
      const std::int64_t id = cards_.integer(0), part = cards_.integer(1);
      const std::array<std::int64_t, 2> nodes{cards_.integer(2), cards_.integer(3)};
      if (cards_.integer(4) != 0) unread_.insert("ELEMENT_BEAM (third node)");
      const TextKind kind{"ELEMENT_BEAM", TopologyKind::line2, 2, IdSpace::beams};
      builder_.add_element(builder_.find_block(name_part(part), part, kind), id, nodes, cards_.place());
    }
  }

  void read_other_elements(const std::string& keyword) {
    while (cards_.next_line()) {
      if (strip_blanks(cards_.line()).empty()) continue;
      cards_.cut(element_widths);
      const auto id = parse_integer(cards_.field(0)), part = parse_integer(cards_.field(1));
      if (id && part) add_other(keyword, "", *id, *part, cards_.place());
    }
  }

  /// A title and a card for each part; the title names its block.
  void read_parts() {
    while (cards_.next_line()) {
      const std::string title(strip_blanks(cards_.line()));
      if (!cards_.next_line()) return;
      cards_.cut(card_widths);
      const std::int64_t part = cards_.integer(0);
      std::string name;
      for (const char c : title) name += c == '/' ? '_' : c == '\t' ? ' ' : c;
      if (!name.empty() && part != 0) titles_[part] = name;
    }
  }

  void read_includes() {
    std::vector<std::string> names;
    bool continues = false;
    while (cards_.next_line()) {
      std::string name(strip_blanks(cards_.line()));
      if (name.empty()) continue;
      if (continues) name.insert(0, names.back());
      if (continues) names.pop_back();
      continues = name.ends_with(" +");
      if (continues) name.resize(name.size() - 2);
      names.push_back(name);
    }
    if (names.empty()) cards_.refuse("*INCLUDE names no file");
    cards_.include(names);
  }

  // --- sets

  void read_set(std::string keyword) {
    const bool has_title = take_suffix(keyword, "_TITLE");
    const bool is_generated = take_suffix(keyword, "_GENERATE");
    const bool is_collected = take_suffix(keyword, "_COLLECT");
    take_suffix(keyword, "_LIST");
    if (keyword != "SET_NODE" && keyword != "SET_PART" && keyword != "SET_SHELL" && keyword != "SET_SOLID" &&
        keyword != "SET_SEGMENT") {
      unread_.insert(cards_.keyword());
      return;
    }
    if (is_collected) cards_.refuse(fmt::format("*{} is not read: write its members in one list", cards_.keyword()));
    std::string title;
    if (has_title && cards_.next_line()) title = strip_blanks(cards_.line());
    if (!cards_.next_line()) return;
    cards_.cut(card_widths);
    const std::int64_t id = cards_.integer(0);
    for (char& c : title) c = c == '/' ? '_' : c;
    const char* const word = keyword == "SET_NODE"      ? "nodes"
                             : keyword == "SET_SEGMENT" ? "sides"
                             : keyword == "SET_PART"    ? "parts"
                                                        : "elements";
    const std::string name = title.empty() ? fmt::format("{}_{}", word, id) : title;
    builder_.number_set(name, id);
    if (keyword == "SET_SEGMENT") return read_segments(name);
    std::vector<std::int64_t> members;
    while (cards_.next_line()) {
      cards_.cut(card_widths);
      for (std::size_t i = 0; i < card_widths.size(); ++i) {
        const std::int64_t member = cards_.integer(i);
        if (member == 0) continue;
        is_generated ? members.push_back(member) : add_member(keyword, name, member);
      }
    }
    if (members.size() % 2 != 0) cards_.refuse(fmt::format("*{} has a beginning without an end", cards_.keyword()));
    for (std::size_t i = 0; i < members.size(); i += 2) add_members(keyword, name, members[i], members[i + 1]);
  }

  static IdSpace find_space(const std::string& keyword) {
    return keyword == "SET_SHELL" ? IdSpace::shells : IdSpace::elements;
  }

  void add_member(const std::string& keyword, const std::string& set, std::int64_t member) {
    if (keyword == "SET_NODE") return builder_.add_set_node(set, member, cards_.place());
    if (keyword == "SET_PART") return builder_.add_set_block(set, member, cards_.place());
    builder_.add_set_element(set, {member, find_space(keyword)}, cards_.place());
  }

  void add_members(const std::string& keyword, const std::string& set, std::int64_t first, std::int64_t last) {
    if (keyword == "SET_NODE") return builder_.add_set_nodes(set, first, last, 1);
    if (keyword == "SET_PART") cards_.refuse("*SET_PART_LIST_GENERATE is not read (list the parts)");
    builder_.add_set_elements(set, {first, find_space(keyword)}, last, 1);
  }

  void read_segments(const std::string& set) {
    while (cards_.next_line()) {
      if (strip_blanks(cards_.line()).empty()) continue;
      cards_.cut(card_widths);
      std::array<std::int64_t, 4> nodes{};
      for (std::size_t i = 0; i < 4; ++i) nodes[i] = cards_.integer(i);
      const std::size_t count = nodes[3] == 0 || nodes[3] == nodes[2] ? 3 : 4;
      builder_.add_set_face(set, std::span(nodes.data(), count), cards_.place());
    }
  }

  TextBuilder builder_;
  KeywordCards cards_;
  std::map<std::int64_t, std::string> titles_;  // of parts
  std::map<std::pair<std::string, std::int64_t>, std::string> other_kinds_;
  std::set<std::string> unread_;
};

}  // namespace

bool is_keyword_file(std::string_view first_bytes) { return begins_with_word(first_bytes, "*KEYWORD", "$"); }

std::unique_ptr<MeshFile> open_keyword_file(const std::string& path) { return KeywordReader(path).read(); }

}  // namespace percuss
