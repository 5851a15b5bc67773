#include "src/checks/flight.hpp"

#include <algorithm>
#include <cmath>

#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Pieces of a run, in which distances change along straight lines.
constexpr int pieces = 256;

double find_size(const Flight::Box& box) {
  return std::max({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
}

/// Adds the range of the displacement that a curve of velocity, or of displacement, leads to by `end`.
void add_range(const Curve& curve, bool is_velocity, double end, double& low, double& high) {
  double sum = 0;
  for (int i = 0; i < pieces; ++i) {
    const double dt = end / pieces;
    sum = is_velocity ? sum + dt * curve((i + 0.5) * dt) : curve((i + 1) * dt);
    low = std::min(low, sum);
    high = std::max(high, sum);
  }
}

/// Whether the deck holds a translation of the rigid body that a part is, alone or with others.
bool is_fixed(const Deck& deck, const PartDeck& part, std::size_t axis) {
  if (!part.rigid) return false;
  return std::any_of(deck.parts.begin(), deck.parts.end(), [&](const PartDeck& other) {
    const bool is_same =
        &other == &part || (!part.rigid->body.empty() && other.rigid && other.rigid->body == part.rigid->body);
    return is_same && other.rigid->fixed[axis];
  });
}

/// The first piece of a run in which `touches(from, to)`, looked for only if it does so in the run as a whole.
template <class Touches>
double find_first(double end, const Touches& touches) {
  if (!touches(0, end)) return -1;
  for (int i = 0; i < pieces; ++i) {
    if (touches(end * i / pieces, end * (i + 1) / pieces)) return end * i / pieces;
  }
  return -1;
}

}  // namespace

bool do_beams_touch(const CheckedScene& scene, std::size_t part) {
  const ContactDeck& contact = scene.deck.contact;
  if (contact.surfaces == ContactDeck::Surfaces::all) return contact.beams;
  const PartMeasures& measures = scene.measures->parts[part];
  const bool is_of_beams = measures.solids + measures.shells == 0;
  const auto means = [&](const Selector& side) {
    const bool names = side.name == scene.deck.parts[part].name;
    return !side.inside && ((names && is_of_beams) || (contact.beams && (names || side.name.empty())));
  };
  return std::any_of(contact.pairs.begin(), contact.pairs.end(),
                     [&](const SurfacePairDeck& pair) { return means(pair.a) || means(pair.b); });
}

Flight::Flight(const CheckedScene& scene, std::size_t part) {
  const PartMeasures& measures = scene.measures->parts[part];
  const Deck& deck = scene.deck;
  half_thickness_ = 0.5 * measures.shell_thickness;
  const PartDeck& own = deck.parts[part];
  if (own.section && do_beams_touch(scene, part))
    half_thickness_ = std::max(half_thickness_, own.contact_radius.value_or(find_contact_radius(*own.section)));
  start_ = {measures.low, measures.high};
  for (std::size_t k = 0; k < 3; ++k) {
    start_.low[k] -= half_thickness_;
    start_.high[k] += half_thickness_;
  }
  velocity_low_ = measures.velocity_low;
  velocity_high_ = measures.velocity_high;
  if (deck.gravity.is_constant()) gravity_ = deck.gravity.at(0);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!is_fixed(deck, deck.parts[part], k)) continue;
    is_held_ = true;
    gravity_[k] = velocity_low_[k] = velocity_high_[k] = 0;
  }
  speed_ = measures.speed;
}

bool Flight::is_uniform() const {
  const Vec3 range = subtract(velocity_high_, velocity_low_);
  return dot(range, range) <= 1e-12 * speed_ * speed_;
}

void Flight::add(const ConditionDeck& condition, double end, bool of_all_nodes) {
  is_held_ = true;
  is_held_in_part_ = is_held_in_part_ || !of_all_nodes || condition.turn.has_value();
  for (std::size_t k = 0; k < 3; ++k) {
    if (!of_all_nodes || condition.active[k]) gravity_[k] = 0;
    if (of_all_nodes && condition.active[k]) velocity_low_[k] = velocity_high_[k] = 0;
  }
  if (condition.kind == ConditionDeck::Kind::fixed || condition.kind == ConditionDeck::Kind::symmetry) return;
  if (condition.turn) {
    add_turn(*condition.turn);
    return;
  }
  const bool is_velocity = condition.kind == ConditionDeck::Kind::velocity;
  for (std::size_t k = 0; k < 3; ++k) {
    if (condition.active[k]) add_range(condition.value[k], is_velocity, end, driven_.low[k], driven_.high[k]);
  }
}

void Flight::add_turn(const TurnDeck& turn) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == turn.axis) continue;
    const double far = std::max(std::abs(start_.low[k] - turn.through[k]), std::abs(start_.high[k] - turn.through[k]));
    square += far * far;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == turn.axis) continue;
    driven_.low[k] -= 2 * std::sqrt(square);
    driven_.high[k] += 2 * std::sqrt(square);
  }
}

bool Flight::moves() const {
  return velocity_low_ != Vec3{} || velocity_high_ != Vec3{} || gravity_ != Vec3{} || find_size(driven_) > 0;
}

bool Flight::moves_with(const Flight& other) const {
  return is_uniform() && other.is_uniform() && velocity_low_ == other.velocity_low_ && gravity_ == other.gravity_ &&
         driven_.low == other.driven_.low && driven_.high == other.driven_.high;
}

Flight::Box Flight::find_box(double time) const {
  Box box = start_;
  for (std::size_t k = 0; k < 3; ++k) {
    const double fall = 0.5 * gravity_[k] * time * time;
    box.low[k] += velocity_low_[k] * time + fall + driven_.low[k];
    box.high[k] += velocity_high_[k] * time + fall + driven_.high[k];
  }
  return box;
}

Flight::Box Flight::find_box(double time, const WallDeck& wall) const {
  Box box = find_box(time);
  const double left_out = wall.includes_thickness ? 0 : half_thickness_;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] += left_out;
    box.high[k] -= left_out;
  }
  return box;
}

std::vector<Flight> find_flights(const CheckedScene& scene) {
  std::vector<Flight> flights;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) flights.emplace_back(scene, p);
  for (const ConditionDeck& condition : scene.deck.conditions) {
    for (const std::size_t p : find_named_parts(scene.deck, condition.where)) {
      const bool of_all_nodes =
          condition.where.name == scene.deck.parts[p].name && !condition.where.inside && !condition.when.any();
      flights[p].add(condition, scene.deck.time.end, of_all_nodes);
    }
  }
  return flights;
}

double find_gap(const Flight::Box& a, const Flight::Box& b) {
  Vec3 apart{};
  for (std::size_t k = 0; k < 3; ++k) apart[k] = std::max({a.low[k] - b.high[k], b.low[k] - a.high[k], 0.0});
  return std::sqrt(dot(apart, apart));
}

bool do_overlap(const Flight::Box& a, const Flight::Box& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.low[k] >= b.high[k] || b.low[k] >= a.high[k]) return false;
  }
  return true;
}

double find_meeting(const Flight& a, const Flight& b, double end, double share) {
  const double gap = share * std::min(find_size(a.find_box(0)), find_size(b.find_box(0)));
  const Vec3 pull = subtract(a.gravity(), b.gravity());
  return find_first(end, [&](double from, double to) {
    const Flight::Box one[] = {a.find_box(from), a.find_box(to)}, other[] = {b.find_box(from), b.find_box(to)};
    for (std::size_t k = 0; k < 3; ++k) {
      const double bend = std::abs(pull[k]) * (to - from) * (to - from) / 8;
      const double above = std::min(one[0].low[k] - other[0].high[k], one[1].low[k] - other[1].high[k]);
      const double below = std::min(other[0].low[k] - one[0].high[k], other[1].low[k] - one[1].high[k]);
      if (above > gap + bend || below > gap + bend) return false;
    }
    return true;
  });
}

namespace {

/// Height of the corner that is closest to a plane.
double find_height(const Flight::Box& box, const WallDeck& wall) {
  double height = 0;
  for (std::size_t k = 0; k < 3; ++k)
    height += wall.normal[k] * ((wall.normal[k] > 0 ? box.low[k] : box.high[k]) - wall.point[k]);
  return height;
}

/// Whether distance(time), a parabola, is not negative at time 0 and grows from there on until `end`.
template <class Distance>
bool is_growing(double end, double size, const Distance& distance) {
  constexpr double round_off = 1e-9;  // share of a size, and of the growth
  const double first = distance(0), middle = distance(0.5 * end), last = distance(end), growth = last - first;
  const double start_slope = 4 * middle - 3 * first - last, end_slope = first - 4 * middle + 3 * last;
  return first >= -round_off * size && growth > round_off * size &&
         std::min(start_slope, end_slope) >= -round_off * growth;
}

/// Height of the middle of a box over a cylinder without end or a sphere, less half its diagonal: a lower bound.
double find_height_over_round(const Flight::Box& box, const WallDeck& wall) {
  Vec3 middle{}, half{};
  for (std::size_t k = 0; k < 3; ++k) {
    middle[k] = 0.5 * (box.low[k] + box.high[k]) - wall.point[k];
    half[k] = 0.5 * (box.high[k] - box.low[k]);
  }
  const double along = wall.cylinder ? dot(middle, wall.cylinder->axis) : 0;
  const double away = std::sqrt(std::max(dot(middle, middle) - along * along, 0.0));
  return away - std::sqrt(dot(half, half)) - (wall.cylinder ? wall.cylinder->radius : wall.sphere->radius);
}

}  // namespace

double find_meeting(const Flight& part, const WallDeck& wall, double end, double share) {
  const double gap = share * find_size(part.find_box(0, wall));
  if (wall.is_round()) {
    const double bend_rate = std::sqrt(dot(part.gravity(), part.gravity())) / 8;
    return find_first(end, [&](double from, double to) {
      // Between two times a flight comes nearer than at either by at most half of its way.
      const Flight::Box box = part.find_box(from, wall), next = part.find_box(to, wall);
      double way = 0;
      for (std::size_t k = 0; k < 3; ++k) way += std::abs(next.low[k] - box.low[k]);
      const double nearest = std::min(find_height_over_round(box, wall), find_height_over_round(next, wall));
      return nearest <= gap + 0.5 * way + bend_rate * (to - from) * (to - from);
    });
  }
  return find_first(end, [&](double from, double to) {
    const double bend = std::abs(dot(part.gravity(), wall.normal)) * (to - from) * (to - from) / 8;
    return std::min(find_height(part.find_box(from, wall), wall), find_height(part.find_box(to, wall), wall)) <=
           gap + bend;
  });
}

double find_gap(const Flight& part, const WallDeck& wall, double time) {
  const Flight::Box box = part.find_box(time, wall);
  return wall.is_round() ? find_height_over_round(box, wall) : find_height(box, wall);
}

double find_wall_way(const WallDeck& wall, double time) {
  if (!wall.speed) return wall.start_speed * time;
  double way = 0;
  for (int i = 0; i < pieces; ++i) way += time / pieces * (*wall.speed)((i + 0.5) * time / pieces);
  return way;
}

Vec3 find_wall_direction(const WallDeck& wall) { return wall.is_round() ? wall.direction : wall.normal; }

// Between two times a wall and a part come nearer than at either by at most half of their ways.
bool does_wall_reach(const WallDeck& wall, const Flight& part, double end) {
  const Vec3 direction = find_wall_direction(wall);
  const double margin = touching_share * find_size(part.find_box(0, wall));
  WallDeck moved = wall;
  double way = 0, last = 0, last_gap = 0;
  for (int i = 0; i <= pieces; ++i) {
    const double time = end * i / pieces;
    way += i == 0       ? 0
           : wall.speed ? end / pieces * (*wall.speed)(end * (i - 0.5) / pieces)
                        : wall.start_speed * end / pieces;
    for (std::size_t k = 0; k < 3; ++k) moved.point[k] = wall.point[k] + way * direction[k];
    const double gap = find_gap(part, moved, time);
    double travel = std::abs(way - last);
    const Flight::Box box = part.find_box(time, wall),
                      before = part.find_box(i == 0 ? 0 : end * (i - 1) / pieces, wall);
    for (std::size_t k = 0; k < 3; ++k) travel += std::abs(box.low[k] - before.low[k]);
    if (std::min(gap, i == 0 ? gap : last_gap) - 0.5 * travel <= margin) return true;
    last = way;
    last_gap = gap;
  }
  return false;
}

bool do_separate(const Flight& a, const Flight& b, double end) {
  const double size = std::min(find_size(a.find_box(0)), find_size(b.find_box(0)));
  for (std::size_t k = 0; k < 3; ++k) {
    const auto above = [&](double time) { return a.find_box(time).low[k] - b.find_box(time).high[k]; };
    const auto below = [&](double time) { return b.find_box(time).low[k] - a.find_box(time).high[k]; };
    if (is_growing(end, size, above) || is_growing(end, size, below)) return true;
  }
  return false;
}

bool do_separate(const Flight& part, const WallDeck& wall, double end) {
  if (wall.is_round()) return false;
  return is_growing(end, find_size(part.find_box(0, wall)),
                    [&](double time) { return find_height(part.find_box(time, wall), wall); });
}

}  // namespace percuss
