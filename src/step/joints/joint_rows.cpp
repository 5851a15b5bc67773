#include "src/step/joints/joint_rows.hpp"

#include <cmath>

#include "src/index.hpp"

namespace percuss {
namespace {

using Vector = Vector3<double>;

constexpr Vector axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

Vector find_arm(const JointEnd& end, const RigidState& body) { return find_rotation(body.orientation) * end.arm; }

Vector find_point(const JointEnd& end, const std::vector<RigidState>& bodies) {
  if (end.body == Joint::ground) return end.arm;
  return bodies[at(end.body)].center + find_arm(end, bodies[at(end.body)]);
}

Vector find_axis(const JointEnd& end, const std::vector<RigidState>& bodies) {
  return end.body == Joint::ground ? end.axis : find_rotation(bodies[at(end.body)].orientation) * end.axis;
}

/// The way of a joint's point on a body in a step: exactly that of a node there.
Vector find_way(const JointEnd& end, const std::vector<RigidState>& now, const std::vector<RigidState>& next,
                double dt) {
  if (end.body == Joint::ground) return {0, 0, 0};
  const RigidState& to = next[at(end.body)];
  const Vector middle = 0.5 * (find_arm(end, now[at(end.body)]) + find_arm(end, to));
  return dt * (to.velocity + cross(to.spin, middle));
}

/// By how much the axis of the first body is turned against that of the second, about the sides, as a length.
std::array<double, 2> find_turned(const Joint& joint, const JointFrame& frame, const std::vector<RigidState>& bodies) {
  const Vector turned = cross(find_axis(joint.ends[1], bodies), find_axis(joint.ends[0], bodies));
  return {joint.length * dot(turned, frame.side[0]), joint.length * dot(turned, frame.side[1])};
}

}  // namespace

JointFrame find_joint_frame(const Joint& joint, const std::vector<RigidState>& now) {
  JointFrame frame;
  const Vector first = find_point(joint.ends[0], now), second = find_point(joint.ends[1], now);
  const Vector apart = first - second;
  frame.point = 0.5 * (first + second);
  frame.gap = {apart.x, apart.y, apart.z, 0, 0};
  if (!joint.has_axis) return frame;
  const Vector axis = find_axis(joint.ends[0], now);
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(get(axis, k)) < std::abs(get(axis, least))) least = k;
  const Vector side = cross(axis, axes[least]);
  frame.side[0] = (1 / norm(side)) * side;
  frame.side[1] = cross(axis, frame.side[0]);
  const auto turned = find_turned(joint, frame, now);
  frame.gap[3] = turned[0];
  frame.gap[4] = turned[1];
  return frame;
}

void add_joint_rows(const Joint& joint, const JointFrame& frame, const std::vector<RigidState>& now,
                    std::vector<JointRow>& rows) {
  for (int r = 0; r < count_rows(joint); ++r) {
    JointRow row;
    for (std::size_t e = 0; e < 2; ++e) {
      const JointEnd& end = joint.ends[e];
      row.body[e] = end.body;
      if (end.body == Joint::ground) continue;
      const double sign = e == 0 ? 1 : -1;
      if (r < 3) {
        row.unit[e] = find_wrench(frame.point - now[at(end.body)].center, sign * axes[r]);
      } else {
        row.unit[e].moment = sign * joint.length * frame.side[at(r - 3)];
      }
    }
    rows.push_back(row);
  }
}

std::array<double, most_joint_rows> find_gap_changes(const Joint& joint, const JointFrame& frame,
                                                     const std::vector<RigidState>& now,
                                                     const std::vector<RigidState>& next, double dt) {
  const Vector way = find_way(joint.ends[0], now, next, dt) - find_way(joint.ends[1], now, next, dt);
  std::array<double, most_joint_rows> changes{way.x, way.y, way.z, 0, 0};
  if (!joint.has_axis) return changes;
  const auto turned = find_turned(joint, frame, next);
  for (std::size_t k = 0; k < 2; ++k) changes[3 + k] = turned[k] - frame.gap[3 + k];
  return changes;
}

std::vector<double> find_gap_rates(const std::vector<JointRow>& rows, const std::vector<RigidState>& bodies) {
  std::vector<double> rates(rows.size(), 0);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t e = 0; e < 2; ++e) {
      if (rows[r].body[e] == Joint::ground) continue;
      const RigidState& body = bodies[at(rows[r].body[e])];
      rates[r] += dot(rows[r].unit[e].impulse, body.velocity) + dot(rows[r].unit[e].moment, body.spin);
    }
  }
  return rates;
}

Wrench sum_joint_rows(const Joint& joint, const JointFrame& frame, const double* multipliers) {
  Wrench sum{{multipliers[0], multipliers[1], multipliers[2]}, {0, 0, 0}};
  if (joint.has_axis) sum.moment = joint.length * (multipliers[3] * frame.side[0] + multipliers[4] * frame.side[1]);
  return sum;
}

std::vector<double> find_mobilities(const std::vector<JointRow>& rows, const std::vector<BodyResponse>& responses) {
  const std::size_t n = rows.size();
  std::vector<double> mobilities(n * n, 0);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t f = 0; f < 2; ++f) {
      const int body = rows[j].body[f];
      if (body == Joint::ground) continue;
      const BodyChange change = find_change(responses[at(body)], rows[j].unit[f]);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t e = 0; e < 2; ++e)
          if (rows[i].body[e] == body)
            mobilities[i * n + j] +=
                dot(rows[i].unit[e].impulse, change.velocity) + dot(rows[i].unit[e].moment, change.spin);
    }
  }
  return mobilities;
}

}  // namespace percuss
