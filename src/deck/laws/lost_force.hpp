#pragma once
// How the force falls over what an evolution of damage takes, both from 0 to 1.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "src/deck/deck.hpp"

namespace percuss {

/// The mean share of force that is left.
inline double find_mean_share(const DamageEvolutionDeck& evolution) {
  if (evolution.exponent) return 1 / *evolution.exponent - 1 / std::expm1(*evolution.exponent);
  const auto& rows = evolution.table;
  double lost = rows.empty() ? 0.5 : 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    lost += 0.5 * (rows[i][0] - rows[i - 1][0]) * (rows[i][1] + rows[i - 1][1]);
  return 1 - lost;
}

/// How fast the force falls at most; 1 along a straight line.
inline double find_steepest_fall(const DamageEvolutionDeck& evolution) {
  if (evolution.exponent) return *evolution.exponent / -std::expm1(-*evolution.exponent);
  const auto& rows = evolution.table;
  double most = rows.empty() ? 1 : 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    most = std::max(most, (rows[i][1] - rows[i - 1][1]) / (rows[i][0] - rows[i - 1][0]));
  return most;
}

}  // namespace percuss
