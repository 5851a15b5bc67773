// Ties that begin and end in the run, and nodes that stick as they come into contact: momenta by hand.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/error.hpp"
#include "tests/expect_error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::late_tie_test {
namespace {

constexpr double density = 1000, modulus = 1e8, length = 1, area = 0.01, speed = 2, born_at = 2e-3;
constexpr double mass = density * length * area;
const double sound = std::sqrt(modulus / density);  // of a bar that does not widen

/// Two equal bars along x, a little apart; the right one moves away from the left one, or as more says.
std::string make_bars(const std::string& ties, const std::string& more = "") {
  return fmt::format(R"yaml(
time: {{end: 8e-3, step_scale: 0.5}}
parts:
  left: {{box: {{size: [1, 0.1, 0.1], cells: [60, 1, 1]}}, at: [-1, 0, 0], material: soft}}
  right: {{box: {{size: [1, 0.1, 0.1], cells: [60, 1, 1]}}, at: [0.001, 0, 0], material: soft}}
materials: {{soft: {{model: elastic, density: {:g}, youngs_modulus: {:g}, poissons_ratio: 0}}}}
initial: [{{part: right, velocity: [{:g}, 0, 0]}}]
sensors: {{event: {{time: {:g}}}}}
contact: {{surfaces: none, ties: [{}]}}
output: {{history: {{every: 0, parts: [left, right], nodes: [{{name: end, near: [0, 0, 0], part: left}}, {{name: start, near: [0.001, 0, 0], part: right}}]}}}}
{})yaml",
                     density, modulus, speed, born_at, ties, more);
}

}  // namespace

// From its beginning on half the speed goes through both bars with the speed of sound: the force is rho c v / 2.
TEST(LateTie, StopsOneBarByTheOtherFromItsBeginningOn) {
  const Outcome run = run_deck(make_bars("{a: right/x_min, b: left/x_max, distance: 0.1, from: event}"));
  EXPECT_EQ(run.history.at(born_at * (1 - 1e-9), "momentum_x:left"), 0);
  const double half_way = born_at + 0.5 * length / sound, whole = born_at + length / sound;
  EXPECT_NEAR(run.history.at(half_way, "momentum_x:left"), 0.25 * mass * speed, 0.01 * mass * speed);
  EXPECT_NEAR(run.history.at(whole, "momentum_x:left"), 0.5 * mass * speed,
              0.01 * mass * speed);  // then both are as fast
  for (std::size_t i = 0; i < run.history.rows(); ++i)
    EXPECT_NEAR(run.history["momentum_x"][i], mass * speed, 1e-10 * mass * speed);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

// The ends stay as far apart as they were then: no jump.
TEST(LateTie, HoldsNodesWhereTheyAreThen) {
  const Outcome run = run_deck(make_bars("{a: right/x_min, b: left/x_max, distance: 0.1, from: event}"));
  const auto gap = [&](double time) { return run.history.at(time, "start_x") - run.history.at(time, "end_x"); };
  EXPECT_NEAR(gap(born_at), 0.001 + speed * born_at, 2e-4);
  EXPECT_NEAR(gap(7e-3), gap(born_at * 1.02), 1e-9);
}

// Until its end it pulls the left bar along; from then on nothing acts on either.
TEST(LateTie, LetsGoAtItsEnd) {
  const Outcome run = run_deck(make_bars("{a: right/x_min, b: left/x_max, distance: 0.1, until: event}"));
  const double then = 0.5 * density * sound * area * speed * born_at;
  EXPECT_NEAR(run.history.at(born_at, "momentum_x:left"), then, 0.02 * then);
  EXPECT_NEAR(run.history.last("momentum_x:left"), run.history.at(born_at * 1.02, "momentum_x:left"), 1e-9 * then);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

TEST(LateTie, ThatFindsNothingEndsTheRun) {
  EXPECT_ERROR(run_deck(make_bars("{a: right/x_min, b: left/x_max, from: event}")), RunError,
               "ties nothing");  // beyond 0.05 of an edge
  const Outcome run = run_deck(make_bars("{a: right/x_min, b: left/x_max, from: event, empty: ignore}"));
  EXPECT_EQ(run.history.last("momentum_x:left"), 0);
}

// The right bar flies onto the left one and would part from it after the wave has gone to both ends and back.
TEST(LateTie, HoldsWhatHasComeIntoContact) {
  const auto make = [&](const std::string& ties) {
    std::string deck = make_bars(ties);
    deck.replace(deck.find("velocity: [2, 0, 0]"), 19, "velocity: [-2, 0, 0]");
    return deck.replace(deck.find("surfaces: none"), 14, "surfaces: all");
  };
  const double meet = 0.001 / speed, part = meet + 2 * length / sound;
  const Outcome stuck = run_deck(make("{a: right, b: left, sticks: on_contact}"), {"time.end=0.03"}),
                free = run_deck(make(""), {"time.end=0.03"});
  const auto gap = [&](const Outcome& run) { return run.history.last("start_x") - run.history.last("end_x"); };
  EXPECT_NEAR(gap(free), speed * (0.03 - part), 0.1 * speed * (0.03 - part));
  EXPECT_NEAR(gap(stuck), 0, 1e-3);
  EXPECT_NEAR(stuck.history.last("momentum_x"), -mass * speed, 1e-9 * mass * speed);
  EXPECT_LT(std::abs(stuck.summary.energy.error), 1e-3);
}

}  // namespace percuss::test::late_tie_test
