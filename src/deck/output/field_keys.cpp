#include "src/deck/output/field_keys.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "kernels/shell/thickness_points.hpp"
#include "src/deck/laws/laminates.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/output/force_keys.hpp"

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
  static ChoiceValue<FieldsFormat> choice() { return {{fields_formats.begin(), fields_formats.end()}}; }
};

/// A part, a side or a list of these; all: every exterior face.
struct FacesValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<Selector>& out) const {
    if (node.kind != Node::Kind::list) {
      Selector faces;
      if (!SelectorValue{Chosen::faces}.read(reader, name, node, faces)) return false;
      out.push_back(std::move(faces));
      return true;
    }
    if (node.items.empty()) {
      reader.refuse(node, name, "at least one part or surface");
      return false;
    }
    return ListValue<SelectorValue>{{Chosen::faces}}.read(reader, name, node, out);
  }
  std::string takes() const { return "a selector of faces or a list of these"; }
  Form form() const { return any_form({SelectorValue{}.form(), list_form(SelectorValue{}.form(), 1)}); }
};

const Keys<FieldsDeck>& field_keys() {
  static const Keys<FieldsDeck> keys = {
      need("every", &FieldsDeck::every, NumberValue{positive}),
      may("write", &FieldsDeck::write, FieldsValue{}),
      may("before_failure", &FieldsDeck::before_failure, IntegerValue{1, 1000000}),
      may("format", &FieldsDeck::formats, FormatsValue{}),
  };
  return keys;
}

const Keys<FieldsDeck>& region_keys() {
  static const Keys<FieldsDeck> keys = [] {
    Keys<FieldsDeck> more = field_keys();
    more.push_back(may("elements", &FieldsDeck::elements, ElementSetsValue{}));
    more.push_back(may("faces", &FieldsDeck::faces, FacesValue{}));
    return more;
  }();
  return keys;
}

bool check_region(const Reader& reader, const Node& node, FieldsDeck& fields) {
  constexpr std::size_t longest_name = 64;  // of which names of files are made
  if (fields.name.size() > longest_name) {
    reader.error(node.key, fmt::format("the name of {} has {} characters (at most {}: files are named by it)",
                                       reader.self(), fields.name.size(), longest_name));
    return false;
  }
  if (fields.elements.empty() || fields.faces.empty()) return true;
  reader.error(node.find("faces")->key,
               fmt::format("{} has both elements and faces (must have one of them at most)", reader.self()));
  return false;
}

/// Points of the shells of a part; of one that does not say: what is not elastic yields, where shells know it.
int find_points(const Deck& deck, const PartDeck& part) {
  const auto material = std::find_if(deck.materials.begin(), deck.materials.end(),
                                     [&](const MaterialDeck& of) { return of.name == part.material; });
  const int asked = part.is_membrane() ? 1 : part.points.value_or(0);
  if (!part.plies.empty()) {
    const auto plies = static_cast<int>(part.plies.size());
    return plies * count_points_of_ply(part.plies.size(), asked);
  }
  const bool yields = material == deck.materials.end() || find_traits(*material).has_plastic_strain;
  return count_points_of_ply(1, asked, yields);
}

/// Most points that a shell of a part can have.
int find_most_points(const Deck& deck) {
  int most = 0;
  for (const PartDeck& part : deck.parts) {
    if (part.has_thickness()) most = std::max(most, find_points(deck, part));
    if (is_shell_shape(part.shape) && !part.has_thickness()) return most_thickness_points;  // which is reported already
  }
  return most;
}

/// Its entry in the deck.
const Node& find_entry(const FieldsDeck& fields, const Node& root) {
  const Node& output = *root.find("output");
  return fields.name.empty() ? *output.find("fields") : *output.find("field_outputs")->find(fields.name);
}

/// A point of shells that no part can have.
void check_points(const FieldsDeck& fields, const Node& root, int most, Reading& reading) {
  for (const std::string& field : fields.write) {
    int point = 0;
    for (const std::string_view quantity : point_quantities)
      point = std::max(point, find_field_number(field, quantity).value_or(0));
    if (point <= most) continue;
    const std::vector<Node>& items = find_entry(fields, root).find("write")->items;
    const auto item = std::find_if(items.begin(), items.end(), [&](const Node& node) { return node.text == field; });
    const std::string text = most == 0
                                 ? "(no part has shells)"
                                 : fmt::format("(shells have at most {} points): set parts.NAME.points for more", most);
    reading.errors.add(item->spot, fmt::format("{}.write has {} {}", fields.key(), field, text));
  }
}

void check_frames(const Deck& deck, const FieldsDeck& fields, const Node& root, Reading& reading) {
  constexpr double most_frames = 1e6;
  if (deck.time.end / *fields.every <= most_frames) return;
  reading.errors.add(
      find_entry(fields, root).find("every")->spot,
      fmt::format("{}.every is {} (it would write {:.3g} frames by time.end, {}; at most {:.0f})", fields.key(),
                  *fields.every, deck.time.end / *fields.every, deck.time.end, most_frames));
}

}  // namespace

MapValue<FieldsDeck> fields_value() { return {field_keys}; }

NamedMapValue<FieldsDeck, MapValue<FieldsDeck>> field_outputs_value() {
  return {"field output", {region_keys, check_region}};
}

void check_fields(const Deck& deck, const Node& root, Reading& reading) {
  const bool knows_points = !deck.parts.empty() && reading.shapeless.empty();
  for (const FieldsDeck* const fields : deck.output.list_fields()) {
    if (knows_points) check_points(*fields, root, find_most_points(deck), reading);
    check_frames(deck, *fields, root, reading);
  }
}

std::optional<int> find_field_number(std::string_view field, std::string_view quantity) {
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
                                    "temperature",   "internal_energy", "alive",          "damage",
                                    "void_fraction",  // of elements
                                    "stress_bottom", "stress_top",      "thickness",      "fibre_damage",
                                    "matrix_damage",                                       // of shells
                                    "axial_force",   "section_force",   "section_moment",  // of beams
                                    "body",          "chunk",           "fe_rank"};
    for (const std::string_view quantity : point_quantities) {
      for (int point = 1; point <= most_layers; ++point) all.push_back(fmt::format("{}{}", quantity, point));
    }
    for (int i = 1; i <= most_state_variables; ++i) all.push_back(fmt::format("{}{}", state_variables, i));
    return all;
  }();
  return names;
}

}  // namespace percuss
