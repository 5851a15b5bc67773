// Preloads of beams and shells: the force of the deck, the energy and the shortening that it gives.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::preload_test {
namespace {

using testing::HasSubstr;

constexpr double steel_modulus = 200e9, force = 60e3, area = 6e-4, length = 0.4;

/// A part along x from 0 to 0.4 m, held at both ends.
std::string hold_part(const std::string& part, const std::string& preload, const std::string& law = "elastic") {
  return fmt::format(R"yaml(
time: {{end: 5e-4}}
parts: {{bar: {{{}, material: steel}}}}
materials: {{steel: {{model: {}, density: 7850, youngs_modulus: {}, poissons_ratio: 0}}}}
start: {{relaxation: {{tolerance: 1e-12}}, preload: {{bolt: {{part: bar, force: {}{}}}}}}}
output: {{history: {{every: 0, forces: [{{name: cut, section: {{part: bar, point: [0.11, 0, 0], normal: x}}}}]}}}}
)yaml",
                     part, law, steel_modulus, force, preload);
}

const std::string both_ends =
    "conditions: [{nodes: bar/start, fixed: [x, y, z]}, {nodes: bar/end, fixed: [x, y, z]}]\n";
const std::string plane = ", point: [0.21, 0, 0], normal: x";

/// F^2 L / (2 E A) holds to what a strain of 5e-4 changes; `share` of a layer that has lost more.
void expect_bar(const Outcome& run, double share) {
  EXPECT_EQ(run.summary.relaxation.state, "settled");
  EXPECT_LT(run.summary.relaxation.preload_error, 5e-6);
  for (std::size_t row = 2; row < run.history.rows(); ++row) {
    const double dt = run.history["dt"][row];
    if (std::abs(dt - run.history["dt"][row - 1]) > 1e-9 * dt) continue;
    ASSERT_NEAR(run.history["fx:cut"][row], force, 5e-6 * force) << row;
  }
  const double exact = force * force * length / (2 * steel_modulus * area);
  fmt::print("energy {:.8g}, exact {:.8g}\n", run.summary.relaxation.energy, exact);
  EXPECT_NEAR(run.summary.relaxation.energy, exact, share * exact);
  EXPECT_NEAR(run.summary.energy.initial, run.summary.relaxation.energy, 1e-5 * exact);
  EXPECT_LT(run.history.largest("kinetic"), 1e-9 * exact);
  for (std::size_t row = 0; row < run.history.rows(); ++row)
    ASSERT_LT(std::abs(run.history["energy_error"][row]), 1e-9);
}

const std::string line = "line: {from: [0, 0, 0], to: [0.4, 0, 0], cells: 8}, section: ";
const std::string truss = line + "{truss: {area: 6e-4}}",
                  square = line + "{rectangle: {size: [0.02, 0.03]}}, toward: y";

}  // namespace

// Each beam has the force: nothing moves, and the energy is exact.
TEST(PreloadOfBeams, EachHasTheForce) {
  for (const std::string& part : {truss, square}) {
    expect_bar(run_deck(hold_part(part, "") + both_ends), 1e-6);
    expect_bar(run_deck(hold_part(part, "", "j2_plasticity, yield_stress: 2e8, hardening_modulus: 1e9") + both_ends),
               1e-6);
  }
}

// One beam of eight is shortened by 8 strains of 5e-4, the others are stretched.
TEST(PreloadOfBeams, AtAPlaneGivesTheForceOfTheSection) {
  for (const std::string& part : {truss, square}) expect_bar(run_deck(hold_part(part, plane) + both_ends), 3e-3);
  // A plane across the beam: its strain along the axis is e cos^2 a, its force along the normal F cos a.
  const Outcome run = run_deck(hold_part(square, ", point: [0.21, 0, 0], normal: [0.8, 0.6, 0]") + both_ends);
  const double exact = force * force / 0.64 * length / (2 * steel_modulus * area);
  EXPECT_NEAR(run.summary.relaxation.energy, exact, 3e-3 * exact);
  EXPECT_NEAR(run.history["fx:cut"].back(), force / 0.8, 1e-5 * force);
}

// A bolt through two blocks between rigid plates: what the bolt pulls, the blocks carry. They get shorter by F L / (E
// A).
TEST(PreloadOfBeams, ABoltClampsTwoBlocks) {
  for (const char* more : {"", ", point: [0.05, 0.05, 0.06], normal: z"}) {
    const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: 5e-4}}
parts:
  base: {{box: {{size: [0.1, 0.1, 0.02], cells: [2, 2, 1]}}, at: [0, 0, -0.02], material: steel, rigid: {{fixed: [x, y, z, rx, ry, rz]}}}}
  low: {{box: {{size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}}, material: steel}}
  top: {{box: {{size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}}, at: [0, 0, 0.1], material: steel}}
  cap: {{box: {{size: [0.1, 0.1, 0.02], cells: [2, 2, 1]}}, at: [0, 0, 0.2], material: steel, rigid: true}}
  bolt: {{line: {{from: [0.05, 0.05, 0], to: [0.05, 0.05, 0.2], cells: 4}}, section: {{round: {{radius: 0.0138}}}}, material: steel}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}}}}
rigid_sets: {{foot: {{nodes: bolt/start, body: base}}, head: {{nodes: bolt/end, body: cap}}}}
contact: {{surfaces: all}}
start: {{relaxation: {{tolerance: 1e-12}}, preload: {{bolt: {{part: bolt, force: 60e3{}}}}}}}
output: {{history: {{every: 1e-5, nodes: [{{name: cap, near: [0, 0, 0.22]}}], forces: [{{name: joint, contact: [top, low]}}]}}}}
)yaml",
                                             more));
    const double bolt = 3.14159265358979 * 0.0138 * 0.0138, block = 0.01, force_length = force * 0.2 / steel_modulus;
    EXPECT_LT(run.summary.relaxation.preload_error, 1e-3);
    EXPECT_NEAR(run.history["cap_z"][0], 0.22 - force_length / block, 0.01 * force_length / block);
    const double exact = 0.5 * force * force_length * (1 / bolt + 1 / block);
    fmt::print("cap {:.6g}, energy {:.6g}, exact {:.6g}\n", run.history["cap_z"][0] - 0.22,
               run.summary.relaxation.energy, exact);
    EXPECT_NEAR(run.summary.relaxation.energy, exact, 5e-3 * exact);
    EXPECT_NEAR(run.history.mean(1e-4, 5e-4, "fz:joint"), force, 2e-3 * force);
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
  }
}

// A strip, also one that is turned: its layers have the stress F / A, its energy is that of a bar.
TEST(PreloadOfShells, GivesTheForceOfTheSection) {
  const std::string ends = "conditions: [{nodes: bar/x_min, fixed: [x, y, z]}, {nodes: bar/x_max, fixed: [x, y, z]}]\n";
  for (const char* more : {"", ", points: 5, rotate: [{axis: x, angle: 30}]"}) {
    const std::string strip = "shell_plate: {size: [0.4, 0.03], cells: [16, 2]}, thickness: 0.02";
    expect_bar(run_deck(hold_part(strip + more, plane) + ends), 8e-3);
    const char* const law = "j2_plasticity, yield_stress: 2e8, hardening_modulus: 1e9";
    expect_bar(run_deck(hold_part(strip + more, plane, law) + ends), 8e-3);
  }
}

TEST(PreloadOfBeams, ThatYieldBelowItIsNotReached) {
  try {
    run_deck(hold_part(square, "", "j2_plasticity, yield_stress: 0.9e8, hardening_modulus: 0") + both_ends,
             {"start.relaxation.max_steps=2000"});
    ADD_FAILURE() << "it settled";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("deck.yaml:5:51: error: preload 'bolt' is not reached in 2000 steps (a beam of 'bar' "
                          "carries 54000, start.preload.bolt.force is 60000; "));
    EXPECT_THAT(error.what(), HasSubstr("give start.relaxation.max_steps more; if the force does not grow, lower it"));
  }
}

// The relaxation does not make all of its 100 000 steps for it.
TEST(PreloadOfBeams, ThatComeNoNearerAreToldEarly) {
  const std::string yields =
      hold_part(square, "", "j2_plasticity, yield_stress: 0.9e8, hardening_modulus: 0") + both_ends;
  const Outcome run = run_deck(yields, {"start.relaxation.unsettled=warn"});
  EXPECT_EQ(run.summary.relaxation.state, "unsettled");
  EXPECT_EQ(run.summary.relaxation.steps, 10500);
  const Warning& told = run.summary.warnings.back();
  EXPECT_EQ(told.rule, "unsettled_relaxation");
  EXPECT_EQ(told.place, "deck.yaml:5:51");
  EXPECT_THAT(told.text, HasSubstr("start.preload.bolt.force is 60000; the force comes no nearer; "));
  EXPECT_THAT(told.text, HasSubstr("): lower the force below what the part can carry, or let conditions, contact or "
                                   "ties keep its ends apart"));
}

/// A bolt with a head that stops are apart from. Its layer, of 10 mm, has no force until it has closed the gap.
std::string pull_head(double stops, double force_of_bolt) {
  return fmt::format(R"yaml(
time: {{end: 1e-5, max_steps: 3}}
parts:
  bar: {{box: {{size: [0.1, 0.01, 0.01], cells: [10, 1, 1]}}, material: steel}}
  head: {{box: {{size: [0.01, 0.03, 0.03], cells: [1, 3, 3]}}, at: [0.1, -0.01, -0.01], material: steel}}
  low: {{box: {{size: [0.01, 0.005, 0.03], cells: [1, 1, 3]}}, at: [{0}, -0.0101, -0.01], material: steel}}
  high: {{box: {{size: [0.01, 0.005, 0.03], cells: [1, 1, 3]}}, at: [{0}, 0.0151, -0.01], material: steel}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}}}}
conditions: [{{nodes: bar/x_min, fixed: [x, y, z]}}, {{nodes: low, fixed: [x, y, z]}}, {{nodes: high, fixed: [x, y, z]}}]
contact: {{surfaces: all, ties: [{{a: bar/x_max, b: head/x_min}}]}}
start: {{relaxation: {{unsettled: warn}}, preload: {{bolt: {{part: bar, point: [0.045, 0, 0], normal: x, force: {1}}}}}}}
)yaml",
                     stops, force_of_bolt);
}

// It lacks nearly all of its force for more than two checks of the progress.
TEST(Preload, ThatClosesAGapIsNotTakenForStuck) {
  const Outcome run = run_deck(pull_head(0.0885, 1e3));
  EXPECT_EQ(run.summary.relaxation.state, "settled");
  EXPECT_GT(run.summary.relaxation.steps, 10500);
  EXPECT_LT(run.summary.relaxation.preload_error, 1e-3);
}

// The layer gets shorter for ever where nothing stops the head: at the second check it has lost more than half.
TEST(Preload, WithoutAStopIsToldEarly) {
  const Outcome run = run_deck(pull_head(-0.5, 10e3));
  EXPECT_EQ(run.summary.relaxation.state, "unsettled");
  EXPECT_EQ(run.summary.relaxation.steps, 10500);
  EXPECT_THAT(run.summary.warnings.back().text, HasSubstr("the force comes no nearer; "));
}

TEST(PreloadOfBeams, WithoutAPlaneIsOfBeamsAlone) {
  const auto find_error = [](const std::string& text) -> std::string {
    try {
      run_deck(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string box = "box: {size: [0.4, 0.02, 0.03], cells: [4, 1, 1]}";
  EXPECT_THAT(find_error(hold_part(box, "")), HasSubstr("preload 'bolt' has no plane and is of part 'bar' (only beams "
                                                        "have a force each): give it point and normal"));
  EXPECT_THAT(find_error(hold_part(truss, ", normal: x") + both_ends),
              HasSubstr("point is missing (a section has point and normal; without both, each beam"));
}

}  // namespace percuss::test::preload_test
