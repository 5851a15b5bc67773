// Keys of `parts`.

#include <cmath>
#include <numbers>

#include "kernels/shell/thickness_points.hpp"
#include "src/deck/mesh_size.hpp"
#include "src/deck/reading/deck_keys.hpp"

namespace percuss {
namespace {

const Keys<ArrayCopies>& array_keys() {
  static const Keys<ArrayCopies> keys = {
      need("count", &ArrayCopies::count, TupleValue<IntegerValue, 3>{}),
      need("pitch", &ArrayCopies::pitch, vector3()),
      may("stagger", &ArrayCopies::stagger, NumberValue{{"from -1 to 1", -1, 1}}),
  };
  return keys;
}

bool check_array(const Reader& reader, const Node& node, ArrayCopies& array) {
  bool good = true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (array.count[i] == 1 || array.pitch[i] != 0) continue;
    reader.error(node.find("pitch")->items[i].spot,
                 fmt::format("{}.{} is 0{} (the {} copies along {} would coincide)", reader.name_of("pitch"), i,
                             reader.in(), array.count[i], "xyz"[i]));
    good = false;
  }
  return good;
}

const Keys<Rotation>& rotation_keys() {
  static const Keys<Rotation> keys = {
      need("axis", &Rotation::axis, DirectionValue{}),
      need("angle", &Rotation::degrees, NumberValue{}),
      may("center", &Rotation::center, vector3()),
  };
  return keys;
}

// The shortest turn that takes local +z onto a direction; none if it is +z already.
std::optional<Rotation> turn_z_onto(const Vec3& direction) {
  const double sine = std::hypot(direction[0], direction[1]);
  if (sine == 0 && direction[2] > 0) return std::nullopt;
  if (sine == 0) return Rotation{{1, 0, 0}, 180, {}};
  const double cosine = direction[2];
  const double degrees = cosine == 0 ? 90 : std::atan2(sine, cosine) * (180 / std::numbers::pi);
  return Rotation{{-direction[1] / sine, direction[0] / sine, 0}, degrees, {}};
}

struct MaterialNameValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const {
    if (!TextValue{}.read(reader, name, node, out)) return false;
    reader.reading().materials.push_back({node.spot, out, reader.in()});
    return true;
  }
  std::string takes() const { return "a name from materials"; }
  Form form() const { return TextValue{}.form(); }
};

/// Points across the thickness of a shell.
struct ThicknessPointsValue {
  static constexpr int most = most_thickness_points;

  bool read(const Reader& reader, const std::string& name, const Node& node, int& out) const {
    return IntegerValue{1, most}.read(reader, name, node, out);
  }
  std::string takes() const { return fmt::format("an integer, from 1 to {}", most); }
  Form form() const { return IntegerValue{1, most}.form(); }
};

/// A number, or where the thickness of each shell comes from.
struct ThicknessValue {
  static const Keys<PartDeck>& keys() {
    static const Keys<PartDeck> keys = {
        may("expression", &PartDeck::thickness_by_place, PlaceFunctionValue{}),
        may("file", &PartDeck::thickness_of_file, BooleanValue{}),
        may("otherwise", &PartDeck::thickness, NumberValue{positive}),
    };
    return keys;
  }
  static bool check(const Reader& reader, const Node& node, PartDeck& part) {
    const Node* otherwise = node.find("otherwise");
    if (part.thickness_of_file == part.thickness_by_place.has_value()) {
      reader.error(node.spot, fmt::format("{} has {} (must have one of expression and file: true)", reader.self(),
                                          part.thickness_of_file ? "both expression and file"
                                                                 : "neither expression nor file: true"));
      return false;
    }
    if (part.thickness_of_file || otherwise == nullptr) return true;
    reader.error(otherwise->key, fmt::format("{} has no effect{} (the expression gives every shell a thickness)",
                                             reader.name_of("otherwise"), reader.in()));
    return false;
  }
  static MapValue<PartDeck> map() { return {keys, check}; }

  bool read(const Reader& reader, const std::string& name, const Node& node, PartDeck& part) const {
    if (node.kind == Node::Kind::map) return map().read(reader, name, node, part);
    double number = 0;
    if (!NumberValue{positive}.read(reader, name, node, number)) return false;
    part.thickness = number;
    return true;
  }
  std::string takes() const { return NumberValue{positive}.takes() + ", or a map"; }
  Form form() const { return any_form({NumberValue{positive}.form(), map().form()}); }
};

/// Which surface of the shells the mesh is. What it is of the thickness is known when that is read.
struct ReferenceValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, double& out) const {
    if (node.kind == Node::Kind::scalar && !node.quoted && is_surface(node.text)) {
      out = 0;
      return true;
    }
    const bool may_be_number = node.kind == Node::Kind::scalar && node.text.find_first_of("0123456789") < 3;
    if (!may_be_number) {
      reader.refuse(node, name, takes());
      return false;
    }
    double height = 0;
    if (!NumberValue{}.read(reader, name, node, height)) return false;
    out = -height;
    return true;
  }
  std::string takes() const { return "middle | bottom | top or a number"; }
  Form form() const { return any_form({word_form({"middle", "bottom", "top"}), number_form()}); }

  static bool is_surface(const std::string& text) { return text == "middle" || text == "bottom" || text == "top"; }
};

// --- cross sections of beams

const Keys<TrussSection>& truss_section_keys() {
  static const Keys<TrussSection> keys = {need("area", &TrussSection::area, NumberValue{positive})};
  return keys;
}

const Keys<RoundSection>& round_section_keys() {
  static const Keys<RoundSection> keys = {need("radius", &RoundSection::radius, NumberValue{positive})};
  return keys;
}

const Keys<TubeSection>& tube_section_keys() {
  static const Keys<TubeSection> keys = {
      need("outer_radius", &TubeSection::outer_radius, NumberValue{positive}),
      need("inner_radius", &TubeSection::inner_radius, NumberValue{positive}),
  };
  return keys;
}

bool check_tube_section(const Reader& reader, const Node& node, TubeSection& tube) {
  if (tube.inner_radius < tube.outer_radius) return true;
  reader.error(node.find("inner_radius")->spot,
               fmt::format("{} is {}{} (must be smaller than outer_radius, {})", reader.name_of("inner_radius"),
                           tube.inner_radius, reader.in(), tube.outer_radius));
  return false;
}

const Keys<RectangleSection>& rectangle_section_keys() {
  static const Keys<RectangleSection> keys = {
      need("size", &RectangleSection::size, TupleValue<NumberValue, 2>{{positive}})};
  return keys;
}

const Keys<BoxSection>& box_section_keys() {
  static const Keys<BoxSection> keys = {
      need("size", &BoxSection::size, TupleValue<NumberValue, 2>{{positive}}),
      need("wall", &BoxSection::wall, NumberValue{positive}),
  };
  return keys;
}

bool check_box_section(const Reader& reader, const Node& node, BoxSection& box) {
  const double narrow = std::min(box.size[0], box.size[1]);
  if (2 * box.wall < narrow) return true;
  reader.error(node.find("wall")->spot,
               fmt::format("{} is {}{} (must be less than half of the width {}): use rectangle for a solid section",
                           reader.name_of("wall"), box.wall, reader.in(), narrow));
  return false;
}

const Keys<BeamSection>& general_section_keys() {
  static const Keys<BeamSection> keys = {
      need("area", &BeamSection::area, NumberValue{positive}),
      need("inertia_y", &BeamSection::inertia_y, NumberValue{positive}),
      need("inertia_z", &BeamSection::inertia_z, NumberValue{positive}),
      need("torsion", &BeamSection::torsion, NumberValue{positive}),
      need("shear_area_y", &BeamSection::shear_area_y, NumberValue{positive}),
      need("shear_area_z", &BeamSection::shear_area_z, NumberValue{positive}),
  };
  return keys;
}

template <class S>
Key<BeamSectionDeck> beam_section_key(const char* name, const Keys<S>& (*keys)(),
                                      bool (*check)(const Reader&, const Node&, S&) = nullptr) {
  return make_key<BeamSectionDeck>(
      name, false, MapValue<S>{keys, check},
      [](const auto& value, const Reader& reader, const std::string& full, const Node& node, BeamSectionDeck& section) {
        S read{};
        const bool good = value.read(reader, full, node, read);
        section = read;
        return good;
      });
}

const Keys<BeamSectionDeck>& beam_section_keys() {
  static const Keys<BeamSectionDeck> keys = {
      beam_section_key<TrussSection>("truss", truss_section_keys),
      beam_section_key<RoundSection>("round", round_section_keys),
      beam_section_key<TubeSection>("tube", tube_section_keys, check_tube_section),
      beam_section_key<RectangleSection>("rectangle", rectangle_section_keys),
      beam_section_key<BoxSection>("box", box_section_keys, check_box_section),
      beam_section_key<BeamSection>("general", general_section_keys),
  };
  return keys;
}

/// A map with one kind of cross section.
struct BeamSectionValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, BeamSectionDeck& out) const {
    if (!reader.expect(node, Node::Kind::map, name, takes())) return false;
    const bool good = read_keys(reader.inside(name), node, beam_section_keys(), out);
    if (node.entries.size() == 1 || !good) return good;
    std::vector<std::string> known;
    for (const Key<BeamSectionDeck>& key : beam_section_keys()) known.push_back(key.name);
    reader.error(node.spot, fmt::format("{} has {} kinds{} (must be one of {})", name, node.entries.size(), reader.in(),
                                        fmt::join(known, ", ")));
    return false;
  }
  std::string takes() const { return "a map with one kind of section"; }
  Form form() const {
    Form form = form_of(beam_section_keys());
    for (const Key<BeamSectionDeck>& key : beam_section_keys()) form.exactly_one.push_back(key.name);
    return form;
  }
};

/// Beams need a section, and a direction for one that is not the same all around. What a file holds is seen when it is
/// read.
bool check_beam_section(const Reader& reader, const Node& node, const PartDeck& part) {
  const bool is_line = std::holds_alternative<LineShape>(part.shape);
  const bool may_have = is_line || std::holds_alternative<FileMesh>(part.shape);
  const Node *section = node.find("section"), *toward = node.find("toward");
  for (const Node* given : {section, toward}) {
    if (may_have || given == nullptr) continue;
    reader.error(given->key, fmt::format("{} has no effect{} (only beams have a cross section)",
                                         reader.name_of(given == section ? "section" : "toward"), reader.in()));
    return false;
  }
  if (is_line && section == nullptr) {
    reader.error(node.key, fmt::format("{} has no section (its beams need one)", reader.self()));
    return false;
  }
  if (section == nullptr && toward != nullptr) {
    reader.error(toward->key, fmt::format("{} has no effect{} (it applies only with a section, and none is given)",
                                          reader.name_of("toward"), reader.in()));
    return false;
  }
  if (section == nullptr) return true;
  if (!part.section || (toward != nullptr && !part.toward)) return false;  // reported already
  if (toward != nullptr && !bends(*part.section)) {
    reader.error(toward->key,
                 fmt::format("{} has no effect{} (a truss does not bend)", reader.name_of("toward"), reader.in()));
    return false;
  }
  if (toward != nullptr || !has_axes(*part.section)) return true;
  reader.error(section->key, fmt::format("{} has no toward (its section is not the same all around; toward says where "
                                         "y of the section points)",
                                         reader.self()));
  return false;
}

void set_offset(const Node& node, PartDeck& part) {
  const Node* reference = node.find("reference");
  if (reference == nullptr || !part.thickness) return;
  if (reference->text == "bottom") part.offset = 0.5 * *part.thickness;
  if (reference->text == "top") part.offset = -0.5 * *part.thickness;
}

bool read_axis(const DirectionValue& value, const Reader& reader, const std::string& name, const Node& node,
               PartDeck& part) {
  Vec3 direction{};
  if (!value.read(reader, name, node, direction)) return false;
  if (const auto turn = turn_z_onto(direction)) part.rotate.insert(part.rotate.begin(), *turn);
  return true;
}

bool read_rigid(const RigidValue& value, const Reader& reader, const std::string& name, const Node& node,
                PartDeck& part) {
  return value.read(reader, name, node, part.rigid);
}

/// A key of `elements` that a part has too.
Key<PartDeck> make_part_key(const Key<PartElementDeck>& key) {
  const auto read = [key](const Reader& reader, const Node& node, PartDeck& part) {
    return key.read(reader, node, part.own_elements);
  };
  return {key.name, key.required, key.takes, read, key.form};
}

const Keys<PartDeck>& part_keys() {
  static const Keys<PartDeck> keys = [] {
    Keys<PartDeck> all = shape_keys();
    all.push_back(need("material", &PartDeck::material, MaterialNameValue{}));
    all.push_back(may("elements", &PartDeck::elements,
                      ChoiceValue<PartDeck::Elements>{{{"hexahedra", PartDeck::Elements::hexahedra},
                                                       {"tetrahedra", PartDeck::Elements::tetrahedra},
                                                       {"wedges", PartDeck::Elements::wedges},
                                                       {"pyramids", PartDeck::Elements::pyramids}}}));
    all.push_back(group<PartDeck>("thickness", ThicknessValue{}));
    all.push_back(may("points", &PartDeck::points, ThicknessPointsValue{}));
    all.push_back(may("reference", &PartDeck::offset, ReferenceValue{}));
    all.push_back(may("section", &PartDeck::section, BeamSectionValue{}));
    all.push_back(may("toward", &PartDeck::toward, DirectionValue{}));
    all.push_back(may("array", &PartDeck::array, MapValue<ArrayCopies>{array_keys, check_array}));
    all.push_back(make_key<PartDeck>("axis", false, DirectionValue{}, read_axis));
    all.push_back(may("rotate", &PartDeck::rotate, ListValue<MapValue<Rotation>>{{rotation_keys}}));
    all.push_back(may("at", &PartDeck::at, vector3()));
    all.push_back(may("mass_scaling", &PartDeck::mass_scaling, mass_scaling_value()));
    all.push_back(make_key<PartDeck>("rigid", false, RigidValue{}, read_rigid));
    for (const Key<PartElementDeck>& key : part_element_keys()) all.push_back(make_part_key(key));
    return all;
  }();
  return keys;
}

bool check_one_shape(const Reader& reader, const Node& node) {
  std::vector<std::string> given, known;
  for (const Key<PartDeck>& key : shape_keys()) {
    known.push_back(key.name);
    if (node.find(key.name) != nullptr) given.push_back(key.name);
  }
  if (given.size() == 1) return true;
  const std::string what =
      given.empty() ? "no shape" : fmt::format("{} shapes, {}", given.size(), fmt::join(given, " and "));
  const Spot spot = given.empty() ? node.key : node.find(given[1])->key;
  reader.error(spot, fmt::format("{} has {} (must be one of {})", reader.self(), what, fmt::join(known, ", ")));
  return false;
}

/// The offset of a surface would follow the thickness of each shell, and a part has one offset.
bool check_reference(const Reader& reader, const Node& node, const PartDeck& part) {
  const Node* reference = node.find("reference");
  if (reference == nullptr || !part.varies_in_thickness()) return true;
  if (reference->text != "bottom" && reference->text != "top") return true;
  reader.error(reference->spot, fmt::format("{} is {}{} (it needs one thickness of all shells): give a number, or make "
                                            "parts of one thickness",
                                            reader.name_of("reference"), reference->text, reader.in()));
  return false;
}

/// Shells need a thickness; of solids it has no effect. What a file holds is seen when it is read.
bool check_thickness(const Reader& reader, const Node& node, const PartDeck& part) {
  if (!check_reference(reader, node, part)) return false;
  if (std::holds_alternative<FileMesh>(part.shape)) return true;
  const bool is_shell = is_shell_shape(part.shape);
  if (is_shell && part.thickness_of_file) {
    reader.error(node.find("thickness")->spot, fmt::format("{} is that of a file{} (its shape is generated): give a "
                                                           "number or an expression",
                                                           reader.name_of("thickness"), reader.in()));
    return false;
  }
  if (is_shell && !part.has_thickness()) {
    if (node.find("thickness") != nullptr) return false;  // reported already
    reader.error(node.key, fmt::format("{} has no thickness (its shells need one)", reader.self()));
    return false;
  }
  for (const char* key : {"thickness", "points", "reference"}) {
    if (is_shell || node.find(key) == nullptr) continue;
    reader.error(node.find(key)->key,
                 fmt::format("{} has no effect{} (only shells have a thickness)", reader.name_of(key), reader.in()));
    return false;
  }
  return true;
}

/// What cells are cut into is a question of generated solids.
bool check_elements(const Reader& reader, const Node& node, const PartDeck& part) {
  const bool is_file = std::holds_alternative<FileMesh>(part.shape);
  const Node* elements = node.find("elements");
  const bool is_line = std::holds_alternative<LineShape>(part.shape);
  if (part.elements == PartDeck::Elements::wedges && std::holds_alternative<SphereShape>(part.shape)) {
    reader.error(elements->key, fmt::format("{} of a sphere cannot be wedges{} (triangles of its cells would meet "
                                            "quadrilaterals): choose tetrahedra or pyramids",
                                            reader.name_of("elements"), reader.in()));
    return false;
  }
  if (elements == nullptr || (!is_file && !is_line && !is_shell_shape(part.shape))) return true;
  reader.error(elements->key, fmt::format("{} has no effect{} ({})", reader.name_of("elements"), reader.in(),
                                          is_file   ? "the file says what its elements are"
                                          : is_line ? "its elements are beams"
                                                    : "its elements are shells"));
  return false;
}

}  // namespace

bool PartValue::read_inside(const Reader& reader, const Node& node, PartDeck& out) const {
  const bool good = read_keys(reader, node, part_keys(), out);
  if (!check_one_shape(reader, node)) {
    reader.reading().shapeless.insert(out.name);
    return false;
  }
  if (!check_thickness(reader, node, out) || !check_beam_section(reader, node, out)) return false;
  if (!check_elements(reader, node, out) || !good) return false;
  set_offset(node, out);
  const MeshSize size = count_cells(out);
  if (size.elements <= largest_mesh && size.nodes <= largest_mesh) return true;
  reader.error(node.key,
               fmt::format("{} has {:.4g} elements and {:.4g} nodes (a mesh can have {:.0f} of each): make it coarser",
                           reader.self(), size.elements, size.nodes, largest_mesh));
  return false;
}

Form PartValue::form() const {
  Form form = form_of(part_keys());
  for (const Key<PartDeck>& key : shape_keys()) form.exactly_one.push_back(key.name);
  return form;
}

}  // namespace percuss
