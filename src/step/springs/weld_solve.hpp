#pragma once
// One weld in a step: the impulse and moment after which its two nodes move as one, or the patches around them.
//
// The impulse p acts at one point c on both nodes, p on the second and -p on the first, each with the moment of its
// lever from the node; nodes that turn also get the moments q and -q. Both momenta are conserved whatever p and q are.

#include <array>

#include "kernels/core/tensor.hpp"

namespace percuss {

/// Change of the mean rigid motion of a patch of nodes by unit impulses along x, y and z at its centre, then by unit
/// moments about them.
struct PatchResponse {
  struct Column {
    Vector3<double> velocity{}, spin{};
  };
  std::array<Column, 6> column{};
};

/// A node as welds see it, or a patch of nodes. Velocities are those at n+1/2, and change.
struct WeldNode {
  Vector3<double> place{};                            // at n
  Vector3<double> velocity{}, spin{};                 // at n+1/2
  Vector3<double> inverse_mass{}, inverse_inertia{};  // by direction; 0 where it is held
  bool turns = false;                                 // whether it has rotary inertia
  bool is_gone = false;
  // For a patch, velocity and spin are those of its mean rigid motion about its centre.
  bool is_patch = false;
  Vector3<double> arm{};     // from the centre to `place`
  PatchResponse response{};  // in place of inverse_inertia
  double twice_energy = 0;   // kinetic, of its nodes in directions that are not held
};

/// Impulse on the second node; the first gets the opposite impulse.
struct WeldImpulse {
  Vector3<double> impulse{};
  std::array<Vector3<double>, 2> moment{};  // of each node, about itself
};

/// Square root of twice the energy that an impulse and moments give to these nodes at rest: both have one unit then.
double find_impulse_size(const WeldImpulse& impulse, const std::array<WeldNode, 2>& nodes);

/// Size of the motion of the nodes in directions that are not held.
double find_motion_size(const std::array<WeldNode, 2>& nodes);

/// Makes both nodes move as one from n to n+1 and returns what that took. length: of the weld at time 0, to which the
/// distance of the nodes returns.
WeldImpulse join_nodes(std::array<WeldNode, 2>& nodes, double length, double dt);

}  // namespace percuss
