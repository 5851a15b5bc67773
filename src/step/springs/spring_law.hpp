#pragma once
// A spring and damper between two nodes: forces, energy and what they ask of the step (docs/theory_line_elements.md).

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "src/step/model/spring_model.hpp"

namespace percuss {

/// Row of the table that an elongation lies behind, so that it and the next one give the line through it.
inline std::size_t find_row(const SpringLaw& law, double elongation) {
  std::size_t row = 0;
  while (row + 2 < law.rows.size() && elongation >= law.rows[row + 1][0]) ++row;
  return row;
}

inline double find_slope(const SpringLaw& law, std::size_t row) {
  return (law.rows[row + 1][1] - law.rows[row][1]) / (law.rows[row + 1][0] - law.rows[row][0]);
}

/// Whether a spring that acts one way does so at an elongation.
inline bool is_acting(const SpringLaw& law, double elongation) {
  using Acts = SpringDeck::Acts;
  return law.acts == Acts::both || (law.acts == Acts::tension ? elongation > 0 : elongation < 0);
}

/// Force on the line between the rows, straight on beyond them.
inline double find_elastic_force(const SpringLaw& law, double elongation) {
  if (law.rows.empty() || !is_acting(law, elongation)) return 0;
  const std::size_t row = find_row(law, elongation);
  return law.rows[row][1] + find_slope(law, row) * (elongation - law.rows[row][0]);
}

/// Integral of that force from no elongation: exact, for the force is linear between rows.
inline double find_stored_energy(const SpringLaw& law, double elongation) {
  const double low = std::min(elongation, 0.0), high = std::max(elongation, 0.0);
  const auto add_piece = [&](double from, double to) {
    return to > from ? (to - from) * find_elastic_force(law, 0.5 * (from + to)) : 0;
  };
  double sum = 0, from = low;
  for (const auto& row : law.rows) {
    if (row[0] <= from || row[0] >= high) continue;
    sum += add_piece(from, row[0]);
    from = row[0];
  }
  sum += add_piece(from, high);
  return elongation < 0 ? -sum : sum;
}

/// Largest stiffness that the spring can have along its axis.
inline double find_largest_slope(const SpringLaw& law) {
  double largest = 0;
  for (std::size_t row = 0; row + 1 < law.rows.size(); ++row) largest = std::max(largest, find_slope(law, row));
  return largest;
}

/// The end points of a spring at n+1 and their velocities at n+1/2.
struct SpringEnds {
  Vector3<double> place[2], velocity[2];
};

/// The spring in new places of its ends. One that is broken has no force and does not mend.
inline SpringState stretch_spring(const SpringLaw& law, double rest_length, const SpringState& before,
                                  const SpringEnds& ends) {
  SpringState now;
  now.is_broken = before.is_broken;
  const Vector3<double> across = ends.place[1] - ends.place[0];
  now.length = std::sqrt(dot(across, across));
  if (now.length > 0) now.axis = (1 / now.length) * across;
  now.elongation = now.length - rest_length;
  if (now.is_broken != 0) return now;
  now.elastic = find_elastic_force(law, now.elongation);
  if (is_acting(law, now.elongation)) now.damping = law.damping * dot(now.axis, ends.velocity[1] - ends.velocity[0]);
  const auto is_beyond = [](double value, double limit) { return limit > 0 && std::abs(value) > limit; };
  if (is_beyond(now.force(), law.largest_force) || is_beyond(now.elongation, law.largest_elongation)) {
    now.is_broken = 1;
    now.elastic = now.damping = 0;
  }
  return now;
}

/// Stiffness in whatever direction it is largest: along the axis that of the law, across it that of a force that pulls,
/// which turns with the axis.
inline double bound_stiffness(const SpringLaw& law, const SpringState& state) {
  const double across = state.length > 0 ? std::max(state.force(), 0.0) / state.length : 0;
  return std::max(law.largest_slope, across);
}

/// The largest eigenvalues of M^-1 K and M^-1 C of all springs.
struct SpringRates {
  double stiffness = 0;  // [1 / time^2]
  double damping = 0;    // [1 / time]
};

/// The largest step h for which 2 h C + h^2 K stays below 4 M, where the elements alone allow `mesh_step`: their share
/// of 4 M then shrinks at least with h / mesh_step.
inline double find_step_with_springs(const SpringRates& rates, double mesh_step) {
  const double b = 2 / mesh_step + rates.damping;  // k h^2 + 2 b h = 4
  return 4 / (b + std::sqrt(b * b + 4 * rates.stiffness));
}

}  // namespace percuss
