// Parts that conditions or joints take out of the motion, elements by which a failure strain counts.

#include <algorithm>
#include <limits>

#include "kernels/material/elastic.hpp"
#include "src/checks/rules.hpp"
#include "src/deck/laws/law_traits.hpp"

namespace percuss {
namespace {

/// The condition that names a part as a whole, or else the part.
std::string find_holding_path(const Deck& deck, const std::string& part) {
  for (std::size_t c = 0; c < deck.conditions.size(); ++c) {
    const ConditionDeck& condition = deck.conditions[c];
    if (condition.kind == ConditionDeck::Kind::fixed && condition.where.name == part) return join_path("conditions", c);
  }
  return "parts." + part;
}

bool names(const Selector& where, const std::string& part) {
  return where.name.substr(0, where.name.find('/')) == part;
}

bool names(const std::vector<Selector>& where, const std::string& part) {
  return std::any_of(where.begin(), where.end(), [&](const Selector& one) { return names(one, part); });
}

/// Where the deck takes two parts for bodies that touch each other; empty: it does not.
std::string find_contact_between(const Deck& deck, const std::string& a, const std::string& b) {
  const auto is_between = [&](const auto& one, const auto& other) {
    return (names(one, a) && names(other, b)) || (names(one, b) && names(other, a));
  };
  for (std::size_t i = 0; i < deck.contact.pairs.size(); ++i)
    if (is_between(deck.contact.pairs[i].a, deck.contact.pairs[i].b)) return join_path("contact.surfaces", i);
  for (std::size_t i = 0; i < deck.contact.frictions.size(); ++i)
    if (deck.contact.frictions[i].b && is_between(deck.contact.frictions[i].a, *deck.contact.frictions[i].b))
      return join_path("contact.friction.pairs", i);
  for (const ForceDeck& force : deck.output.forces)
    if (force.kind == ForceDeck::Kind::contact && is_between(force.on, force.from))
      return fmt::format("force '{}'", force.name);
  return "";
}

bool joins(const JoinDeck& join, const std::string& part) {
  return join.parts.empty() || std::find(join.parts.begin(), join.parts.end(), part) != join.parts.end();
}

/// The entry of `join` that names both.
std::string find_join_path(const Deck& deck, const std::string& a, const std::string& b) {
  for (std::size_t i = 0; i < deck.joins.size(); ++i)
    if (joins(deck.joins[i], a) && joins(deck.joins[i], b)) return join_path("join", i);
  return "";
}

/// Fasteners of two parts: beams or a preloaded part that both share nodes with.
class Fasteners {
 public:
  explicit Fasteners(const CheckedScene& scene) : scene_(scene) {}

  struct Found {
    std::string part;                     // empty: there is none
    std::int64_t with_a = 0, with_b = 0;  // nodes that it shares with them
  };

  Found find(int a, int b) const {
    for (std::size_t p = 0; p < scene_.deck.parts.size(); ++p) {
      const std::int64_t with_a = count_shared(static_cast<int>(p), a), with_b = count_shared(static_cast<int>(p), b);
      if (with_a > 0 && with_b > 0 && is_fastener(p)) return {scene_.deck.parts[p].name, with_a, with_b};
    }
    return {};
  }

 private:
  bool is_fastener(std::size_t part) const {
    const PartMeasures& measures = scene_.measures->parts[part];
    const auto& preloads = scene_.deck.start.preloads;
    return measures.beams == measures.elements() ||
           std::any_of(preloads.begin(), preloads.end(),
                       [&](const PreloadDeck& preload) { return preload.part == scene_.deck.parts[part].name; });
  }

  std::int64_t count_shared(int part, int other) const {
    for (const JointMeasures& joint : scene_.measures->joints)
      if (joint.part == std::min(part, other) && joint.other == std::max(part, other)) return joint.nodes;
    return 0;
  }

  const CheckedScene& scene_;
};

/// Whether a part that is held may be meant to be hit, and not to deform: an elastic one that others can touch.
bool is_obstacle(const Deck& deck, const PartDeck& part) {
  const ContactDeck& contact = deck.contact;
  const bool touches = contact.surfaces == ContactDeck::Surfaces::all ||
                       std::any_of(contact.pairs.begin(), contact.pairs.end(), [&](const SurfacePairDeck& pair) {
                         return names(pair.a, part.name) || names(pair.b, part.name);
                       });
  const MaterialDeck& material = find_material(deck, part);
  return touches && material.law.model == Elastic::name && !material.failure;
}

/// Whether a material fails by a strain, which is that of a whole element, and which failure.size scales.
bool fails_by_strain(const FailureDeck& failure) {
  return failure.plastic_strain || failure.principal_strain || failure.thinning || failure.mean_thinning ||
         failure.johnson_cook || !failure.triaxiality.empty() || failure.shear;
}

/// Whether a criterion of stress makes elements fail.
bool fails_by_stress(const FailureDeck& failure) { return failure.principal_stress || failure.pressure; }

/// The key by which a material loses force over a strain that no size of its elements scales; empty: none does.
std::string find_softening(const MaterialDeck& material) {
  constexpr double fall = 0.01;  // share of the largest stress of a table: less is noise of a test
  const auto& failure = material.failure;
  if (failure && failure->size.empty()) {
    if (failure->evolution && failure->evolution->plastic_strain) return "failure.evolution.plastic_strain";
    if (failure->coupling && failure->coupling->exponent_of_size.empty()) return "failure.coupling";
  }
  for (const auto& [name, rows] : material.law.tables) {
    const bool is_at_rates = name.starts_with("hardening_at_rates");
    if (name != "hardening" && !is_at_rates) continue;
    double largest = 0;
    for (const auto& [strain, stress] : rows) {
      if (stress < (1 - fall) * largest) return is_at_rates ? "hardening_at_rates" : "hardening";
      largest = std::max(largest, stress);
    }
  }
  return "";
}

/// The smallest and the largest element of a material, and their parts.
struct ElementRange {
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  std::string fine, coarse;
};

ElementRange find_elements(const CheckedScene& scene, const MaterialDeck& material) {
  ElementRange range;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const PartMeasures& measures = scene.measures->parts[p];
    if (part.material != material.name || part.rigid || measures.elements() == 0) continue;
    if (measures.smallest_element < range.smallest) range.fine = part.name;
    if (measures.largest_element > range.largest) range.coarse = part.name;
    range.smallest = std::min(range.smallest, measures.smallest_element);
    range.largest = std::max(range.largest, measures.largest_element);
  }
  return range;
}

}  // namespace

std::vector<Warning> check_held_parts(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const std::string& name = scene.deck.parts[p].name;
    const PartMeasures& part = scene.measures->parts[p];
    if (scene.deck.parts[p].rigid || part.nodes == 0 || scene.measures->selections.held[p] < part.nodes) continue;
    if (is_obstacle(scene.deck, scene.deck.parts[p]) || part.beams > 0) continue;  // beams can twist
    warnings.push_back(warn_at(scene.deck, "held_part", find_holding_path(scene.deck, name),
                               fmt::format("all {} nodes of part '{}' are held (it cannot deform, and its elements are "
                                           "computed for nothing): hold one of its sides, or make it an obstacle by "
                                           "rigid: {{fixed: [x, y, z, rx, ry, rz]}}",
                                           part.nodes, name)));
  }
  return warnings;
}

std::vector<Warning> check_loose_skins(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const std::int64_t loose = scene.measures->selections.loose[p];
    if (loose == 0) continue;
    const PartDeck& part = scene.deck.parts[p];
    warnings.push_back(warn_at(scene.deck, "loose_skin", "parts." + part.name + ".material",
                               fmt::format("{} of {} nodes of the skin '{}' belong to nothing else (a skin has no "
                                           "stress, so each of them flies by itself): join them to a body, tie them or "
                                           "make them a rigid set, or give the part a material with strength",
                                           loose, scene.measures->parts[p].nodes, part.name)));
  }
  return warnings;
}

std::vector<Warning> check_join_glue(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  const Fasteners fasteners(scene);
  std::vector<Warning> warnings;
  for (const JointMeasures& joint : scene.measures->joints) {
    const std::string &a = deck.parts[static_cast<std::size_t>(joint.part)].name,
                      &b = deck.parts[static_cast<std::size_t>(joint.other)].name;
    const std::string path = find_join_path(deck, a, b);
    if (joint.faces == 0 || path.empty()) continue;
    const std::string contact = find_contact_between(deck, a, b);
    const Fasteners::Found fastener = fasteners.find(joint.part, joint.other);
    if (contact.empty() && fastener.part.empty()) continue;
    std::string why = contact.empty() ? "" : "; " + contact + " takes them for bodies that touch";
    std::string remedy = "leave one of them out of the entry, or move them apart by a gap";
    if (!fastener.part.empty()) {
      why += fmt::format("; '{}', which shares {} and {} nodes with them, then carries nothing", fastener.part,
                         fastener.with_a, fastener.with_b);
      remedy = fmt::format("write two entries, {{parts: [{0}, {1}]}} and {{parts: [{0}, {2}]}}", fastener.part, a, b);
    }
    warnings.push_back(warn_at(deck, "join_glue", path,
                               fmt::format("this entry glues '{}' and '{}' by {} faces with {} nodes (they cannot open "
                                           "or slide there{}): {}",
                                           a, b, joint.faces, joint.nodes, why, remedy)));
  }
  return warnings;
}

std::vector<Warning> check_softening_strain(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    const std::string key = find_softening(material);
    if (key.empty() || find_elements(scene, material).largest == 0) continue;
    warnings.push_back(warn_at(
        scene.deck, "softening_strain", "materials." + material.name + "." + key,
        fmt::format("material '{}' softens over a strain, with nothing that has the size of its elements (the "
                    "strain gathers in one row of elements, so that the energy of a crack grows with their size, "
                    "and goes to zero as the mesh is refined): give failure.evolution an energy or a "
                    "displacement, or failure.size factors for the size",
                    material.name)));
  }
  return warnings;
}

std::vector<Warning> check_failure_size(const CheckedScene& scene) {
  constexpr double most = 3;         // times: so much does the energy of a crack depend on the place where it runs
  constexpr double rounding = 1e-3;  // share of sizes that the table is meant to reach
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    if (!material.failure) continue;
    const bool by_strain = fails_by_strain(*material.failure), by_voids = find_traits(material).has_void_fraction;
    if (!by_strain && !by_voids && !fails_by_stress(*material.failure)) continue;
    const ElementRange range = find_elements(scene, material);
    const auto& rows = material.failure->size;
    const std::string what =
        fmt::format("elements {} that are {:.3g} to {:.3g} large",
                    range.fine == range.coarse ? "of part '" + range.fine + "'"
                                               : fmt::format("of parts '{}' and '{}'", range.fine, range.coarse),
                    range.smallest, range.largest);
    const auto& evolution = material.failure->evolution;
    const bool takes_energy_by_area = evolution && !evolution->plastic_strain;
    if (rows.empty() && !takes_energy_by_area && range.largest > most * range.smallest)
      warnings.push_back(warn_at(
          scene.deck, "failure_size", "materials." + material.name + (by_voids ? "" : ".failure"),
          fmt::format("material '{}' fails at one {} in {} (necks and cracks are one element wide, so that the "
                      "largest take {:.2g} times the energy of the smallest): {}mesh evenly where the material fails",
                      material.name,
                      by_strain  ? "strain"
                      : by_voids ? "void fraction"
                                 : "stress",
                      what, range.largest / range.smallest,
                      by_strain ? "give the factors of the strain over the size as failure.size, or " : "")));
    else if (!rows.empty() && range.largest > 0 &&
             (range.smallest < (1 - rounding) * rows.front()[0] || range.largest > (1 + rounding) * rows.back()[0]))
      warnings.push_back(
          warn_at(scene.deck, "failure_size", "materials." + material.name + ".failure.size",
                  fmt::format("the sizes of material '{}' go from {:.3g} to {:.3g}, but it has {} (beyond its rows the "
                              "factor is constant): add rows, each fitted to a mesh of that size",
                              material.name, rows.front()[0], rows.back()[0], what)));
  }
  return warnings;
}

}  // namespace percuss
