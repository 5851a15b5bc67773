#pragma once
// One row of the contact system: a node against a face, an edge against an edge or a node against a wall, in the normal
// and two tangential directions; or a node tied to a face (tie_row.hpp) in the directions of the axes, or the rotation
// of one.
//
// The row sees its nodes through signed weights w: those of the point that is pushed sum to 1, those of the point that
// pushes back to -1. Node on face: 1 and -N_i. Edge on edge: 1 - s, s and t - 1, -t. An impulse P acts on node i as
// w_i P - q x rho_i, with rho_i = x_i - mean(x) over the bearing nodes (the corners of the face; all four of two
// edges; rho = 0 for others), J = sum (rho^2 I - rho rho^T) and the couple q = J^-1 (r x P), r = sum w_i x_i, all at
// x_n. So the impulses of a row sum to zero and their moments about any point do too, because sum w_i = 0, sum rho_i =
// 0 and sum rho_i x (q x rho_i) = J q. The motion goes from x_n with the corrected velocity, so angular momentum sum
// x_n x m v(n+1/2) is kept exactly when the moments are taken with the places at n. Solvers see slots, weights and
// directions only; a wall's row has one node and nothing that pushes back.

#include "kernels/contact/geometry/contact_limits.hpp"
#include "kernels/contact/geometry/point3.hpp"

namespace percuss {

/// Most nodes of a row. Slots: the contact node, then the corners of the face; or the nodes of edge A, then of edge B;
/// or the contact node at a wall.
inline constexpr int row_nodes = 5;

/// Impulses of a row along the normal (>= 0: a push) and the two tangents: friction. [force x time]
struct RowImpulse {
  double normal = 0;
  double tangential[2] = {0, 0};
};

enum class RowKind { face, edges, wall, tie };

struct ContactRow {
  std::int64_t key = 0;    // its place in every sum: make_face_row_key()
  std::int64_t face = -1;  // number of the contact face or of edge B; -1: a wall
  RowKind kind = RowKind::wall;
  int count = 1;                                // slots in use
  int place[row_nodes] = {-1, -1, -1, -1, -1};  // of its nodes in RowSystem::at; -1: no such slot
  double gap = 0;                               // predicted gap at n+1
  double target = 0;                            // gap wanted at n+1, <= 0
  int record = -1;                              // history record that this row writes
  bool is_caught = false;                       // by a face that looks past the node, or inside: remembered without a
                                                // push
  bool has_thickness = false;                   // of shells between the two sides
  double weight[row_nodes] = {1, 0, 0, 0, 0};   // w
  Point3 rho[row_nodes]{};
  Symmetric3<double> inverse_inertia{};  // J^-1
  Point3 arm{};                          // r
  double lever = 0;                      // of a row that ties a rotation: its couple is J^-1 (lever P) [length]
  Point3 normal{}, tangent[2]{};
  Point3 gap_gradient{};            // of the gap by the place of the pushed point; gap_gradient . normal = 1
  double friction = 0;              // contact_limits::no_friction_limit: a tie
  int pair = 0;                     // of surfaces, as work is booked; walls are the last
  bool is_held = false;             // nothing moves its nodes
  bool is_rigid = false;            // between rigid bodies, or of one with a wall, where mark_rigid_rows() found them
  bool has_spring = false;          // a spring pushes it, where nodes are free (SpringRows); others are iterated
  bool is_solved = false;           // its impulse stands already (rigid_rows.hpp): the iteration leaves it
  double held_apart = 0;            // tie: way to its place in directions in which nothing moves its nodes [length]
  double spring = 0;                // stiffness of a penalty row [force/length], 0: none
  double held = 0;                  // penalty: energy that the sides have given the spring; 0: not known
  double size = 0;                  // h of the face or the edges
  double gap_start = 0;             // gap at n
  double reference = 0;             // overlap accepted at the start, >= 0
  double to_push = 0;               // overlap that is to be pushed out, of which the reference is left
  double depth_tolerance = 0;       // RowInputs::depth_tolerance
  double slide[2] = {0, 0};         // predicted tangential displacement in the step plus what sticking still owes
  double stiffness = 0;             // D of the normal: row sum of |G M^-1 G^T| [1/mass]
  double tangential_stiffness = 0;  // D of both tangents
  RowImpulse impulse, previous;     // iterates k and k-1
  Point3 force{}, couple{};         // P and q of `impulse`
};

KOKKOS_INLINE_FUNCTION bool is_tie(const ContactRow& row) { return row.kind == RowKind::tie; }
KOKKOS_INLINE_FUNCTION bool ties_rotation(const ContactRow& row) { return row.lever > 0; }

/// The gap below which the two sides push each other, <= 0.
KOKKOS_INLINE_FUNCTION double find_floor(const ContactRow& row) {
  return row.reference > row.depth_tolerance ? -row.reference : -row.depth_tolerance;
}

KOKKOS_INLINE_FUNCTION int count_nodes(const ContactRow& row) { return row.count; }
KOKKOS_INLINE_FUNCTION int count_directions(const ContactRow& row) { return row.friction > 0 ? 3 : 1; }
KOKKOS_INLINE_FUNCTION const Point3& get_direction(const ContactRow& row, int d) {
  return d == 0 ? row.normal : row.tangent[d - 1];
}

/// q of an impulse P on the pushed point.
KOKKOS_INLINE_FUNCTION Point3 find_couple(const ContactRow& row, const Point3& impulse) {
  const Point3 moment = ties_rotation(row) ? row.lever * impulse : cross(row.arm, impulse);
  return row.inverse_inertia * moment;
}

/// Impulse on node `slot` of the row for the impulse P on the pushed point and its couple q.
KOKKOS_INLINE_FUNCTION Point3 spread_impulse(const ContactRow& row, int slot, const Point3& impulse,
                                             const Point3& couple) {
  return row.weight[slot] * impulse - cross(couple, row.rho[slot]);
}

/// Relative velocities of a row: of the pushed point to the point that pushes back (without the couple); and the vector
/// u with (sum of impulses . velocities) = P . u for every P, the transpose of spread_impulse().
struct RowVelocity {
  Point3 relative{}, work{};
};

/// velocity(slot): velocity of node `slot`.
template <class Velocity>
KOKKOS_INLINE_FUNCTION RowVelocity find_row_velocity(const ContactRow& row, const Velocity& velocity) {
  Point3 relative{}, spin{};
  for (int slot = 0; slot < row.count; ++slot) {
    const Point3 v = velocity(slot);
    relative = relative + row.weight[slot] * v;
    spin = spin + cross(row.rho[slot], v);
  }
  // P . u = P . relative - (J^-1 (r x P)) . spin, and J^-1 is symmetric.
  const Point3 turn = row.inverse_inertia * spin;
  return {relative, relative - (ties_rotation(row) ? row.lever * turn : cross(turn, row.arm))};
}

template <class Velocity>
KOKKOS_INLINE_FUNCTION Point3 find_work_velocity(const ContactRow& row, const Velocity& velocity) {
  return find_row_velocity(row, velocity).work;
}

template <class Velocity>
KOKKOS_INLINE_FUNCTION Point3 find_relative_velocity(const ContactRow& row, const Velocity& velocity) {
  Point3 relative{};
  for (int slot = 0; slot < row.count; ++slot) relative = relative + row.weight[slot] * velocity(slot);
  return relative;
}

/// Velocity of the pushed point relative to what it slides on: with thickness between them, to what is rigidly joined
/// to the other side there, so that turning as one is no sliding and friction never gives energy.
template <class Velocity>
KOKKOS_INLINE_FUNCTION Point3 find_slip_velocity(const ContactRow& row, const Velocity& velocity) {
  return row.has_thickness ? find_work_velocity(row, velocity) : find_relative_velocity(row, velocity);
}
KOKKOS_INLINE_FUNCTION const Point3& find_slip_velocity(const ContactRow& row, const RowVelocity& v) {
  return row.has_thickness ? v.work : v.relative;
}

/// Two unit vectors that complete the normal, from the axis that is least along it.
KOKKOS_INLINE_FUNCTION void set_tangents(ContactRow& row) {
  const Point3& n = row.normal;
  const double x = n.x < 0 ? -n.x : n.x, y = n.y < 0 ? -n.y : n.y, z = n.z < 0 ? -n.z : n.z;
  const Point3 axis = x <= y && x <= z ? Point3{1, 0, 0} : (y <= z ? Point3{0, 1, 0} : Point3{0, 0, 1});
  row.tangent[0] = normalize(cross(n, axis));
  row.tangent[1] = cross(n, row.tangent[0]);
}

/// P of the impulses along the row's directions.
KOKKOS_INLINE_FUNCTION Point3 sum_impulse(const ContactRow& row, const RowImpulse& p) {
  const Point3 push = p.normal * row.normal;
  return row.friction > 0 ? push + (p.tangential[0] * row.tangent[0] + p.tangential[1] * row.tangent[1]) : push;
}

/// Shortens the tangential impulse to Coulomb's limit, friction times the normal one; a tie has none.
KOKKOS_INLINE_FUNCTION void limit_friction(const ContactRow& row, RowImpulse& p) {
  if (is_tie(row)) return;
  const double limit = row.friction * p.normal;
  if (!(limit > 0)) {  // even where the square of a tiny one is zero
    p.tangential[0] = p.tangential[1] = 0;
    return;
  }
  const double length = std::sqrt(p.tangential[0] * p.tangential[0] + p.tangential[1] * p.tangential[1]);
  if (!(length > limit)) return;
  const double factor = limit / length;
  p.tangential[0] *= factor;
  p.tangential[1] *= factor;
}

/// Sets the impulses of a row with their P and q.
KOKKOS_INLINE_FUNCTION void set_impulse(ContactRow& row, const RowImpulse& p) {
  row.impulse = row.previous = p;
  row.force = sum_impulse(row, p);
  row.couple = find_couple(row, row.force);
}

/// Whether the iteration leaves the impulse of a row as it is: that of a spring, or one that is found already.
KOKKOS_INLINE_FUNCTION bool is_frozen(const ContactRow& row) { return row.spring > 0 || row.is_solved; }

/// Whether Coulomb's limit has not shortened the tangential impulse.
KOKKOS_INLINE_FUNCTION bool is_sticking(const ContactRow& row) {
  constexpr double sticking = 1 - 1e-9;  // share of the limit
  const double* t = row.impulse.tangential;
  const double limit = sticking * row.friction * row.impulse.normal;
  return t[0] * t[0] + t[1] * t[1] < limit * limit;
}

/// Whether the iteration begins with the row, and not only once its nodes move.
KOKKOS_INLINE_FUNCTION bool wants_something(const ContactRow& row) {
  return row.impulse.normal > 0 || row.gap < row.target || is_tie(row);
}

}  // namespace percuss
