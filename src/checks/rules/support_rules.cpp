// Supports of parts: those of a few nodes, held parts with the velocity of another, beams that hang on nothing.

#include <algorithm>
#include <cmath>

#include "src/checks/rules.hpp"
#include "src/checks/who_touches.hpp"
#include "src/deck/embedded_parts.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

bool holds_places(const ConditionDeck& condition) {
  return condition.kind == ConditionDeck::Kind::fixed && condition.active[0] && condition.active[1] &&
         condition.active[2] && !condition.when.any();
}

/// Parts that an entry of the deck acts on or connects: all that can move them but contact, gravity and a velocity.
Marks mark_acted_on(const Deck& deck) {
  Marks marks = mark_connected(deck);
  for (const ConditionDeck& condition : deck.conditions) mark(deck, condition.where, marks);
  for (const PressureDeck& pressure : deck.pressures) mark(deck, pressure.where, marks);
  for (const NodalLoadDeck& load : deck.nodal_loads) mark(deck, load.where, marks);
  return marks;
}

/// Whether a part is free, and begins at rest: it may be the one whose velocity another has.
bool is_waiting(const CheckedScene& scene, const Marks& acted_on, std::size_t part) {
  const auto& rigid = scene.deck.parts[part].rigid;
  const bool is_fixed =
      rigid && std::any_of(rigid->fixed.begin(), rigid->fixed.end(), [](bool fixed) { return fixed; });
  const PartMeasures& measures = scene.measures->parts[part];
  return !is_fixed && !acted_on[part] && !scene.measures->is_joined(part) && measures.speed == 0 &&
         measures.solids + measures.shells > 0;
}

/// The only condition that names a part, if it holds places; none: -1.
int find_only_support(const Deck& deck, std::size_t part) {
  int found = -1;
  for (std::size_t c = 0; c < deck.conditions.size(); ++c) {
    const std::vector<std::size_t> parts = find_named_parts(deck, deck.conditions[c].where);
    if (std::find(parts.begin(), parts.end(), part) == parts.end()) continue;
    if (found >= 0 || parts.size() > 1 || !holds_places(deck.conditions[c])) return -1;
    found = static_cast<int>(c);
  }
  return found;
}

/// Whether the nodes of a support are a small patch: within a share of the part's box along each of its edges but the
/// shortest, or that of a flat part.
bool is_patch(const ConditionMeasures& support, const PartMeasures& part) {
  constexpr double most = 0.25;
  std::array<double, 3> shares{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double size = part.high[k] - part.low[k];
    shares[k] = size > 0 ? (support.high[k] - support.low[k]) / size : 0;
  }
  const Vec3 size = subtract(part.high, part.low);
  const auto thin = static_cast<std::size_t>(std::min_element(size.begin(), size.end()) - size.begin());
  shares[thin] = 0;
  return *std::max_element(shares.begin(), shares.end()) < most;
}

}  // namespace

std::vector<Warning> check_velocity_part(const CheckedScene& scene) {
  constexpr double little = 0.1;  // share of the speed, which gravity gives within the run
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  if (std::any_of(deck.walls.begin(), deck.walls.end(), [](const WallDeck& wall) { return wall.moves(); })) return {};
  const Marks acted_on = mark_acted_on(deck), touching = mark_touching(deck);
  const Vec3 gravity = deck.gravity.at(0);
  const double fall = deck.gravity.is_constant() ? std::sqrt(dot(gravity, gravity)) * deck.time.end : HUGE_VAL;
  for (std::size_t i = 0; i < deck.initial.size(); ++i) {
    const InitialMeasures& entry = scene.measures->initial[i];
    const std::vector<std::size_t> parts = find_named_parts(deck, deck.initial[i].where);
    if (parts.size() != 1 || entry.stopped == 0) continue;
    if (fall > little * scene.measures->parts[parts.front()].speed) continue;
    for (std::size_t q = 0; q < deck.parts.size(); ++q) {
      if (q == parts.front() || !touching[q] || !is_waiting(scene, acted_on, q)) continue;
      const std::string &held = deck.parts[parts.front()].name, &free = deck.parts[q].name;
      warnings.push_back(warn_at(
          deck, "velocity_part", join_path("initial", i),
          fmt::format("part '{0}' starts with a velocity against its own support, {1} nodes of it, while part '{2}', "
                      "which nothing holds, starts at rest (usually the free body moves): check whether this velocity "
                      "is that of '{2}'",
                      held, entry.stopped, free)));
      break;
    }
  }
  return warnings;
}

std::vector<Warning> check_point_support(const CheckedScene& scene) {
  constexpr std::int64_t most_held = 9, least_nodes = 30;
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  const Marks connected = mark_connected(deck);
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    const PartMeasures& part = scene.measures->parts[p];
    const std::int64_t held = scene.measures->selections.held[p];
    if (deck.parts[p].rigid || connected[p] || scene.measures->is_joined(p) || part.solids + part.shells == 0) continue;
    if (held == 0 || held > most_held || part.nodes < least_nodes) continue;
    const int support = find_only_support(deck, p);
    if (support < 0) continue;
    if (!is_patch(scene.measures->selections.conditions[static_cast<std::size_t>(support)], part)) continue;
    warnings.push_back(
        warn_at(deck, "point_support", join_path("conditions", static_cast<std::size_t>(support)),
                fmt::format("this is all that holds part '{}', and it has {} of its {} nodes (the stress at a point "
                            "grows as the mesh is refined, and the part turns about it): check that it names the whole "
                            "side, and the margin of `inside`",
                            deck.parts[p].name, held, part.nodes)));
  }
  return warnings;
}

std::vector<Warning> check_loose_beams(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  const Marks acted_on = mark_acted_on(deck), of_beams = scene.measures->mark_beams();
  if (deck.contact.beams || std::find(of_beams.begin(), of_beams.end(), false) == of_beams.end()) return warnings;
  const Marks touching = mark_named_surfaces(deck);
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    if (!of_beams[p] || acted_on[p] || touching[p] || deck.parts[p].rigid || scene.measures->is_joined(p)) continue;
    if (scene.measures->parts[p].beams == 0 || is_embedded(deck, deck.parts[p].name)) continue;
    warnings.push_back(warn_at(deck, "loose_beam", "parts." + deck.parts[p].name,
                               fmt::format("the beams of part '{}' hang on nothing (they share no node with another "
                                           "part, and no tie, weld, joint, embedding, condition or contact holds "
                                           "them): join them by `join`, whose nodes must coincide, or tie them",
                                           deck.parts[p].name)));
  }
  return warnings;
}

}  // namespace percuss
