#include "src/deck/parts/element_keys.hpp"

#include <optional>
#include <string>
#include <type_traits>

namespace percuss {
namespace {

using Hourglass = ElementDeck::Hourglass;
using Integration = ElementDeck::Integration;

ChoiceValue<Hourglass> hourglass_kind() {
  return {{{"assumed_strain", Hourglass::assumed_strain},
           {"stiffness", Hourglass::stiffness},
           {"viscous", Hourglass::viscous}}};
}

/// T: as below; membranes are a matter of a part.
template <class T>
ChoiceValue<Integration> integration_kind() {
  ChoiceValue<Integration> kinds{
      {{"one_point", Integration::one_point}, {"full", Integration::full}, {"thick_shell", Integration::thick_shell}}};
  if constexpr (std::is_same_v<T, PartElementDeck>) kinds.choices.push_back({"membrane", Integration::membrane});
  return kinds;
}

/// Points across a thick shell.
struct ThickPointsValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, int& out) const {
    int points = 0;
    if (!IntegerValue{3, 5}.read(reader, name, node, points)) return false;
    if (points == 4) {
      reader.refuse(node, name, takes());
      return false;
    }
    out = points;
    return true;
  }
  bool read(const Reader& reader, const std::string& name, const Node& node, std::optional<int>& out) const {
    int points = 0;
    if (!read(reader, name, node, points)) return false;
    out = points;
    return true;
  }
  std::string takes() const { return "3 or 5"; }
  Form form() const { return IntegerValue{3, 5}.form(); }
};

/// T: ElementDeck or PartElementDeck, whose members have the same names.
template <class T>
const Keys<T>& integration_keys() {
  using Across = ElementDeck::Across;
  static const Keys<T> keys = {
      need("kind", &T::integration, integration_kind<T>()),
      may("points", &T::thick_points, ThickPointsValue{}),
      may("across", &T::across,
          ChoiceValue<Across>{{{"first", Across::first},
                               {"second", Across::second},
                               {"third", Across::third},
                               {"shortest", Across::shortest}}}),
  };
  return keys;
}

/// The kind alone, or a map.
template <class T>
struct IntegrationValue {
  MapValue<T> map{integration_keys<T>};

  bool read(const Reader& reader, const std::string& name, const Node& node, T& out) const {
    if (node.kind != Node::Kind::scalar) return map.read(reader, name, node, out);
    Integration kind{};
    if (!integration_kind<T>().read(reader, name, node, kind)) return false;
    out.integration = kind;
    return true;
  }
  std::string takes() const { return integration_kind<T>().takes() + ", or a map"; }
  Form form() const { return any_form({integration_kind<T>().form(), map.form()}); }
};

/// T: ElementDeck or PartElementDeck, whose members have the same names.
template <class T>
const Keys<T>& hourglass_keys() {
  static const Keys<T> keys = {
      may("kind", &T::hourglass, hourglass_kind()),
      may("coefficient", &T::hourglass_coefficient, NumberValue{{"from 0 to 1", 0, 1}}),
  };
  return keys;
}

/// The kind alone, or a map.
template <class T>
struct HourglassValue {
  MapValue<T> map{hourglass_keys<T>};

  bool read(const Reader& reader, const std::string& name, const Node& node, T& out) const {
    if (node.kind != Node::Kind::scalar) return map.read(reader, name, node, out);
    Hourglass kind{};
    if (!hourglass_kind().read(reader, name, node, kind)) return false;
    out.hourglass = kind;
    return true;
  }
  std::string takes() const { return hourglass_kind().takes() + ", or a map"; }
  Form form() const { return any_form({hourglass_kind().form(), map.form()}); }
};

template <class T>
const Keys<T>& viscosity_keys() {
  static const Keys<T> keys = {
      may("linear", &T::linear_viscosity, NumberValue{not_negative}),
      may("quadratic", &T::quadratic_viscosity, NumberValue{not_negative}),
  };
  return keys;
}

/// Keys that a part may have too.
template <class T>
Keys<T> settings_keys() {
  return {
      group<T>("integration", IntegrationValue<T>{}),
      group<T>("hourglass", HourglassValue<T>{}),
      group<T>("bulk_viscosity", MapValue<T>{viscosity_keys<T>}),
      may("stiffness_damping", &T::stiffness_damping, NumberValue{not_negative}),
      may("shell_hourglass", &T::shell_hourglass, NumberValue{{"above 0 and at most 1", 0, 1, true, false}}),
  };
}

const Keys<ElementDeck>& element_keys() {
  static const Keys<ElementDeck> keys = [] {
    Keys<ElementDeck> all = settings_keys<ElementDeck>();
    all.push_back(may("resist_folding", &ElementDeck::resist_folding, BooleanValue{}));
    all.push_back(may("skip_resting", &ElementDeck::skip_resting, BooleanValue{}));
    all.push_back(may("tetrahedra", &ElementDeck::tetrahedra,
                      ChoiceValue<ElementDeck::Tetrahedra>{
                          {{"mixed", ElementDeck::Tetrahedra::mixed}, {"plain", ElementDeck::Tetrahedra::plain}}}));
    return all;
  }();
  return keys;
}

/// Checks the keys that only thick shells have.
void check_thick_keys(const Reader& reader, const Node& node, const ElementDeck& deck) {
  const Node* integration = node.find("integration");
  if (integration == nullptr || integration->kind != Node::Kind::map || integration->broken) return;
  if (deck.integration == Integration::thick_shell) return;
  for (const char* key : {"points", "across"})
    if (const Node* given = integration->find(key))
      reader.error(given->key,
                   fmt::format("{} has no effect{} (only thick shells have points across a thickness): give "
                               "kind: thick_shell, or leave it out",
                               reader.name_of(std::string("integration.") + key), reader.in()));
}

/// Settings that do nothing beside the others that hold there.
void check_settings(const Reader& reader, const Node& node, const ElementDeck& deck) {
  check_thick_keys(reader, node, deck);
  const Node* hourglass = node.find("hourglass");
  if (hourglass == nullptr || hourglass->broken) return;
  if (deck.integration != Integration::one_point) {
    const char* const why = deck.integration == Integration::full ? "full, which leaves no hourglass modes"
                            : deck.integration == Integration::thick_shell
                                ? "thick_shell, which leaves no hourglass modes"
                                : "membrane; shell_hourglass is the key of shells";
    reader.error(hourglass->key,
                 fmt::format("{} has no effect{} (integration is {})", reader.name_of("hourglass"), reader.in(), why));
    return;
  }
  if (hourglass->kind != Node::Kind::map || deck.hourglass != Hourglass::assumed_strain) return;
  const Node *coefficient = hourglass->find("coefficient"), *kind = hourglass->find("kind");
  if (coefficient == nullptr || (kind != nullptr && kind->text != "assumed_strain")) return;
  reader.error(
      coefficient->key,
      fmt::format(
          "{} has no effect{} (assumed_strain follows from the material): give kind: stiffness or kind: viscous",
          reader.name_of("hourglass.coefficient"), reader.in()));
}

/// Membranes are shells, with one point across each layer and nothing that bends.
void check_membrane(const Reader& reader, const Node& node, const PartDeck& part) {
  if (!part.is_membrane()) return;
  const bool is_file = std::holds_alternative<FileMesh>(part.shape);
  if (!is_file && !is_shell_shape(part.shape))
    reader.error(node.find("integration")->key,
                 fmt::format("{} is membrane{} (membranes are shells, and it has none): give it a shape of shells, or "
                             "leave it out",
                             reader.name_of("integration"), reader.in()));
  if (const Node* points = node.find("points"))
    reader.error(points->key, fmt::format("{} has no effect{} (a layer of a membrane has one point): remove it",
                                          reader.name_of("points"), reader.in()));
  if (const Node* reference = node.find("reference"))
    reader.error(reference->key, fmt::format("{} has no effect{} (a membrane does not bend, wherever its mesh lies): "
                                             "remove it",
                                             reader.name_of("reference"), reader.in()));
}

/// Wedges and pyramids have one point and the stiffness form of hourglass control.
void check_one_point(const Reader& reader, const Node& node, const PartDeck& part) {
  const char* const elements = part.elements == PartDeck::Elements::wedges ? "wedges" : "pyramids";
  if (const Node* given = node.find("integration"))
    reader.error(given->key, fmt::format("{} has no effect{} (its elements are {}; the key is for hexahedra)",
                                         reader.name_of("integration"), reader.in(), elements));
  const Node* given = node.find("hourglass");
  if (given == nullptr || part.own_elements.hourglass == Hourglass::stiffness) return;
  reader.error(given->key, fmt::format("{} has no effect{} (its elements are {}, which have the stiffness form alone): "
                                       "give kind: stiffness with its coefficient, or leave it out",
                                       reader.name_of("hourglass"), reader.in(), elements));
}

/// Checks keys by the kind of element: a part without hexahedra has no hourglass modes; shells and beams have no bulk
/// viscosity either.
void check_kind(const Reader& reader, const Node& node, const PartDeck& part) {
  if (std::holds_alternative<FileMesh>(part.shape)) return;
  const bool is_shell = is_shell_shape(part.shape);
  const Node* of_shells = node.find("shell_hourglass");
  if (of_shells != nullptr && !is_shell)
    reader.error(of_shells->key, fmt::format("{} has no effect{} (it applies to shells): remove it",
                                             reader.name_of("shell_hourglass"), reader.in()));
  const bool is_line = std::holds_alternative<LineShape>(part.shape), is_solid = !is_shell && !is_line;
  if (is_solid && part.elements == PartDeck::Elements::hexahedra) return;
  if (is_solid && !part.is_cut_into_tetrahedra()) return check_one_point(reader, node, part);
  for (const std::string key : {"integration", "hourglass", "bulk_viscosity"}) {
    const Node* given = node.find(key);
    const bool is_viscosity = key == "bulk_viscosity";
    if (given == nullptr || (is_solid && is_viscosity) || (key == "integration" && part.is_membrane())) continue;
    reader.error(given->key, fmt::format("{} has no effect{} (its elements are {}; this applies to hexahedra{})",
                                         reader.name_of(key), reader.in(),
                                         is_shell  ? "shells"
                                         : is_line ? "beams"
                                                   : "tetrahedra",
                                         is_viscosity ? " and tetrahedra" : ""));
  }
}

}  // namespace

MapValue<ElementDeck> element_value() { return {element_keys}; }

Keys<PartElementDeck> part_element_keys() { return settings_keys<PartElementDeck>(); }

void check_element_settings(const Deck& deck, const Node& root, Reading& reading) {
  const Node *elements = root.find("elements"), *parts = root.find("parts");
  if (elements != nullptr && elements->kind == Node::Kind::map)
    check_settings(Reader(reading).inside("elements"), *elements, deck.elements);
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    const PartDeck& part = deck.parts[p];
    const Node* node = parts->find(part.name);
    if (node == nullptr || node->kind != Node::Kind::map || reading.shapeless.contains(part.name)) continue;
    const Reader reader = Reader(reading).inside_named("part", part.name);
    check_settings(reader, *node, deck.find_elements(p));
    check_kind(reader, *node, part);
    check_membrane(reader, *node, part);
  }
}

}  // namespace percuss
