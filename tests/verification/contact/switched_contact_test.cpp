// Pairs of surfaces and walls that act from one event on, or until another: nothing before, nothing after, and what
// overlaps as they begin is taken as overlap at the start.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::switched_contact_test {
namespace {

using testing::HasSubstr;

constexpr double mass = 8, speed = 10, step = 2e-5, born_at = 2e-3;

/// A block of edge 0.2 above z = 0, with what the tests add, and a plate below that is held.
std::string make_block(double height, const std::string& rest) {
  return fmt::format(R"yaml(
time: {{end: 5e-3, max_step: {:g}}}
parts:
  block: {{box: {{size: [0.2, 0.2, 0.2], cells: [2, 2, 2]}}, at: [0, 0, {:g}], material: soft}}
  plate: {{box: {{size: [0.6, 0.6, 0.1], cells: [5, 5, 1]}}, at: [-0.2, -0.2, -0.1], material: soft}}
materials: {{soft: {{model: elastic, density: 1000, youngs_modulus: 1e8, poissons_ratio: 0.3}}}}
conditions: [{{nodes: plate, fixed: [x, y, z]}}]
sensors: {{event: {{time: {:g}}}, another: {{time: 3.5e-3}}}}
output: {{history: {{every: 0, parts: [block], nodes: [{{name: foot, near: [0, 0, {:g}], part: block}}]}}}}
)yaml",
                     step, height, born_at, height) +
         rest;
}

/// The block falls and comes to z = 0 at 1 ms.
std::string make_falling(const std::string& contact) {
  return make_block(speed * 1e-3,
                    fmt::format("initial: [{{part: block, velocity: [0, 0, {:g}]}}]\n", -speed) + contact);
}

bool warns(const Outcome& run, const std::string& rule) {
  const auto& all = run.summary.warnings;
  return std::any_of(all.begin(), all.end(), [&](const Warning& warning) { return warning.rule == rule; });
}

class Switched : public testing::TestWithParam<std::string> {
 public:
  /// The pair or the wall, with keys of the entry and of contact.
  static std::string make(const std::string& when, const std::string& contact = "overlap: accept") {
    return fmt::format(fmt::runtime(GetParam()), fmt::arg("when", when), fmt::arg("contact", contact));
  }
};
class SwitchedPair : public Switched {};

const auto pairs =
    testing::Values("contact: {{surfaces: [{{a: block, b: plate, {when}}}], {contact}}}\n",
                    "contact: {{surfaces: [{{a: all, b: all, {when}}}], {contact}}}\n",
                    "contact: {{surfaces: [{{a: block, b: plate, {when}}}], enforcement: penalty, {contact}}}\n");
INSTANTIATE_TEST_SUITE_P(Pairs, Switched, pairs);
INSTANTIATE_TEST_SUITE_P(Pairs, SwitchedPair, pairs);
INSTANTIATE_TEST_SUITE_P(
    Walls, Switched,
    testing::Values("contact: {{surfaces: none, {contact}}}\nwalls: [{{point: [0, 0, 0], normal: z, {when}}}]\n"));

}  // namespace

TEST_P(Switched, ActsFromItsEventOnWithoutForceOfWhatOverlapsThen) {
  const Outcome run = run_deck(make_falling(make("from: event")));
  EXPECT_NEAR(run.history.at(born_at, "momentum_z:block"), -mass * speed, 1e-9);
  EXPECT_GT(run.history.last("momentum_z:block"), 0.6 * mass * speed);
  // It comes as deep as it is at the event, but for the step of that and what springs of the penalty method give way.
  const double deepest = speed * (born_at - 1e-3), more = GetParam().find("penalty") == std::string::npos ? 0 : 5e-3;
  EXPECT_LE(run.history.smallest("foot_z"), -deepest * (1 - 1e-9));
  EXPECT_GE(run.history.smallest("foot_z"), -deepest - 3 * speed * step - more);
  EXPECT_LT(run.history.largest("kinetic"), 0.5 * mass * speed * speed * (1 + 1e-9));
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
  EXPECT_EQ(warns(run, "no_contact"), GetParam().find("surfaces: none") != std::string::npos);
}

TEST_P(Switched, ThatHasEndedBeforeLetsItPass) {
  const Outcome run = run_deck(make_falling(make("until: event")), {"sensors.event.time=5e-4"});
  EXPECT_NEAR(run.history.last("momentum_z:block"), -mass * speed, 1e-9);
  EXPECT_TRUE(warns(run, "no_contact"));
}

TEST_P(Switched, ThatNeverBeginsIsTold) {
  const Outcome run = run_deck(make_falling(make("from: event")), {"sensors.event.time=1"});
  EXPECT_NEAR(run.history.last("momentum_z:block"), -mass * speed, 1e-9);
  EXPECT_TRUE(warns(run, "no_contact"));
}

TEST_P(Switched, CarriesWeightUntilItsEvent) {
  const std::string gravity = "loads: {gravity: [0, 0, -10]}\n";
  const Outcome run = run_deck(make_block(0, gravity + make("until: event")));
  const double after = born_at + 2 * step, fall = run.summary.time - after;
  EXPECT_NEAR(run.history.last("momentum_z:block") - run.history.at(after, "momentum_z:block"), -mass * 10 * fall,
              1e-6 * mass * 10 * fall);
  EXPECT_GT(run.history.at(born_at, "momentum_z:block"), -0.5 * mass * 10 * born_at);  // it was carried until then
}

TEST_P(SwitchedPair, BeginsAgainWhereAnotherEntryOfTheSameSurfacesSaysSo) {
  const std::string gravity = "loads: {gravity: [0, 0, -10]}\n";
  const std::string deck = make_block(0, gravity + make("until: event}, {a: block, b: plate, from: another"));
  const Outcome run = run_deck(deck);
  const double off = born_at + 2 * step, on = 3.5e-3;
  EXPECT_NEAR(run.history.at(on, "momentum_z:block") - run.history.at(off, "momentum_z:block"), -mass * 10 * (on - off),
              1e-6);
  EXPECT_GT(run.history.last("momentum_z:block"), run.history.at(on, "momentum_z:block"));
}

TEST_P(Switched, PushesOutWhatOverlapsAtItsEvent) {
  const std::string deck = make_block(-5e-3, make("from: event", "overlap: push_out"));
  const Outcome run = run_deck(deck, {"time.end=0.025"});
  EXPECT_EQ(run.history.at(born_at, "foot_z"), -5e-3);
  // By a thousandth of the overlap in each step, so that it leaves about as fast.
  EXPECT_GT(run.history.at(born_at + 250 * step, "foot_z"), -5e-3);
  EXPECT_LT(run.history.at(born_at + 250 * step, "foot_z"), 0);
  EXPECT_GT(run.history.last("foot_z"), 0);
  // Springs give back what pressed them: a body that such a ground pushes leaves at twice its speed, and swings.
  const double swing = GetParam().find("penalty") == std::string::npos ? 2 : 2.5;
  EXPECT_LT(run.history.largest("momentum_z:block"), swing * mass * 5e-6 / step);
}

TEST_P(Switched, RefusesOverlapAtItsEventWhereTheDeckDoes) {
  try {
    run_deck(make_falling(make("from: event", "overlap: refuse")));
    FAIL() << "the run went on";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), HasSubstr("as contact begins"));
  }
}

}  // namespace percuss::test::switched_contact_test
