#pragma once
// Where in a history elements die.

#include <gtest/gtest.h>

#include <functional>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {

/// First row that `is_met` holds for; as many as there are rows: none.
inline std::size_t find_row(const HistoryTable& history, const std::function<bool(std::size_t)>& is_met) {
  std::size_t row = 0;
  while (row < history.rows() && !is_met(row)) ++row;
  return row;
}

inline std::size_t find_death(const HistoryTable& history) {
  return find_row(history, [&](std::size_t row) { return history["eroded_elements"][row] > 0; });
}

/// Expects element "e" to be dead `steps` after the first row in which the criterion is met, which is none of the
/// first.
inline void expect_death(const HistoryTable& history, const std::function<bool(std::size_t)>& is_met,
                         std::size_t steps = 1) {
  const std::size_t met = find_row(history, is_met);
  EXPECT_GT(met, 3U);
  ASSERT_LT(met + steps, history.rows());
  EXPECT_EQ(find_death(history), met + steps);
  EXPECT_EQ(history.last("eroded_elements"), 1);
  EXPECT_EQ(history.last("e_stress_xx"), 0);
}

}  // namespace percuss::test
