#pragma once
// A bound of the step from the motion of bodies: elements bound a step by their waves alone, which say nothing about a
// body that flies faster than they do. In a longer step it would be inside of another before contact could act.

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "src/contact/surface/contact_ranks.hpp"
#include "src/contact/surface/surface_share.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {

/// Largest relative displacement of two bodies in a step, once the gap between them is closed, as a share of the
/// shortest edge of their contact faces. docs/stability.md has the errors of other shares.
constexpr double approach_share = 0.5;

/// No step is longer than this many times the one before.
constexpr double most_step_growth = 1.2;

/// A bound of the next step, and the two bodies, or the body and the wall, that request it.
struct Approach {
  double step = std::numeric_limits<double>::infinity();  // longest; infinity: nothing limits it
  double travel_step = 0;                                 // in which the share is travelled; step less the way there
  double speed = 0;                                       // of one body beside the other, at most
  int part = -1, other = -1;                              // index into Mesh::parts; other: -1 - w for wall w

  bool limits(double dt) const { return step < dt; }
};

/// "the approach of parts 'ball' and 'plate' at 4e+05".
std::string describe_approach(const Approach& approach, const Mesh& mesh);

inline Approach choose_shorter(const Approach& a, const Approach& b) { return b.step < a.step ? b : a; }

void archive_approach(CheckpointArchive& archive, Approach& approach);

class ApproachWatch {
 public:
  /// The share outlives this. Collective, as are all calls.
  ApproachWatch(const Communicator& ranks, const SurfaceShare& share);

  /// The share is another now.
  void redefine();

  /// Whether a step in which no contact node goes farther can be followed by one that has a bound.
  bool may_limit(double largest_way) const;

  /// Bound of the first step, dt at most. Any motion counts, also of bodies whose boxes overlap: nothing has deformed
  /// yet.
  Approach look_at_start(const Rows3<const double>& x, const Rows3<const double>& v, double dt);

  /// Bound of the step after that of `motion`. largest_way: longest way of a contact node in it, of all ranks; if that
  /// is short, nothing else is looked at. Once the boxes of two bodies overlap, the difference of their mean velocities
  /// counts: their nodes fly in all directions then.
  Approach look(const SurfaceMotion& motion, double largest_way);

 private:
  /// Contact nodes of a body that lie on the same surfaces.
  struct Group {
    int surface_class = 0, body = 0, part = 0;
    double size = 0, offset = 0;                 // shortest edge, half the thickness of a shell [length]
    std::array<double, 3> low{}, high{};         // of positions
    std::array<double, 3> slowest{}, fastest{};  // of velocities
    std::array<double, 3> mean{};                // velocity
  };
  enum class Moment { start, later };

  void find_groups();
  void measure_groups();
  void move_groups(const SurfaceMotion& motion);
  void average_velocities(const SurfaceMotion& motion);
  bool may_touch(const Group& a, const Group& b) const;
  Approach find_approach(const Group& a, const Group& b, Moment moment) const;
  Approach find_shortest(double horizon, Moment moment) const;

  const Communicator ranks_;
  const SurfaceShare& share_;
  double least_size_ = 0;          // of all groups
  bool has_groups_ = false;        // of the share as it is
  std::vector<Group> groups_;      // of all ranks, by body and class
  std::vector<int> node_groups_;   // [owned contact nodes] -1: a free particle
  std::vector<double> frictions_;  // SurfaceShare::pair_friction
};

}  // namespace percuss
