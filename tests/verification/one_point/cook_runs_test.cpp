// Cook's membrane of nearly incompressible wedges, pyramids and tetrahedra as decks: none locks.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::cook_runs_test {
namespace {

constexpr double tip = 0.0807;  // deflection of the converged membrane in plane strain: 8.07 of a load of 100

/// Deflection of the upper corner at rest, with so many cells a side; `more`: settings of the elements.
double find_tip(const std::string& kind, int cells, const std::string& more = "") {
  const HistoryTable history = run_deck(fmt::format(R"(
title: Cook's membrane
time: {{end: 1e-3}}
parts:
  b: {{box: {{size: [48, 44, 2], cells: [{1}, {1}, 1]}}, elements: {0}, material: m}}
imperfections:
  - {{nodes: b, direction: y, mode: "44/48*x + y/44*(44 - 28*x/48) - y"}}
materials:
  m: {{model: elastic, density: 1e-3, youngs_modulus: 240.565, poissons_ratio: 0.4999}}
start: {{relaxation: {{tolerance: 1e-6}}}}
conditions:
  - {{nodes: b/x_min, fixed: [x, y, z]}}
  - {{nodes: b, fixed: [z]}}
loads:
  pressure: [{{faces: b/x_max, value: 0.0625, direction: y}}]
output: {{history: {{every: 0, nodes: [{{name: a, near: [48, 60, 0]}}]}}}}
{2}
)",
                                                    kind, cells, more))
                                   .history;
  return history["a_y"][0] - 60;
}

TEST(CooksMembraneOfDecks, DoesNotLockWhenNearlyIncompressible) {
  for (const char* kind : {"wedges", "pyramids", "tetrahedra"}) {
    const double coarse = find_tip(kind, 4) / tip, fine = find_tip(kind, 8) / tip;
    fmt::print("{}: {:.3f} and {:.3f} of the deflection\n", kind, coarse, fine);
    EXPECT_GT(fine, kind == std::string("wedges") ? 0.9 : 0.75)
        << kind;  // parallel diagonals: 0.79; locked: 0.27 and 0.64
    EXPECT_LT(fine, 1.01) << kind;
    EXPECT_LT(1 - fine, 0.6 * (1 - coarse)) << kind;  // towards the answer
  }
}

// Crossing diagonals keep wedges from locking by themselves, as in the plane; parallel ones would leave 0.27.
TEST(CooksMembraneOfDecks, IsStifferOfWedgesThatAverageNothing) {
  const double plain = find_tip("wedges", 8, "elements: {tetrahedra: plain}") / tip;
  EXPECT_GT(plain, 0.7);
  EXPECT_LT(plain, 0.85);
}

}  // namespace
}  // namespace percuss::test::cook_runs_test
