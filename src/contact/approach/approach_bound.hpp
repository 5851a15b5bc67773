#pragma once
// The bound of a step from all that approaches: bodies each other, and what walls stop the walls.

#include "src/contact/approach/approach.hpp"
#include "src/contact/approach/wall_watch.hpp"

namespace percuss {

class ApproachBound {
 public:
  /// All but ranks outlive this. Collective, as are all calls but may_limit(), clear() and next().
  ApproachBound(const Communicator& ranks, const SurfaceShare& share, const WallPairs& walls, const Deck& deck,
                const Mesh& mesh);

  /// Share and walls are others now.
  void redefine();

  /// Before the first step, of dt at most.
  void look_at_start(const Rows3<const double>& x, const Rows3<const double>& v, double dt, const MovingWalls& moving);

  /// Whether a step of dt in which no node goes farther than `way` can be followed by one that has a bound.
  bool may_limit(double way, double dt, const MovingWalls& moving) const;

  /// Looks at the step after that of `motion`. way: the longest of a node in it.
  void look(const SurfaceMotion& motion, double way, const MovingWalls& moving);
  /// As look(), where bodies cannot touch each other. fastest: no node of this rank is faster in the motion; negative:
  /// not known.
  void look_at_walls_alone(const SurfaceMotion& motion, double fastest, const MovingWalls& moving);
  /// Nothing can bound the step after this one.
  void clear() { next_ = {}; }

  /// Bound of the next step, as found last.
  const Approach& next() const { return next_; }

  void archive(CheckpointArchive& archive) { archive_approach(archive, next_); }

 private:
  bool may_walls_limit(double way, double dt, const MovingWalls& moving) const;
  Approach look_at_walls(const SurfaceMotion& motion, double way, const MovingWalls& moving) const;

  const Communicator ranks_;
  const Deck& deck_;
  const WallPairs& pairs_;
  ApproachWatch bodies_;
  WallWatch walls_;
  Approach next_;
};

}  // namespace percuss
