#include "src/checks/checked_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "kernels/material/laws/johnson_cook.hpp"
#include "kernels/material/laws/rate_table_plasticity.hpp"
#include "kernels/material/laws/tabulated_plasticity.hpp"
#include "src/deck/laws/make_law.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/deck/rigid_bodies.hpp"

namespace percuss {

std::string find_shape_path(const PartDeck& part) {
  constexpr const char* names[] = {"box",        "cylinder",     "tube",           "sphere", "shell_plate",
                                   "shell_tube", "shell_sphere", "shell_box_tube", "line",   "mesh"};
  static_assert(std::variant_size_v<Shape> == std::size(names), "every shape has its key");
  const auto* mesh = std::get_if<FileMesh>(&part.shape);
  const char* const name = mesh != nullptr && mesh->is_exodus ? "exodus" : names[part.shape.index()];
  return fmt::format("parts.{}.{}", part.name, name);
}

namespace {

/// Parts of a rigid body, and parts that have nodes of it.
std::vector<std::size_t> find_parts_of_body(const Deck& deck, const std::string& body) {
  const RigidNames names = name_rigid_bodies(deck);
  const int index = names.find(body);
  std::vector<std::size_t> parts;
  for (std::size_t p = 0; p < deck.parts.size(); ++p)
    if (names.body_of_part[p] == index) parts.push_back(p);
  for (std::size_t s = 0; s < deck.rigid_sets.size(); ++s) {
    if (names.body_of_set[s] != index) continue;
    const std::vector<std::size_t> of_set = find_named_parts(deck, deck.rigid_sets[s].where);
    parts.insert(parts.end(), of_set.begin(), of_set.end());
  }
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  return parts;
}

}  // namespace

bool may_act_after(const Deck& deck, const SwitchDeck& when, double time) {
  const auto is_at_most = [&](const std::string& name, double limit) {
    const auto sensor =
        std::find_if(deck.sensors.begin(), deck.sensors.end(), [&](const SensorDeck& s) { return s.name == name; });
    return sensor != deck.sensors.end() && sensor->time && *sensor->time + sensor->delay <= limit;
  };
  const auto is_of_time = [&](const std::string& name) {
    return is_at_most(name, std::numeric_limits<double>::infinity());
  };
  if (is_of_time(when.from) && !is_at_most(when.from, deck.time.end)) return false;
  return !is_at_most(when.until, time);
}

std::vector<std::size_t> find_named_parts(const Deck& deck, const Selector& selector) {
  if (const std::string body = find_body(selector); !body.empty()) return find_parts_of_body(deck, body);
  const std::string name = selector.name.substr(0, selector.name.find('/'));
  const auto part =
      std::find_if(deck.parts.begin(), deck.parts.end(), [&](const PartDeck& p) { return p.name == name; });
  if (part != deck.parts.end()) return {static_cast<std::size_t>(part - deck.parts.begin())};
  std::vector<std::size_t> all(deck.parts.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

bool is_driven(const Deck& deck, const PartDeck& part) {
  std::array<bool, 3> held{};
  for (const ConditionDeck& condition : deck.conditions) {
    if (condition.where.name != part.name || condition.where.inside || condition.when.any()) continue;
    for (std::size_t k = 0; k < 3; ++k) held[k] = held[k] || condition.active[k];
  }
  return held[0] && held[1] && held[2];
}

const MaterialDeck& find_material(const Deck& deck, const PartDeck& part) {
  return *std::find_if(deck.materials.begin(), deck.materials.end(),
                       [&](const MaterialDeck& material) { return material.name == part.material; });
}

std::optional<NamedValue> find_first_yield(const LawDeck& law) {
  constexpr const char* rate_curves = "hardening_at_rates";
  if (law.model == TabulatedPlasticity::name) return NamedValue{"hardening", law.tables.at("hardening").front()[1]};
  if (law.model == RateTablePlasticity::name)
    return NamedValue{rate_curves, law.tables.at(name_curve(rate_curves, 0)).front()[1]};
  const std::string key = law.model == JohnsonCook::name ? "a" : "yield_stress";
  const auto found = law.numbers.find(key);
  if (found == law.numbers.end()) return std::nullopt;
  return NamedValue{key, found->second};
}

double find_wave_modulus(const MaterialDeck& material) {
  const LameConstants moduli = find_moduli(material);
  return moduli.lambda + 2 * moduli.mu;
}

double find_wave_speed(const MaterialDeck& material) {
  return std::sqrt(find_wave_modulus(material) / material.density);
}

double find_stiffness(const MaterialDeck& material) {
  const LameConstants moduli = find_moduli(material);
  if (!(moduli.mu > 0)) return moduli.lambda;
  return find_youngs_modulus(moduli);
}

}  // namespace percuss
