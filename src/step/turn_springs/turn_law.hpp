#pragma once
// Moments and angles of a turn spring (docs/theory_rigid.md, Turn springs).

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "src/step/model/state.hpp"
#include "src/step/springs/spring_law.hpp"

namespace percuss {

/// The axes of both bodies as they are now.
using TurnAxes = std::array<std::array<Vector3<double>, 3>, 2>;

/// The angle that differs from another by whole turns and is nearest to a third.
inline double unwrap(double angle, double near) { return near + std::remainder(angle - near, 2 * std::numbers::pi); }

/// The angles about x, y and z that lead from the axes of the first body to those of the second. Two sets do, and whole
/// turns more: those nearest to `before`, which follow a turn beyond a right angle about y.
inline std::array<double, 3> find_turn_angles(const TurnAxes& axes, const std::array<double, 3>& before) {
  const auto& [a, b] = axes;
  const double sine = std::clamp(dot(a[0], b[2]), -1.0, 1.0);
  const std::array<double, 3> first{std::atan2(-dot(a[1], b[2]), dot(a[2], b[2])), std::asin(sine),
                                    std::atan2(-dot(a[0], b[1]), dot(a[0], b[0]))};
  const std::array<double, 3> second{first[0] + std::numbers::pi, std::numbers::pi - first[1],
                                     first[2] + std::numbers::pi};
  const auto bring_near = [&](std::array<double, 3> angles) {
    for (std::size_t k = 0; k < 3; ++k) angles[k] = unwrap(angles[k], before[k]);
    return angles;
  };
  const auto find_distance = [&](const std::array<double, 3>& angles) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += std::abs(angles[k] - before[k]);
    return sum;
  };
  const std::array<double, 3> one = bring_near(first), other = bring_near(second);
  return find_distance(other) < find_distance(one) ? other : one;
}

/// For each angle the vector whose product with the spin of the second body against the first is its rate. A moment
/// along it does work on that angle alone. Within three degrees of a right angle about y, where two of the angles are
/// one turn, the vectors are as long as there.
inline std::array<Vector3<double>, 3> find_rate_vectors(const TurnAxes& axes, const std::array<double, 3>& angle) {
  constexpr double least_cosine = 0.05;
  const auto& a = axes[0];
  const double c = std::cos(angle[0]), s = std::sin(angle[0]);
  const Vector3<double> across = c * a[1] + s * a[2], up = c * a[2] + (-s) * a[1];
  const double cosine = std::cos(angle[1]), sine = std::sin(angle[1]);
  const double bounded = std::copysign(std::max(std::abs(cosine), least_cosine), cosine);
  return {a[0] + (-sine / bounded) * up, across, (1 / bounded) * up};
}

/// Moment of the spring and of the stops.
inline double find_elastic_moment(const TurnLaw& law, double angle) {
  double moment = find_elastic_force(law.spring, angle);
  if (law.least) moment += law.hold_stiffness * std::min(angle - *law.least, 0.0);
  if (law.most) moment += law.hold_stiffness * std::max(angle - *law.most, 0.0);
  return moment;
}

/// Integral of that moment from no angle.
inline double find_turn_energy(const TurnLaw& law, double angle) {
  const auto of_stop = [&](double way, double at_rest) {
    return 0.5 * law.hold_stiffness * (way * way - at_rest * at_rest);
  };
  double energy = find_stored_energy(law.spring, angle);
  if (law.least) energy += of_stop(std::min(angle - *law.least, 0.0), std::min(-*law.least, 0.0));
  if (law.most) energy += of_stop(std::max(angle - *law.most, 0.0), std::max(-*law.most, 0.0));
  return energy;
}

/// Friction after a turn: it sticks with its stiffness and slips at its moment.
inline double find_friction(const TurnLaw& law, double angle, double turned, double before) {
  if (!law.slips()) return 0;
  const double limit = std::max(find_elastic_force(law.friction, angle), 0.0);
  return std::clamp(before + law.hold_stiffness * turned, -limit, limit);
}

/// Largest stiffness against the angle.
inline double bound_turn_stiffness(const TurnLaw& law) {
  const bool holds = law.slips() || law.least || law.most;
  return law.spring.largest_slope + (holds ? law.hold_stiffness : 0);
}

}  // namespace percuss
