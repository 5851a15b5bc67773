// Keys of `output.history.forces`.

#include "src/deck/output/force_keys.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "src/deck/keys/keys.hpp"

namespace percuss {
namespace {

bool read_element_set(const Reader& reader, const std::string& name, const Node& node, std::vector<Selector>& out) {
  if (node.kind != Node::Kind::scalar || node.text == "all") {
    reader.refuse(node, name, ElementSetsValue{}.takes());
    return false;
  }
  Selector elements;
  if (!SelectorValue{Chosen::elements}.read(reader, name, node, elements)) return false;
  out.push_back(std::move(elements));
  return true;
}

/// One side of a contact: a part, a surface or a list of these. all: an empty list, where that is allowed.
struct SideValue {
  bool takes_all;

  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<Selector>& out) const {
    if (node.kind != Node::Kind::list) {
      if (!takes_all && node.text == "all") {
        reader.refuse(node, name, takes());
        return false;
      }
      Selector side;
      if (!SelectorValue{}.read(reader, name, node, side)) return false;
      if (side.inside || !side.name.empty()) out.push_back(std::move(side));
      return true;
    }
    if (node.items.empty()) {
      reader.refuse(node, name, "at least one part or surface");
      return false;
    }
    bool good = true;
    for (std::size_t i = 0; i < node.items.size(); ++i)
      good = SideValue{false}.read(reader, fmt::format("{}.{}", name, i), node.items[i], out) && good;
    return good;
  }
  std::string takes() const {
    return std::string("a part, a surface") + (takes_all ? ", a list of these or all" : " or a list of these");
  }
  Form form() const { return any_form({SelectorValue{}.form(), list_form(SelectorValue{}.form(), 1)}); }
};

/// [a, b]: the force on a that comes from b.
struct ContactSidesValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, ForceDeck& out) const {
    if (node.kind != Node::Kind::list || node.items.size() != 2) {
      reader.refuse(node, name, takes());
      return false;
    }
    const bool on = SideValue{false}.read(reader, name + ".0", node.items[0], out.on);
    return SideValue{true}.read(reader, name + ".1", node.items[1], out.from) && on;
  }
  std::string takes() const {
    return "a pair [a, b]: on a part, a surface or a list of these, from others or from all";
  }
  Form form() const { return tuple_form({SideValue{false}.form(), SideValue{true}.form()}); }
};

const Keys<ForceDeck>& section_keys() {
  static const Keys<ForceDeck> keys = {
      may("part", &ForceDeck::part, PartNameValue{}),
      may("point", &ForceDeck::point, vector3()),
      may("normal", &ForceDeck::normal, DirectionValue{}),
      may("nodes", &ForceDeck::nodes, SelectorValue{}),
      may("elements", &ForceDeck::elements, ElementSetsValue{}),
  };
  return keys;
}

/// Checks a section: by a plane, with `point` and `normal`; or by `nodes` and `elements`.
bool check_section(const Reader& reader, const Node& node, ForceDeck&) {
  const auto has = [&](const char* key) { return node.find(key) != nullptr; };
  const bool is_of_plane = has("point") || has("normal") || has("part"), is_of_sets = has("nodes") || has("elements");
  if (is_of_plane && is_of_sets) {
    reader.error(node.key, fmt::format("{} has keys of a plane and of sets (must have point and normal, or nodes and "
                                       "elements)",
                                       reader.self()));
    return false;
  }
  for (const char* key : is_of_sets ? std::array{"nodes", "elements"} : std::array{"point", "normal"}) {
    if (has(key)) continue;
    reader.error(node.key, fmt::format("{} is missing (a section has point and normal, or nodes and elements)",
                                       reader.name_of(key)));
    return false;
  }
  return true;
}

struct ForceKind {
  const char* key;
  ForceDeck::Kind kind;
};
constexpr ForceKind kinds[] = {{"contact", ForceDeck::Kind::contact},
                               {"wall", ForceDeck::Kind::wall},
                               {"support", ForceDeck::Kind::support},
                               {"section", ForceDeck::Kind::section}};

const Keys<ForceDeck>& force_keys() {
  static const Keys<ForceDeck> keys = {
      need("name", &ForceDeck::name, NameValue{}),
      group<ForceDeck>("contact", ContactSidesValue{}),
      may("wall", &ForceDeck::wall, NameValue{}),
      may("support", &ForceDeck::where, SelectorValue{}),
      group<ForceDeck>("section", MapValue<ForceDeck>{section_keys, check_section}),
      may("about", &ForceDeck::about, vector3()),
  };
  return keys;
}

}  // namespace

bool ElementSetsValue::read(const Reader& reader, const std::string& name, const Node& node,
                            std::vector<Selector>& out) const {
  if (node.kind != Node::Kind::list) return read_element_set(reader, name, node, out);
  if (node.items.empty()) {
    reader.refuse(node, name, "at least one part, element block or element set");
    return false;
  }
  bool good = true;
  for (std::size_t i = 0; i < node.items.size(); ++i)
    good = read_element_set(reader, fmt::format("{}.{}", name, i), node.items[i], out) && good;
  return good;
}

bool ForceValue::read(const Reader& reader, const std::string& name, const Node& node, ForceDeck& out) const {
  if (!reader.expect(node, Node::Kind::map, name, takes())) return false;
  const bool good = read_keys(reader.inside(name), node, force_keys(), out);
  out.place = node.spot.place;
  std::vector<std::string> given, known;
  for (const ForceKind& kind : kinds) {
    known.emplace_back(kind.key);
    if (node.find(kind.key) == nullptr) continue;
    given.emplace_back(kind.key);
    out.kind = kind.kind;
  }
  if (given.size() == 1 || (given.empty() && !good)) return good;  // a wrong key may have been meant to be the kind
  const std::string what = given.empty() ? "no kind of force" : fmt::format("{}", fmt::join(given, " and "));
  reader.error(node.spot, fmt::format("{} has {} (must have exactly one of {})", name, what, fmt::join(known, ", ")));
  return false;
}

Form ForceValue::form() const {
  Form form = form_of(force_keys());
  for (const ForceKind& kind : kinds) form.exactly_one.emplace_back(kind.key);
  return form;
}

namespace {

/// Names of walls that are wrong too, whose messages tell already why no force can be theirs.
std::set<std::string> list_given_walls(const Node& root) {
  std::set<std::string> names;
  const Node* walls = root.find("walls");
  if (walls == nullptr) return names;
  for (const Node& wall : walls->items)
    if (const Node* name = wall.find("name")) names.insert(name->text);
  return names;
}

}  // namespace

void check_forces(const Deck& deck, const Node& root, Reading& reading) {
  const std::set<std::string> given = list_given_walls(root);
  std::vector<std::string> walls;
  for (const WallDeck& wall : deck.walls) {
    if (wall.name.empty()) continue;
    if (std::find(walls.begin(), walls.end(), wall.name) != walls.end())
      reading.errors.add({wall.place, -1}, fmt::format("two walls have the name '{}'", wall.name));
    walls.push_back(wall.name);
  }
  std::set<std::string_view> names;
  std::size_t contacts = 0;
  for (const ForceDeck& force : deck.output.forces) {
    const Spot spot{force.place, -1};
    if (!names.insert(force.name).second)
      reading.errors.add(spot, fmt::format("name '{}' is given twice in output.history.forces", force.name));
    if (force.kind == ForceDeck::Kind::wall && !given.contains(force.wall))
      reading.errors.add(spot, fmt::format("force '{}' is of the wall {} (no wall has this name){}", force.name,
                                           quote(force.wall), name_hint(force.wall, walls)));
    if (force.is_of_contact()) ++contacts;
  }
  if (contacts > most_forces_of_contact)
    reading.errors.add({deck.output.forces.front().place, -1},
                       fmt::format("output.history.forces has {} forces of contact and walls (at most {})", contacts,
                                   most_forces_of_contact));
}

namespace {

std::string identify_box(const Selector& where) {
  if (!where.inside) return "";
  return fmt::format(":{},{}", fmt::join((*where.inside)[0], ","), fmt::join((*where.inside)[1], ","));
}

std::string identify_all(const std::vector<Selector>& side) {
  std::vector<std::string> texts;
  texts.reserve(side.size());
  for (const Selector& where : side) texts.push_back(where.name + identify_box(where));
  return fmt::format("{}", fmt::join(texts, "+"));
}

}  // namespace

std::string identify(const ForceDeck& force) {
  std::string text =
      fmt::format("{}:{}:{}>{}:{}:{}:{}", force.name, static_cast<int>(force.kind), identify_all(force.on),
                  identify_all(force.from), force.wall, force.where.name, force.part);
  text += identify_box(force.where);
  if (force.nodes)
    text += fmt::format(":{}{}>{}", force.nodes->name, identify_box(*force.nodes), identify_all(force.elements));
  text += fmt::format(":{}:{}", fmt::join(force.point, ","), fmt::join(force.normal, ","));
  return force.about ? text + fmt::format(":{}", fmt::join(*force.about, ",")) : text;
}

}  // namespace percuss
