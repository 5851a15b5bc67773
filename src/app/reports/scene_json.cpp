#include "src/app/reports/scene_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "kernels/core/host_copy.hpp"
#include "src/app/reports/plan_estimate.hpp"
#include "src/deck/asked_for.hpp"
#include "src/index.hpp"
#include "src/mesh/surface_nodes.hpp"
#include "src/output/warning_json.hpp"
#include "src/step/model/followed_points.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_nodes = 4000;

/// Entries of a deck that select something, in its order.
class SelectionList {
 public:
  SelectionList(const Deck& deck, const Mesh& mesh) : deck_(deck), mesh_(mesh) {}

  void add_nodes(const std::string& key, const std::string& what, const Selector& where) {
    add(key, what, where, select_nodes(mesh_, deck_, where));
  }
  void add_faces(const std::string& key, const std::string& what, const Selector& where) {
    add(key, what, where, select_surface_nodes(mesh_, deck_, where).nodes);
  }
  /// The node of a point, which may be anywhere in the mesh.
  void add_point(const std::string& key, const std::string& what, const HistoryPoint& point, int node) {
    Selector where;
    where.name = point.id ? fmt::format("node {}", *point.id) : "the nearest node";
    where.place = point.place;
    add(key, what, where, {node});
  }
  Json take() { return std::move(list_); }

 private:
  void add(const std::string& key, const std::string& what, const Selector& where, const std::vector<int>& nodes) {
    Json numbers = Json::array();
    const std::size_t stride = std::max<std::size_t>(1, (nodes.size() + most_nodes - 1) / most_nodes);
    for (std::size_t i = 0; i < nodes.size(); i += stride) numbers.push_back(mesh_.node_numbers[at(nodes[i])]);
    list_.push_back({{"key", key},
                     {"what", what},
                     {"where", where.name.empty() ? "the whole mesh" : where.name},
                     {"place", deck_.where(where.place)},
                     {"count", nodes.size()},
                     {"nodes", std::move(numbers)}});
  }

  const Deck& deck_;
  const Mesh& mesh_;
  Json list_ = Json::array();
};

/// "fixed x, y": the directions of a condition or of a load.
std::string name_directions(const std::string& what, const std::array<bool, 6>& active) {
  std::string text = what;
  for (std::size_t d = 0; d < direction_names.size(); ++d) {
    if (active[d]) text += fmt::format("{} {}", text == what ? "" : ",", direction_names[d]);
  }
  return text;
}

std::string name_kind(ConditionDeck::Kind kind) {
  switch (kind) {
    case ConditionDeck::Kind::fixed:
      return "fixed";
    case ConditionDeck::Kind::symmetry:
      return "symmetry";
    case ConditionDeck::Kind::velocity:
      return "velocity";
    case ConditionDeck::Kind::displacement:
      return "displacement";
    case ConditionDeck::Kind::turn:
      return "turn";
  }
  return "";
}

template <class Items, class Add>
void add_each(const char* list, const Items& items, const Add& add) {
  for (std::size_t i = 0; i < items.size(); ++i) add(fmt::format("{}.{}", list, i), items[i]);
}

const std::array<SpringEndDeck, 2>* find_ends(const ConstraintDeck& entry) {
  return entry.between ? &*entry.between : nullptr;
}
template <class Entry>
const std::array<SpringEndDeck, 2>* find_ends(const Entry& entry) {
  return &entry.between;
}

/// Ends of springs, welds or constraints. kind: "spring" and so on.
template <class Entries>
void list_ends(const std::string& kind, const Entries& entries, const Deck& deck, const ChunkedMesh& chunked,
               SelectionList& list) {
  std::vector<HistoryPoint> points;  // found together, since each search looks at the whole mesh
  for (const auto& entry : entries)
    for (std::size_t i = 0; find_ends(entry) != nullptr && i < 2; ++i)
      if (const auto& end = (*find_ends(entry))[i]; end.point) points.push_back(*end.point);
  const std::vector<FollowedPoint> found = find_points(deck, chunked, points, "end of " + kind);
  std::size_t next = 0;
  for (const auto& entry : entries) {
    for (std::size_t i = 0; find_ends(entry) != nullptr && i < 2; ++i) {
      const SpringEndDeck& end = (*find_ends(entry))[i];
      const std::string key = fmt::format("{}s.{}.between.{}", kind, entry.name, i);
      if (end.point)
        list.add_point(key, kind, *end.point, found[next++].index);
      else
        list.add_nodes(key, kind, end.where);
    }
  }
}

/// Nodes that are not ends of pairs.
void list_constraints(const Deck& deck, const ChunkedMesh& chunked, SelectionList& list) {
  for (const ConstraintDeck& constraint : deck.constraints) {
    const std::string key = "constraints." + constraint.name;
    if (constraint.nodes) list.add_nodes(key, "constraint", *constraint.nodes);
    for (std::size_t i = 0; i < constraint.equation.size(); ++i) {
      const SpringEndDeck& of = constraint.equation[i].of;
      const std::string term = fmt::format("{}.equation.{}", key, i);
      if (of.point)
        list.add_point(term, "constraint", *of.point,
                       find_points(deck, chunked, {*of.point}, "end of constraint").front().index);
      else
        list.add_nodes(term, "constraint", of.where);
    }
  }
}

void list_contact(const ContactDeck& contact, SelectionList& list) {
  add_each("contact.pairs", contact.pairs, [&](const std::string& key, const SurfacePairDeck& pair) {
    list.add_faces(key + ".a", "contact pair", pair.a);
    list.add_faces(key + ".b", "contact pair", pair.b);
  });
  add_each("contact.friction.pairs", contact.frictions, [&](const std::string& key, const PairFrictionDeck& pair) {
    const std::string what = fmt::format("contact friction {:g}", pair.friction);
    list.add_faces(key + ".a", what, pair.a);
    if (pair.b) list.add_faces(key + ".b", what, *pair.b);
  });
  add_each("ties", contact.ties, [&](const std::string& key, const TieDeck& tie) {
    list.add_faces(key + ".a", "tied nodes", tie.a);
    list.add_faces(key + ".b", "tied faces", tie.b);
  });
}

Json list_field_outputs(const SceneReport& scene) {
  Json list = Json::array();
  for (const FieldOutputSize& of : scene.field_outputs)
    list.push_back({{"name", of.name}, {"elements", of.elements}, {"nodes", of.nodes}});
  return list;
}

Json list_selections(const Deck& deck, const ChunkedMesh& chunked) {
  SelectionList list(deck, chunked.mesh);
  add_each("initial", deck.initial, [&](const std::string& key, const InitialDeck& initial) {
    list.add_nodes(key, "initial velocity", initial.where);
  });
  add_each("conditions", deck.conditions, [&](const std::string& key, const ConditionDeck& condition) {
    list.add_nodes(key, name_directions(name_kind(condition.kind), condition.active), condition.where);
  });
  add_each("pressures", deck.pressures, [&](const std::string& key, const PressureDeck& pressure) {
    list.add_faces(key, "pressure", pressure.where);
  });
  add_each("nodal_loads", deck.nodal_loads, [&](const std::string& key, const NodalLoadDeck& load) {
    list.add_nodes(key, name_directions("load", load.active), load.where);
  });
  add_each("damping", deck.dampings,
           [&](const std::string& key, const DampingDeck& damping) { list.add_nodes(key, "damping", damping.where); });
  add_each("added_mass", deck.added_masses,
           [&](const std::string& key, const AddedMassDeck& added) { list.add_nodes(key, "added mass", added.where); });
  for (const RigidSetDeck& set : deck.rigid_sets) list.add_nodes("rigid_sets." + set.name, "rigid set", set.where);
  list_ends("spring", deck.springs, deck, chunked, list);
  list_ends("weld", deck.welds, deck, chunked, list);
  list_ends("constraint", deck.constraints, deck, chunked, list);
  list_constraints(deck, chunked, list);
  for (const EmbeddedDeck& embedded : deck.embedded)
    list.add_nodes("embedded." + embedded.name, "embedded nodes", embedded.nodes);
  list_contact(deck.contact, list);
  return list.take();
}

Json list_parts(const SceneReport& scene, const ChunkedMesh& chunked, const ChunkResults& results) {
  const auto bounds = to_host(results.stable_step);
  const auto elements = to_host(results.controlling_element);
  std::vector<double> steps(scene.parts.size(), std::numeric_limits<double>::infinity());
  std::vector<int> controlling(scene.parts.size(), -1);
  for (std::size_t c = 0; c < bounds.extent(0); ++c) {
    const std::size_t part = at(chunked.chunks[c].part);
    if (bounds(c) >= steps[part]) continue;
    steps[part] = bounds(c);
    controlling[part] = elements(c);
  }
  Json list = Json::array();
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    const PartReport& part = scene.parts[p];
    const std::string element = controlling[p] < 0 ? "" : name_element(chunked.mesh, controlling[p]);
    list.push_back({{"name", part.name},
                    {"material", part.material},
                    {"elements", part.elements},
                    {"nodes", part.nodes},
                    {"mass", part.mass},
                    {"step", steps[p] * scene.deck.time.step_scale},
                    {"controlling_element", element}});
  }
  return list;
}

Json describe(const StartOverlap& overlap, const Mesh& mesh, const Deck& deck) {
  const auto name = [&](int part) {
    if (part >= 0) return mesh.parts[at(part)].name;
    const std::string& wall = deck.walls[at(-1 - part)].name;
    return wall.empty() ? fmt::format("walls.{}", -1 - part) : wall;
  };
  Json parts = Json::array(), gaps = Json::array();
  for (const PartOverlap& p : overlap.parts) {
    parts.push_back({{"part", name(p.part)}, {"inside", name(p.other)}, {"nodes", p.nodes}, {"deepest", p.deepest}});
  }
  for (const PartGap& gap : overlap.gaps) {
    gaps.push_back({{"part", name(gap.part)}, {"other", name(gap.other)}, {"gap", gap.gap}});
  }
  constexpr const char* contact_names[] = {"never", "later", "now"};
  Json crossings = Json::array();
  for (const PartCrossing& of : overlap.crossings)
    if (of.is_deep())
      crossings.push_back({{"part", name(of.part)},
                           {"other", name(of.other)},
                           {"contact", contact_names[static_cast<int>(of.contact)]},
                           {"depth", of.depth},
                           {"at", of.deepest},
                           {"places", of.places}});
  std::vector<std::int64_t> inside = overlap.inside;
  std::sort(inside.begin(), inside.end());
  inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
  return {{"nodes", inside},
          {"too_deep", overlap.too_deep},
          {"deepest", overlap.deepest},
          {"edge_pairs", overlap.edge_pairs},
          {"deepest_edges", overlap.deepest_edges},
          {"parts", std::move(parts)},
          {"gaps", std::move(gaps)},
          {"crossings", std::move(crossings)}};
}

Json list_walls(const Deck& deck) {
  Json list = Json::array();
  for (const WallDeck& wall : deck.walls) {
    Json round = Json::object();  // what planes have not
    if (wall.cylinder)
      round = {{"axis", wall.cylinder->axis},
               {"radius", wall.cylinder->radius},
               {"length", wall.cylinder->length ? Json(*wall.cylinder->length) : Json()}};
    if (wall.sphere) round = {{"radius", wall.sphere->radius}};
    list.push_back({{"name", wall.name},
                    {"shape", wall.cylinder ? "cylinder"
                              : wall.sphere ? "sphere"
                                            : "plane"},
                    {"point", wall.point},
                    {"normal", wall.normal},
                    {"friction", wall.friction},
                    {"place", deck.where(wall.place)}});
    list.back().update(round);
  }
  return list;
}

}  // namespace

std::string format_scene_json(const SceneReport& scene, const ChunkedMesh& chunked, const StartOverlap& overlap,
                              const ChunkResults& results) {
  const Deck& deck = scene.deck;
  std::vector<std::string> notes = scene.mesh_notes;
  notes.insert(notes.end(), scene.contact_notes.begin(), scene.contact_notes.end());
  double mass = 0;
  for (const PartReport& part : scene.parts) mass += part.mass;
  const Json json = {{"deck", deck.file},
                     {"title", deck.title},
                     {"units", deck.units},
                     {"elements", scene.elements},
                     {"nodes", scene.nodes},
                     {"bodies", scene.bodies},
                     {"contact_nodes", scene.contact_nodes},
                     {"contact_faces", scene.contact_faces},
                     {"mass", mass},
                     {"total_mass", scene.total_mass},
                     {"low", scene.low},
                     {"high", scene.high},
                     {"end", deck.time.end},
                     {"first_step", scene.first_step},
                     {"controlling_element", scene.controlling_element},
                     {"steps", count_steps(deck.time, scene.first_step)},
                     {"parts", list_parts(scene, chunked, results)},
                     {"joints", scene.joints},
                     {"notes", notes},
                     {"selections", list_selections(deck, chunked)},
                     {"walls", list_walls(deck)},
                     {"field_outputs", list_field_outputs(scene)},
                     {"columns", Json::parse(format_columns(scene.columns, deck.units))["columns"]},
                     {"values", Json::parse(deck.resolved)},
                     {"overlap", describe(overlap, chunked.mesh, deck)},
                     {"warnings", to_json(scene.warnings)}};
  return json.dump(1, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace percuss
