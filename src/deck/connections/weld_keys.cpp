#include "src/deck/connections/weld_keys.hpp"

#include <algorithm>
#include <cmath>

#include "src/deck/connections/spring_end_value.hpp"
#include "src/deck/keys/file_value.hpp"
#include "src/deck/keys/strength_keys.hpp"

namespace percuss {
namespace {

const Keys<WeldDeck>& weld_failure_keys() {
  static const Keys<WeldDeck> keys = [] {
    Keys<WeldDeck> all = strength_keys<WeldDeck>();
    all.push_back(may("time", &WeldDeck::time, NumberValue{not_negative}));
    return all;
  }();
  return keys;
}

/// One place, or several.
struct PlacesValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<Vec3>& out) const {
    const bool is_list = node.kind == Node::Kind::list && !node.items.empty() && node.items[0].kind == Node::Kind::list;
    if (is_list) return ListValue<TupleValue<NumberValue, 3>>{vector3()}.read(reader, name, node, out);
    Vec3 place{};
    if (!vector3().read(reader, name, node, place)) return false;
    out = {place};
    return true;
  }
  std::string takes() const { return "a list of 3, each a number, or a list of these"; }
  Form form() const { return any_form({vector3().form(), list_form(vector3().form(), 1)}); }
};

const Keys<WeldDeck>& weld_keys() {
  static const Keys<WeldDeck> keys = {
      need("between", &WeldDeck::between, TupleValue<SpringEndValue, 2>{}),
      may("at", &WeldDeck::at, PlacesValue{}),
      may("from", &WeldDeck::from, vector3()),
      may("to", &WeldDeck::to, vector3()),
      may("pitch", &WeldDeck::pitch, NumberValue{positive}),
      may("file", &WeldDeck::file, FileValue{}),
      may("radius", &WeldDeck::radius, NumberValue{positive}),
      may("normal", &WeldDeck::normal, DirectionValue{}),
      group<WeldDeck>("failure", MapValue<WeldDeck>{weld_failure_keys, check_strengths<WeldDeck>}),
  };
  return keys;
}

/// Most welds of a row: a pitch in other units than the places would make more.
constexpr double most_in_row = 10000;

/// Fills weld.at: even distances of at most the pitch, the first and the last at the ends.
bool fill_row(const Reader& reader, const Node& node, WeldDeck& weld) {
  for (const char* key : {"from", "to", "pitch"}) {
    if (node.find(key) != nullptr) continue;
    reader.error(node.spot, fmt::format("{} is missing{} (a row of welds has from, to and pitch)", reader.name_of(key),
                                        reader.in()));
    return false;
  }
  const Vec3 &a = *weld.from, &b = *weld.to;
  const double length = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  const double spaces = std::max(1.0, std::ceil(length / *weld.pitch * (1 - 1e-9)));
  if (!(length > 0) || spaces >= most_in_row) {
    reader.error(node.find(length > 0 ? "pitch" : "to")->spot,
                 length > 0
                     ? fmt::format("{} is {:g}{} (the row of length {:g} would have {:.0f} welds): give a larger one",
                                   reader.name_of("pitch"), *weld.pitch, reader.in(), length, spaces + 1)
                     : fmt::format("{} is the same place as {}{} (a row has two ends): use at for one weld",
                                   reader.name_of("to"), reader.name_of("from"), reader.in()));
    return false;
  }
  for (double i = 0; i <= spaces; ++i) {
    Vec3& x = weld.at.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) x[k] = (a[k] * (spaces - i) + b[k] * i) / spaces;
  }
  return true;
}

/// The keys that say where welds are: none, or one way of these. Tells what does not go together.
bool check_weld_places(const Reader& reader, const Node& node, WeldDeck& weld) {
  const bool is_row = weld.from || weld.to || weld.pitch;
  const int ways = (weld.at.empty() ? 0 : 1) + (is_row ? 1 : 0) + (weld.file.empty() ? 0 : 1);
  if (ways > 1) {
    reader.error(node.spot, fmt::format("{} has places in several ways (must have one of at; from, to and pitch; file)",
                                        reader.self()));
    return false;
  }
  if (ways == 1 && !weld.radius && weld.file.empty()) {
    reader.error(node.find(is_row ? (weld.from ? "from"
                                     : weld.to ? "to"
                                               : "pitch")
                                  : "at")
                     ->key,
                 fmt::format("{} is missing{} (a weld at places holds the faces within a radius around each)",
                             reader.name_of("radius"), reader.in()));
    return false;
  }
  if (ways == 0 && weld.radius) {
    reader.error(node.find("radius")->key,
                 fmt::format("{} is missing{} (a weld at places holds the faces within a radius around each)",
                             reader.name_of("at"), reader.in()));
    return false;
  }
  return !is_row || fill_row(reader, node, weld);
}

/// A radius and places belong together, and have faces at their ends.
bool check_weld(const Reader& reader, const Node& node, WeldDeck& weld) {
  if (!check_weld_places(reader, node, weld)) return false;
  if (!weld.is_between_faces()) return true;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!weld.between[i].point) continue;
    reader.error(node.find("between")->items[i].spot,
                 fmt::format("{}.{} is a node (a weld with a radius is between faces): give a selector of faces",
                             reader.name_of("between"), i));
    return false;
  }
  return true;
}

}  // namespace

NamedMapValue<WeldDeck, MapValue<WeldDeck>> welds_value() { return {"weld", {weld_keys, check_weld}}; }

}  // namespace percuss
