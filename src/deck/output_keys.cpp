// Keys of `output`.

#include "src/deck/deck_keys.hpp"

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
};

const Keys<OutputDeck>& field_keys() {
  static const Keys<OutputDeck> keys = {
      need("every", &OutputDeck::fields_every, NumberValue{positive}),
      may("write", &OutputDeck::fields, FieldsValue{}),
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
  void list(const std::string& path, std::vector<DeckKey>& out) const { value().list(path, out); }
  static ListValue<MapValue<HistoryPoint>> value() { return {{point_keys, check_point}}; }
};

const Keys<OutputDeck>& history_keys() {
  static const Keys<OutputDeck> keys = {
      may("every", &OutputDeck::history_every, NumberValue{not_negative}),
      group<OutputDeck>("nodes", PointsValue{false}),
      group<OutputDeck>("elements", PointsValue{true}),
  };
  return keys;
}

bool check_history(const Reader& reader, const Node& node, OutputDeck& output) {
  if (!output.history_every) output.history_every = 0;  // the section is there: every step
  for (std::size_t i = 0; i < output.points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (output.points[i].name != output.points[j].name) continue;
      const Place place = output.points[i].place;
      reader.error(place.line > 0 ? Spot{place, -1} : node.key,
                   fmt::format("name '{}' is given twice in {} (columns of history.csv need different names)",
                               output.points[i].name, reader.self()));
      return false;
    }
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

}  // namespace

MapValue<OutputDeck> output_value() { return {output_keys}; }

const std::vector<std::string>& field_names() {
  static const std::vector<std::string> names = {
      "displacement",  "velocity",        "contact_force", "mass",
      "contact_rank",  // of nodes
      "stress",        "pressure",        "von_mises",     "equivalent_plastic_strain",
      "temperature",   "internal_energy", "alive",         "damage",  // of elements
      "stress_bottom", "stress_top",      "thickness",                // of shells
      "body",          "chunk",           "fe_rank"};
  return names;
}

}  // namespace percuss
