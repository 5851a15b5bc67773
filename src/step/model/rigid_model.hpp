#pragma once
// Rigid bodies of a model, and their state. Every rank has all of them, and the same bits.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/rigid/rigid_motion.hpp"
#include "kernels/rigid/rigid_nodes.hpp"
#include "src/deck/spring_deck.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// A force and a moment on a point of a body; const after set-up.
struct BodyLoad {
  std::size_t load = 0;   // row of Model::nodal_values
  Vector3<double> arm{};  // of the point at time 0, from the centre
};

/// A body at time 0; const after set-up.
struct RigidBody {
  static constexpr int free = -1;

  std::string name;
  double mass = 0;
  Vector3<double> center{};
  Symmetric3<double> inertia{};        // about the centre
  Vector3<double> velocity{}, spin{};  // of the centre; about it [rad / time]
  // Row of Model::motions that holds each translation, then each rotation about an axis through the centre; free: none.
  std::array<int, 6> motion{free, free, free, free, free, free};
  std::array<int, 6> switched_by{free, free, free, free, free, free};  // condition that sensors switch; free: none
  std::vector<BodyLoad> loads{};
  double radius = 0;                                    // largest distance of a node from the centre
  std::int64_t parts = 0, nodes = 0, shared_nodes = 0;  // of all ranks; shared with elements that deform
  bool has_given_masses = false;                        // whether the deck gives mass, centre or inertia

  /// x, y, z, then rotations about them: at all times.
  bool always_holds(std::size_t direction) const { return motion[direction] != free && switched_by[direction] == free; }
};

/// A chunk of elements of a body, at time 0: exact integrals over their shapes; const after set-up.
struct RigidChunk {
  int chunk = 0, body = 0;
  double mass = 0;
  Vector3<double> center{};
  Symmetric3<double> second{};  // moments of mass about it
};

/// Where a joint holds one of its bodies.
struct JointEnd {
  int body = -1;           // of the model, or Joint::ground
  Vector3<double> arm{};   // at time 0, from the centre; of the ground, the point itself
  Vector3<double> axis{};  // at time 0, of joints that have one
  Vector3<double> turn{};  // at time 0, perpendicular to that of the other body, of joints that keep it so
};

/// Joint of two bodies; const after set-up. The first is no ground.
struct Joint {
  static constexpr int ground = -1;

  std::string name, place;  // the latter in the deck
  JointTraits::Point point = JointTraits::Point::all;
  bool keeps_axis = false, keeps_turn = false;
  double lead = 0;  // of a screw: way along the axis over the angle about it [length]; 0: no screw
  std::array<JointEnd, 2> ends;
  double length = 0;  // radius of gyration of a body: turns times this are compared with ways
};

struct RigidModel {
  std::vector<RigidBody> bodies;
  std::vector<RigidChunk> chunks;  // of this rank
  std::vector<Joint> joints;
  RigidNodes nodes;
  Array<int> body_of_node;  // [nodes] -1: of none; empty without bodies
  RigidLoads loads;
  bool is_loaded = false;  // whether anything can act on a body besides gravity and contact, on any rank
  bool is_all = false;     // whether nothing of the scene deforms
  double least_edge = 0;   // shortest edge of a rigid element, of all ranks

  bool any() const { return !bodies.empty(); }
  KOKKOS_INLINE_FUNCTION static bool holds(const Array<const int>& body_of_node, int n) {
    return body_of_node.extent(0) > 0 && body_of_node(n) >= 0;
  }
};

/// A body in the loop.
struct RigidState {
  Vector3<double> center{};         // at n
  Orientation orientation{};        // from time 0 to n
  Vector3<double> velocity{};       // of the centre, at n-1/2 (at n = 0: at 0)
  Vector3<double> spin_momentum{};  // angular momentum of the nodes about the centre, likewise
  Vector3<double> spin{};           // w of rigid_motion.hpp, likewise
  std::array<bool, 6> released{};   // directions that a condition would hold, but for a sensor
};

/// Whether something holds a direction of a body now.
inline bool holds(const RigidBody& body, const RigidState& state, std::size_t direction) {
  return body.motion[direction] != RigidBody::free && !state.released[direction];
}

/// Force and moment of a joint on its first body in the last step, on average; to the second the opposite.
struct JointState {
  Vector3<double> force{}, moment{};  // the latter about the joint's point
};

/// Inertia about the centre at n.
inline Symmetric3<double> find_inertia(const RigidBody& body, const RigidState& state) {
  return push_forward(find_rotation(state.orientation), body.inertia);
}

/// Its inverse in the rotations that nothing holds.
inline Symmetric3<double> find_free_inverse(const RigidBody& body, const RigidState& state) {
  const bool held[3] = {holds(body, state, 3), holds(body, state, 4), holds(body, state, 5)};
  return invert_free(find_inertia(body, state), held);
}

inline Vector3<double> to_vector(const Vec3& a) { return {a[0], a[1], a[2]}; }

}  // namespace percuss
