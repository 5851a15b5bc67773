#pragma once
// Rigid walls that move along their normal, or along the direction of a cylinder or a sphere: as the deck prescribes,
// or with a mass that bodies push.
//
// The rows see a wall at one speed from n to n+1. That of a wall with a mass is the one at which it and the nodes that
// it meets stop each other, if nothing else pushed them: so a light wall takes no more than it can. Afterwards its
// momentum changes by the impulse of its rows, whatever that is, and nothing is lost.

#include <vector>

#include "comm/communicator.hpp"
#include "kernels/contact/enforcement/enforcement.hpp"
#include "src/contact/enforcement/contact_report.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {

/// Motion of a wall along its normal, towards the bodies, or along its direction.
struct WallMotion {
  double displacement = 0;  // from its place at time 0 to that at n [length]
  double speed = 0;         // at n-1/2
};

/// Work of walls on the bodies in a step.
struct WallWork {
  double push = 0, friction = 0;  // by normal forces and by friction
  double driven = 0;              // of both, by walls with a prescribed speed, whose energy comes from outside
};

class MovingWalls {
 public:
  /// deck, ranks: outlive this.
  MovingWalls(const Deck& deck, const Communicator& ranks);

  /// Whether any wall of the deck moves; if not, nothing else need be called.
  bool any() const { return !moving_.empty(); }

  /// Whether walls stand still, as if they had no mass and no speed yet.
  void hold(bool is_held) { is_held_ = is_held; }

  /// Brings the walls to where they are at n.
  void place(const WallPairs& walls) const;

  /// Sets the speeds of the step, on which the rows depend. Collective.
  void start_step(const WorkSpace& space, const WallPairs& walls, const RowInputs& inputs, double time,
                  RowSumMemory& memory);

  /// Takes the pushes of the rows from first_row on, and moves on to n+1. Returns the work of the walls on the bodies.
  /// converged: the pushes fulfil the rows; if not, throws RunError, on all ranks, where they give a wall with a mass
  /// more speed than any impact can. Collective.
  WallWork finish_step(const WorkSpace& space, int first_row, const ContactMotion& motion, bool converged,
                       const RowSystem& system, RowSumMemory& memory);

  /// No wall comes towards bodies faster in the step from n = time to n+1; none went faster in the last one.
  double find_fastest(double time, double dt) const;
  double find_fastest_before() const;

  /// Motions of the walls that move, in the order of the deck.
  const std::vector<WallMotion>& motions() const { return motions_; }

  /// Kinetic energy of walls with a mass, at n-1/2 [energy].
  double find_kinetic_energy() const;

  void archive(CheckpointArchive& archive);

 private:
  const WallDeck& wall(std::size_t i) const { return deck_.walls[static_cast<std::size_t>(moving_[i])]; }
  double find_speed(std::size_t i, double time, double dt) const;
  void write(const WallPairs& walls, const std::vector<double>& speeds) const;
  void refuse_throw(std::size_t i, double after, const Rows3<const double>& v_before) const;

  const Deck& deck_;
  const Communicator& ranks_;
  std::vector<int> moving_;          // walls of the deck
  std::vector<WallMotion> motions_;  // of these
  std::vector<double> speeds_;       // of these, from n to n+1 as rows see them
  bool has_begun_ = false, is_held_ = false;
};

}  // namespace percuss
