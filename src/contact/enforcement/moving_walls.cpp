#include "src/contact/enforcement/moving_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

std::vector<int> list_moving_walls(const Deck& deck) {
  std::vector<int> moving;
  for (std::size_t w = 0; w < deck.walls.size(); ++w)
    if (deck.walls[w].moves()) moving.push_back(static_cast<int>(w));
  return moving;
}

/// The largest speed of all nodes [mesh nodes, of all ranks]. Collective.
double find_fastest_node(const Rows3<const double>& v, const Communicator& ranks) {
  const auto host = to_host(v);
  double square = 0;
  for (std::size_t n = 0; n < host.extent(0); ++n)
    square = std::max(square, host(n, 0) * host(n, 0) + host(n, 1) * host(n, 1) + host(n, 2) * host(n, 2));
  all_reduce(ranks, Reduce::largest, square);
  return std::sqrt(square);
}

}  // namespace

std::vector<std::string> name_moving_walls(const Deck& deck) {
  std::vector<std::string> names;
  for (const int w : list_moving_walls(deck)) {
    const std::string& name = deck.walls[static_cast<std::size_t>(w)].name;
    names.push_back(name.empty() ? fmt::format("walls.{}", w) : name);
  }
  return names;
}

MovingWalls::MovingWalls(const Deck& deck, const Communicator& ranks)
    : deck_(deck),
      ranks_(ranks),
      moving_(list_moving_walls(deck)),
      motions_(moving_.size()),
      speeds_(moving_.size(), 0) {
  for (std::size_t i = 0; i < moving_.size(); ++i) motions_[i].speed = find_speed(i, 0, 0);
}

/// As prescribed; of a wall with a mass that of n-1/2, and at the start that of the deck.
double MovingWalls::find_speed(std::size_t i, double time, double dt) const {
  if (wall(i).speed) return (*wall(i).speed)(time + 0.5 * dt);
  return has_begun_ ? motions_[i].speed : wall(i).start_speed;
}

/// A wall with a mass, which is a plane, only slows down where bodies meet it.
double MovingWalls::find_fastest(double time, double dt) const {
  double fastest = 0;
  for (std::size_t i = 0; i < moving_.size(); ++i) fastest = std::max(fastest, std::abs(find_speed(i, time, dt)));
  return fastest;
}

double MovingWalls::find_fastest_before() const {
  double fastest = 0;
  for (const WallMotion& motion : motions_) fastest = std::max(fastest, std::abs(motion.speed));
  return fastest;
}

void MovingWalls::write(const WallPairs& walls, const std::vector<double>& speeds) const {
  const auto host = Kokkos::create_mirror_view(walls.walls);
  copy_values(host, walls.walls);
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    ContactWall& of = host(static_cast<std::size_t>(moving_[i]));
    const Vec3& point = wall(i).point;
    const Point3& way = of.shape == WallShape::plane ? of.normal : of.direction;
    of.point = Point3{point[0], point[1], point[2]} + motions_[i].displacement * way;
    of.speed = speeds[i];
  }
  copy_values(walls.walls, host);
}

void MovingWalls::place(const WallPairs& walls) const {
  if (any()) write(walls, std::vector<double>(moving_.size(), 0));
}

void MovingWalls::start_step(const WorkSpace& space, const WallPairs& walls, const RowInputs& inputs, double time,
                             RowSumMemory& memory) {
  if (!any() || is_held_) return;
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    speeds_[i] = find_speed(i, time, inputs.motion.dt);
    if (!has_begun_ && wall(i).speed) motions_[i].speed = speeds_[i];
  }
  has_begun_ = true;
  write(walls, speeds_);
  // M (w - w0) + sum of m max(0, w - touching) = 0 has a convex left side: Newton's method comes down to the root, in
  // as many passes as sets of nodes come off, most often one or two.
  constexpr int most_passes = 50;
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    if (!wall(i).mass) continue;
    const double mass = *wall(i).mass, before = motions_[i].speed;
    for (int pass = 0; pass < most_passes; ++pass) {
      const WallMeeting own = sum_wall_meeting(space, moving_[i], walls, inputs, memory);
      std::array<ExactSum, 2> sums{own.mass, own.momentum};
      sum_over_ranks(ranks_, sums);
      const double met = sums[0].round(), next = (mass * before + sums[1].round()) / (mass + met);
      if (met == 0 || !(next < speeds_[i])) break;
      speeds_[i] = next;
      write(walls, speeds_);
    }
  }
}

/// Rows that contradict each other push without bound. A wall with a mass then leaves faster than an elastic impact
/// allows: on nodes whose motion it cannot change, it turns from w to 2 a - w.
void MovingWalls::refuse_throw(std::size_t i, double after, const Rows3<const double>& v_before) const {
  constexpr double margin = 1.1;
  const double before = motions_[i].speed, alone = std::max(std::abs(before), std::abs(2 * speeds_[i] - before));
  if (std::abs(after) <= margin * alone) return;
  if (std::abs(after) <= margin * std::max(alone, std::abs(before) + 2 * find_fastest_node(v_before, ranks_))) return;
  throw RunError(
      fmt::format("wall '{}' would be thrown back (from speed {:.3g} to {:.3g} in a step, because contact does not "
                  "converge: held nodes, or nodes against another wall, cannot move away): use a rigid part of this "
                  "mass, or name only nodes that can move in walls.N.nodes",
                  name_moving_walls(deck_)[i], before, after));
}

WallWork MovingWalls::finish_step(const WorkSpace& space, int first_row, const ContactMotion& motion, bool converged,
                                  const RowSystem& system, RowSumMemory& memory) {
  WallWork work;
  if (is_held_) return work;
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    const Vec3& way = wall(i).direction;
    const WallPush own = sum_wall_push(space, first_row, moving_[i], Point3{way[0], way[1], way[2]}, system, memory);
    std::array<ExactSum, 2> push{own.push, own.friction};
    sum_over_ranks(ranks_, push);
    const double impulse = push[0].round(), before = motions_[i].speed;
    const double after = wall(i).mass ? before - impulse / *wall(i).mass : speeds_[i];
    if (wall(i).mass && !converged) refuse_throw(i, after, motion.v_before);
    const double pushed = impulse * (0.5 * (before + after)), by_friction = push[1].round() * (0.5 * (before + after));
    work.push += pushed;
    work.friction += by_friction;
    if (!wall(i).mass) work.driven += pushed + by_friction;
    motions_[i] = {motions_[i].displacement + motion.dt * after, after};
  }
  return work;
}

double MovingWalls::find_kinetic_energy() const {
  double energy = 0;
  for (std::size_t i = 0; i < moving_.size() && !is_held_; ++i) {
    if (!wall(i).mass) continue;
    energy += 0.5 * *wall(i).mass * (motions_[i].speed * motions_[i].speed);
  }
  return energy;
}

void MovingWalls::archive(CheckpointArchive& archive) {
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const std::string name = fmt::format("contact/walls/{}/", moving_[i]);
    archive.number(name + "displacement", motions_[i].displacement);
    archive.number(name + "speed", motions_[i].speed);
  }
  if (any()) archive.integer("contact/walls/has_begun", has_begun_);
}

}  // namespace percuss
