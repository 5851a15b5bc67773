// Relaxations that change nothing, or end too early.

#include <algorithm>

#include "src/checks/rules.hpp"

namespace percuss {
namespace {

bool acts_at_start(const NodalLoadDeck& load) {
  for (std::size_t k = 0; k < load.value.size(); ++k)
    if (load.active[k] && load.value[k](0) != 0) return true;
  return false;
}

/// Whether anything of a deck may strain its parts before time 0.
bool acts_at_start(const Deck& deck) {
  const bool has_state = !deck.start.fields.empty() || !deck.start.preloads.empty();
  const bool is_pushed = deck.contact.overlap == ContactDeck::Overlap::push_out;
  if (has_state || is_pushed || !deck.springs.empty() || !deck.turn_springs.empty()) return true;
  if (deck.gravity.at(0) != Vec3{}) return true;
  return std::any_of(deck.pressures.begin(), deck.pressures.end(),
                     [](const PressureDeck& pressure) { return pressure.value(0) != 0; }) ||
         std::any_of(deck.nodal_loads.begin(), deck.nodal_loads.end(),
                     [](const NodalLoadDeck& load) { return acts_at_start(load); });
}

}  // namespace

std::vector<Warning> check_idle_relaxation(const CheckedScene& scene) {
  if (!scene.deck.start.relaxation || acts_at_start(scene.deck)) return {};
  return {warn_at(scene.deck, "idle_relaxation", "start.relaxation",
                  "the relaxation finds a scene at rest (no load, preload or spring acts at time 0, and it does not "
                  "see velocities): give loads their values at time 0, or remove it")};
}

std::vector<Warning> check_loose_relaxation(const CheckedScene& scene) {
  constexpr double most = 1e-3;  // share of the largest kinetic energy: 3 % of the swing
  const auto& relaxation = scene.deck.start.relaxation;
  if (!relaxation || relaxation->tolerance <= most) return {};
  return {warn_at(scene.deck, "loose_relaxation", "start.relaxation.tolerance",
                  fmt::format("start.relaxation.tolerance is {:g} (so much of the largest kinetic energy may be left; "
                              "usual is 1e-6): lower it",
                              relaxation->tolerance))};
}

}  // namespace percuss
