#include "src/mesh/formats/gmsh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "src/mesh/files/text_builder.hpp"
#include "src/mesh/formats/gmsh_scanner.hpp"

namespace percuss {
namespace {

/// A kind of element by its number in the format.
struct GmshType {
  const char* name;
  int dimension, nodes;
  std::optional<TopologyKind> topology;
};

const GmshType* find_type(std::int64_t number) {
  static const std::map<std::int64_t, GmshType> types = {
      {1, {"2-node line", 1, 2, {}}},
      {2, {"3-node triangle", 2, 3, TopologyKind::tri3}},
      {3, {"4-node quadrangle", 2, 4, TopologyKind::quad4}},
      {4, {"4-node tetrahedron", 3, 4, TopologyKind::tet4}},
      {5, {"8-node hexahedron", 3, 8, TopologyKind::hex8}},
      {6, {"6-node prism", 3, 6, TopologyKind::wedge6}},
      {7, {"5-node pyramid", 3, 5, TopologyKind::pyramid5}},
      {8, {"3-node line", 1, 3, {}}},
      {9, {"6-node triangle", 2, 6, {}}},
      {10, {"9-node quadrangle", 2, 9, {}}},
      {11, {"10-node tetrahedron", 3, 10, TopologyKind::tet4}},
      {12, {"27-node hexahedron", 3, 27, {}}},
      {13, {"18-node prism", 3, 18, {}}},
      {14, {"14-node pyramid", 3, 14, {}}},
      {15, {"point", 0, 1, {}}},
      {16, {"8-node quadrangle", 2, 8, {}}},
      {17, {"20-node hexahedron", 3, 20, {}}},
      {18, {"15-node prism", 3, 15, {}}},
      {19, {"13-node pyramid", 3, 13, {}}},
  };
  const auto found = types.find(number);
  return found == types.end() ? nullptr : &found->second;
}

/// Kinds of elements that can be run.
std::string list_gmsh_kinds() {
  return "3-node triangles, 4-node quadrangles, 4-node and 10-node tetrahedra, 5-node pyramids, 6-node prisms and "
         "8-node hexahedra";
}

/// Names of groups by dimension, where they have none.
constexpr std::array<const char*, 4> group_words = {"points", "curve", "sides", "block"};

/// An entity or a group of entities.
using DimTag = std::pair<std::int64_t, std::int64_t>;

class GmshReader {
 public:
  explicit GmshReader(const std::string& path) : source_(path, builder_.names), scan_(source_.text(), builder_.names) {}

  std::unique_ptr<MeshFile> read() {
    while (true) {
      const std::string section(scan_.next_word());
      if (section.empty()) break;
      read_section(section);
    }
    if (version_ == 0) scan_.refuse("the file has no $MeshFormat");
    return std::make_unique<TextMesh>(builder_.finish(list_gmsh_kinds()));
  }

 private:
  void read_section(const std::string& section) {
    if (!section.starts_with('$')) scan_.refuse(fmt::format("{} begins no section", quote_field(section)));
    if (version_ == 0 && section != "$MeshFormat" && section != "$Comments")
      scan_.refuse("the file does not begin with $MeshFormat");
    if (section == "$MeshFormat")
      read_format();
    else if (section == "$PhysicalNames")
      read_names();
    else if (section == "$Entities" && version_ == 4)
      read_entities();
    else if (section == "$Nodes")
      version_ == 4 ? read_nodes_4() : read_nodes_2();
    else if (section == "$Elements")
      version_ == 4 ? read_elements_4() : read_elements_2();
    else if (section == "$PartitionedEntities" || section == "$ParametricNodes")
      scan_.refuse(fmt::format("{} is not read (save the mesh whole, without partitions)", section));
    else
      return skip(section);
    const std::string end(scan_.next_word());
    if (end != "$End" + section.substr(1))
      scan_.refuse(fmt::format("{} stands where $End{} is expected", quote_field(end), section.substr(1)));
  }

  void skip(const std::string& section) {
    const std::string end = "$End" + section.substr(1);
    while (scan_.bytes_left() > 0) {
      if (scan_.next_line() == end) return;
    }
    scan_.refuse(fmt::format("the file ends within {}", section));
  }

  void read_format() {
    const std::string version(scan_.next_word());
    const bool is_2 = version == "2" || version == "2.0" || version == "2.1" || version == "2.2";
    if (!is_2 && version != "4.1")
      scan_.refuse(
          fmt::format("the version is {} (2 to 2.2 and 4.1 are read): save it as one of these", quote_field(version)));
    if (version_ != 0) scan_.refuse("$MeshFormat comes again");
    const std::int64_t type = scan_.next_integer<int>("the file type"), size = scan_.next_integer<int>("the data size");
    if ((type != 0 && type != 1) || size != 8)
      scan_.refuse(fmt::format("the format is {} {} (0 8 or 1 8 is expected)", type, size));
    version_ = version == "4.1" ? 4 : 2;
    names_have_dimensions_ = version != "2" && version != "2.0";
    if (type == 0) return;
    scan_.next_line();
    scan_.is_binary = true;
    if (scan_.next_integer<int>("the mark of the byte order") != 1)
      scan_.refuse("the byte order is that of another type of machine");
  }

  void read_names() {
    const bool was_binary = std::exchange(scan_.is_binary, false);  // this section is always text
    const std::int64_t count = scan_.next_count<int>("the number of names", 5);
    for (std::int64_t i = 0; i < count; ++i) read_name();
    scan_.is_binary = was_binary;
  }

  /// Reads a name. In version 2.0 it has no dimension, and counts for groups of any. Some programs give it one all the
  /// same.
  void read_name() {
    const std::int64_t first = scan_.next_integer<int>(names_have_dimensions_ ? "a dimension" : "a group");
    const TextPlace place = scan_.place();
    const std::string_view line = scan_.next_line();
    const std::size_t open = std::min(line.find('"'), line.size()), close = line.rfind('"');
    const std::string_view between = strip_blanks(line.substr(0, open));
    const std::optional<std::int64_t> second = parse_integer(between);
    const bool has_dimension = names_have_dimensions_ || !between.empty();
    if (close == std::string_view::npos || close == open || second.has_value() != has_dimension ||
        (has_dimension && (first < 0 || first > 3)))
      scan_.refuse_at(
          place, fmt::format("a name is not as: {} \"name\"", names_have_dimensions_ ? "dimension group" : "group"));
    std::string name;
    for (const char c : line.substr(open + 1, close - open - 1)) name += c >= ' ' || c < 0 ? c : ' ';
    if (name.empty()) return;
    for (int d = 0; d <= 3; ++d)
      if (!has_dimension || d == first) names_[{d, has_dimension ? *second : first}] = name;
  }

  void read_entities() {
    begin_binary();
    std::array<std::int64_t, 4> counts{};
    for (std::int64_t& count : counts) count = scan_.next_count<std::uint64_t>("a number of entities", 4);
    for (std::size_t dimension = 0; dimension < counts.size(); ++dimension) {
      for (std::int64_t i = 0; i < counts[dimension]; ++i) {
        const std::int64_t tag = scan_.next_integer<int>("an entity");
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) scan_.next_real("a bound of an entity");
        std::vector<std::int64_t>& groups = groups_[{static_cast<std::int64_t>(dimension), tag}];
        const std::int64_t group_count = scan_.next_count<std::uint64_t>("a number of groups", 2);
        for (std::int64_t g = 0; g < group_count; ++g) groups.push_back(scan_.next_integer<int>("a group"));
        if (dimension == 0) continue;
        const std::int64_t bounds = scan_.next_count<std::uint64_t>("a number of bounding entities", 2);
        for (std::int64_t b = 0; b < bounds; ++b) scan_.next_integer<int>("a bounding entity");
      }
    }
  }

  void read_nodes_2() {
    const bool was_binary = std::exchange(scan_.is_binary, false);
    const std::int64_t count = scan_.next_count<int>("the number of nodes", 7);
    scan_.is_binary = was_binary;
    begin_binary();
    for (std::int64_t n = 0; n < count; ++n) {
      const std::int64_t id = scan_.next_integer<int>("the id of a node");
      const TextPlace place = scan_.place();
      builder_.add_node(id, read_place(), place);
    }
  }

  Vec3 read_place() {
    Vec3 x{};
    for (double& coordinate : x) coordinate = scan_.next_real("a coordinate");
    return x;
  }

  void read_nodes_4() {
    begin_binary();
    const std::int64_t blocks = scan_.next_count<std::uint64_t>("the number of blocks of nodes", 6);
    for (int i = 0; i < 3; ++i) scan_.next_integer<std::uint64_t>("a count of nodes");
    std::vector<std::pair<std::int64_t, TextPlace>> ids;
    for (std::int64_t b = 0; b < blocks; ++b) {
      const std::int64_t dimension = scan_.next_integer<int>("a dimension");
      scan_.next_integer<int>("an entity");
      const std::int64_t parametric = scan_.next_integer<int>("the mark of parametric coordinates");
      const std::int64_t count = scan_.next_count<std::uint64_t>("the number of nodes of a block", 7);
      ids.clear();
      for (std::int64_t n = 0; n < count; ++n) {
        ids.emplace_back(scan_.next_integer<std::uint64_t>("the id of a node"), TextPlace{});
        ids.back().second = scan_.place();
      }
      for (const auto& [id, place] : ids) {
        builder_.add_node(id, read_place(), place);
        for (std::int64_t k = 0; parametric != 0 && k < dimension; ++k) scan_.next_real("a parametric coordinate");
      }
    }
  }

  const GmshType& read_type() {
    const std::int64_t number = scan_.next_integer<int>("the type of an element");
    const GmshType* type = find_type(number);
    if (type == nullptr)
      scan_.refuse(fmt::format("there are elements of type {} (only types 1 to 19 are known)", number));
    return *type;
  }

  void read_elements_2() {
    const bool was_binary = std::exchange(scan_.is_binary, false);
    const std::int64_t count = scan_.next_count<int>("the number of elements", 6);
    scan_.is_binary = was_binary;
    begin_binary();
    for (std::int64_t e = 0; e < count;) {
      std::int64_t id = scan_.is_binary ? 0 : scan_.next_integer<int>("the id of an element");
      const GmshType& type = read_type();
      const std::int64_t row = scan_.is_binary ? scan_.next_count<int>("the number of elements of a type", 4) : 1;
      const std::int64_t tags = scan_.next_count<int>("the number of tags", 1);
      for (std::int64_t i = 0; i < row; ++i) {
        if (scan_.is_binary) id = scan_.next_integer<int>("the id of an element");
        const TextPlace place = scan_.place();
        std::int64_t group = 0, entity = 0;
        for (std::int64_t t = 0; t < tags; ++t) {
          const std::int64_t tag = scan_.next_integer<int>("a tag");
          if (t == 0) group = tag;
          if (t == 1) entity = tag;
        }
        groups_of_element_.assign(1, group != 0 ? group : entity);
        add_element(type, id, place);
      }
      if (row <= 0) scan_.refuse("a row of elements is empty");
      e += row;
    }
  }

  void read_elements_4() {
    begin_binary();
    const std::int64_t blocks = scan_.next_count<std::uint64_t>("the number of blocks of elements", 6);
    for (int i = 0; i < 3; ++i) scan_.next_integer<std::uint64_t>("a count of elements");
    for (std::int64_t b = 0; b < blocks; ++b) {
      const std::int64_t dimension = scan_.next_integer<int>("a dimension"), tag = scan_.next_integer<int>("an entity");
      const GmshType& type = read_type();
      const auto groups = groups_.find({dimension, tag});
      groups_of_element_.assign(1, tag);
      if (groups != groups_.end() && !groups->second.empty()) groups_of_element_ = groups->second;
      const std::int64_t count = scan_.next_count<std::uint64_t>("the number of elements of a block", 4);
      for (std::int64_t e = 0; e < count; ++e) {
        const std::int64_t id = scan_.next_integer<std::uint64_t>("the id of an element");
        add_element(type, id, scan_.place());
      }
    }
  }

  std::string name_group(int dimension, std::int64_t group) const {
    const auto name = names_.find({dimension, group});
    if (name != names_.end()) return name->second;
    return fmt::format("{}_{}", group_words[static_cast<std::size_t>(dimension)], group);
  }

  /// Adds an element. Of the groups that it is in, the first is its block or its surface.
  void add_element(const GmshType& type, std::int64_t id, TextPlace place) {
    nodes_.clear();
    for (int i = 0; i < type.nodes; ++i) {
      nodes_.push_back(version_ == 4 ? scan_.next_integer<std::uint64_t>("a node of an element")
                                     : scan_.next_integer<int>("a node of an element"));
    }
    const std::int64_t group = groups_of_element_.front();
    const std::string name = name_group(type.dimension, group);
    const TextKind kind{type.name, type.topology, type.nodes, IdSpace::elements};
    if (type.dimension < 2) {
      for (const std::int64_t g : groups_of_element_) {
        const std::string set = name_group(type.dimension, g);
        builder_.number_set(set, g);
        for (const std::int64_t node : nodes_) builder_.add_set_node(set, node, place);
      }
      return;
    }
    const bool is_quadratic_face = type.dimension == 2 && type.nodes == 6;  // of tetrahedra: its corners say which
    if (type.dimension == 2 && (type.topology || is_quadratic_face)) {
      if (is_quadratic_face) nodes_.resize(3);
      builder_.name_surface(name, group);
      builder_.add_surface_element(name, kind, {id, IdSpace::elements}, nodes_, place);
      return;
    }
    if (!type.topology) nodes_.clear();
    if (nodes_.size() == tet10_nodes) std::swap(nodes_[8], nodes_[9]);  // this format has the last edges the other way
    builder_.add_element(builder_.find_block(name, group, kind), id, nodes_, place);
    for (std::size_t g = 1; g < groups_of_element_.size(); ++g)
      builder_.add_set_element(name_group(type.dimension, groups_of_element_[g]), {id, IdSpace::elements}, place);
  }

  /// Binary content begins behind the line of the section's name.
  void begin_binary() {
    if (scan_.is_binary) scan_.next_line();
  }

  TextBuilder builder_;
  TextSource source_;
  GmshScanner scan_;
  int version_ = 0;
  bool names_have_dimensions_ = true;
  std::map<DimTag, std::string> names_;
  std::map<DimTag, std::vector<std::int64_t>> groups_;  // of each entity
  std::vector<std::int64_t> nodes_, groups_of_element_;
};

}  // namespace

std::unique_ptr<MeshFile> open_gmsh_file(const std::string& path) { return GmshReader(path).read(); }

}  // namespace percuss
