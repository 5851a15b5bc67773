// Velocities that conditions undo, motions and loads that no material follows, gravity that pulls bodies away.

#include <algorithm>
#include <cmath>

#include "kernels/material/pressure/equation_of_state.hpp"
#include "src/checks/rules.hpp"
#include "src/deck/asked_for.hpp"
#include "src/deck/laws/fluid_at_rest.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Number of points at which a curve is evaluated over a run.
constexpr int samples = 512;

/// Largest size of a curve, or of its slope, over the run.
double find_largest(const Curve& curve, double end, bool of_slope) {
  double largest = 0;
  for (int i = 0; i < samples; ++i) {
    const double here = curve(end * i / samples), next = curve(end * (i + 1) / samples);
    const double value = of_slope ? (next - here) / (end / samples) : std::max(std::abs(here), std::abs(next));
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

/// The parts of a selector, and the fastest wave in any of them.
double find_fastest_wave(const Deck& deck, const Selector& where) {
  double fastest = 0;
  for (const std::size_t p : find_named_parts(deck, where))
    fastest = std::max(fastest, find_wave_speed(find_material(deck, deck.parts[p])));
  return fastest;
}

/// The speed of a part at the start beside the other parts, or beside the walls and what conditions hold [length /
/// time]. A body that flies with all the others is under no load.
class RelativeSpeed {
 public:
  explicit RelativeSpeed(const CheckedScene& scene)
      : scene_(scene), has_fixed_frame_(!scene.deck.walls.empty() || !scene.deck.conditions.empty()) {
    const std::vector<PartMeasures>& parts = scene.measures->parts;
    low_ = parts.front().velocity_low;
    high_ = parts.front().velocity_high;
    for (const PartMeasures& part : parts) {
      for (std::size_t k = 0; k < 3; ++k) {
        low_[k] = std::min(low_[k], part.velocity_low[k]);
        high_[k] = std::max(high_[k], part.velocity_high[k]);
      }
    }
  }

  double operator()(std::size_t p) const {
    const PartMeasures& part = scene_.measures->parts[p];
    if (has_fixed_frame_) return part.speed;
    Vec3 farthest{};
    for (std::size_t k = 0; k < 3; ++k)
      farthest[k] = std::max(high_[k] - part.velocity_low[k], part.velocity_high[k] - low_[k]);
    return std::min(part.speed, std::sqrt(dot(farthest, farthest)));
  }

 private:
  const CheckedScene& scene_;
  bool has_fixed_frame_;
  Vec3 low_{}, high_{};  // of the velocities of all parts
};

/// "initial.N" of the last entry that names a part.
std::string find_initial_path(const Deck& deck, std::size_t part) {
  for (std::size_t i = deck.initial.size(); i-- > 0;) {
    const std::vector<std::size_t> parts = find_named_parts(deck, deck.initial[i].where);
    if (std::find(parts.begin(), parts.end(), part) != parts.end()) return join_path("initial", i);
  }
  return "initial";
}

/// Walls that no material of the scene can follow.
void warn_of_fast_walls(const Deck& deck, std::vector<Warning>& warnings) {
  const double wave = find_fastest_wave(deck, {});
  for (std::size_t w = 0; w < deck.walls.size(); ++w) {
    const WallDeck& wall = deck.walls[w];
    const double speed = wall.speed ? find_largest(*wall.speed, deck.time.end, false) : std::abs(wall.start_speed);
    if (wave == 0 || speed <= wave) continue;
    warnings.push_back(
        warn_at(deck, "prescribed_speed", join_path("walls", w) + (wall.speed ? ".speed" : ".start_speed"),
                fmt::format("the wall moves at up to {:.4g} (the fastest waves of the parts run at {:.4g}, so that "
                            "nothing can give way): check its unit",
                            speed, wave)));
  }
}

/// Speed of a node on the side of the box of a condition's nodes that is farthest from the axis about which they turn.
double find_turning_speed(const CheckedScene& scene, std::size_t condition) {
  const TurnDeck& turn = *scene.deck.conditions[condition].turn;
  const ConditionMeasures& nodes = scene.measures->selections.conditions[condition];
  double reach = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (k != turn.axis)
      reach = std::max({reach, std::abs(nodes.low[k] - turn.through[k]), std::abs(nodes.high[k] - turn.through[k])});
  return reach * find_largest(turn.angular_velocity, scene.deck.time.end, false);
}

void warn_of_fast_turns(const CheckedScene& scene, std::vector<Warning>& warnings) {
  for (std::size_t c = 0; c < scene.deck.conditions.size(); ++c) {
    if (!scene.deck.conditions[c].turn) continue;
    const double wave = find_fastest_wave(scene.deck, scene.deck.conditions[c].where);
    const double speed = find_turning_speed(scene, c);
    if (speed <= wave) continue;
    warnings.push_back(
        warn_at(scene.deck, "prescribed_speed", join_path("conditions", c) + ".turn.angular_velocity",
                fmt::format("these nodes turn at up to {:.4g} (faster than the wave speed {:.4g} of their "
                            "material, which cannot follow): check that it is in radians, and its unit",
                            speed, wave)));
  }
}

/// Names what keeps nodes from their velocity: InitialMeasures::condition.
std::string describe_holding(const Deck& deck, int condition) {
  const auto c = static_cast<std::size_t>(condition);
  if (c < deck.conditions.size()) return "the condition at " + deck.where(deck.places.find(join_path("conditions", c)));
  const std::string& part = deck.parts[c - deck.conditions.size()].name;
  return "rigid.fixed at " + deck.where(deck.places.find("parts." + part + ".rigid.fixed"));
}

/// Describes what the impulse of a pressure would do to its sheet, were it free; empty: no more than waves do.
std::string describe_thrust(const CheckedScene& scene, const PressureDeck& load, double largest) {
  if (scene.measures == nullptr) return "";
  double impulse = 0;  // by area
  for (int i = 0; i < samples; ++i)
    impulse += scene.deck.time.end / samples * std::abs(load.value(scene.deck.time.end * (i + 0.5) / samples));
  for (const std::size_t p : find_named_parts(scene.deck, load.where)) {
    const PartDeck& part = scene.deck.parts[p];
    const MaterialDeck& material = find_material(scene.deck, part);
    const PartMeasures& measures = scene.measures->parts[p];
    if (part.rigid || material.equation_of_state || measures.shells == 0) continue;
    const double mass = material.density * measures.shell_thickness;  // by area
    const double speed = mass > 0 ? impulse / mass : 0, wave = find_wave_speed(material);
    if (speed <= wave) continue;
    return fmt::format("part '{}' yields far below {:.3g}; free, it would reach {:.2g} times its wave speed {:.4g}",
                       part.name, largest, speed / wave, wave);
  }
  return "";
}

/// How far the velocity of a condition along an axis is from that of the nodes beside it when a wave has crossed an
/// element; a table may rise until then.
double find_jump(const ConditionDeck& condition, std::size_t axis, const PartMeasures& part, double crossing) {
  const double value = condition.value[axis](crossing);
  return std::max(std::abs(value - part.velocity_low[axis]), std::abs(value - part.velocity_high[axis]));
}

}  // namespace

std::vector<Warning> check_velocity_jump(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  for (std::size_t c = 0; c < deck.conditions.size(); ++c) {
    const ConditionDeck& condition = deck.conditions[c];
    if (condition.kind != ConditionDeck::Kind::velocity || condition.turn || condition.when.any()) continue;
    const std::vector<std::size_t> parts = find_named_parts(deck, condition.where);
    if (parts.size() != 1 || deck.parts[parts.front()].rigid || is_driven(deck, deck.parts[parts.front()])) continue;
    const MaterialDeck& material = find_material(deck, deck.parts[parts.front()]);
    const PartMeasures& part = scene.measures->parts[parts.front()];
    const auto yield = find_first_yield(material.law);
    const double wave = find_wave_speed(material);
    if (!yield || part.shortest_edge >= part.extent()) continue;
    const double most = yield->value / (material.density * wave);
    for (std::size_t k = 0; k < 3; ++k) {
      const double jump = condition.active[k] ? find_jump(condition, k, part, part.shortest_edge / wave) : 0;
      if (jump <= most) continue;
      warnings.push_back(
          warn_at(deck, "velocity_jump", join_path("conditions", c) + ".velocity." + direction_names[k],
                  fmt::format("these nodes of part '{}' jump to {:.4g} along {} at the start (above {:.3g} = yield "
                              "stress / (density x wave speed) the elements beside them yield at once, by the jump "
                              "alone): raise the velocity by a table over some passages of a wave, or give the whole "
                              "part its velocity at the start",
                              deck.parts[parts.front()].name, condition.value[k](part.shortest_edge / wave),
                              direction_names[k], most)));
      break;
    }
  }
  return warnings;
}

std::vector<Warning> check_stopped_velocity(const CheckedScene& scene) {
  constexpr double least = 0.5;  // share of the nodes: the foot of a bar that is held where it hits is meant
  std::vector<Warning> warnings;
  for (std::size_t i = 0; i < scene.deck.initial.size(); ++i) {
    const InitialMeasures& entry = scene.measures->initial[i];
    if (entry.stopped == 0 || static_cast<double>(entry.stopped) < least * static_cast<double>(entry.moving)) continue;
    warnings.push_back(
        warn_at(scene.deck, "stopped_velocity", join_path("initial", i),
                fmt::format("{} of {} nodes with this initial velocity are held in its direction (by "
                            "{}): remove one of the two entries, or name the part that is to move",
                            entry.stopped, entry.moving, describe_holding(scene.deck, entry.condition))));
  }
  return warnings;
}

std::vector<Warning> check_unused_velocity(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (std::size_t i = 0; i < scene.deck.initial.size(); ++i) {
    const InitialMeasures& entry = scene.measures->initial[i];
    if (entry.governed > 0 || entry.selected == 0) continue;
    warnings.push_back(warn_at(scene.deck, "unused_velocity", join_path("initial", i),
                               fmt::format("later entries override this velocity on all {} nodes (the last entry that "
                                           "names a node wins): remove this entry or move it down",
                                           entry.selected)));
  }
  return warnings;
}

std::vector<Warning> check_fast_velocity(const CheckedScene& scene) {
  constexpr double most_of_solid = 1, most_of_state = 5;  // in wave speeds: without and with an equation of state
  std::vector<Warning> warnings;
  const RelativeSpeed find_speed(scene);
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const MaterialDeck& material = find_material(scene.deck, part);
    const auto& state = material.equation_of_state;
    if (state && state->model == IdealGasState::name) continue;  // cold gases run into each other at any speed
    const double wave = find_wave_speed(material), speed = find_speed(p);
    if (wave == 0) continue;  // a skin
    if (speed <= (state ? most_of_state : most_of_solid) * wave) continue;
    const char* why = state ? "light-gas guns reach 2" : "such a shock needs an equation of state";
    warnings.push_back(warn_at(scene.deck, "fast_velocity", find_initial_path(scene.deck, p),
                               fmt::format("part '{}' starts at {:.4g}, {:.3g} times the wave speed {:.4g} of material "
                                           "'{}' ({}): check the unit of the velocity",
                                           part.name, speed, speed / wave, wave, material.name, why)));
  }
  return warnings;
}

std::vector<Warning> check_prescribed_speed(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (std::size_t c = 0; c < scene.deck.conditions.size(); ++c) {
    const ConditionDeck& condition = scene.deck.conditions[c];
    const bool is_displacement = condition.kind == ConditionDeck::Kind::displacement;
    if (!is_displacement && condition.kind != ConditionDeck::Kind::velocity) continue;
    const double wave = find_fastest_wave(scene.deck, condition.where);
    for (std::size_t k = 0; k < 3; ++k) {
      const double speed =
          condition.active[k] ? find_largest(condition.value[k], scene.deck.time.end, is_displacement) : 0;
      if (speed <= wave) continue;
      const std::string path = join_path("conditions", c) + (is_displacement ? ".displacement." : ".velocity.");
      warnings.push_back(
          warn_at(scene.deck, "prescribed_speed", path + direction_names[k],
                  fmt::format("these nodes are moved at up to {:.4g} along {} (faster than the wave speed {:.4g} of "
                              "their material, which cannot follow): check the units of the curve",
                              speed, direction_names[k], wave)));
    }
  }
  warn_of_fast_turns(scene, warnings);
  warn_of_fast_walls(scene.deck, warnings);
  return warnings;
}

std::vector<Warning> check_pressure_size(const CheckedScene& scene) {
  constexpr double most = 0.5;  // of lambda + 2 mu, which resists both pressure and crushing of a sheet: far beyond use
  constexpr double much =
      0.01;  // of it: sheets are formed by a fifth of that, and detonations are over in microseconds
  std::vector<Warning> warnings;
  for (std::size_t i = 0; i < scene.deck.pressures.size(); ++i) {
    const PressureDeck& load = scene.deck.pressures[i];
    double stiffness = 0;
    for (const std::size_t p : find_named_parts(scene.deck, load.where)) {
      const MaterialDeck& material = find_material(scene.deck, scene.deck.parts[p]);
      if (find_traits(material).needs_equation_of_state && !can_rest(material, 0)) continue;  // a gas has this pressure
      stiffness = std::max(stiffness, find_wave_modulus(material));
    }
    const double largest = find_largest(load.value, scene.deck.time.end, false);
    if (stiffness == 0 || largest <= much * stiffness) continue;
    if (largest <= most * stiffness) {
      const std::string flight = describe_thrust(scene, load, largest);
      if (!flight.empty())
        warnings.push_back(warn_at(scene.deck, "pressure_size", join_path("loads.pressure", i) + ".value",
                                   fmt::format("the pressure reaches {:.3g}, {:.2g} of the stiffness {:.3g} of the "
                                               "material that it acts on ({}): check its unit",
                                               largest, largest / stiffness, stiffness, flight)));
      continue;
    }
    warnings.push_back(warn_at(scene.deck, "pressure_size", join_path("loads.pressure", i) + ".value",
                               fmt::format("the pressure reaches {:.3g}, {:.3g} times the stiffness {:.3g} of the "
                                           "material that it acts on (solids are crushed long before): check its unit",
                                           largest, largest / stiffness, stiffness)));
  }
  return warnings;
}

std::vector<Warning> check_gravity_direction(const CheckedScene& scene) {
  constexpr double least = 0.5;  // share of gravity along the normal: less is a wall at the side
  if (!scene.deck.gravity.is_constant()) return {};
  const Vec3 g = scene.deck.gravity.at(0);
  const double size = std::sqrt(dot(g, g));
  if (size == 0 || scene.deck.walls.empty()) return {};
  double up = 0;
  for (const WallDeck& wall : scene.deck.walls) {
    if (wall.is_round()) return {};  // which bodies may lie on
    const double along = dot(g, wall.normal) / size;
    if (along < 0) return {};
    up = std::max(up, along);
  }
  if (up < least) return {};
  return {warn_at(scene.deck, "gravity_direction", "loads.gravity",
                  "gravity pulls all bodies away from every wall (normals must point to the side of the bodies): "
                  "reverse gravity or the normal")};
}

}  // namespace percuss
