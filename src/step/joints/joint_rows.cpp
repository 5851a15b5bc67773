#include "src/step/joints/joint_rows.hpp"

#include <cmath>
#include <numbers>

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

/// A direction that is fixed to the body of an end, as it is now.
Vector find_direction(const JointEnd& end, const Vector& at_start, const std::vector<RigidState>& bodies) {
  return end.body == Joint::ground ? at_start : find_rotation(bodies[at(end.body)].orientation) * at_start;
}

/// The way of a joint's point on a body in a step: exactly that of a node there.
Vector find_way(const JointEnd& end, const std::vector<RigidState>& now, const std::vector<RigidState>& next,
                double dt) {
  if (end.body == Joint::ground) return {0, 0, 0};
  const RigidState& to = next[at(end.body)];
  const Vector middle = 0.5 * (find_arm(end, now[at(end.body)]) + find_arm(end, to));
  return dt * (to.velocity + cross(to.spin, middle));
}

/// Rotation of the axis of the first body against that of the second, about the sides, as a length.
std::array<double, 2> find_turned(const Joint& joint, const JointFrame& frame, const std::vector<RigidState>& bodies) {
  const Vector axis = find_direction(joint.ends[0], joint.ends[0].axis, bodies);
  const Vector turned = cross(find_direction(joint.ends[1], joint.ends[1].axis, bodies), axis);
  return {joint.length * dot(turned, frame.side[0]), joint.length * dot(turned, frame.side[1])};
}

/// The sine of the angle by which the turns of both bodies are not perpendicular, as a length.
double find_skew(const Joint& joint, const std::vector<RigidState>& bodies) {
  return joint.length * dot(find_direction(joint.ends[0], joint.ends[0].turn, bodies),
                            find_direction(joint.ends[1], joint.ends[1].turn, bodies));
}

/// The angle by which the first body has turned about the axis against the second, between -pi and pi: the turn of the
/// second is a right angle ahead at the start.
double find_angle(const Joint& joint, const std::vector<RigidState>& bodies) {
  const Vector axis = find_direction(joint.ends[0], joint.ends[0].axis, bodies),
               turn = find_direction(joint.ends[0], joint.ends[0].turn, bodies),
               ahead = find_direction(joint.ends[1], joint.ends[1].turn, bodies);
  return std::atan2(dot(turn, ahead), dot(turn, cross(ahead, axis)));
}

/// An angle without the whole turns in it.
double take_turns_off(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

/// Change of a distance by the displacement of a step, and by the rotation of the direction that it is measured along.
double find_way_change(const Vector& way, const Vector& apart, const Vector& before, const Vector& after) {
  return dot(way, after) + dot(apart, after - before);
}

/// The directions of the ways that are kept. Those of a point that slides turn with the first body.
std::array<Vector, 3> find_ways(const Joint& joint, const JointFrame& frame, const Vector& axis) {
  if (joint.point == JointTraits::Point::all) return {axes[0], axes[1], axes[2]};
  if (joint.point == JointTraits::Point::along) return {axis, {0, 0, 0}, {0, 0, 0}};
  return {frame.side[0], frame.side[1], {0, 0, 0}};
}

}  // namespace

std::array<Vector, 2> find_sides(const Vector& axis) {
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(get(axis, k)) < std::abs(get(axis, least))) least = k;
  const Vector side = cross(axis, axes[least]), first = (1 / norm(side)) * side;
  return {first, cross(axis, first)};
}

JointFrame find_joint_frame(const Joint& joint, const std::vector<RigidState>& now) {
  JointFrame frame;
  const Vector first = find_point(joint.ends[0], now), second = find_point(joint.ends[1], now);
  frame.apart = first - second;
  const bool slides = joint.point != JointTraits::Point::all;
  frame.point = slides ? second : 0.5 * (first + second);
  const Vector axis = find_direction(joint.ends[0], joint.ends[0].axis, now);
  if (joint.keeps_axis) frame.side = find_sides(axis);
  frame.way = find_ways(joint, frame, axis);
  std::size_t row = 0;
  for (; row < at(count_ways(joint)); ++row) frame.gap[row] = dot(frame.apart, frame.way[row]);
  if (joint.keeps_axis) {
    for (const double turned : find_turned(joint, frame, now)) frame.gap[row++] = turned;
  }
  if (joint.lead != 0) {  // the whole turns follow from the way, whose error is round-off
    frame.turn = axis;
    frame.gap[row] = joint.lead * take_turns_off(dot(frame.apart, axis) / joint.lead - find_angle(joint, now));
  }
  if (joint.keeps_turn) {
    frame.turn = cross(find_direction(joint.ends[0], joint.ends[0].turn, now),
                       find_direction(joint.ends[1], joint.ends[1].turn, now));
    frame.gap[row] = find_skew(joint, now);
  }
  return frame;
}

void add_joint_rows(const Joint& joint, const JointFrame& frame, const std::vector<RigidState>& now,
                    std::vector<JointRow>& rows) {
  const int ways = count_ways(joint);
  for (int r = 0; r < count_rows(joint); ++r) {
    const bool is_way = r < ways, is_side = joint.keeps_axis && r < ways + 2;
    JointRow row;
    for (std::size_t e = 0; e < 2; ++e) {
      const JointEnd& end = joint.ends[e];
      row.body[e] = end.body;
      if (end.body == Joint::ground) continue;
      const double sign = e == 0 ? 1 : -1;
      if (is_way) {
        row.unit[e] = find_wrench(frame.point - now[at(end.body)].center, sign * frame.way[at(r)]);
      } else {
        const bool is_thread = joint.lead != 0 && !is_side;
        if (is_thread) row.unit[e] = find_wrench(frame.point - now[at(end.body)].center, sign * frame.turn);
        const double lever = is_thread ? -joint.lead : joint.length;
        row.unit[e].moment = row.unit[e].moment + sign * lever * (is_side ? frame.side[at(r - ways)] : frame.turn);
      }
    }
    rows.push_back(row);
  }
}

std::array<double, most_joint_rows> find_gap_changes(const Joint& joint, const JointFrame& frame,
                                                     const std::vector<RigidState>& now,
                                                     const std::vector<RigidState>& next, double dt) {
  const Vector way = find_way(joint.ends[0], now, next, dt) - find_way(joint.ends[1], now, next, dt);
  std::array<double, most_joint_rows> changes{way.x, way.y, way.z, 0, 0, 0};
  std::size_t row = at(count_ways(joint));
  if (joint.point != JointTraits::Point::all) {
    const int first = joint.ends[0].body;
    const Matrix3<double> before = find_rotation(now[at(first)].orientation),
                          after = find_rotation(next[at(first)].orientation);
    for (std::size_t r = 0; r < row; ++r)
      changes[r] = find_way_change(way, frame.apart, frame.way[r], after * transpose_times(before, frame.way[r]));
    if (joint.lead != 0)
      changes[row + 2] = find_way_change(way, frame.apart, frame.turn, after * transpose_times(before, frame.turn)) -
                         joint.lead * take_turns_off(find_angle(joint, next) - find_angle(joint, now));
  }
  if (joint.keeps_axis) {
    for (const double turned : find_turned(joint, frame, next)) {
      changes[row] = turned - frame.gap[row];
      ++row;
    }
  }
  if (joint.keeps_turn) changes[row] = find_skew(joint, next) - frame.gap[row];
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
  Wrench sum{{0, 0, 0}, {0, 0, 0}};
  const double* next = multipliers;
  for (std::size_t r = 0; r < at(count_ways(joint)); ++r) sum.impulse = sum.impulse + *next++ * frame.way[r];
  if (joint.keeps_axis) {
    sum.moment = joint.length * (next[0] * frame.side[0] + next[1] * frame.side[1]);
    next += 2;
  }
  if (joint.lead != 0) {
    sum.impulse = sum.impulse + next[0] * frame.turn;
    sum.moment = sum.moment + (-joint.lead * next[0]) * frame.turn;
  }
  if (joint.keeps_turn) sum.moment = sum.moment + (joint.length * next[0]) * frame.turn;
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
