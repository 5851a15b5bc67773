// Keys of `output`.

#include <algorithm>
#include <set>
#include <string_view>

#include "kernels/shell/thickness_points.hpp"
#include "src/deck/asked_for.hpp"
#include "src/deck/sections/deck_keys.hpp"
#include "src/deck/sections/field_keys.hpp"
#include "src/deck/sections/force_keys.hpp"
#include "src/deck/sections/history_keys.hpp"

namespace percuss {
namespace {

Keys<HistoryPoint> make_point_keys() {
  return {
      need("name", &HistoryPoint::name, NameValue{}),
      may("near", &HistoryPoint::near, vector3()),
      may("id", &HistoryPoint::id, IntegerValue{1, std::numeric_limits<long>::max()}),
      may("part", &HistoryPoint::part, PartNameValue{}),
  };
}

const Keys<HistoryPoint>& node_keys() {
  static const Keys<HistoryPoint> keys = make_point_keys();
  return keys;
}

const Keys<HistoryPoint>& element_point_keys() {
  static const Keys<HistoryPoint> keys = [] {
    Keys<HistoryPoint> more = make_point_keys();
    more.push_back(may("point", &HistoryPoint::layer, IntegerValue{1, most_thickness_points}));
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

bool check_point(const Reader& reader, const Node& node, HistoryPoint& point) {
  point.place = node.spot.place;
  if (point.near.has_value() != point.id.has_value()) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have one of near and id)", reader.self(),
                                      point.near ? "both near and id" : "neither near nor id"));
  return false;
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
      may("accelerometers", &OutputDeck::accelerometers, accelerometers_value()),
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
      may("at_end", &OutputDeck::checkpoint_at_end, BooleanValue{}),
  };
  return keys;
}

bool check_checkpoint(const Reader& reader, const Node& node, OutputDeck& output) {
  if (output.checkpoint_every || output.checkpoint_wall || node.find("at_end") != nullptr) return true;
  reader.error(node.spot, fmt::format("{} has none of every, wall and at_end (they say when to write)", reader.self()));
  return false;
}

const Keys<OutputDeck>& output_keys() {
  static const Keys<OutputDeck> keys = {
      may("fields", &OutputDeck::fields, fields_value()),
      may("field_outputs", &OutputDeck::field_outputs, field_outputs_value()),
      group<OutputDeck>("history", MapValue<OutputDeck>{history_keys, check_history}),
      group<OutputDeck>("checkpoint", MapValue<OutputDeck>{checkpoint_keys, check_checkpoint}),
  };
  return keys;
}

}  // namespace

MapValue<OutputDeck> output_value() { return {output_keys}; }

}  // namespace percuss
