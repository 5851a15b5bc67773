#include "src/contact/approach/approach_bound.hpp"

#include "comm/all_reduce.hpp"

namespace percuss {
namespace {

/// Displacement and speed of each wall.
std::vector<WallMotion> list_motions(const Deck& deck, const MovingWalls& moving) {
  std::vector<WallMotion> motions(deck.walls.size());
  std::size_t next = 0;
  for (std::size_t w = 0; w < motions.size(); ++w)
    if (deck.walls[w].moves()) motions[w] = moving.motions()[next++];
  return motions;
}

}  // namespace

ApproachBound::ApproachBound(const Communicator& ranks, const SurfaceShare& share, const WallPairs& walls,
                             const Deck& deck, const Mesh& mesh)
    : ranks_(ranks), deck_(deck), pairs_(walls), bodies_(ranks, share), walls_(ranks, deck, mesh) {
  walls_.redefine(pairs_);
}

void ApproachBound::redefine() {
  bodies_.redefine();
  walls_.redefine(pairs_);
}

void ApproachBound::look_at_start(const Rows3<const double>& x, const Rows3<const double>& v, double dt,
                                  const MovingWalls& moving) {
  next_ = bodies_.look_at_start(x, v, dt);
  if (deck_.walls.empty()) return;
  const MovedWalls moved{pairs_, list_motions(deck_, moving)};
  next_ = choose_shorter(next_, walls_.look_at_start(moved, x, v, dt));
}

bool ApproachBound::may_walls_limit(double way, double dt, const MovingWalls& moving) const {
  return !deck_.walls.empty() && walls_.may_limit(way, list_motions(deck_, moving), dt);
}

bool ApproachBound::may_limit(double way, double dt, const MovingWalls& moving) const {
  return bodies_.may_limit(way) || may_walls_limit(way, dt, moving);
}

Approach ApproachBound::look_at_walls(const SurfaceMotion& motion, double way, const MovingWalls& moving) const {
  if (!may_walls_limit(way, motion.dt, moving)) return {};
  return walls_.look({pairs_, list_motions(deck_, moving)}, motion);
}

void ApproachBound::look(const SurfaceMotion& motion, double way, const MovingWalls& moving) {
  next_ = choose_shorter(bodies_.look(motion, way), look_at_walls(motion, way, moving));
}

void ApproachBound::look_at_walls_alone(const SurfaceMotion& motion, double fastest, const MovingWalls& moving) {
  next_ = {};
  if (deck_.walls.empty()) return;
  if (fastest >= 0) {
    all_reduce(ranks_, Reduce::largest, fastest);
    if (!may_walls_limit(motion.dt * fastest, motion.dt, moving)) return;
  }
  next_ = look_at_walls(motion, walls_.find_way(pairs_, motion), moving);
}

}  // namespace percuss
