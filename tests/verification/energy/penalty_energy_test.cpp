// Springs of contact give back what they took, and no more: bodies that rattle, and overlap that is pushed out.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::penalty_energy_test {
namespace {

/// Largest sum of what contact has given and what its springs hold.
double find_largest_gain(const HistoryTable& history) {
  const std::vector<double>&given = history["contact"], &stored = history["contact_stored"];
  double largest = 0;
  for (std::size_t i = 0; i < given.size(); ++i) largest = std::max(largest, given[i] + stored[i]);
  return largest;
}

/// A block of `cells` cells an edge that flies between two walls or two rigid bodies, 0.5 apart from it, at `speed`.
/// max_step: below that of its elements the steps are even.
std::string describe_rattle(const std::string& stops, double speed, int cells, double max_step) {
  return fmt::format(R"(
time: {{end: {}, max_step: {}}}
parts:
  block: {{box: {{size: [1, 1, 1], cells: [{}, {}, {}]}}, at: [0.03, 0.02, 0.2637], material: m}}
{}
materials:
  m: {{model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.3}}
initial: [{{part: block, velocity: [0, 0, {}]}}]
output: {{history: {{every: 0}}}}
)",
                     2 / speed, max_step, cells, cells, cells, stops, speed);
}

const std::string walls = R"(
walls: [{point: [0, 0, 0], normal: z}, {point: [0, 0, 1.5], normal: -z}]
contact: {enforcement: penalty}
)";
const std::string bodies =
    "  low: {box: {size: [3, 3, 0.5], cells: [3, 3, 1]}, at: [-1, -1, -0.5], material: m, rigid: {fixed: [x, y, z, rx, "
    "ry, rz]}}\n"
    "  high: {box: {size: [3, 3, 0.5], cells: [3, 3, 1]}, at: [-1, -1, 1.5], material: m, rigid: {fixed: [x, y, z, rx, "
    "ry, rz]}}\n"
    "contact: {surfaces: all, enforcement: penalty}\n";

}  // namespace

// Nodes on walls are springs apart, and conserve. Rows of faces share nodes, and lose a little where several begin.
TEST(PenaltyEnergy, OfABlockThatRattlesStaysAsItIs) {
  struct Case {
    const std::string& stops;
    double speed;
    int cells;
    double gain, loss;  // of the energy at the start
  };
  for (const auto& [stops, speed, cells, gain, loss] :
       {Case{walls, 0.003, 1, 1e-10, 1e-10}, Case{walls, 0.003, 3, 1e-10, 1e-10}, Case{walls, 0.03, 1, 1e-10, 1e-10},
        Case{walls, 0.03, 3, 1e-10, 1e-10}, Case{bodies, 0.003, 1, 2e-3, 2e-3}, Case{bodies, 0.003, 3, 1e-9, 1e-9},
        Case{bodies, 0.03, 3, 1e-4, 0.02}}) {
    const Outcome run = run_deck(describe_rattle(stops, speed, cells, 0.2 / cells));
    const double start = run.history["kinetic"].front();
    EXPECT_LT(find_largest_gain(run.history), gain * start) << speed << " " << cells;
    EXPECT_GT(run.history.last("contact") + run.history.last("contact_stored"), -loss * start) << speed << " " << cells;
  }
}

// The step follows the elements that impacts press, by a tenth and more. Of rows that share nodes those that come
// deeper than their cushion lose.
TEST(PenaltyEnergy, OfABlockThatRattlesInUnevenStepsStaysAsItIs) {
  struct Case {
    const std::string& stops;
    double speed;
    int cells;
    double gain, loss;  // of the energy at the start
  };
  for (const auto& [stops, speed, cells, gain, loss] :
       {Case{walls, 0.03, 1, 1e-10, 1e-10}, Case{walls, 0.03, 3, 1e-10, 1e-10}, Case{walls, 0.05, 1, 1e-10, 1e-10},
        Case{bodies, 0.03, 1, 1e-9, 0.12}, Case{bodies, 0.03, 3, 2e-4, 0.02}}) {
    const Outcome run = run_deck(describe_rattle(stops, speed, cells, 1e9));
    const double start = run.history["kinetic"].front(), gained = find_largest_gain(run.history);
    const double left = run.history.last("contact") + run.history.last("contact_stored");
    fmt::print("contact adds {:.2e}, {:.2e} at the end\n", gained / start, left / start);
    EXPECT_LT(gained, gain * start) << speed << " " << cells;
    EXPECT_GT(left, -loss * start) << speed << " " << cells;
  }
}

// What friction holds as a spring is among what springs hold, and it only takes.
TEST(PenaltyEnergy, OfABlockThatRattlesAndRubsInUnevenStepsOnlyFalls) {
  const std::string rough = R"(
walls: [{point: [0, 0, 0], normal: z, friction: 0.3}, {point: [0, 0, 1.5], normal: -z, friction: 0.3}]
contact: {enforcement: penalty}
)";
  for (const int cells : {1, 3}) {
    for (const double speed : {0.03, 0.05}) {
      const Outcome run = run_deck(describe_rattle(rough, speed, cells, 1e9));
      const HistoryTable& h = run.history;
      double largest = 0;
      for (std::size_t i = 0; i < h["contact"].size(); ++i)
        largest = std::max(largest, h["contact"][i] + h["contact_stored"][i] + h["friction"][i]);
      EXPECT_LT(largest, 1e-10 * h["kinetic"].front()) << speed << " " << cells;
      EXPECT_LT(h.last("friction"), -0.05 * h["kinetic"].front());
    }
  }
}

// Contacts of a few steps: springs of friction that cross their middle give back what they hold, and no more.
TEST(PenaltyEnergy, OfSheetsAndBlocksThatMeetAndRubOnlyFalls) {
  const std::string sheets =
      "  a: {shell_plate: {size: [0.04, 0.04], cells: [4, 4]}, thickness: 0.001, at: [0, 0, 0.001001], material: m}\n"
      "  b: {shell_plate: {size: [0.04, 0.04], cells: [4, 4]}, thickness: 0.001, material: m}\n";
  const std::string blocks =
      "  a: {box: {size: [0.01, 0.012, 0.01], cells: [3, 3, 3]}, at: [0.001, 0.002, 0.010001], material: m}\n"
      "  b: {box: {size: [0.02, 0.02, 0.01], cells: [4, 5, 3]}, material: m}\n";
  for (const std::string& parts : {sheets, blocks}) {
    for (const double friction : {0.2, 1.0}) {
      for (const char* velocity : {"[7, 0, -10]", "[2, 3, -10]", "[20, -5, -10]"}) {
        const Outcome run = run_deck(fmt::format(R"(
time: {{end: 1e-4}}
parts:
{}materials:
  m: {{model: elastic, density: 8000, youngs_modulus: 2e11, poissons_ratio: 0.3}}
initial: [{{part: a, velocity: {}}}]
contact: {{surfaces: all, friction: {}, enforcement: penalty}}
output: {{history: {{every: 0}}}}
)",
                                                 parts, velocity, friction));
        const HistoryTable& h = run.history;
        double largest = 0;
        for (std::size_t i = 0; i < h["contact"].size(); ++i)
          largest = std::max(largest, h["contact"][i] + h["contact_stored"][i] + h["friction"][i]);
        fmt::print("contact adds {:.2e}, friction takes {:.2e}\n", largest / h["kinetic"].front(),
                   -h.last("friction") / h["kinetic"].front());
        EXPECT_LT(largest, 1e-4 * h["kinetic"].front()) << velocity << " " << friction;
        EXPECT_LT(h.last("friction"), 0) << velocity << " " << friction;
      }
    }
  }
}

// A steel block that friction holds on a slope of 30 degrees. Round-off must not grow.
TEST(PenaltyEnergy, OfABlockThatRestsOnASlopeStaysNone) {
  const Outcome run = run_deck(R"(
time: {end: 0.01}
parts: {block: {box: {size: [0.04, 0.04, 0.02], cells: [2, 2, 1]}, material: steel}}
materials: {steel: {model: elastic, density: 8000, youngs_modulus: 2e11, poissons_ratio: 0.3}}
start: {relaxation: {tolerance: 1e-16}}
loads: {gravity: [4.905, 0, -8.495709]}
walls: [{normal: z, friction: 0.7}]
contact: {enforcement: penalty}
output: {history: {every: 1e-4, nodes: [{name: n, near: [0.02, 0.02, 0.01]}]}}
)");
  EXPECT_GT(run.summary.steps, 5000);
  EXPECT_LT(run.history.last("kinetic"), 1e-20);
  EXPECT_LT(std::abs(run.history.last("n_x") - run.history["n_x"].front()), 1e-14);
}

// Two blocks of 0.5 between fixed ends, of E = 1 and without Poisson's ratio, overlap by 0.02: a is 1 x 1, b 0.8 x 0.8.
// The work of push-out is less than that of closing 0.02 with both in uniform compression: the springs give way too.
TEST(PenaltyEnergy, OfOverlapThatIsPushedOutIsThatOfTheOverlap) {
  const Outcome run = run_deck(R"(
time: {end: 90}
parts:
  a: {box: {size: [1, 1, 0.5], cells: [4, 4, 2]}, material: m}
  b: {box: {size: [0.8, 0.8, 0.5], cells: [4, 4, 2]}, at: [0.1, 0.1, 0.48], material: m}
materials:
  m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}
conditions:
  - {nodes: a/z_min, fixed: [z]}
  - {nodes: b/z_max, fixed: [z]}
contact: {surfaces: [[a, b]], overlap: push_out, enforcement: penalty}
output: {history: {every: 0}}
)");
  const double between = 0.02 / (0.5 / 1 + 0.5 / 0.64) * 0.02 / 2;  // energy if each is in uniform compression
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
  EXPECT_LT(find_largest_gain(run.history), between);
  EXPECT_GT(find_largest_gain(run.history), 0.3 * between);
  EXPECT_LT(run.history.largest("kinetic"), 0.2 * between);
  EXPECT_GT(run.summary.steps, 300);
}

}  // namespace percuss::test::penalty_energy_test
