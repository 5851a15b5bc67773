// Loads, planes and forces that act on nothing, damping that stops what is to move.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/checks/rules.hpp"
#include "src/checks/who_touches.hpp"
#include "src/deck/asked_for.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Diagonal of a box.
double find_diagonal(const Vec3& low, const Vec3& high) {
  const Vec3 size = subtract(high, low);
  return std::sqrt(dot(size, size));
}

/// Time integral of a curve over a run, as it damps.
double integrate(const Curve& curve, double end) {
  constexpr int pieces = 512;
  double sum = 0;
  for (int i = 0; i < pieces; ++i) sum += end / pieces * curve(end * (i + 0.5) / pieces);
  return sum;
}

/// Whether contact or a tie can act between any of two lists of parts and surfaces; empty: all.
class PossibleContact {
 public:
  explicit PossibleContact(const Deck& deck) : deck_(deck) {}

  bool between(const ForceDeck& force) const {
    if (deck_.contact.surfaces == ContactDeck::Surfaces::all) return true;
    if (force.from.empty() && !deck_.walls.empty()) return true;
    return meets(deck_.contact.pairs, force) || meets(deck_.contact.ties, force);
  }

 private:
  bool names(const Selector& where, const std::vector<Selector>& sides) const {
    if (sides.empty()) return true;
    const std::vector<std::size_t> named = find_named_parts(deck_, where);
    return std::any_of(sides.begin(), sides.end(), [&](const Selector& side) {
      const std::vector<std::size_t> of_side = find_named_parts(deck_, side);
      return std::find_first_of(named.begin(), named.end(), of_side.begin(), of_side.end()) != named.end();
    });
  }

  template <class Pairs>
  bool meets(const Pairs& pairs, const ForceDeck& force) const {
    return std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
      if constexpr (requires { pair.when; })
        if (!may_act_after(deck_, pair.when, 0)) return false;
      return (names(pair.a, force.on) && names(pair.b, force.from)) ||
             (names(pair.b, force.on) && names(pair.a, force.from));
    });
  }

  const Deck& deck_;
};

/// Whether both sides of a force are the same whole parts.
bool is_of_itself(const ForceDeck& force) {
  const auto list = [](const std::vector<Selector>& sides) {
    std::vector<std::string> names;
    names.reserve(sides.size());
    for (const Selector& side : sides) names.push_back(side.inside ? "" : side.name);
    std::sort(names.begin(), names.end());
    return names;
  };
  const std::vector<std::string> on = list(force.on);
  return !on.empty() && !on.front().empty() && on == list(force.from);
}

/// Distance of a box from a cylinder or a sphere, at least: its centre's, less half its diagonal.
double find_distance_of_round(const WallDeck& wall, const Vec3& middle, const Vec3& half) {
  Vec3 away = middle;
  if (wall.cylinder) {
    const double along = dot(middle, wall.cylinder->axis);
    const double end = wall.cylinder->length.value_or(std::abs(along));
    const double nearest = std::clamp(along, wall.cylinder->length ? 0.0 : -end, end);
    for (std::size_t k = 0; k < 3; ++k) away[k] -= nearest * wall.cylinder->axis[k];
  }
  return std::sqrt(dot(away, away)) - std::sqrt(dot(half, half)) -
         (wall.cylinder ? wall.cylinder->radius : wall.sphere->radius);
}

/// Distance of the scene's box from a wall: from its plane, or from the rectangle that it ends at.
double find_distance(const WallDeck& wall, const Vec3& low, const Vec3& high) {
  Vec3 middle{}, half{};
  for (std::size_t k = 0; k < 3; ++k) {
    middle[k] = 0.5 * (low[k] + high[k]) - wall.point[k];
    half[k] = 0.5 * (high[k] - low[k]);
  }
  if (wall.is_round()) return find_distance_of_round(wall, middle, half);
  const auto find_reach = [&](const Vec3& direction) {
    return std::abs(direction[0]) * half[0] + std::abs(direction[1]) * half[1] + std::abs(direction[2]) * half[2];
  };
  double distance = std::abs(dot(middle, wall.normal)) - find_reach(wall.normal);
  if (!wall.rectangle) return distance;
  const RectangleDeck& end = *wall.rectangle;
  const Vec3 edges[] = {end.along, cross(wall.normal, end.along)};
  for (std::size_t k = 0; k < 2; ++k) {
    const double along = dot(middle, edges[k]), reach = find_reach(edges[k]);
    distance = std::max({distance, -along - reach, along - reach - end.size[k]});
  }
  return distance;
}

/// Warns of a symmetry that holds whole bodies along an axis.
Warning warn_of_thick_plane(const Deck& deck, std::size_t condition, std::size_t axis, const ConditionMeasures& nodes) {
  const char* const name = direction_names[axis];
  return warn_at(deck, "symmetry_plane", join_path("conditions", condition) + ".symmetry",
                 fmt::format("these nodes lie in no plane across {0}, but from {1:.4g} to {2:.4g} ({3} of them between "
                             "both; symmetry: {0} holds them all along {0}): name the side that lies in the plane, "
                             "such as part/{0}_min, or write fixed: [{0}]",
                             name, nodes.low[axis], nodes.high[axis], nodes.between[axis]));
}

/// The axis across which a part is flat; -1: none.
int find_flat_axis(const PartMeasures& part) {
  constexpr double flat = 1e-6;  // share of the diagonal of its box
  for (std::size_t k = 0; k < 3; ++k)
    if (part.high[k] - part.low[k] <= flat * find_diagonal(part.low, part.high)) return static_cast<int>(k);
  return -1;
}

/// Load along an axis on a part that is flat across it; empty: nothing.
std::string find_load_across(const Deck& deck, std::size_t part, std::size_t axis) {
  for (const PressureDeck& pressure : deck.pressures) {
    const std::vector<std::size_t> parts = find_named_parts(deck, pressure.where);
    const bool leans = !pressure.direction || (*pressure.direction)[axis] != 0;
    if (leans && std::find(parts.begin(), parts.end(), part) != parts.end()) return "a pressure";
  }
  const Curve& gravity = deck.gravity.along[axis];
  return gravity.is_constant() && gravity(0) == 0 ? "" : "gravity";
}

}  // namespace

std::vector<Warning> check_idle_loads(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  for (std::size_t i = 0; i < deck.nodal_loads.size(); ++i) {
    const LoadMeasures& load = scene.measures->selections.loads[i];
    const auto& active = deck.nodal_loads[i].active;
    if (load.held > 0 && load.held == load.selected)
      warnings.push_back(warn_at(deck, "idle_load", join_path("loads.nodal", i) + ".force",
                                 fmt::format("all {} nodes of this load are held in its direction (conditions carry it "
                                             "at once, and nothing deforms): take other nodes, or free them",
                                             load.selected)));
    if (!load.turns && find_body(deck.nodal_loads[i].where).empty() && (active[3] || active[4] || active[5]))
      warnings.push_back(warn_at(deck, "idle_load", join_path("loads.nodal", i) + ".moment",
                                 "none of these nodes has rotations (only shells and beams do, and a moment on others "
                                 "has no effect): give pairs of forces"));
  }
  return warnings;
}

std::vector<Warning> check_flat_membranes(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  if (deck.start.relaxation || !deck.start.fields.empty()) return warnings;
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    const PartDeck& part = deck.parts[p];
    if (!part.is_membrane() || part.rigid) continue;
    const int across = find_flat_axis(scene.measures->parts[p]);
    const std::string load = across < 0 ? "" : find_load_across(deck, p, static_cast<std::size_t>(across));
    if (load.empty()) continue;
    warnings.push_back(
        warn_at(deck, "flat_membrane", "parts." + part.name + ".integration",
                fmt::format("part '{}' is a flat membrane, and {} acts across it (without tension it has no stiffness "
                            "there, and falls freely until it has bulged): start from rest by start: {{relaxation: "
                            "{{}}}}, give it tension, or take shells",
                            part.name, load)));
  }
  return warnings;
}

std::vector<Warning> check_symmetry_planes(const CheckedScene& scene) {
  constexpr double flat = 1e-6;  // share of the size of the nodes' box
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  for (std::size_t c = 0; c < deck.conditions.size(); ++c) {
    const ConditionDeck& condition = deck.conditions[c];
    const ConditionMeasures& box = scene.measures->selections.conditions[c];
    if (condition.kind != ConditionDeck::Kind::symmetry) continue;
    const double size = find_diagonal(box.low, box.high);
    const auto is_flat = [&](std::size_t k) { return box.high[k] - box.low[k] <= flat * size; };
    for (std::size_t k = 0; k < 3; ++k) {
      if (!condition.active[k] || is_flat(k)) continue;
      const bool is_thick = !is_flat((k + 1) % 3) && !is_flat((k + 2) % 3);
      // Two planes, with nothing between them, may be meant.
      if (is_thick && box.between[k] > 0) warnings.push_back(warn_of_thick_plane(deck, c, k, box));
      if (is_flat((k + 1) % 3) == is_flat((k + 2) % 3)) continue;
      const std::size_t across = is_flat((k + 1) % 3) ? (k + 1) % 3 : (k + 2) % 3;
      warnings.push_back(warn_at(
          deck, "symmetry_plane", join_path("conditions", c) + ".symmetry",
          fmt::format("these nodes lie in a plane with the normal {} (symmetry: {} holds them along that plane, "
                      "not across it): write symmetry: {}",
                      direction_names[across], direction_names[k], direction_names[across])));
    }
  }
  return warnings;
}

std::vector<Warning> check_damping_size(const CheckedScene& scene) {
  constexpr double most = 0.5;       // largest change of the logarithm of the speed: a body in flight loses 40 %
  constexpr double most_creep = 50;  // times critical damping, 2 pi speed / length, of the slowest wave along a part
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  for (std::size_t i = 0; i < deck.dampings.size(); ++i) {
    const double lost = integrate(deck.dampings[i].coefficient, deck.time.end);
    for (const std::size_t p : find_named_parts(deck, deck.dampings[i].where)) {
      const PartMeasures& part = scene.measures->parts[p];
      const double wave = find_wave_speed(find_material(deck, deck.parts[p]));
      const double creep = wave > 0 ? lost / deck.time.end * part.extent() / (2 * std::numbers::pi * wave) : 0;
      const bool is_stopped = part.speed > 0 && lost > most;
      if (!is_stopped && creep <= most_creep) continue;
      const std::string effect =
          is_stopped ? fmt::format("by the end free flight has slowed down to {:.2g} of its start", std::exp(-lost))
                     : fmt::format("it is {:.2g} times critical for waves along the part", creep);
      warnings.push_back(warn_at(deck, "damping_size", join_path("damping", i) + ".coefficient",
                                 fmt::format("damping stops the motion of part '{}' ({}): lower it, or switch it off "
                                             "by a table",
                                             deck.parts[p].name, effect)));
      break;
    }
  }
  return warnings;
}

std::vector<Warning> check_idle_forces(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  const PossibleContact contact(deck);
  std::vector<Warning> warnings;
  for (const ForceDeck& force : deck.output.forces) {
    if (force.kind != ForceDeck::Kind::contact) continue;
    if (is_of_itself(force)) {
      warnings.push_back({"idle_force",
                          fmt::format("the resultant of force '{}' stays 0 (both of its sides are '{}', and the forces "
                                      "of a body on itself cancel; only their magnitudes do not): name another part",
                                      force.name, force.on.front().name),
                          deck.where(force.place), 0, 1});
      continue;
    }
    if (contact.between(force)) continue;
    warnings.push_back({"idle_force",
                        fmt::format("force '{}' stays 0 (no contact, pair or tie of the deck acts between its parts): "
                                    "add a pair to contact.surfaces, or name other parts",
                                    force.name),
                        deck.where(force.place), 0, 1});
  }
  return warnings;
}

std::vector<Warning> check_idle_columns(const CheckedScene& scene, const std::vector<unsigned char>& has_acted) {
  const Deck& deck = scene.deck;
  const bool has_glue = std::any_of(deck.contact.ties.begin(), deck.contact.ties.end(),
                                    [](const TieDeck& tie) { return tie.cohesive.has_value(); });
  const char* const untouched =
      has_glue ? "its surfaces never touched, and cohesive ties do not count here" : "its surfaces never touched";
  std::vector<Warning> warnings;
  for (std::size_t f = 0; f < deck.output.forces.size(); ++f) {
    const ForceDeck& force = deck.output.forces[f];
    if (has_acted[f] != 0) continue;
    const char* const why = force.kind == ForceDeck::Kind::contact   ? untouched
                            : force.kind == ForceDeck::Kind::wall    ? "nothing ever touched this wall"
                            : force.kind == ForceDeck::Kind::support ? "nothing ever pulled at these nodes"
                                                                     : "nothing ever went through this section";
    warnings.push_back({"idle_force",
                        fmt::format("force '{}' stayed 0 in the whole run ({}): check places, velocities and time.end, "
                                    "or name others",
                                    force.name, why),
                        deck.where(force.place), 0, 1});
  }
  return warnings;
}

std::vector<Warning> check_wall_place(const CheckedScene& scene) {
  constexpr double most = 10;  // diagonals of the scene
  const Deck& deck = scene.deck;
  const double size = find_diagonal(scene.measures->low, scene.measures->high);
  std::vector<Warning> warnings;
  for (std::size_t w = 0; w < deck.walls.size(); ++w) {
    const double distance = find_distance(deck.walls[w], scene.measures->low, scene.measures->high);
    if (distance <= most * size) continue;
    warnings.push_back(warn_at(deck, "wall_place", join_path("walls", w) + ".point",
                               fmt::format("this wall is {:.3g} away from all parts ({:.3g} times the size of the "
                                           "scene): check its place and its unit",
                                           distance, distance / size)));
  }
  return warnings;
}

std::vector<Warning> check_wall_radius(const CheckedScene& scene) {
  constexpr double least = 2;  // element edges
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  for (std::size_t w = 0; w < deck.walls.size(); ++w) {
    const WallDeck& wall = deck.walls[w];
    if (!wall.is_round()) continue;
    std::size_t nearest = 0;  // part
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < deck.parts.size(); ++p) {
      const PartMeasures& part = scene.measures->parts[p];
      const double own = find_distance(wall, part.low, part.high);
      if (part.elements() == 0 || own >= distance) continue;
      nearest = p;
      distance = own;
    }
    const double radius = wall.cylinder ? wall.cylinder->radius : wall.sphere->radius;
    const PartMeasures& part = scene.measures->parts[nearest];
    if (radius >= least * part.shortest_edge || distance > part.extent()) continue;
    warnings.push_back(warn_at(
        deck, "wall_radius", join_path("walls", w) + (wall.cylinder ? ".cylinder.radius" : ".sphere.radius"),
        fmt::format("the radius is {:.3g} times the shortest element edge of part '{}' (walls stop nodes, so that this "
                    "one may slip between them): use elements of at most half the radius",
                    radius / part.shortest_edge, deck.parts[nearest].name)));
  }
  return warnings;
}

namespace {

/// Why the thickness of a sheet matters at a wall that stops it at its middle; empty: it hardly does.
std::string find_fault_of_thickness(const WallDeck& wall, const PartMeasures& part) {
  constexpr double most_bend = 0.05;                 // half a thickness over the radius that a sheet is bent to
  constexpr double nearest = 0.45, farthest = 0.55;  // thicknesses off the wall: it was placed as if the wall saw them
  constexpr double flat = 0.1;                       // of its width: a tube that stands on the wall touches by its edge
  const double distance = find_distance(wall, part.low, part.high), thickness = part.shell_thickness;
  if (wall.is_round()) {
    const double radius = wall.cylinder ? wall.cylinder->radius : wall.sphere->radius;
    if (0.5 * thickness <= most_bend * radius || distance > part.extent()) return "";
    return fmt::format("the radius to its middle is {:.3g} and not {:.3g}", radius, radius + 0.5 * thickness);
  }
  const Vec3 size = subtract(part.high, part.low);
  const double depth =
      std::abs(wall.normal[0]) * size[0] + std::abs(wall.normal[1]) * size[1] + std::abs(wall.normal[2]) * size[2];
  if (depth > flat * std::sqrt(dot(size, size)) || distance < nearest * thickness || distance > farthest * thickness)
    return "";
  return fmt::format("it begins {:.3g} off the wall, half its thickness, and has this way to go", distance);
}

}  // namespace

std::vector<Warning> check_wall_thickness(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  for (std::size_t w = 0; w < deck.walls.size(); ++w) {
    const std::string path = join_path("walls", w) + ".thickness";
    if (deck.places.has(path)) continue;
    const Marks stopped = mark_stopped(deck, deck.walls[w]);
    for (std::size_t p = 0; p < deck.parts.size(); ++p) {
      const PartMeasures& part = scene.measures->parts[p];
      const std::string fault =
          stopped[p] && part.shell_thickness > 0 ? find_fault_of_thickness(deck.walls[w], part) : "";
      if (fault.empty()) continue;
      warnings.push_back(warn_at(deck, "wall_thickness", path,
                                 fmt::format("this wall stops the shells of part '{}' at their middle ({}): set "
                                             "{}: included, or ignored if that is meant",
                                             deck.parts[p].name, fault, path)));
      break;
    }
  }
  return warnings;
}

std::vector<Warning> check_spring_length(const CheckedScene& scene) {
  constexpr double most = 10;  // diagonals of the scene
  const Deck& deck = scene.deck;
  const double size = find_diagonal(scene.measures->low, scene.measures->high);
  std::vector<Warning> warnings;
  for (const SpringDeck& spring : deck.springs) {
    if (!spring.rest_length || *spring.rest_length <= most * size) continue;
    warnings.push_back(warn_at(deck, "spring_length", "springs." + spring.name + ".rest_length",
                               fmt::format("spring '{}' is {:g} long at rest, {:.3g} times the size of the scene (it "
                                           "pushes its ends apart at once): check its unit",
                                           spring.name, *spring.rest_length, *spring.rest_length / size)));
  }
  return warnings;
}

}  // namespace percuss
