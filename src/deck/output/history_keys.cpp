#include "src/deck/output/history_keys.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "kernels/element/hex8/hex_record.hpp"
#include "kernels/shell/thickness_points.hpp"
#include "src/deck/asked_for.hpp"
#include "src/deck/keys/point_keys.hpp"
#include "src/deck/output/force_keys.hpp"

namespace percuss {
namespace {

/// Points with a stress of their own that any element has: plies of shells, or those of a thick shell.
constexpr int most_element_points =
    std::max({most_thickness_points, most_layers, hex_points<HexKind::full>, hex_points<HexKind::thick5>});

Keys<HistoryPoint> make_point_keys() {
  Keys<HistoryPoint> keys = {need("name", &HistoryPoint::name, NameValue{})};
  for (const AnyKey& key : point_keys()) keys.push_back(key);
  return keys;
}

const Keys<HistoryPoint>& node_keys() {
  static const Keys<HistoryPoint> keys = make_point_keys();
  return keys;
}

const Keys<HistoryPoint>& element_point_keys() {
  static const Keys<HistoryPoint> keys = [] {
    Keys<HistoryPoint> more = make_point_keys();
    more.push_back(may("point", &HistoryPoint::layer, IntegerValue{1, most_element_points}));
    return more;
  }();
  return keys;
}

const Keys<HistoryPoint>& material_point_keys() {
  static const Keys<HistoryPoint> keys = {
      need("name", &HistoryPoint::name, NameValue{}),
      need("at", &HistoryPoint::near, vector3()),
      may("part", &HistoryPoint::part, PartNameValue{}),
  };
  return keys;
}

bool check_material_point(const Reader&, const Node& node, HistoryPoint& point) {
  point.place = node.spot.place;
  return true;
}

/// history.nodes, history.elements or history.points.
struct PointsValue {
  enum class Kind { nodes, elements, inside } kind;

  bool read(const Reader& reader, const std::string& name, const Node& node, OutputDeck& out) const {
    std::vector<HistoryPoint> points;
    const bool good = value().read(reader, name, node, points);
    for (HistoryPoint& point : points) {
      point.is_element = kind == Kind::elements;
      point.is_inside = kind == Kind::inside;
      out.points.push_back(std::move(point));
    }
    return good;
  }
  std::string takes() const { return value().takes(); }
  Form form() const { return value().form(); }
  ListValue<MapValue<HistoryPoint>> value() const {
    if (kind == Kind::inside) return {{material_point_keys, check_material_point}};
    return {{kind == Kind::elements ? element_point_keys : node_keys, check_point}};
  }
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

/// Parts by name, each once.
struct MotionPartsValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<std::string>& out) const {
    if (node.kind == Node::Kind::scalar && node.text == "all") {
      out = {"all"};
      return true;
    }
    if (!reader.expect(node, Node::Kind::list, name, takes())) return false;
    bool good = true;
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      std::string part;
      if (!PartNameValue{}.read(reader, fmt::format("{}.{}", name, i), node.items[i], part)) {
        good = false;
      } else if (part.empty() || std::find(out.begin(), out.end(), part) != out.end()) {
        reader.refuse(node.items[i], fmt::format("{}.{}", name, i), "a name from parts, each once");
        good = false;
      } else {
        out.push_back(part);
      }
    }
    return good;
  }
  std::string takes() const { return "all or a list of parts"; }
  Form form() const { return any_form({word_form({"all"}), list_form(PartNameValue{}.form())}); }
};

/// Names of element blocks and element sets, each once.
struct BlocksValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<Selector>& out) const {
    if (!reader.expect(node, Node::Kind::list, name, takes())) return false;
    if (node.items.empty()) {
      reader.refuse(node, name, "at least one element block or element set");
      return false;
    }
    bool good = true;
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const Node& item = node.items[i];
      if (item.kind != Node::Kind::scalar || item.text.empty() || item.text == "all") {
        reader.refuse(item, fmt::format("{}.{}", name, i), "the name of an element block or an element set");
        good = false;
      } else if (std::any_of(out.begin(), out.end(), [&](const Selector& other) { return other.name == item.text; })) {
        reader.error(item.spot, fmt::format("block '{}' is named twice in {}", item.text, name));
        good = false;
      } else {
        reader.reading().selectors.push_back({item.spot, item.text, fmt::format(" in {}", name)});
        out.push_back({item.text, {}, item.spot.place});
        reader.reading().used_selectors.push_back({out.back(), Chosen::elements});
      }
    }
    return good;
  }
  std::string takes() const { return "a list of element blocks or element sets"; }
  Form form() const { return list_form(Form::Kind::text, 1); }
};

const Keys<AccelerometerDeck>& accelerometer_keys() {
  using Weight = AccelerometerDeck::Weight;
  static const Keys<AccelerometerDeck> keys = {
      need("name", &AccelerometerDeck::name, NameValue{}),
      need("nodes", &AccelerometerDeck::nodes, ListValue<NameValue>{}),
      may("gravity", &AccelerometerDeck::gravity,
          ChoiceValue<Weight>{{{"keep", Weight::keep}, {"remove", Weight::remove}}}),
  };
  return keys;
}

bool check_accelerometer(const Reader& reader, const Node& node, AccelerometerDeck& out) {
  out.place = node.spot.place;
  const std::set<std::string_view> different(out.nodes.begin(), out.nodes.end());
  if (out.nodes.size() == 3 && different.size() == 3) return true;
  reader.refuse(*node.find("nodes"), reader.name_of("nodes"), "three different names of output.history.nodes");
  return false;
}

const Keys<OutputDeck>& history_keys() {
  static const Keys<OutputDeck> keys = {
      may("every", &OutputDeck::history_every, NumberValue{not_negative}),
      group<OutputDeck>("nodes", PointsValue{PointsValue::Kind::nodes}),
      group<OutputDeck>("elements", PointsValue{PointsValue::Kind::elements}),
      group<OutputDeck>("points", PointsValue{PointsValue::Kind::inside}),
      group<OutputDeck>("parts", PartsValue{}),
      may("motion", &OutputDeck::motions, MotionPartsValue{}),
      may("blocks", &OutputDeck::blocks, BlocksValue{}),
      may("forces", &OutputDeck::forces, ListValue<ForceValue>{}),
      may("accelerometers", &OutputDeck::accelerometers,
          ListValue<MapValue<AccelerometerDeck>>{{accelerometer_keys, check_accelerometer}}),
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

}  // namespace

MapValue<OutputDeck> history_value() { return {history_keys, check_history}; }

void check_blocks(const Deck& deck, Reading& reading) {
  for (const Selector& block : deck.output.blocks) {
    if (std::none_of(deck.parts.begin(), deck.parts.end(), [&](const auto& part) { return part.name == block.name; }))
      continue;
    reading.errors.add({block.place, -1},
                       fmt::format("output.history.blocks names the part '{}' (must be an element block or an element "
                                   "set): name it in output.history.parts",
                                   block.name));
  }
}

void check_accelerometers(const Deck& deck, Reading& reading) {
  std::vector<std::string> nodes;
  for (const HistoryPoint& point : deck.output.points)
    if (!point.is_element && !point.is_inside && (point.near || point.id)) nodes.push_back(point.name);
  std::set<std::string_view> names;
  for (const AccelerometerDeck& one : deck.output.accelerometers) {
    const Spot spot{one.place, -1};
    if (!names.insert(one.name).second)
      reading.errors.add(spot, fmt::format("name '{}' is given twice in output.history.accelerometers", one.name));
    for (const std::string& node : one.nodes)
      if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
        reading.errors.add(spot, fmt::format("accelerometer '{}' has the node '{}' (must be a name of "
                                             "output.history.nodes){}",
                                             one.name, node, name_hint(node, nodes)));
  }
}

}  // namespace percuss
