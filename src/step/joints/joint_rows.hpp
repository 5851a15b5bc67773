#pragma once
// The rows of a joint: what keeps its point, its axis and its turn on both bodies.
//
// A row is a unit impulse on the first body and its opposite on the second, at the point at n: all momenta are
// conserved. Its gap is what the row is to keep zero, a length. Where the point slides, its ways are along directions
// that turn with the first body, and the point is that of the second one.

#include <vector>

#include "kernels/rigid/body_response.hpp"
#include "src/step/model/rigid_model.hpp"

namespace percuss {

struct JointRow {
  std::array<int, 2> body{Joint::ground, Joint::ground};
  std::array<Wrench, 2> unit{};  // about the centre of each
};

/// A joint at n.
struct JointFrame {
  Vector3<double> point{};                // midway between those of both bodies, which are one but for round-off
  Vector3<double> apart{};                // the point of the first body less that of the second
  std::array<Vector3<double>, 3> way{};   // directions of the ways that are kept, of length one
  std::array<Vector3<double>, 2> side{};  // across the axis; of length one
  Vector3<double> turn{};                 // axis of the turn that is kept, of a screw of the thread
  std::array<double, 6> gap{};
};

/// Most rows of a joint, and those of one of a kind: first those of ways, then of the axis, then of the turn or thread.
constexpr int most_joint_rows = 6;
inline int count_ways(const Joint& joint) {
  return joint.point == JointTraits::Point::all ? 3 : joint.point == JointTraits::Point::across ? 2 : 1;
}
inline int count_rows(const Joint& joint) {
  return count_ways(joint) + (joint.keeps_axis ? 2 : 0) + (joint.keeps_turn || joint.lead != 0 ? 1 : 0);
}

/// Two directions across an axis, of length one.
std::array<Vector3<double>, 2> find_sides(const Vector3<double>& axis);

JointFrame find_joint_frame(const Joint& joint, const std::vector<RigidState>& now);

/// Appends the rows of the joint.
void add_joint_rows(const Joint& joint, const JointFrame& frame, const std::vector<RigidState>& now,
                    std::vector<JointRow>& rows);

/// Change of the gaps of the joint in the step from now to next. The velocities of next are those between both.
std::array<double, most_joint_rows> find_gap_changes(const Joint& joint, const JointFrame& frame,
                                                     const std::vector<RigidState>& now,
                                                     const std::vector<RigidState>& next, double dt);

/// Rates of the gaps, from velocities and spins at one time.
std::vector<double> find_gap_rates(const std::vector<JointRow>& rows, const std::vector<RigidState>& bodies);

/// Force, or impulse, on the first body and its moment about the point, of multipliers of the joint's rows.
Wrench sum_joint_rows(const Joint& joint, const JointFrame& frame, const double* multipliers);

/// [row][row] how fast the gap of one changes by a unit impulse of another.
std::vector<double> find_mobilities(const std::vector<JointRow>& rows, const std::vector<BodyResponse>& responses);

}  // namespace percuss
