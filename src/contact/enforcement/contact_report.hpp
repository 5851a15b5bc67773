#pragma once
// What the contact of a step works on, and what it did.

#include <cstdint>
#include <string>
#include <vector>

#include "kernels/contact/geometry/point3.hpp"
#include "kernels/contact/rows/row_system.hpp"
#include "kernels/contact/rows/wall_sums.hpp"
#include "kernels/core/views.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// The motion of one step as the stage sees it; one row a mesh node.
struct ContactMotion {
  Rows3<const double> x;             // position at n
  Rows3<const double> v_before;      // velocity at n-1/2, for the work of the contact impulses
  Rows3<double> v;                   // in: velocity at n+1/2 predicted without contact; out: corrected
  Rows3<const double> inverse_mass;  // 1/m in each direction; 0 where a condition holds the node
  Rows3<double> impulse;             // out: contact impulse of this step [force x time], zero where there is none
  double dt = 0;                     // from n to n+1
  Point3 center{};                   // about which moments of walls' impulses are taken
  BodyInputs bodies{};               // rigid ones as they stand at n, which alone says how their nodes move
  double time = 0;                   // at n
  SpinInputs spins{};                // rotations of nodes
  // Bounds of the speeds of this rank's nodes: as predicted at n+1/2, and as they came to n; negative: not known.
  double fastest = -1, fastest_before = -1;
  Array<const double> growth{};  // by how much damping raises the masses of nodes, in inverse_mass; empty: nowhere
};

/// Result of one step's contact on all ranks, the same on each. Work is positive where contact adds energy to the
/// bodies; every impulse P of a node does the work P . (v(n-1/2) + v(n+1/2)) / 2, which closes the energy balance of
/// the explicit midpoint rule exactly.
struct ContactReport {
  int interactions = 0;         // rows with a push, walls included, and tied nodes
  std::int64_t candidates = 0;  // candidate pairs held
  bool searched = false;        // whether the search was due
  bool enforced = false;        // whether impulses were looked for in this step
  int iterations = 0;           // of the enforcement
  double residual = 0;          // largest penetration left over, or of a tied node from its place / face edge
  double complementarity = 0;   // lagrange: deviation from complementarity / largest closing velocity
  bool converged = true;
  double normal_work = 0;             // of the pushes
  double friction_work = 0;           // of the tangential impulses (negative: dissipated)
  double stored = 0;                  // penalty: energy in the springs at n+1
  double stored_slip = 0;             // of that, in the tangential ones
  double rate = 0;                    // penalty: bound of the square of the frequency that the springs add [1/time^2]
  double deepest = 0;                 // deepest penetration at n among checked pairs / face edge, 0 if none
  std::int64_t deepest_node = -1;     // number of the node that has it
  std::int64_t giving_node = -1;      // number of the node whose push gave most energy; -1: none gave any
  double held_apart = 0;              // farthest that conditions hold a tied node from its place / face edge
  std::int64_t held_apart_node = -1;  // number of that node
  std::int64_t failed_ties = 0;       // tied nodes released since the start, those of this step among them
  WallSums walls;                     // what walls gave the nodes of this rank, and of no other
  std::vector<Wrench> bodies;         // what each rigid body got, of all ranks; empty: nothing
};

/// Names of the walls that move: their own, or `walls.N`, which no own name can be.
std::vector<std::string> name_moving_walls(const Deck& deck);

/// Names of what work is booked by: "surfaces" where all may touch all or "a:b" for each pair of the deck, "tie:a:b"
/// for each tie, "walls". Empty where one name would mean all work.
std::vector<std::string> name_contact_pairs(const Deck& deck);

}  // namespace percuss
