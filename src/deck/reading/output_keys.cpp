// Keys of `output`.

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>

#include "kernels/shell/thickness_points.hpp"
#include "src/deck/asked_for.hpp"
#include "src/deck/reading/deck_keys.hpp"

namespace percuss {
namespace {

/// Names of fields, each once.
struct FieldsValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<std::string>& out) const {
    if (!reader.expect(node, Node::Kind::list, name, takes())) return false;
    bool good = true;
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const Node& item = node.items[i];
      const std::string item_name = fmt::format("{}.{}", name, i);
      if (!reader.expect(item, Node::Kind::scalar, item_name, "the name of a field")) {
        good = false;
      } else if (const auto& known = field_names(); std::find(known.begin(), known.end(), item.text) == known.end()) {
        reader.error(item.spot,
                     fmt::format("unknown field {} in {}{}", quote(item.text), name, name_hint(item.text, known)));
        good = false;
      } else if (std::find(out.begin(), out.end(), item.text) != out.end()) {
        reader.error(item.spot, fmt::format("field '{}' is named twice in {}", item.text, name));
        good = false;
      } else {
        out.push_back(item.text);
      }
    }
    return good;
  }
  std::string takes() const { return "a list of fields"; }
  Form form() const { return list_form(word_form(field_names())); }
};

/// A format, or a list of formats.
struct FormatsValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<FieldsFormat>& out) const {
    std::vector<FieldsFormat> formats;
    if (node.kind != Node::Kind::list) {
      formats.resize(1);
      if (!choice().read(reader, name, node, formats[0])) return false;
    } else if (!ListValue<ChoiceValue<FieldsFormat>>{choice()}.read(reader, name, node, formats)) {
      return false;
    }
    std::sort(formats.begin(), formats.end());
    if (formats.empty() || std::adjacent_find(formats.begin(), formats.end()) != formats.end()) {
      reader.refuse(node, name, "formats, each once");
      return false;
    }
    out = std::move(formats);
    return true;
  }
  std::string takes() const { return choice().takes() + ", or a list of these"; }
  Form form() const { return any_form({choice().form(), list_form(choice().form(), 1)}); }

 private:
  static ChoiceValue<FieldsFormat> choice() {
    return {{{"vtkhdf", FieldsFormat::vtkhdf}, {"exodus", FieldsFormat::exodus}}};
  }
};

const Keys<OutputDeck>& field_keys() {
  static const Keys<OutputDeck> keys = {
      need("every", &OutputDeck::fields_every, NumberValue{positive}),
      may("write", &OutputDeck::fields, FieldsValue{}),
      may("format", &OutputDeck::fields_formats, FormatsValue{}),
  };
  return keys;
}

const Keys<HistoryPoint>& point_keys() {
  static const Keys<HistoryPoint> keys = {
      need("name", &HistoryPoint::name, NameValue{}),
      may("near", &HistoryPoint::near, vector3()),
      may("id", &HistoryPoint::id, IntegerValue{1, std::numeric_limits<long>::max()}),
      may("part", &HistoryPoint::part, PartNameValue{}),
  };
  return keys;
}

bool check_point(const Reader& reader, const Node& node, HistoryPoint& point) {
  point.place = node.spot.place;
  if (point.near.has_value() != point.id.has_value()) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have one of near and id)", reader.self(),
                                      point.near ? "both near and id" : "neither near nor id"));
  return false;
}

/// history.nodes or history.elements.
struct PointsValue {
  bool elements;

  bool read(const Reader& reader, const std::string& name, const Node& node, OutputDeck& out) const {
    std::vector<HistoryPoint> points;
    const bool good = value().read(reader, name, node, points);
    for (HistoryPoint& point : points) {
      point.is_element = elements;
      out.points.push_back(std::move(point));
    }
    return good;
  }
  std::string takes() const { return value().takes(); }
  Form form() const { return value().form(); }
  static ListValue<MapValue<HistoryPoint>> value() { return {{point_keys, check_point}}; }
};

/// history.parts: each a point without a place, that of `all` without a part.
struct PartsValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, OutputDeck& out) const {
    if (node.kind == Node::Kind::scalar && node.text == "all") {
      out.points.push_back(whole_part("", node));
      return true;
    }
    if (!reader.expect(node, Node::Kind::list, name, takes())) return false;
    bool good = true;
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      if (!read_part(reader, fmt::format("{}.{}", name, i), node.items[i], parts)) {
        good = false;
      } else {
        out.points.push_back(whole_part(parts.back(), node.items[i]));
      }
    }
    return good;
  }
  std::string takes() const { return "all or a list of parts"; }
  Form form() const { return any_form({word_form({"all"}), list_form(PartNameValue{}.form())}); }

 private:
  static HistoryPoint whole_part(const std::string& name, const Node& node) {
    HistoryPoint point;
    point.name = point.part = name;
    point.place = node.spot.place;
    return point;
  }

  static bool read_part(const Reader& reader, const std::string& name, const Node& item,
                        std::vector<std::string>& parts) {
    std::string part;
    if (item.kind == Node::Kind::scalar && item.text == "all") {
      reader.refuse(item, name, "a name from parts");
      return false;
    }
    if (!PartNameValue{}.read(reader, name, item, part)) return false;
    if (std::find(parts.begin(), parts.end(), part) != parts.end()) {
      reader.error(item.spot, fmt::format("part '{}' is named twice in output.history.parts", part));
      return false;
    }
    parts.push_back(std::move(part));
    return true;
  }
};

const Keys<OutputDeck>& history_keys() {
  static const Keys<OutputDeck> keys = {
      may("every", &OutputDeck::history_every, NumberValue{not_negative}),
      group<OutputDeck>("nodes", PointsValue{false}),
      group<OutputDeck>("elements", PointsValue{true}),
      group<OutputDeck>("parts", PartsValue{}),
      may("forces", &OutputDeck::forces, ListValue<ForceValue>{}),
  };
  return keys;
}

bool check_history(const Reader& reader, const Node& node, OutputDeck& output) {
  if (!output.history_every) output.history_every = 0;  // the section is there: every step
  std::set<std::string_view> names;
  for (const HistoryPoint& point : output.points) {
    if (names_parts(point) || names.insert(point.name).second) continue;  // columns of parts end with their name
    reader.error(point.place.line > 0 ? Spot{point.place, -1} : node.key,
                 fmt::format("name '{}' is given twice in {} (columns of history.csv need different names)", point.name,
                             reader.self()));
    return false;
  }
  return true;
}

const Keys<OutputDeck>& checkpoint_keys() {
  static const Keys<OutputDeck> keys = {
      may("every", &OutputDeck::checkpoint_every, NumberValue{positive}),
      may("wall", &OutputDeck::checkpoint_wall, NumberValue{positive}),
  };
  return keys;
}

bool check_checkpoint(const Reader& reader, const Node& node, OutputDeck& output) {
  if (output.checkpoint_every || output.checkpoint_wall) return true;
  reader.error(node.spot, fmt::format("{} has neither every nor wall (one of them says when to write)", reader.self()));
  return false;
}

const Keys<OutputDeck>& output_keys() {
  static const Keys<OutputDeck> keys = {
      group<OutputDeck>("fields", MapValue<OutputDeck>{field_keys}),
      group<OutputDeck>("history", MapValue<OutputDeck>{history_keys, check_history}),
      group<OutputDeck>("checkpoint", MapValue<OutputDeck>{checkpoint_keys, check_checkpoint}),
  };
  return keys;
}

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

MapValue<OutputDeck> output_value() { return {output_keys}; }

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

std::string identify(const ForceDeck& force) {
  std::string text =
      fmt::format("{}:{}:{}>{}:{}:{}:{}", force.name, static_cast<int>(force.kind), fmt::join(force.on, "+"),
                  fmt::join(force.from, "+"), force.wall, force.where.name, force.part);
  if (force.where.inside)
    text += fmt::format(":{},{}", fmt::join((*force.where.inside)[0], ","), fmt::join((*force.where.inside)[1], ","));
  text += fmt::format(":{}:{}", fmt::join(force.point, ","), fmt::join(force.normal, ","));
  return force.about ? text + fmt::format(":{}", fmt::join(*force.about, ",")) : text;
}

std::optional<int> find_thickness_point(std::string_view field, std::string_view quantity) {
  if (field.substr(0, quantity.size()) != quantity) return std::nullopt;
  const std::string_view digits = field.substr(quantity.size());
  int point = 0;
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), point);
  if (error != std::errc() || end != digits.end()) return std::nullopt;
  return point;
}

const std::vector<std::string>& field_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = {"displacement",  "velocity",        "contact_force",  "contact_pressure",
                                    "mass",          "contact_rank",  // of nodes
                                    "stress",        "pressure",        "von_mises",      "equivalent_plastic_strain",
                                    "temperature",   "internal_energy", "alive",          "damage",  // of elements
                                    "stress_bottom", "stress_top",      "thickness",                 // of shells
                                    "axial_force",   "section_force",   "section_moment",            // of beams
                                    "body",          "chunk",           "fe_rank"};
    for (const std::string_view quantity : {stress_points, plastic_strain_points}) {
      for (int point = 1; point <= most_thickness_points; ++point) all.push_back(fmt::format("{}{}", quantity, point));
    }
    return all;
  }();
  return names;
}

}  // namespace percuss
