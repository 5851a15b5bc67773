#include "src/deck/reading/check_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "src/deck/connections/joint_keys.hpp"
#include "src/deck/connections/turn_spring_keys.hpp"
#include "src/deck/keys/values.hpp"
#include "src/deck/loads/node_values.hpp"
#include "src/deck/loads/sensor_keys.hpp"
#include "src/deck/loads/start_keys.hpp"
#include "src/deck/mesh_size.hpp"
#include "src/deck/output/field_keys.hpp"
#include "src/deck/output/force_keys.hpp"
#include "src/deck/output/history_keys.hpp"
#include "src/deck/parts/element_keys.hpp"
#include "src/deck/parts/placement_keys.hpp"
#include "src/deck/parts/rigid_keys.hpp"

namespace percuss {
namespace {

template <class T>
std::vector<std::string> names_of(const std::vector<T>& things) {
  std::vector<std::string> names;
  names.reserve(things.size());
  for (const T& thing : things) names.push_back(thing.name);
  return names;
}

void check_materials(const Deck& deck, const Node& root, Reading& reading) {
  const std::vector<std::string> known = names_of(deck.materials);
  std::set<std::string> used;
  for (const NameUse& use : reading.materials) {
    used.insert(use.name);
    if (known.empty() || std::find(known.begin(), known.end(), use.name) != known.end()) continue;
    reading.errors.add(use.spot,
                       fmt::format("unknown material {}{}{}", quote(use.name), use.in, name_hint(use.name, known)));
  }
  const Node* materials = root.find("materials");
  for (const std::string& name : known) {
    if (used.count(name) == 0)
      reading.errors.warn(materials->find(name)->key, "unused_material",
                          fmt::format("material '{}' is used by no part", name));
  }
}

/// Checks laminates: the failure criteria of the part's material act in all plies; those of other materials are lost.
void check_plies(const Deck& deck, const Node& root, Reading& reading) {
  const Node* const parts = root.find("parts");
  for (const PartDeck& part : deck.parts) {
    const Node* const own = parts == nullptr ? nullptr : parts->find(part.name);  // none of an image of a part
    for (std::size_t i = 0; own != nullptr && i < part.plies.size(); ++i) {
      const std::string& name = part.plies[i].material;
      const auto material = std::find_if(deck.materials.begin(), deck.materials.end(),
                                         [&](const MaterialDeck& of) { return of.name == name; });
      if (material == deck.materials.end() || name == part.material || !material->failure) continue;
      reading.errors.warn(own->find("plies")->items[i].spot, "key_without_effect",
                          fmt::format("failure of material {} does nothing in plies.{} of part {} (that of the part's "
                                      "material acts in all plies)",
                                      quote(name), i, quote(part.name)));
    }
  }
}

void check_selector(const NameUse& use, const std::map<std::string, const PartDeck*>& parts, Reading& reading) {
  const auto slash = use.name.find('/');
  const std::string part_name = use.name.substr(0, slash);
  const auto part = parts.find(part_name);
  if (part == parts.end()) {
    if (std::any_of(parts.begin(), parts.end(), [](const auto& entry) { return !is_name(entry.first); })) return;
    const auto is_file = [](const auto& entry) { return std::holds_alternative<FileMesh>(entry.second->shape); };
    if (slash == std::string::npos && std::any_of(parts.begin(), parts.end(), is_file)) return;  // may be a set of it
    std::vector<std::string> known;
    known.reserve(parts.size());
    for (const auto& entry : parts) known.push_back(entry.first);
    reading.errors.add(use.spot,
                       fmt::format("unknown part {}{}{}", quote(part_name), use.in, name_hint(part_name, known)));
    return;
  }
  if (slash == std::string::npos || reading.shapeless.count(part_name) > 0) return;
  const std::string side = use.name.substr(slash + 1);
  const std::vector<std::string> sides = side_names(part->second->shape);
  if (sides.empty() && !side.empty()) return;  // sets of a mesh file are known when it is read
  if (std::find(sides.begin(), sides.end(), side) != sides.end()) return;
  reading.errors.add(
      use.spot, fmt::format("part '{}' has no side {}{}{}", part_name, quote(side), use.in, name_hint(side, sides)));
}

void check_selectors(const Deck& deck, Reading& reading) {
  if (deck.parts.empty()) return;
  std::map<std::string, const PartDeck*> parts;
  for (const PartDeck& part : deck.parts) parts.emplace(part.name, &part);
  for (const NameUse& use : reading.selectors) check_selector(use, parts, reading);
}

void check_size(const Deck& deck, const Node& root, Reading& reading) {
  MeshSize total;
  for (const PartDeck& part : deck.parts) {
    const MeshSize size = count_cells(part);
    if (size.elements > largest_mesh || size.nodes > largest_mesh) return;  // reported already
    total.elements += size.elements;
    total.nodes += size.nodes;
  }
  if (total.elements <= largest_mesh && total.nodes <= largest_mesh) return;
  reading.errors.add(
      root.find("parts")->key,
      fmt::format("the parts have {:.4g} elements and {:.4g} nodes (a mesh can have {:.0f} of each): make them coarser",
                  total.elements, total.nodes, largest_mesh));
}

/// Rotations are held of nodes of shells, of beams and of rigid bodies only.
void check_rotations(const Deck& deck, const Node& root, Reading& reading) {
  const Node* parts = root.find("parts");
  const auto is_meant_to_turn = [&](const PartDeck& part) {  // but its section or its thickness is wrong
    const Node* node = parts == nullptr ? nullptr : parts->find(part.name);
    return node != nullptr && ((node->find("section") != nullptr && !part.section) ||
                               (node->find("thickness") != nullptr && !part.has_thickness()));
  };
  if (std::any_of(deck.parts.begin(), deck.parts.end(), is_meant_to_turn)) return;
  const auto may_turn = [](const PartDeck& part) {
    return part.has_thickness() || part.rigid || (part.section && bends(*part.section)) ||
           std::holds_alternative<FileMesh>(part.shape);
  };
  if (!deck.rigid_sets.empty() || std::any_of(deck.parts.begin(), deck.parts.end(), may_turn)) return;
  for (const NameUse& use : reading.rotations) {
    reading.errors.add(
        use.spot,
        fmt::format(
            "{} has no effect{} (only nodes of shells, beams and rigid parts have rotations, and there are none)",
            use.name, use.in));
  }
}

/// The eigenvalue of the mesh is that of hexahedra.
void check_step_estimate(const Deck& deck, const Node& root, Reading& reading) {
  if (deck.time.step_estimate != TimeDeck::StepEstimate::global) return;
  const auto other = std::find_if(deck.parts.begin(), deck.parts.end(),
                                  [](const auto& part) { return part.has_thickness() || part.section; });
  if (other == deck.parts.end()) return;
  reading.errors.add(
      root.find("time")->find("step_estimate")->spot,
      fmt::format(
          "time.step_estimate is global (part '{}' has {}, which the global estimate does not support): leave it out",
          other->name, other->has_thickness() ? "shells" : "beams"));
}

/// The eigenvalue of the mesh is that of its first masses.
void check_running_masses(const Deck& deck, const Node& root, Reading& reading) {
  if (deck.time.step_estimate != TimeDeck::StepEstimate::global || !deck.scales_mass_in_run()) return;
  reading.errors.add(root.find("time")->find("step_estimate")->spot,
                     "time.step_estimate is global (mass_scaling.every adds mass during the run, which the global "
                     "estimate does not support): leave one of them out");
}

void check_curves(const Deck& deck, Reading& reading) {
  constexpr int samples = 64;
  for (const CurveUse& use : reading.curves) {
    for (int i = 0; i <= samples; ++i) {
      const double t = deck.time.end * i / samples;
      const double value = use.curve(t);
      if (std::isfinite(value) && !(use.is_not_negative && value < 0)) continue;
      const std::string what = std::isfinite(value) ? fmt::format("{:g}", value)
                               : std::isnan(value)  ? "not a number"
                                                    : "infinite";
      reading.errors.add(use.spot, fmt::format("{} is {} at t = {} (must be {} from 0 to time.end)", use.name, what, t,
                                               use.is_not_negative ? "zero or positive" : "finite"));
      break;
    }
  }
}

/// The step keeps no watched data of eroded elements.
void check_estimate(const Deck& deck, const Node& root, Reading& reading) {
  const Node* materials = root.find("materials");
  if (deck.time.step_estimate != TimeDeck::StepEstimate::global) return;
  for (const MaterialDeck& material : deck.materials) {
    if (!material.failure) continue;
    reading.errors.add(materials->find(material.name)->key,
                       fmt::format("material '{}' can fail (time.step_estimate: global does not support erosion): use "
                                   "time.step_estimate: element",
                                   material.name));
  }
}

/// Settings of contact that nothing reads as the others stand: accepted, for a switch may come and go by --set.
void check_idle_contact(const Deck& deck, const Node& root, Reading& reading) {
  using Enforcement = ContactDeck::Enforcement;
  const Node* contact = root.find("contact");
  if (contact == nullptr || contact->kind != Node::Kind::map) return;
  const auto warn = [&](const char* key, bool is_idle, const char* why) {
    const Node* node = contact->find(key);
    if (node != nullptr && is_idle)
      reading.errors.warn(node->key, "key_without_effect", fmt::format("contact.{} does nothing ({})", key, why));
  };
  const ContactDeck& read = deck.contact;
  warn("penalty_scale", read.enforcement != Enforcement::penalty, "it applies only to contact.enforcement: penalty");
  warn("tolerance", !read.is_iterated(), "it applies only to contact.enforcement: automatic and kinematic");
  const bool has_bodies = !deck.rigid_sets.empty() || std::any_of(deck.parts.begin(), deck.parts.end(),
                                                                  [](const PartDeck& part) { return part.rigid; });
  warn("restitution", !has_bodies, "no part is rigid, and others rebound by their own waves");
  for (const char* key : {"friction", "edges", "search", "reuse_search", "rebalance"})
    warn(key, read.surfaces == ContactDeck::Surfaces::none, "contact.surfaces is none");
}

/// A wall that gives way knows the masses of nodes, which those of a rigid body do not have.
void check_walls(const Deck& deck, const Node& root, Reading& reading) {
  const auto rigid = std::find_if(deck.parts.begin(), deck.parts.end(), [](const auto& part) { return part.rigid; });
  const Node* walls = root.find("walls");
  if (walls == nullptr || walls->items.size() != deck.walls.size())
    return;  // some are wrong, which is reported already
  const bool has_springs = deck.contact.enforcement == ContactDeck::Enforcement::penalty;
  for (std::size_t w = 0; w < deck.walls.size(); ++w) {
    const WallDeck& wall = deck.walls[w];
    if (has_springs && wall.is_round() && wall.speed && wall.friction > 0)
      reading.errors.add(walls->items[w].find("friction")->key,
                         fmt::format("walls.{}.friction cannot be used with contact.enforcement: penalty (its springs "
                                     "do not follow a surface that moves along itself): use kinematic or lagrange",
                                     w));
    if (!wall.mass) continue;
    const Spot spot = walls->items[w].find("mass")->key;
    if (has_springs)
      reading.errors.add(spot, fmt::format("walls.{}.mass cannot be used with contact.enforcement: penalty (its "
                                           "springs do not account for the wall's mass): use kinematic or lagrange",
                                           w));
    if (rigid != deck.parts.end())
      reading.errors.add(spot, fmt::format("walls.{}.mass cannot be used beside rigid parts such as '{}' (their nodes "
                                           "have no masses of their own): make the wall a rigid part too",
                                           w, rigid->name));
    if (!deck.rigid_sets.empty())
      reading.errors.add(spot, fmt::format("walls.{}.mass cannot be used beside rigid_sets (their nodes have no masses "
                                           "of their own): make the wall a rigid part",
                                           w));
  }
}

/// The curves of blasts are in kg, m, kPa and ms.
void check_blasts(const Deck& deck, const Node& root, Reading& reading) {
  if (!deck.units.empty()) return;
  const Node* loads = root.find("loads");
  const Node* list = loads == nullptr ? nullptr : loads->find("pressure");
  for (std::size_t i = 0; list != nullptr && i < list->items.size(); ++i)
    if (const Node* blast = list->items[i].find("blast"))
      reading.errors.add(blast->key,
                         "a blast needs the units of the deck (its curves are in kg, m, kPa and ms): give "
                         "the key units, for example units: m, kg, s");
}

}  // namespace

void check_deck(const Deck& deck, const Node& root, Reading& reading) {
  for (const char* section : {"parts", "materials"}) {
    const Node* node = root.find(section);
    if (node == nullptr || node->kind != Node::Kind::map || !node->entries.empty()) continue;
    reading.errors.add(node->key, fmt::format("{} is empty (there must be at least one)", section));
  }
  check_materials(deck, root, reading);
  check_plies(deck, root, reading);
  check_selectors(deck, reading);
  check_size(deck, root, reading);
  check_rotations(deck, root, reading);
  check_step_estimate(deck, root, reading);
  check_running_masses(deck, root, reading);
  check_places(deck, reading);
  check_rigid(deck, root, reading);
  check_joints(deck, root, reading);
  check_turn_springs(deck, root, reading);
  check_body_names(deck, reading);
  check_start(deck, root, reading);
  check_curves(deck, reading);
  check_estimate(deck, root, reading);
  check_element_settings(deck, root, reading);
  check_idle_contact(deck, root, reading);
  check_walls(deck, root, reading);
  check_fields(deck, root, reading);
  check_blasts(deck, root, reading);
  check_forces(deck, root, reading);
  check_blocks(deck, reading);
  check_accelerometers(deck, reading);
  check_sensors(deck, root, reading);
}

}  // namespace percuss
