#include "src/deck/parts/part_keys.hpp"

#include <cmath>
#include <numbers>

#include "kernels/shell/thickness_points.hpp"
#include "src/deck/mesh_size.hpp"
#include "src/deck/parts/beam_section_keys.hpp"
#include "src/deck/parts/element_keys.hpp"
#include "src/deck/parts/mass_keys.hpp"
#include "src/deck/parts/rigid_keys.hpp"
#include "src/deck/parts/shape_keys.hpp"

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

const Keys<PlyDeck>& ply_keys() {
  static const Keys<PlyDeck> keys = {
      need("thickness", &PlyDeck::thickness, NumberValue{positive}),
      may("angle", &PlyDeck::angle, NumberValue{}),
      may("material", &PlyDeck::material, MaterialNameValue{}),
  };
  return keys;
}

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

/// The surface of the shells that the mesh is. Its offset is known when the thickness is read.
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

const Keys<PartDeck>& part_keys() {
  static const Keys<PartDeck> keys = [] {
    Keys<PartDeck> all = shape_keys();
    all.push_back(need("material", &PartDeck::material, MaterialNameValue{}));
    all.push_back(may("elements", &PartDeck::elements,
                      ChoiceValue<PartDeck::Elements>{{{"hexahedra", PartDeck::Elements::hexahedra},
                                                       {"tetrahedra", PartDeck::Elements::tetrahedra},
                                                       {"six_tetrahedra", PartDeck::Elements::six_tetrahedra},
                                                       {"five_tetrahedra", PartDeck::Elements::five_tetrahedra},
                                                       {"wedges", PartDeck::Elements::wedges},
                                                       {"pyramids", PartDeck::Elements::pyramids}}}));
    all.push_back(group<PartDeck>("thickness", ThicknessValue{}));
    all.push_back(may("points", &PartDeck::points, ThicknessPointsValue{}));
    all.push_back(may("plies", &PartDeck::plies, ListValue<MapValue<PlyDeck>>{{ply_keys}}));
    all.push_back(may("reference", &PartDeck::offset, ReferenceValue{}));
    all.push_back(may("section", &PartDeck::section, BeamSectionValue{}));
    all.push_back(may("toward", &PartDeck::toward, DirectionValue{}));
    all.push_back(may("contact_radius", &PartDeck::contact_radius, NumberValue{positive}));
    all.push_back(may("array", &PartDeck::array, MapValue<ArrayCopies>{array_keys, check_array}));
    all.push_back(make_key<PartDeck>("axis", false, DirectionValue{}, read_axis));
    all.push_back(may("rotate", &PartDeck::rotate, ListValue<MapValue<Rotation>>{{rotation_keys}}));
    all.push_back(may("at", &PartDeck::at, vector3()));
    all.push_back(may("mass_scaling", &PartDeck::mass_scaling, mass_scaling_value()));
    all.push_back(make_key<PartDeck>("rigid", false, RigidValue{}, read_rigid));
    for (const AnyKey& key : part_element_keys()) all.push_back(lift_key(key, &PartDeck::own_elements));
    return all;
  }();
  return keys;
}

bool check_one_shape(const Reader& reader, const Node& node) {
  std::vector<std::string> given, known;
  for (const AnyKey& key : shape_keys()) {
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

/// Plies have the thickness of the part, and there is room for so many layers.
bool check_plies(const Reader& reader, const Node& node, PartDeck& part) {
  const Node* const plies = node.find("plies");
  if (plies == nullptr || part.plies.empty()) return true;
  if (const Node* thickness = node.find("thickness")) {
    reader.error(thickness->key, fmt::format("{} is given beside plies{} (which have their own): leave it out",
                                             reader.name_of("thickness"), reader.in()));
    return false;
  }
  double sum = 0;
  for (const PlyDeck& ply : part.plies) sum += ply.thickness;
  part.thickness = sum;
  const int each = part.points.value_or(1), count = each * static_cast<int>(part.plies.size());
  if (count <= most_layers) return true;
  reader.error(plies->key, fmt::format("{} has {} plies of {} points{} (at most {} points in all): join plies that are "
                                       "alike",
                                       reader.name_of("plies"), part.plies.size(), each, reader.in(), most_layers));
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
    const Node* const plies = node.find("plies");
    const bool has_plies = plies != nullptr && !(plies->kind == Node::Kind::list && plies->items.empty());
    if (node.find("thickness") != nullptr || has_plies) return false;  // reported already
    reader.error(node.key, fmt::format("{} has no thickness (its shells need one): give thickness", reader.self()));
    return false;
  }
  for (const char* key : {"thickness", "points", "plies", "reference"}) {
    if (is_shell || node.find(key) == nullptr) continue;
    reader.error(node.find(key)->key,
                 fmt::format("{} has no effect{} (only shells have a thickness)", reader.name_of(key), reader.in()));
    return false;
  }
  return true;
}

/// Whether cells can be cut so that each is the mirror of its neighbours.
bool can_alternate(const Shape& shape) {
  const auto* tube = std::get_if<TubeShape>(&shape);
  return tube == nullptr || tube->arc < 360 || tube->cells[1] % 2 == 0;
}

/// Checks the key that says what cells are cut into: only generated solids have it.
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
  if (part.elements == PartDeck::Elements::five_tetrahedra && !can_alternate(part.shape)) {
    reader.error(elements->key, fmt::format("{} of a closed tube with an odd number of cells around cannot be "
                                            "five_tetrahedra{} (diagonals of neighbours alternate, and would meet): "
                                            "choose an even number, or six_tetrahedra",
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
  if (!check_plies(reader, node, out)) return false;
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
  for (const AnyKey& key : shape_keys()) form.exactly_one.push_back(key.name);
  return form;
}

}  // namespace percuss
