// Mass scaling against its exact answers: a bar with one short element.

#include "src/step/mass/mass_scaling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

constexpr double density = 7850;

/// A bar of five cubes of edge 1, the last of which is cut to a quarter, and a cube apart.
struct BarScene {
  explicit BarScene(const std::string& bar, const std::string& rest = "")
      : deck(parse_deck("time: {end: 1}\nparts:\n  bar: {box: {size: [5, 1, 1], cells: [5, 1, 1]}, material: steel" +
                            bar +
                            "}\n  cube: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [9, 0, 0], material: steel}\n" +
                            rest + steel_text,
                        "deck.yaml")),
        chunked(shorten(load_mesh(deck, Communicator::world()))),
        model(build_model(deck, chunked)),
        contact(chunked, deck, Communicator::world()),
        state(make_initial_state(model)),
        stepper(deck, chunked, model, contact) {}

  static ChunkedMesh shorten(ChunkedMesh chunked) {
    for (Vec3& node : chunked.mesh.nodes) {
      if (node[0] == 5) node[0] = 4.25;
    }
    return chunked;
  }

  /// Mass of the bar's short element.
  double find_short_mass() const {
    double least = INFINITY, most = 0;
    for (int e = 0; e < 6; ++e) {
      const double mass = model.element_mass(static_cast<std::size_t>(e));
      if (std::abs(mass / density - 1) < 1e-12) continue;  // a cube's own
      least = std::min(least, mass);
      most = std::max(most, mass);
    }
    EXPECT_EQ(least, most);  // there is one
    return most;
  }

  Deck deck;
  ChunkedMesh chunked;
  Model model;
  ContactStage contact;
  State state;
  Stepper stepper;
};

double find_first_bound(const std::string& bar) {
  BarScene scene(bar);
  scene.stepper.start(scene.state);
  return scene.state.bound.step;
}

}  // namespace

TEST(MassScaling, AShortElementGetsTheMassThatItsBoundLacks) {
  const double bound = find_first_bound("");
  const double wanted = 1.5 * bound;
  BarScene scene(fmt::format(", mass_scaling: {{step: {:.17g}, max_added: 0.1}}", wanted));
  scene.stepper.start(scene.state);
  EXPECT_NEAR(scene.state.bound.step / wanted, 1, 1e-13);
  EXPECT_NEAR(scene.find_short_mass() / (0.25 * density * 1.5 * 1.5), 1, 1e-13);
  EXPECT_NEAR(scene.model.total_mass / (density * (5.25 + 0.25 * 1.25)), 1, 1e-13);
  ASSERT_EQ(scene.model.added_masses.size(), 1U);
  const AddedMass& added = scene.model.added_masses[0];
  EXPECT_EQ(added.part, "bar");
  EXPECT_EQ(added.scaled, 1);
  EXPECT_EQ(added.elements, 5);
  EXPECT_NEAR(added.mass / (4.25 * density), 1, 1e-13);
  EXPECT_NEAR(added.added / (0.25 * 1.25 * density), 1, 1e-13);
  EXPECT_DOUBLE_EQ(added.least_bound, bound);
}

TEST(MassScaling, AddedMassFallsAndMovesLikeAnyOther) {
  const double wanted = 1.5 * find_first_bound("");
  BarScene scene(fmt::format(", mass_scaling: {{step: {:.17g}, max_added: 0.1}}", wanted),
                 "loads: {gravity: [0, 0, -10]}\ninitial: [{velocity: [3, 0, 0]}]\n");
  scene.stepper.start(scene.state);
  for (int i = 0; i < 100; ++i) scene.stepper.advance(scene.state);
  const double t = scene.state.time - 0.5 * scene.state.dt;
  for (int n = 0; n < scene.model.node_count; ++n) {
    EXPECT_NEAR(scene.state.v(static_cast<std::size_t>(n), 0), 3, 1e-12);
    EXPECT_NEAR(scene.state.v(static_cast<std::size_t>(n), 2), -10 * t, 1e-11);
  }
}

TEST(MassScaling, AStepBelowEveryBoundAddsNothing) {
  BarScene plain(""), scene(fmt::format(", mass_scaling: {{step: {:.17g}}}", 0.99 * find_first_bound("")));
  EXPECT_EQ(scene.model.total_mass, plain.model.total_mass);
  EXPECT_EQ(scene.model.added_masses.at(0).scaled, 0);
}

TEST(MassScaling, APartOfShellsBesideChangesNothing) {
  const std::string scaled =
      fmt::format(", mass_scaling: {{step: {:.17g}, max_added: 0.1}}", 1.5 * find_first_bound(""));
  const BarScene alone(scaled);
  BarScene beside(scaled,
                  "  sheet: {shell_plate: {size: [1, 1], cells: [2, 2]}, thickness: 0.01, at: [0, 9, 0], material: "
                  "steel}\n");
  ASSERT_EQ(beside.model.added_masses.size(), 1U);
  EXPECT_EQ(beside.model.added_masses[0].added, alone.model.added_masses[0].added);
  EXPECT_EQ(beside.model.added_masses[0].least_bound, alone.model.added_masses[0].least_bound);
  beside.stepper.start(beside.state);
  beside.stepper.advance(beside.state);
  EXPECT_GT(beside.state.time, 0);
}

TEST(MassScaling, ShellsGetMassAndRotaryInertiaAlike) {
  const auto find_deck = [](const std::string& scaling) {
    return parse_deck(
        "time: {end: 1}\nparts: {sheet: {shell_plate: {size: [2, 1], cells: [4, 3]}, thickness: 0.05, "
        "reference: bottom, material: steel" +
            scaling + "}}\n" + steel_text,
        "deck.yaml");
  };
  const auto start = [&](const std::string& scaling) {
    auto scene = std::make_unique<Scene>(find_deck(scaling));
    scene->stepper.start(scene->state);
    return scene;
  };
  const auto plain = start("");
  const double wanted = 1.2 * plain->state.bound.step;
  const auto scaled = start(fmt::format(", mass_scaling: {{step: {:.17g}, max_added: 0.5}}", wanted));
  EXPECT_NEAR(scaled->state.bound.step / wanted, 1, 1e-13);
  EXPECT_NEAR(scaled->model.total_mass / plain->model.total_mass, 1.44, 1e-13);
  for (std::size_t n = 0; n < 20; ++n) {
    EXPECT_NEAR(scaled->model.mass(n) / plain->model.mass(n), 1.44, 1e-12);
    EXPECT_NEAR(scaled->model.inertia(n) / plain->model.inertia(n), 1.44, 1e-12);
  }
  ASSERT_EQ(scaled->model.added_masses.size(), 1U);
  EXPECT_EQ(scaled->model.added_masses[0].scaled, 12);
  EXPECT_NEAR(scaled->model.added_masses[0].least_bound / plain->state.bound.step, 1, 1e-13);
}

TEST(MassScaling, MoreThanTheLimitIsRefusedWithItsPlace) {
  const double wanted = 3 * find_first_bound("");
  try {
    BarScene scene(fmt::format(", mass_scaling: {{step: {:.17g}}}", wanted));
    FAIL() << "no refusal";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr("deck.yaml:3:"), testing::HasSubstr("part 'bar'"),
                               testing::HasSubstr("max_added = 0.05"), testing::HasSubstr("5 of its 5 elements")));
  }
}

TEST(MassScaling, OfTheWholeSceneActsOnEveryPart) {
  const double bound = find_first_bound("");
  const Deck deck = parse_deck(
      fmt::format("time: {{end: 1, max_steps: 3, mass_scaling: {{step: {:.17g}, max_added: 9}}}}\n", 5 * bound) +
          "parts: {a: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: steel}}\n" + steel_text,
      "deck.yaml");
  const Summary summary = run_scene(deck, {}).summary;
  EXPECT_NEAR(summary.dt.max / (0.9 * 5 * bound), 1, 1e-9);
  EXPECT_GT(summary.mass.added, 0);
  EXPECT_NEAR(summary.mass.share, summary.mass.added / density, 1e-12);
}

}  // namespace percuss::test
