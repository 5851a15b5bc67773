#pragma once
// Where parts can be during a run if nothing stops them: boxes that fly at the velocities of the start.

#include <vector>

#include "src/checks/checked_scene.hpp"

namespace percuss {

/// The box of a part over time.
class Flight {
 public:
  struct Box {
    Vec3 low, high;
  };

  /// A part without conditions.
  Flight(const CheckedScene& scene, std::size_t part);

  /// A condition that names the part, or some of its nodes.
  void add(const ConditionDeck& condition, double end, bool of_all_nodes);

  /// Where the part is, half its thickness included.
  Box find_box(double time) const;

  /// The box that a wall meets: that of its nodes, with half its thickness only where the wall includes that.
  Box find_box(double time, const WallDeck& wall) const;

  const Vec3& gravity() const { return gravity_; }

  /// Whether no condition holds the part and all its nodes have one velocity.
  bool is_free() const { return !is_held_ && is_uniform(); }

  /// Whether the deck says where all its nodes go: they fly with one velocity, or conditions move them all alike.
  bool is_known() const { return !is_held_in_part_ && is_uniform(); }

  /// Velocity at the start of a part that is free.
  const Vec3& velocity() const { return velocity_low_; }

  /// Whether it moves at all.
  bool moves() const;

  /// Whether both move alike, so that neither comes closer to the other.
  bool moves_with(const Flight& other) const;

 private:
  Box start_{};
  double half_thickness_ = 0;                          // of shells; the radius of beams that touch
  Vec3 velocity_low_{}, velocity_high_{}, gravity_{};  // gravity: 0 where it changes in time
  Box driven_{};                                       // range of the displacement that conditions prescribe
  double speed_ = 0;                                   // of its fastest node
  bool is_held_ = false, is_held_in_part_ = false;

  bool is_uniform() const;
  void add_turn(const TurnDeck& turn);
};

/// Bodies closer than this share of their size are taken as touching.
inline constexpr double touching_share = 1e-6;

/// The share of the size where boxes that only touch may part.
inline constexpr double overlapping_share = -1e-6;

/// All parts of a scene.
std::vector<Flight> find_flights(const CheckedScene& scene);

/// Whether the beams of a part touch, by the deck.
bool do_beams_touch(const CheckedScene& scene, std::size_t part);

/// Whether two boxes overlap.
bool do_overlap(const Flight::Box& a, const Flight::Box& b);

/// The distance between two boxes; 0: they overlap.
double find_gap(const Flight::Box& a, const Flight::Box& b);

/// Lower bound of the gap between a part and a wall at time 0. Finite walls are treated as infinite; for round walls
/// the part is replaced by the ball around its box.
double find_gap(const Flight& part, const WallDeck& wall, double time);

/// The first time up to `end` at which the boxes of two parts can come closer than a share of their smaller size; below
/// 0: never.
double find_meeting(const Flight& a, const Flight& b, double end, double share);

/// The first time at which a part can come that close to a wall of time 0, treated as infinite; for a cylinder or a
/// sphere the part is replaced by the ball around its box.
/// share: of the part's size.
double find_meeting(const Flight& part, const WallDeck& wall, double end, double share);

/// Displacement at a time of a wall that moves, if nothing pushes it, along the direction that find_wall_direction()
/// gives.
double find_wall_way(const WallDeck& wall, double time);
Vec3 find_wall_direction(const WallDeck& wall);

/// Whether a wall that moves comes to a part before `end`.
bool does_wall_reach(const WallDeck& wall, const Flight& part, double end);

/// Whether the boxes of two parts are apart at the start and only move farther apart until `end`, along one axis.
bool do_separate(const Flight& a, const Flight& b, double end);

/// Whether a part is in front of a plane at the start and only moves farther away from it until `end`. False for walls
/// that are round.
bool do_separate(const Flight& part, const WallDeck& wall, double end);

}  // namespace percuss
