#pragma once
// A bound of the step from the motion of parts and rigid walls towards each other: a part that flies faster than its
// waves would be deep behind a wall, with all nodes that the wall stops at once, before contact could act.

#include <vector>

#include "comm/communicator.hpp"
#include "kernels/contact/rows/row_system.hpp"
#include "src/contact/approach/approach.hpp"
#include "src/contact/enforcement/moving_walls.hpp"

namespace percuss {

/// Walls with their pairs, and how each moves.
struct MovedWalls {
  const WallPairs& pairs;
  std::vector<WallMotion> motions;  // [walls]
};

class WallWatch {
 public:
  /// Deck and mesh outlive this. Collective, as are all calls but may_limit().
  WallWatch(const Communicator& ranks, const Deck& deck, const Mesh& mesh) : ranks_(ranks), deck_(deck), mesh_(mesh) {}

  /// The pairs are others now.
  void redefine(const WallPairs& pairs);

  /// Longest way of a node that a wall stops, in a step [length].
  double find_way(const WallPairs& pairs, const SurfaceMotion& motion) const;

  /// Whether a step of dt in which no node goes farther than `way` can be followed by one that has a bound.
  bool may_limit(double way, const std::vector<WallMotion>& motions, double dt) const;

  /// Bound of the first step, dt at most. Any motion counts, also of what is at a wall: nothing has deformed yet.
  Approach look_at_start(const MovedWalls& walls, const Rows3<const double>& x, const Rows3<const double>& v,
                         double dt) const;

  /// Bound of the step after that of `motion`. Once a part is at the wall, the mean of its nodes' velocities counts.
  Approach look(const MovedWalls& walls, const SurfaceMotion& motion) const;

 private:
  /// The nodes of a part before a wall, of all ranks.
  struct Front;
  enum class Moment { start, later };

  std::vector<Front> measure_fronts(const MovedWalls& moved, const SurfaceMotion& motion) const;
  Approach find_shortest(const std::vector<Front>& fronts, double horizon, Moment moment) const;

  const Communicator ranks_;
  const Deck& deck_;
  const Mesh& mesh_;
  double least_size_ = 0;  // of all pairs
};

}  // namespace percuss
