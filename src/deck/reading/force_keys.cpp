// Keys of `output.history.forces`.

#include <set>

#include "src/deck/reading/deck_keys.hpp"

namespace percuss {
namespace {

/// Parts of one side of a contact: a name or a list of names. all: an empty list, where that is allowed.
struct SideValue {
  bool takes_all;

  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<std::string>& out) const {
    if (node.kind != Node::Kind::list) {
      if (!takes_all && node.text == "all") {
        reader.refuse(node, name, takes());
        return false;
      }
      std::string part;
      if (!PartNameValue{}.read(reader, name, node, part)) return false;
      if (!part.empty()) out.push_back(std::move(part));
      return true;
    }
    if (node.items.empty()) {
      reader.refuse(node, name, "at least one part");
      return false;
    }
    bool good = true;
    for (std::size_t i = 0; i < node.items.size(); ++i)
      good = SideValue{false}.read(reader, fmt::format("{}.{}", name, i), node.items[i], out) && good;
    return good;
  }
  std::string takes() const { return takes_all ? "a part, a list of parts or all" : "a part or a list of parts"; }
  Form form() const { return any_form({Form::Kind::text, list_form(Form::Kind::text, 1)}); }
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
  std::string takes() const { return "a pair [a, b]: on a part or a list of parts, from others or from all"; }
  Form form() const { return tuple_form({SideValue{false}.form(), SideValue{true}.form()}); }
};

const Keys<ForceDeck>& section_keys() {
  static const Keys<ForceDeck> keys = {
      may("part", &ForceDeck::part, PartNameValue{}),
      need("point", &ForceDeck::point, vector3()),
      need("normal", &ForceDeck::normal, DirectionValue{}),
  };
  return keys;
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
      group<ForceDeck>("section", MapValue<ForceDeck>{section_keys}),
      may("about", &ForceDeck::about, vector3()),
  };
  return keys;
}

}  // namespace

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
  if (given.size() == 1) return good;
  const std::string what = given.empty() ? "no kind of force" : fmt::format("{}", fmt::join(given, " and "));
  reader.error(node.spot, fmt::format("{} has {} (must have exactly one of {})", name, what, fmt::join(known, ", ")));
  return false;
}

Form ForceValue::form() const {
  Form form = form_of(force_keys());
  for (const ForceKind& kind : kinds) form.exactly_one.emplace_back(kind.key);
  return form;
}

void check_forces(const Deck& deck, Reading& reading) {
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
    if (force.kind == ForceDeck::Kind::wall && std::find(walls.begin(), walls.end(), force.wall) == walls.end())
      reading.errors.add(spot, fmt::format("force '{}' is of the wall {} (no wall has this name){}", force.name,
                                           quote(force.wall), name_hint(force.wall, walls)));
    if (force.kind == ForceDeck::Kind::contact || force.kind == ForceDeck::Kind::wall) ++contacts;
  }
  if (contacts > most_forces_of_contact)
    reading.errors.add({deck.output.forces.front().place, -1},
                       fmt::format("output.history.forces has {} forces of contact and walls (at most {})", contacts,
                                   most_forces_of_contact));
}

}  // namespace percuss
