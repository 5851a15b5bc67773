// Bodies that rest on each other: rigid ones with many nodes, and those that friction is to hold.

#include <algorithm>
#include <cmath>
#include <optional>

#include "src/checks/flight.hpp"
#include "src/checks/rules.hpp"
#include "src/checks/who_touches.hpp"
#include "src/deck/jointed_parts.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Whether the nodes of a part have no motion of their own: it is rigid, or held or driven as a whole.
bool moves_as_one(const Deck& deck, std::size_t part) {
  return deck.parts[part].rigid.has_value() || is_driven(deck, deck.parts[part]);
}

/// Whom parts meet in a run or touch at its start, by their boxes.
class Neighbours {
 public:
  explicit Neighbours(const CheckedScene& scene)
      : scene_(scene), flights_(find_flights(scene)), touching_(mark_touching(scene.deck)) {}

  /// "part 'plate'" or "walls.0" that a part comes to before a time; empty: nothing.
  std::string find(std::size_t part, double end) const {
    const Deck& deck = scene_.deck;
    for (std::size_t q = 0; q < flights_.size(); ++q)
      if (meets(part, q, end)) return fmt::format("part '{}'", deck.parts[q].name);
    for (std::size_t w = 0; w < deck.walls.size(); ++w)
      if (meets_wall(part, w, end)) return join_path("walls", w);
    return "";
  }

  bool meets(std::size_t part, std::size_t other, double end) const {
    return other != part && touching_[part] && touching_[other] && !scene_.measures->are_joined(part, other) &&
           !are_jointed(scene_.deck, part, other) &&
           find_meeting(flights_[part], flights_[other], end, touching_share) >= 0;
  }

  bool meets_wall(std::size_t part, std::size_t wall, double end) const {
    const WallDeck& one = scene_.deck.walls[wall];
    return mark_stopped(scene_.deck, one)[part] && find_meeting(flights_[part], one, end, touching_share) >= 0;
  }

  const Flight& flight(std::size_t part) const { return flights_[part]; }

 private:
  const CheckedScene& scene_;
  std::vector<Flight> flights_;
  Marks touching_;
};

/// A load that has its full direction from the first step on.
struct SuddenLoad {
  std::string path;
  Vec3 force{};
  std::optional<Selector> where;  // none: everywhere
};

std::vector<SuddenLoad> list_sudden_loads(const Deck& deck) {
  std::vector<SuddenLoad> loads;
  if (deck.gravity.at(0) != Vec3{}) loads.push_back({"loads.gravity", deck.gravity.at(0), {}});
  for (std::size_t i = 0; i < deck.nodal_loads.size(); ++i) {
    const NodalLoadDeck& load = deck.nodal_loads[i];
    Vec3 force{};
    for (std::size_t k = 0; k < 3; ++k) force[k] = load.active[k] ? load.value[k](0) : 0;
    if (force != Vec3{} && !load.when.any()) loads.push_back({join_path("loads.nodal", i), force, load.where});
  }
  return loads;
}

/// Whether a force pulls a body along a surface with this normal.
bool pulls_along(const Vec3& force, const Vec3& normal) {
  constexpr double least = 0.02;  // sine of the angle: a degree
  const Vec3 across = cross(force, normal);
  return dot(across, across) > least * least * dot(force, force) * dot(normal, normal);
}

/// The normal between two boxes that touch along one axis alone; zero where it is not known.
Vec3 find_normal(const Flight::Box& a, const Flight::Box& b) {
  Vec3 normal{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double size = std::min(a.high[k] - a.low[k], b.high[k] - b.low[k]);
    const double overlap = std::min(a.high[k], b.high[k]) - std::max(a.low[k], b.low[k]);
    if (overlap <= touching_share * size) normal[k] = 1;
  }
  return normal[0] + normal[1] + normal[2] == 1 ? normal : Vec3{};
}

double find_friction(const Deck& deck) {
  double most = deck.contact.friction;
  for (const PairFrictionDeck& pair : deck.contact.frictions) most = std::max(most, pair.friction);
  for (const SurfacePairDeck& pair : deck.contact.pairs) most = std::max(most, pair.friction.value_or(0));
  return most;
}

/// Surface along which a load may pull a part from the start, with friction: "walls.0", "part 'plate'"; empty: nothing.
std::string find_slope(const CheckedScene& scene, const Neighbours& neighbours, std::size_t part, const Vec3& force) {
  const Deck& deck = scene.deck;
  for (std::size_t w = 0; w < deck.walls.size(); ++w) {
    const WallDeck& wall = deck.walls[w];
    if (wall.friction == 0 || (!wall.is_round() && !pulls_along(force, wall.normal))) continue;
    if (neighbours.meets_wall(part, w, 0)) return join_path("walls", w);
  }
  if (find_friction(deck) == 0) return "";
  for (std::size_t q = 0; q < deck.parts.size(); ++q) {
    if (!neighbours.meets(part, q, 0)) continue;
    const Vec3 normal = find_normal(neighbours.flight(part).find_box(0), neighbours.flight(q).find_box(0));
    if (normal == Vec3{} || pulls_along(force, normal)) return fmt::format("part '{}'", deck.parts[q].name);
  }
  return "";
}

/// Whether the vibrations of a part continue: neither its material nor its control of bending damps them.
bool rings(const Deck& deck, std::size_t part) {
  const ElementDeck elements = deck.find_elements(part);
  return !deck.parts[part].rigid && elements.stiffness_damping == 0 &&
         elements.hourglass != ElementDeck::Hourglass::viscous;
}

bool is_at_rest(const CheckedScene& scene) {
  const auto drives = [](const ConditionDeck& condition) {
    return condition.turn || condition.kind == ConditionDeck::Kind::velocity ||
           condition.kind == ConditionDeck::Kind::displacement;
  };
  const auto& parts = scene.measures->parts;
  return std::none_of(parts.begin(), parts.end(), [](const PartMeasures& part) { return part.speed > 0; }) &&
         std::none_of(scene.deck.conditions.begin(), scene.deck.conditions.end(), drives) &&
         std::none_of(scene.deck.walls.begin(), scene.deck.walls.end(),
                      [](const WallDeck& wall) { return wall.moves(); });
}

}  // namespace

std::vector<Warning> check_lagrange_rigid(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  if (deck.contact.enforcement != ContactDeck::Enforcement::lagrange || deck.parts.size() > most_compared_parts)
    return {};
  const Neighbours neighbours(scene);
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    if (!moves_as_one(deck, p)) continue;
    const std::string other = neighbours.find(p, deck.time.end);
    if (other.empty()) continue;
    return {
        warn_at(deck, "lagrange_rigid", "contact.enforcement",
                fmt::format("{} part '{}' meets {} (where more of its nodes touch than the motion of the other side "
                            "needs, the rows of lagrange depend on each other and do not converge): use "
                            "enforcement: kinematic",
                            deck.parts[p].rigid ? "rigid" : "held", deck.parts[p].name, other))};
  }
  return {};
}

// Coulomb friction holds a node while its forces allow it; what rings takes them off, node after node, at every swing.
std::vector<Warning> check_undamped_friction(const CheckedScene& scene) {
  constexpr double share = 0.25;  // of the step: a fifth to a third damps what flutters
  const Deck& deck = scene.deck;
  if (deck.start.relaxation || !deck.dampings.empty() || !is_at_rest(scene)) return {};
  if (deck.parts.size() > most_compared_parts) return {};
  const Neighbours neighbours(scene);
  for (const SuddenLoad& load : list_sudden_loads(deck)) {
    Marks loaded(deck.parts.size(), !load.where);
    if (load.where) mark(deck, *load.where, loaded);
    for (std::size_t p = 0; p < deck.parts.size(); ++p) {
      const std::string on = loaded[p] && neighbours.flight(p).is_free() && rings(deck, p)
                                 ? find_slope(scene, neighbours, p, load.force)
                                 : "";
      if (on.empty()) continue;
      const std::string& name = deck.parts[p].name;
      return {warn_at(deck, "undamped_friction", load.path,
                      fmt::format("this load acts at once on part '{}', which friction is to hold on {} (without "
                                  "damping it rings, and creeps where it should stick, by some 1 % of a free fall): "
                                  "set parts.{}.stiffness_damping: {:.2g}, or begin at rest by start.relaxation",
                                  name, on, name, share * deck.time.step_scale * scene.stable_step))};
    }
  }
  return {};
}

}  // namespace percuss
