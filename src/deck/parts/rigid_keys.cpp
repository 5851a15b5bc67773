#include "src/deck/parts/rigid_keys.hpp"

#include <algorithm>

#include "src/deck/rigid_bodies.hpp"
#include "src/deck/text/nearest_name.hpp"

namespace percuss {
namespace {

/// Translations and rotations of a body, each once.
struct FreedomsValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::array<bool, 6>& out) const {
    std::vector<std::size_t> held;
    if (!ListValue<ChoiceValue<std::size_t>>{direction()}.read(reader, name, node, held)) return false;
    for (const std::size_t k : held) out[k] = true;
    return true;
  }
  std::string takes() const { return "a list of directions: x, y, z, rx, ry, rz"; }
  Form form() const { return list_form(direction().form()); }

  static ChoiceValue<std::size_t> direction() {
    return {{{"x", 0}, {"y", 1}, {"z", 2}, {"rx", 3}, {"ry", 4}, {"rz", 5}}};
  }
};

const Keys<RigidDeck>& rigid_keys() {
  static const Keys<RigidDeck> keys = {
      may("body", &RigidDeck::body, NameValue{}),
      may("mass", &RigidDeck::mass, NumberValue{positive}),
      may("center", &RigidDeck::center, vector3()),
      may("inertia", &RigidDeck::inertia, TupleValue<NumberValue, 6>{}),
      may("fixed", &RigidDeck::fixed, FreedomsValue{}),
  };
  return keys;
}

/// Checks that real masses can have the tensor: it is positive definite, and no moment of inertia exceeds the sum of
/// the others.
template <class Rigid>
bool check_inertia(const Reader& reader, const Node& node, Rigid& rigid) {
  if (!rigid.inertia || is_inertia_of_masses(*rigid.inertia)) return true;
  reader.error(node.find("inertia")->spot,
               fmt::format("{} is not a valid inertia tensor{} (xx, yy, zz, xy, yz, zx must be positive definite, and "
                           "each principal moment at most the sum of the others)",
                           reader.name_of("inertia"), reader.in()));
  return false;
}

const Keys<RigidSetDeck>& rigid_set_keys() {
  static const Keys<RigidSetDeck> keys = {
      need("nodes", &RigidSetDeck::where, SelectorValue{Chosen::nodes}),
      may("body", &RigidSetDeck::body, NameValue{}),
      may("mass", &RigidSetDeck::mass, NumberValue{positive}),
      may("center", &RigidSetDeck::center, vector3()),
      may("inertia", &RigidSetDeck::inertia, TupleValue<NumberValue, 6>{}),
      may("node_masses", &RigidSetDeck::counts_nodes, ChoiceValue<bool>{{{"count", true}, {"ignore", false}}}),
      may("fixed", &RigidSetDeck::fixed, FreedomsValue{}),
  };
  return keys;
}

/// Sets that name a body which is none, or that have the name of another.
void check_rigid_sets(const Deck& deck, const Node& root, Reading& reading) {
  const RigidNames names = name_rigid_bodies(deck);
  const Node* sets = root.find("rigid_sets");
  for (std::size_t s = 0; s < deck.rigid_sets.size(); ++s) {
    const RigidSetDeck& set = deck.rigid_sets[s];
    const Node* node = sets->find(set.name);
    if (names.body_of_set[s] < 0) {
      const auto part =
          std::find_if(deck.parts.begin(), deck.parts.end(), [&](const PartDeck& p) { return p.name == set.body; });
      const std::string why = part == deck.parts.end() ? name_hint(set.body, names.bodies) : " (that part deforms)";
      reading.errors.add(node->find("body")->spot,
                         fmt::format("rigid_sets.{}.body is '{}', which is no rigid body{}", set.name, set.body, why));
    }
    if (set.body.empty() && std::count(names.bodies.begin(), names.bodies.end(), set.name) > 1) {
      reading.errors.add(node->key, fmt::format("rigid set '{}' has the name of another rigid body (it would be one "
                                                "of its own): choose another name, or join it with body: {}",
                                                set.name, set.name));
    }
  }
}

/// A body whose nodes do not count has its mass from the deck.
void check_ignored_masses(const Deck& deck, const Node& root, Reading& reading) {
  for (const RigidSetDeck& set : deck.rigid_sets) {
    if (set.counts_nodes || !set.body.empty() || (set.mass > 0 && set.center && set.inertia)) continue;
    reading.errors.add(root.find("rigid_sets")->find(set.name)->find("node_masses")->key,
                       fmt::format("rigid set '{}' ignores the masses of its nodes (then it is a body without mass): "
                                   "give mass, center and inertia",
                                   set.name));
  }
}

/// Values that several parts of one body give.
void check_merged(const Deck& deck, const Node& parts, Reading& reading) {
  const RigidNames names = name_rigid_bodies(deck);
  for (const char* key : {"mass", "center", "inertia"}) {
    std::vector<int> giver(names.bodies.size(), -1);
    for (std::size_t p = 0; p < deck.parts.size(); ++p) {
      if (names.body_of_part[p] < 0) continue;
      const Node* const own = parts.find(deck.parts[p].name);  // null: an image of a part, which gives none
      const Node* const given = own == nullptr ? nullptr : own->find("rigid")->find(key);
      int& first = giver[static_cast<std::size_t>(names.body_of_part[p])];
      if (given != nullptr && first >= 0) {
        reading.errors.add(given->spot,
                           fmt::format("rigid.{} is given again in part '{}' (part '{}' already gives that of body "
                                       "'{}'): leave one of them out",
                                       key, deck.parts[p].name, deck.parts[static_cast<std::size_t>(first)].name,
                                       names.bodies[static_cast<std::size_t>(names.body_of_part[p])]));
      }
      if (given != nullptr && first < 0) first = static_cast<int>(p);
    }
  }
}

}  // namespace

bool RigidValue::read(const Reader& reader, const std::string& name, const Node& node,
                      std::optional<RigidDeck>& out) const {
  RigidDeck rigid;
  rigid.place = node.spot.place;
  if (node.kind == Node::Kind::scalar && (node.text == "true" || node.text == "false")) {
    bool is_rigid = false;
    if (!BooleanValue{}.read(reader, name, node, is_rigid)) return false;
    if (is_rigid) out = rigid;
    return true;
  }
  if (node.kind != Node::Kind::map) {
    reader.refuse(node, name, takes());
    return false;
  }
  if (!MapValue<RigidDeck>{rigid_keys, check_inertia<RigidDeck>}.read(reader, name, node, rigid)) return false;
  out = rigid;
  return true;
}

Form RigidValue::form() const {
  return any_form({BooleanValue{}.form(), MapValue<RigidDeck>{rigid_keys, check_inertia<RigidDeck>}.form()});
}

void check_rigid(const Deck& deck, const Node& root, Reading& reading) {
  const Node* parts = root.find("parts");
  check_rigid_sets(deck, root, reading);
  check_ignored_masses(deck, root, reading);
  if (!deck.rigid_sets.empty() && deck.time.step_estimate == TimeDeck::StepEstimate::global) {
    reading.errors.add(root.find("time")->find("step_estimate")->spot,
                       "time.step_estimate is global (the global estimate does not support rigid_sets): leave it out");
  }
  const auto rigid =
      std::find_if(deck.parts.begin(), deck.parts.end(), [](const PartDeck& part) { return part.rigid.has_value(); });
  if (rigid == deck.parts.end()) return;
  for (const PartDeck& part : deck.parts) {
    if (!part.rigid || !part.mass_scaling || !part.images.empty()) continue;
    reading.errors.add(
        parts->find(part.name)->find("mass_scaling")->key,
        fmt::format("mass_scaling has no effect in part '{}' (it is rigid and does not limit the time step)",
                    part.name));
  }
  if (deck.time.step_estimate == TimeDeck::StepEstimate::global) {
    reading.errors.add(root.find("time")->find("step_estimate")->spot,
                       fmt::format("time.step_estimate is global (part '{}' is rigid, which the global estimate does "
                                   "not support): leave it out",
                                   rigid->name));
  }
  check_merged(deck, *parts, reading);
}

NamedMapValue<RigidSetDeck, MapValue<RigidSetDeck>> rigid_sets_value() {
  return {"rigid set", {rigid_set_keys, check_inertia<RigidSetDeck>}};
}

}  // namespace percuss
