#include "src/checks/flight.hpp"

#include <algorithm>
#include <cmath>

#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Pieces of a run; between their ends boxes are joined, so that nothing is missed.
constexpr int pieces = 256;

/// Share of a part's size to which boxes are told apart.
constexpr double margin = 0.05;

double find_size(const Flight::Box& box) {
  return std::max({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
}

Flight::Box join(const Flight::Box& a, const Flight::Box& b) {
  Flight::Box both = a;
  for (std::size_t k = 0; k < 3; ++k) {
    both.low[k] = std::min(both.low[k], b.low[k]);
    both.high[k] = std::max(both.high[k], b.high[k]);
  }
  return both;
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

Flight::Flight(const CheckedScene& scene, std::size_t part) {
  const PartMeasures& measures = scene.measures->parts[part];
  const Deck& deck = scene.deck;
  const double half = 0.5 * deck.parts[part].thickness.value_or(0);
  start_ = {measures.low, measures.high};
  for (std::size_t k = 0; k < 3; ++k) {
    start_.low[k] -= half;
    start_.high[k] += half;
  }
  velocity_low_ = measures.velocity_low;
  velocity_high_ = measures.velocity_high;
  gravity_ = deck.gravity;
  const Vec3 range = subtract(velocity_high_, velocity_low_);
  is_uniform_ = dot(range, range) <= 1e-12 * measures.speed * measures.speed;
}

void Flight::add(const ConditionDeck& condition, double end) {
  is_held_ = true;
  gravity_ = {};
  if (condition.kind == ConditionDeck::Kind::fixed || condition.kind == ConditionDeck::Kind::symmetry) return;
  const bool is_velocity = condition.kind == ConditionDeck::Kind::velocity;
  for (std::size_t k = 0; k < 3; ++k) {
    if (condition.active[k]) add_range(condition.value[k], is_velocity, end, driven_.low[k], driven_.high[k]);
  }
}

bool Flight::moves() const {
  return velocity_low_ != Vec3{} || velocity_high_ != Vec3{} || gravity_ != Vec3{} || find_size(driven_) > 0;
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

Flight::Box Flight::find_box(double from, double to) const {
  Box box = join(find_box(from), find_box(to));
  for (std::size_t k = 0; k < 3; ++k) {  // the top of a throw
    const double rise = std::abs(gravity_[k]) * (to - from) * (to - from) / 8;
    box.low[k] -= gravity_[k] > 0 ? rise : 0;
    box.high[k] += gravity_[k] < 0 ? rise : 0;
  }
  return box;
}

std::vector<Flight> find_flights(const CheckedScene& scene) {
  std::vector<Flight> flights;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) flights.emplace_back(scene, p);
  for (const ConditionDeck& condition : scene.deck.conditions) {
    for (const std::size_t p : find_named_parts(scene.deck, condition.where))
      flights[p].add(condition, scene.deck.time.end);
  }
  return flights;
}

double find_meeting(const Flight& a, const Flight& b, double end) {
  const double gap = margin * std::min(find_size(a.find_box(0, 0)), find_size(b.find_box(0, 0)));
  return find_first(end, [&](double from, double to) {
    const Flight::Box one = a.find_box(from, to), other = b.find_box(from, to);
    for (std::size_t k = 0; k < 3; ++k) {
      if (one.low[k] > other.high[k] + gap || other.low[k] > one.high[k] + gap) return false;
    }
    return true;
  });
}

double find_meeting(const Flight& part, const WallDeck& wall, double end) {
  const double gap = margin * find_size(part.find_box(0, 0));
  return find_first(end, [&](double from, double to) {
    const Flight::Box box = part.find_box(from, to);
    double height = 0;  // of the corner that is closest to the wall
    for (std::size_t k = 0; k < 3; ++k)
      height += wall.normal[k] * ((wall.normal[k] > 0 ? box.low[k] : box.high[k]) - wall.point[k]);
    return height <= gap;
  });
}

}  // namespace percuss
