#include "src/mesh/formats/abaqus_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "src/mesh/files/text_builder.hpp"
#include "src/mesh/files/text_numbers.hpp"
#include "src/mesh/files/unread_words.hpp"
#include "src/mesh/formats/abaqus_lines.hpp"

namespace percuss {
namespace {

/// Faces of the hexahedron by their numbers: 1-2-3-4, 5-8-7-6, 1-5-6-2, 2-6-7-3, 3-7-8-4, 4-8-5-1.
constexpr std::array<int, 6> faces_of_hexahedra = {4, 5, 0, 1, 2, 3};
constexpr std::array<int, 6> faces_of_tetrahedra = {3, 0, 1, 2, TextSide::missing, TextSide::missing};
/// 1-2-3, 4-6-5, 1-4-5-2, 2-5-6-3, 3-6-4-1; and 1-2-3-4, 1-5-2, 2-5-3, 3-5-4, 4-5-1.
constexpr std::array<int, 6> faces_of_wedges = {3, 4, 0, 1, 2, TextSide::missing};
constexpr std::array<int, 6> faces_of_pyramids = {4, 0, 1, 2, 3, TextSide::missing};

std::optional<TextSide> find_side(const std::string& name) {
  if (name == "SPOS") return TextSide{TextSide::missing, top_face};
  if (name == "SNEG") return TextSide{TextSide::missing, bottom_face};
  if (name.size() != 2 || name[0] != 'S' || name[1] < '1' || name[1] > '6') return {};
  const auto number = static_cast<std::size_t>(name[1] - '1');
  return TextSide{faces_of_hexahedra[number],
                  number == 0   ? bottom_face
                  : number == 1 ? top_face
                                : TextSide::missing,
                  faces_of_tetrahedra[number], faces_of_wedges[number], faces_of_pyramids[number]};
}

/// Whether elements of a type are cut into eight.
bool is_tet10(const std::string& type) { return type == "C3D10" || type == "C3D10M"; }

std::optional<TopologyKind> find_kind(const std::string& type) {
  for (std::size_t kind = 0; kind < topology_count; ++kind) {
    const auto& names = topologies[kind].abaqus_names;
    if (std::find(names.begin(), names.end(), type) != names.end()) return static_cast<TopologyKind>(kind);
  }
  return is_tet10(type) ? std::optional(TopologyKind::tet4) : std::nullopt;
}

std::string list_abaqus_kinds() {
  std::string list;
  for (const Topology& topology : topologies) {
    for (const std::string_view name : topology.abaqus_names)
      if (!name.empty()) list += (list.empty() ? "" : ", ") + std::string(name);
  }
  return list + ", C3D10, C3D10M";
}

class AbaqusReader {
 public:
  explicit AbaqusReader(const std::string& path) : lines_(path, builder_.names) {}

  std::unique_ptr<MeshFile> read() {
    while (lines_.next_keyword()) read_keyword(lines_.keyword());
    if (!unread_.empty()) builder_.add_note(describe_unread(unread_, "*"));
    return std::make_unique<TextMesh>(builder_.finish(list_abaqus_kinds()));
  }

 private:
  void read_keyword(const std::string& keyword) {
    if (keyword == "NODE") return read_nodes();
    if (keyword == "ELEMENT") return read_elements();
    if (keyword == "NSET") return read_set(true);
    if (keyword == "ELSET") return read_set(false);
    if (keyword == "SURFACE") return read_surface();
    if (keyword == "INSTANCE") return read_instance();
    if (keyword == "NODAL THICKNESS") return read_nodal_thickness();
    if (keyword == "SHELL SECTION") read_shell_section();
    for (const char* word : {"INCLUDE", "SYSTEM", "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "PARAMETER",
                             "MODEL CHANGE", "IMPORT"}) {
      if (keyword == word) lines_.refuse(fmt::format("*{} is not read (it changes the mesh)", keyword));
    }
    if (keyword == "PART" && ++parts_ > 1)
      lines_.refuse("the file has several parts (one part with one instance is read): export the mesh as a flat one");
    for (const char* word : {"HEADING", "PART", "END PART", "ASSEMBLY", "END ASSEMBLY", "END INSTANCE", "PREPRINT"})
      if (keyword == word) return;
    unread_.insert(keyword);
  }

  /// One with its part where the part stands.
  void read_instance() {
    if (++instances_ > 1)
      lines_.refuse(
          "the file has several instances (one part with one instance is read): export the mesh as a flat one");
    while (lines_.next_data()) lines_.refuse("the instance is moved: move the part with `at` of the deck");
  }

  /// Names do not tell capitals from small letters, nor where a set is that one instance has.
  std::string find_name(std::string_view name) {
    std::string text(name.substr(name.find('.') == std::string_view::npos ? 0 : name.find('.') + 1));
    for (char& c : text) c = c == '/' ? '_' : c;
    return names_.emplace(to_upper(text), text).first->second;
  }

  void refuse_file() const {
    if (lines_.has_parameter("INPUT")) lines_.refuse(fmt::format("*{} with INPUT is not read", lines_.keyword()));
  }

  void read_nodes() {
    refuse_file();
    const std::string system = to_upper(lines_.parameter("SYSTEM"));
    if (!system.empty() && system != "R") lines_.refuse("*NODE with SYSTEM is not read: give global coordinates");
    const std::string set = lines_.parameter("NSET");
    while (lines_.next_data()) {
      const std::int64_t id = lines_.integer(0);
      builder_.add_node(id, {lines_.real(1), lines_.real(2), lines_.real(3)}, lines_.place());
      if (!set.empty()) builder_.add_set_node(find_name(set), id, lines_.place());
    }
  }

  void read_elements() {
    refuse_file();
    const std::string type = to_upper(lines_.parameter("TYPE"));
    if (type.empty()) lines_.refuse("*ELEMENT has no TYPE");
    TextKind kind{type, find_kind(type), 0, IdSpace::elements};
    if (kind.topology)
      kind.nodes = is_tet10(type) ? std::int64_t{tet10_nodes} : find_topology(*kind.topology).corner_count;
    if (!kind.topology) kind.name += fmt::format(" (line {})", lines_.place().line);
    const std::string set = lines_.parameter("ELSET");
    const std::string name = set.empty() ? fmt::format("block_{}", blocks_ + 1) : find_name(set);
    const int block = builder_.find_block(name, ++blocks_, kind);
    std::vector<std::int64_t> items;
    while (lines_.next_data()) {
      const TextPlace place = lines_.place();
      items.clear();
      while (true) {
        for (std::size_t i = 0; i < lines_.field_count(); ++i) items.push_back(lines_.integer(i));
        const bool is_whole =
            kind.topology ? items.size() > static_cast<std::size_t>(kind.nodes) : !lines_.ends_with_comma();
        if (is_whole || !lines_.next_data()) break;
      }
      if (kind.topology && items.size() != static_cast<std::size_t>(kind.nodes) + 1)
        builder_.names.refuse(
            place, fmt::format("element {} has {} nodes (a {} has {})", items[0], items.size() - 1, type, kind.nodes));
      const std::span nodes(items.data() + 1, kind.topology ? items.size() - 1 : 0);
      builder_.add_element(block, items[0], nodes, place);
    }
  }

  /// A node or a node set, and a thickness, which may stand below *SHELL SECTION or above it.
  void read_nodal_thickness() {
    if (lines_.has_parameter("GENERATE")) lines_.refuse("*NODAL THICKNESS with GENERATE is not read (list the nodes)");
    while (lines_.next_data()) {
      const auto id = parse_integer(lines_.field(0));
      const double thickness = lines_.real(1);
      id ? builder_.add_node_thickness(*id, thickness, lines_.place())
         : builder_.add_node_thickness_of(find_name(lines_.field(0)), thickness, lines_.place());
    }
  }

  /// Only whether thicknesses are those of nodes.
  void read_shell_section() {
    if (lines_.has_parameter("NODAL THICKNESS"))
      builder_.average_thickness_of(find_name(lines_.parameter("ELSET")), lines_.place());
  }

  void read_set(bool of_nodes) {
    const std::string given = lines_.parameter(of_nodes ? "NSET" : "ELSET");
    if (given.empty()) lines_.refuse(fmt::format("*{} has no name", lines_.keyword()));
    const std::string name = find_name(given);
    const bool is_generated = lines_.has_parameter("GENERATE");
    if (lines_.has_parameter("ELSET") && of_nodes) lines_.refuse("*NSET of an ELSET is not read (list its nodes)");
    while (lines_.next_data()) {
      if (is_generated) {
        const std::int64_t first = lines_.integer(0), last = lines_.field_count() > 1 ? lines_.integer(1) : first;
        const std::int64_t step = lines_.field_count() > 2 ? lines_.integer(2) : 1;
        if (step < 1) lines_.refuse(fmt::format("the step is {} (it must be positive)", step));
        of_nodes ? builder_.add_set_nodes(name, first, last, step)
                 : builder_.add_set_elements(name, {first, IdSpace::elements}, last, step);
        continue;
      }
      for (std::size_t i = 0; i < lines_.field_count(); ++i) {
        const std::string_view field = lines_.field(i);
        const auto id =
            parse_integer(field.substr(field.find('.') == std::string_view::npos ? 0 : field.find('.') + 1));
        if (id)
          of_nodes ? builder_.add_set_node(name, *id, lines_.place())
                   : builder_.add_set_element(name, {*id, IdSpace::elements}, lines_.place());
        else
          of_nodes ? builder_.add_set_nodes_of(name, find_name(field), lines_.place())
                   : builder_.add_set_elements_of(name, find_name(field), lines_.place());
      }
    }
  }

  void read_surface() {
    const std::string given = lines_.parameter("NAME"), type = to_upper(lines_.parameter("TYPE"));
    if (given.empty()) lines_.refuse("*SURFACE has no NAME");
    if (!type.empty() && type != "ELEMENT" && type != "NODE") {
      unread_.insert("SURFACE, TYPE=" + type);
      return;
    }
    const std::string name = find_name(given);
    while (lines_.next_data()) {
      const auto id = parse_integer(lines_.field(0));
      const std::string set = id ? "" : find_name(lines_.field(0));
      if (type == "NODE") {
        id ? builder_.add_set_node(name, *id, lines_.place()) : builder_.add_set_nodes_of(name, set, lines_.place());
        continue;
      }
      for (const TextSide& side : list_sides(to_upper(lines_.field(1)))) {
        id ? builder_.add_set_side(name, {*id, IdSpace::elements}, side, lines_.place())
           : builder_.add_set_sides_of(name, set, side, lines_.place());
      }
    }
  }

  /// Sides of a surface; without a name all faces, of which selections keep the free ones.
  std::vector<TextSide> list_sides(const std::string& name) const {
    std::vector<TextSide> sides;
    if (!name.empty()) {
      const auto side = find_side(name);
      if (!side)
        lines_.refuse(fmt::format("there is no side {} (S1 to S6, SPOS and SNEG are known)", quote_field(name)));
      return {*side};
    }
    sides.reserve(6);
    for (int face = 0; face < 6; ++face)
      sides.push_back({face, face < 2 ? face : TextSide::left_out, face < 4 ? face : TextSide::left_out});
    return sides;
  }

  TextBuilder builder_;
  AbaqusLines lines_;
  std::map<std::string, std::string> names_;  // as they stand first, by the same in capitals
  std::set<std::string> unread_;
  std::int64_t blocks_ = 0;
  int parts_ = 0, instances_ = 0;
};

}  // namespace

bool is_abaqus_file(std::string_view first_bytes) { return begins_with_word(first_bytes, "*HEADING", "**"); }

std::unique_ptr<MeshFile> open_abaqus_file(const std::string& path) { return AbaqusReader(path).read(); }

}  // namespace percuss
