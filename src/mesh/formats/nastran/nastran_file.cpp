#include "src/mesh/formats/nastran/nastran_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "src/mesh/files/text_builder.hpp"
#include "src/mesh/files/text_numbers.hpp"
#include "src/mesh/files/unread_words.hpp"
#include "src/mesh/formats/nastran/nastran_cards.hpp"
#include "src/mesh/formats/nastran/nastran_names.hpp"
#include "src/mesh/formats/nastran/nastran_sets.hpp"
#include "src/mesh/formats/nastran/nastran_systems.hpp"

namespace percuss {
namespace {

constexpr std::array property_names{"PSOLID", "PLSOLID", "PSHELL", "PCOMP", "PCOMPG", "PBAR",
                                    "PBARL",  "PBEAM",   "PBEAML", "PROD",  "PTUBE",  "PSHEAR"};

/// Elements with nodes that cannot be run; all other unknown entries are no part of the mesh.
constexpr std::array other_elements{"CQUAD8", "CTRIA6", "CQUAD",   "CTRIA",  "CSHEAR",  "CONROD", "CBEND",  "CBEAM3",
                                    "CQUADX", "CTRIAX", "CQUADX4", "CTRAX3", "CQUADX8", "CTRAX6", "CTRIAX6"};

/// Cards that would change the mesh that is read.
constexpr std::array refused{"GRIDA", "GRIDB", "GRIDF", "GRIDG", "EGRID", "SEBULK", "CGEN"};

template <std::size_t N>
bool is_among(const std::string& name, const std::array<const char*, N>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::optional<TopologyKind> find_kind_of_entry(const std::string& name) {
  for (std::size_t kind = 0; kind < topology_count; ++kind) {
    const auto& names = topologies[kind].nastran_names;
    if (!name.empty() && std::find(names.begin(), names.end(), name) != names.end())
      return static_cast<TopologyKind>(kind);
  }
  return {};
}

std::string list_nastran_kinds() {
  std::string list;
  for (const Topology& topology : topologies) {
    for (const std::string_view name : topology.nastran_names)
      if (!name.empty()) list += (list.empty() ? "" : ", ") + std::string(name);
  }
  return list + " with nodes at their corners alone, CTETRA with ten nodes";
}

class NastranReader {
 public:
  explicit NastranReader(const std::string& path) : cards_(path, builder_.names) {}

  std::unique_ptr<MeshFile> read() {
    for (const auto& [line, place] : cards_.control())
      if (strip_blanks(line).starts_with('$')) named_.take_comment(strip_blanks(line));
    sets_.read_control(cards_.control());
    while (cards_.next()) {
      for (const std::string& comment : cards_.comments()) named_.take_comment(comment);
      named_.take_entry(is_among(cards_.name(), property_names) ? parse_integer(cards_.field(0)).value_or(0) : 0);
      read_card(cards_.name());
    }
    for (const std::string& comment : cards_.comments()) named_.take_comment(comment);
    add_grids();
    set_thicknesses();
    for (const auto& [id, name] : named_.list_properties()) builder_.rename_blocks(id, name);
    give_sets();
    if (!unread_.empty()) builder_.add_note(describe_unread(unread_, ""));
    return std::make_unique<TextMesh>(builder_.finish(list_nastran_kinds()));
  }

 private:
  struct Grid {
    std::int64_t id = 0;
    std::optional<std::int64_t> system;  // none: that of GRDSET
    Vec3 x{};
    TextPlace place;
  };
  /// A shell with thicknesses at its corners.
  struct CornerThicknesses {
    int block = 0;
    std::size_t element = 0, corners = 0;  // element: in its block
    std::int64_t property = 0;
    std::array<double, 4> given{};  // 0: that of the property
    bool is_relative = false;       // to that of the property
    TextPlace place;
  };
  /// The last one that was requested, and how many elements blocks have.
  struct LastBlock {
    std::int64_t property = 0;
    std::string kind;
    int block = -1;
  };

  void read_card(const std::string& name) {
    if (name == "GRID") {
      cards_.check_lines();
      return read_grid();
    }
    if (const auto kind = find_kind_of_entry(name)) {
      cards_.check_lines();
      return read_element(*kind);
    }
    read_other_card(name);
  }

  void read_other_card(const std::string& name) {
    const bool is_read = name.starts_with("CORD") || name.starts_with("SET") || name == "PSHELL" || name == "GRDSET";
    if (is_read) cards_.check_lines();
    if (name.starts_with("CORD")) return systems_.add(cards_);
    if (name == "PSHELL") return read_shell_property();
    if (name == "GRDSET") return read_grid_defaults();
    if (name == "SET" || name == "SET1" || name == "SET3") return read_set();
    if (is_among(name, refused)) cards_.refuse(fmt::format("{} is not read (it changes the mesh)", name));
    if ((name == "BAROR" || name == "BEAMOR") && !cards_.is_blank(1))
      cards_.refuse(fmt::format("{} with a property is not read: give each bar its own", name));
    if (is_among(name, other_elements)) return add_other(name, cards_.place());
    if (name.starts_with('C') || name.starts_with("RBE") || name == "PLOTEL") {
      if (const auto id = parse_integer(cards_.field(0))) ids_.others.push_back(*id);
    }
    if (name != "PSOLID") unread_.insert(name);
  }

  void read_set() {
    const std::string left = sets_.read_card(cards_);
    if (!left.empty()) unread_.insert(left);
  }

  /// A constraint, a superelement or another system for displacements do not move the point.
  void read_grid() {
    Grid& grid = grids_.emplace_back();
    grid.id = cards_.integer(0);
    if (!cards_.is_blank(1)) grid.system = cards_.integer(1);
    grid.x = {cards_.real(2), cards_.real(3), cards_.real(4)};
    grid.place = cards_.place();
    if (cards_.integer(5) != 0) unread_.insert("GRID (CD)");
    if (cards_.integer(6) != 0) unread_.insert("GRID (PS)");
    if (cards_.integer(7) != 0) cards_.refuse("a grid point is of a superelement (these are not read)");
  }

  void read_grid_defaults() {
    default_system_ = cards_.integer(1);
    if (cards_.integer(6) != 0) unread_.insert("GRDSET (PS)");
  }

  void add_grids() {
    for (const Grid& grid : grids_) {
      builder_.add_node(grid.id, systems_.find_place(grid.system.value_or(default_system_), grid.x, grid.place),
                        grid.place);
      ids_.nodes.push_back(grid.id);
    }
    grids_ = {};
  }

  /// The element's own id where it names none.
  std::int64_t find_property() const { return cards_.is_blank(1) ? cards_.integer(0) : cards_.integer(1); }

  int find_block(std::int64_t property, const TextKind& kind) {
    if (last_.block < 0 || last_.property != property || last_.kind != kind.name) {
      last_ = {property, kind.name, builder_.find_block(fmt::format("block_{}", property), property, kind)};
      ids_.properties.push_back(property);
    }
    return last_.block;
  }

  /// Ids of nodes up to the last field that is not blank; 0 where one is blank.
  std::vector<std::int64_t> read_nodes() const {
    std::vector<std::int64_t> nodes;
    for (std::size_t i = 2; i < cards_.field_count(); ++i) nodes.push_back(cards_.integer(i));
    while (!nodes.empty() && nodes.back() == 0) nodes.pop_back();
    return nodes;
  }

  void read_element(TopologyKind kind) {
    const Topology& topology = find_topology(kind);
    if (!topology.is_solid()) return read_line_or_shell(kind);
    const std::vector<std::int64_t> nodes = read_nodes();
    const auto corners = static_cast<std::size_t>(topology.corner_count);
    const auto blanks = static_cast<std::size_t>(std::count(nodes.begin(), nodes.end(), 0));
    if (nodes.size() < corners || std::count(nodes.begin(), nodes.begin() + topology.corner_count, 0) > 0)
      cards_.refuse(fmt::format("{} {} has {} nodes at its {} corners", cards_.name(), cards_.integer(0),
                                std::min(nodes.size(), corners) - std::min(blanks, std::min(nodes.size(), corners)),
                                corners));
    const bool is_tet10 = kind == TopologyKind::tet4 && nodes.size() == tet10_nodes && blanks == 0;
    if (nodes.size() > corners && !is_tet10)
      return add_other(fmt::format("{} of {} nodes", cards_.name(), nodes.size() - blanks), cards_.place());
    const TextKind made{is_tet10 ? cards_.name() + " of 10 nodes" : cards_.name(), kind,
                        static_cast<std::int64_t>(nodes.size()), IdSpace::elements};
    add_element(made, nodes);
  }

  int add_element(const TextKind& kind, std::span<const std::int64_t> nodes) {
    const int block = find_block(find_property(), kind);
    if (counts_.size() <= static_cast<std::size_t>(block)) counts_.resize(static_cast<std::size_t>(block) + 1, 0);
    ++counts_[static_cast<std::size_t>(block)];
    builder_.add_element(block, cards_.integer(0), nodes, cards_.place());
    ids_.elements.push_back(cards_.integer(0));
    return block;
  }

  void read_line_or_shell(TopologyKind kind) {
    const Topology& topology = find_topology(kind);
    const auto corners = static_cast<std::size_t>(topology.corner_count);
    std::array<std::int64_t, 4> nodes{};
    for (std::size_t i = 0; i < corners; ++i) nodes[i] = cards_.integer(2 + i);
    if (std::count(nodes.begin(), nodes.begin() + topology.corner_count, 0) > 0)
      cards_.refuse(fmt::format("{} {} has a blank among its {} nodes", cards_.name(), cards_.integer(0), corners));
    const TextKind made{cards_.name(), kind, topology.corner_count, IdSpace::elements};
    const int block = add_element(made, std::span(nodes.data(), corners));
    topology.is_surface() ? read_shell_fields(block, corners) : note_bar_fields();
  }

  /// Thicknesses of the corners, on the second line: of both kinds of shells in the same fields.
  void read_shell_fields(int block, std::size_t corners) {
    constexpr std::size_t flag = 9, first = 10;
    if (cards_.real(corners + 3) != 0)
      unread_.insert(cards_.name() + " (ZOFFS, which `reference` of the part may stand for)");
    CornerThicknesses of{block,
                         counts_[static_cast<std::size_t>(block)] - 1,
                         corners,
                         find_property(),
                         {},
                         cards_.integer(flag) == 1,
                         cards_.place()};
    for (std::size_t i = 0; i < corners; ++i) of.given[i] = cards_.real(first + i);
    if (*std::min_element(of.given.begin(), of.given.end()) < 0) cards_.refuse("a thickness is negative");
    if (std::count(of.given.begin(), of.given.end(), 0.0) < 4) corner_thicknesses_.push_back(of);
  }

  void note_bar_fields() {
    if (cards_.name() != "CBAR" && cards_.name() != "CBEAM") return;
    for (std::size_t i = 4; i < 7; ++i)
      if (!cards_.is_blank(i)) unread_.insert(cards_.name() + " (orientation)");
    for (std::size_t i = 8; i < 10; ++i)
      if (!cards_.is_blank(i)) unread_.insert(cards_.name() + " (pin flags)");
    for (std::size_t i = 10; i < 16; ++i)
      if (cards_.real(i) != 0) unread_.insert(cards_.name() + " (offsets)");
  }

  /// Elements that cannot be run, by the line of their first.
  void add_other(const std::string& name, TextPlace place) {
    const std::int64_t id = cards_.integer(0), property = name == "CONROD" ? 0 : find_property();
    const auto [kind, is_new] = other_kinds_.emplace(std::pair(name, property), std::string());
    if (is_new) {
      const std::string at = builder_.names.at(place);
      kind->second = fmt::format("{} (first {})", name, at.substr(0, at.size() - 2));
    }
    builder_.add_element(find_block(property, {kind->second, {}, 0, IdSpace::elements}), id, {}, place);
    ids_.elements.push_back(id);
  }

  void read_shell_property() {
    const double thickness = cards_.real(2);
    if (thickness < 0) cards_.refuse(fmt::format("the thickness is {} (it must not be negative)", thickness));
    if (!thicknesses_.emplace(cards_.integer(0), thickness).second)
      cards_.refuse(fmt::format("PSHELL {} is defined twice", cards_.integer(0)));
  }

  /// The mean of the corners; where one has none, it has that of the property.
  void set_thicknesses() {
    for (const CornerThicknesses& of : corner_thicknesses_) {
      const auto property = thicknesses_.find(of.property);
      const double usual = property == thicknesses_.end() ? 0 : property->second;
      if (of.is_relative && usual == 0)
        builder_.names.refuse(of.place,
                              fmt::format("TFLAG is 1, but there is no PSHELL {} with a thickness", of.property));
      std::array<double, 4> at_corners{};
      std::size_t count = 0;
      for (std::size_t i = 0; i < of.corners; ++i) {
        const double thickness = of.given[i] == 0 ? usual : of.is_relative ? of.given[i] * usual : of.given[i];
        if (thickness != 0) at_corners[count++] = thickness;
      }
      const std::span given(at_corners.data(), count);
      const bool are_equal = std::count(given.begin(), given.end(), given[0]) == static_cast<std::ptrdiff_t>(count);
      const double sum = std::accumulate(given.begin(), given.end(), 0.0);
      builder_.set_thickness(of.block, of.element, are_equal ? given[0] : sum / static_cast<double>(count));
    }
    for (const auto& [id, thickness] : thicknesses_)
      if (thickness > 0) builder_.fill_thickness(id, thickness);
  }

  void give_sets() {
    for (auto* ids : {&ids_.nodes, &ids_.elements, &ids_.properties, &ids_.others}) {
      std::sort(ids->begin(), ids->end());
      ids->erase(std::unique(ids->begin(), ids->end()), ids->end());
    }
    sets_.give(ids_, named_, builder_, unread_);
  }

  TextBuilder builder_;
  NastranCards cards_;
  NastranNames named_;
  NastranSystems systems_{builder_.names};
  NastranSets sets_{builder_.names};
  NastranIds ids_;
  std::vector<Grid> grids_;
  std::int64_t default_system_ = 0;
  LastBlock last_;
  std::vector<std::size_t> counts_;             // [blocks] elements
  std::map<std::int64_t, double> thicknesses_;  // of PSHELL by id; 0: none
  std::vector<CornerThicknesses> corner_thicknesses_;
  std::map<std::pair<std::string, std::int64_t>, std::string> other_kinds_;
  std::set<std::string> unread_;
};

}  // namespace

bool is_nastran_file(std::string_view first_bytes) {
  for (const char* word : {"BEGIN BULK", "SOL ", "CEND", "NASTRAN ", "INIT ", "GRID", "CORD2"})
    if (begins_with_word(first_bytes, word, "$")) return true;
  return false;
}

std::unique_ptr<MeshFile> open_nastran_file(const std::string& path) { return NastranReader(path).read(); }

}  // namespace percuss
