#pragma once
// Input of the rules on suspicious input, and how they report warnings.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/checks/scene_measures.hpp"
#include "src/contact/overlap/start_overlap.hpp"
#include "src/contact/ties/tie_measures.hpp"
#include "src/deck/deck.hpp"
#include "src/warning.hpp"

namespace percuss {

/// A scene that can be run. What is not known yet is null or 0.
struct CheckedScene {
  const Deck& deck;
  const SceneMeasures* measures = nullptr;  // of the mesh
  const StartOverlap* overlap = nullptr;    // of a scene with contact or walls, at time 0
  double stable_step = 0;                   // smallest bound of an element, without step_scale [time]
  const TieMeasures* ties = nullptr;
  const std::vector<double>* part_steps = nullptr;  // find_part_steps()
};

/// Parts beyond which rules that compare each with each other are left out: they would take seconds.
inline constexpr std::size_t most_compared_parts = 2000;

/// A warning at the key of a path such as "parts.rod.thickness", or at what is around it where the deck leaves it out.
inline Warning warn_at(const Deck& deck, const std::string& rule, const std::string& path, std::string text) {
  return {rule, std::move(text), deck.where(deck.places.find(path)), 0, 1};
}

/// "conditions.3"
inline std::string join_path(const std::string& list, std::size_t item) { return fmt::format("{}.{}", list, item); }

/// The path of the shape of a part: "parts.rod.cylinder".
std::string find_shape_path(const PartDeck& part);

/// The parts that a selector may mean, by its name alone: one, or all for a set that several parts may have.
std::vector<std::size_t> find_named_parts(const Deck& deck, const Selector& selector);

/// Whether an entry that sensors switch may act after a time of the run, as far as sensors of time alone say it.
bool may_act_after(const Deck& deck, const SwitchDeck& when, double time);

/// Whether a condition holds or moves all nodes of a part in all directions.
bool is_driven(const Deck& deck, const PartDeck& part);

/// The material of a part.
const MaterialDeck& find_material(const Deck& deck, const PartDeck& part);

/// A constant of a law by its key in the deck.
struct NamedValue {
  std::string key;
  double value = 0;
};

/// The stress at first yield of a material that yields [pressure].
std::optional<NamedValue> find_first_yield(const LawDeck& law);

/// Stiffness against a plane pressure wave at the start, lambda + 2 mu [pressure].
double find_wave_modulus(const MaterialDeck& material);

/// Speed of a plane pressure wave at the start, sqrt((lambda + 2 mu) / density) [length / time].
double find_wave_speed(const MaterialDeck& material);

/// Young's modulus at the start; of a fluid its bulk modulus [pressure].
double find_stiffness(const MaterialDeck& material);

}  // namespace percuss
