// Forces of the history against the momentum that they change, exact waves and Coulomb's law; on any ranks, over a
// restart.

#include "src/step/forces/force_books.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/step/forces/force_scenes.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
TEST(ForceBooks, ContactIsTheMomentumExchanged) {
  for (const char* enforcement : {"kinematic", "penalty", "lagrange"}) {
    Scene scene(make_collision(enforcement));
    scene.stepper.start(scene.state);
    const auto is_b = [](const Vec3& x) { return x[0] > 1.015; };
    const auto is_a = [](const Vec3& x) { return x[0] > 0.005 && x[0] < 1.015 && x[1] < 2; };
    const Vec3 a_before = sum_momentum(scene, is_a), b_before = sum_momentum(scene, is_b);
    for (int i = 0; i < 60; ++i) scene.stepper.advance(scene.state);
    const auto j = take_impulses(scene, 0);
    const double scale = std::abs(b_before[0]);
    const Vec3 ab = find_vector(j, 'f', "ab"), wall = find_vector(j, 'f', "wall");
    EXPECT_LT(ab[0], -0.05 * scale) << enforcement;
    EXPECT_GT(wall[0], 0.01 * scale) << enforcement;
    expect_near(find_vector(j, 'f', "ba"), {-ab[0], -ab[1], -ab[2]}, 1e-14 * scale);
    expect_near(find_vector(j, 'f', "a_all"), minus(ab, {-wall[0], -wall[1], -wall[2]}), 1e-13 * scale);
    expect_near(find_vector(j, 'f', "both"), wall, 1e-13 * scale);
    expect_near(minus(sum_momentum(scene, is_b), b_before), {-ab[0], -ab[1], -ab[2]}, 1e-12 * scale);
    expect_near(minus(sum_momentum(scene, is_a), a_before), find_vector(j, 'f', "a_all"), 1e-12 * scale);
    expect_near(find_vector(j, 'f', "ca"), {}, 0);
    // Moments: opposite about one point; about another they differ by the force on the way between.
    const Vec3 m_ab = find_vector(j, 'm', "ab"), m = find_vector(j, 'm', "ba"), o = find_vector(j, 'm', "ba_origin");
    expect_near(o, {-m_ab[0], -m_ab[1], -m_ab[2]}, 1e-13 * scale);
    const Vec3 f = find_vector(j, 'f', "ba");
    expect_near(minus(o, m), {2 * f[2] - 3 * f[1], 3 * f[0] - 1 * f[2], 1 * f[1] - 2 * f[0]}, 1e-13 * scale);
    EXPECT_GE(j.at("normal:ab"), std::abs(ab[0]));
    EXPECT_LE(j.at("tangential:ab"), 0.2 * j.at("normal:ab") * (1 + 1e-12));
    EXPECT_GT(j.at("tangential:ab"), 0);
  }
}

/// A bar and a sheet whose ends are held.
const char* const clamped = R"(
time: {end: 1}
parts:
  bar: {box: {size: [4, 1, 1], cells: [60, 3, 3]}, material: m}
  sheet: {shell_plate: {size: [4, 1], cells: [16, 4]}, thickness: 0.1, at: [0, 3, 0], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.3}}
initial: [{part: bar, velocity: [1, 0.2, -0.1]}, {part: sheet, velocity: [0, 0.3, -0.4]}]
conditions: [{nodes: bar/x_min, fixed: [x, y, z]}, {nodes: sheet/x_min, fixed: [x, y, z, rx, ry, rz]}]
output:
  history:
    forces:
      - {name: foot, support: bar}
      - {name: cut, section: {part: bar, point: [1.7, 0, 0], normal: x}, about: [0, 0, 0]}
      - {name: back, section: {part: bar, point: [1.7, 0, 0], normal: -x}, about: [0, 0, 0]}
      - {name: on_nodes, section: {part: bar, point: [2, 0, 0], normal: x}}
      - {name: clamp, support: {name: sheet/x_min}}
      - {name: fold, section: {part: sheet, point: [2.1, 0, 0], normal: [1, 0, 0]}}
)";

TEST(ForceBooks, SectionsAndSupportsBalanceWhatLiesBetween) {
  Scene scene(clamped);
  scene.stepper.start(scene.state);
  const auto is_bar_behind = [](const Vec3& x) { return x[1] < 2 && x[0] < 1.7; };
  const auto is_bar_ahead = [](const Vec3& x) { return x[1] < 2 && x[0] > 1.7; };
  const auto is_sheet_behind = [](const Vec3& x) { return x[1] > 2 && x[0] < 2.1; };
  // Held nodes lose their speed in start(), which is no step.
  const Vec3 behind = sum_momentum(scene, is_bar_behind), ahead = sum_momentum(scene, is_bar_ahead),
             sheet = sum_momentum(scene, is_sheet_behind);
  for (int i = 0; i < 80; ++i) scene.stepper.advance(scene.state);
  const auto j = take_impulses(scene, 0);
  const Vec3 cut = find_vector(j, 'f', "cut"), foot = find_vector(j, 'f', "foot");
  const double scale = std::abs(ahead[0]);
  EXPECT_GT(cut[0], 0.02 * scale);  // the bar is stretched
  expect_near(minus(sum_momentum(scene, is_bar_ahead), ahead), {-cut[0], -cut[1], -cut[2]}, 1e-12 * scale);
  const Vec3 gained = minus(sum_momentum(scene, is_bar_behind), behind);
  expect_near(gained, minus(cut, {-foot[0], -foot[1], -foot[2]}), 1e-12 * scale);
  expect_near(find_vector(j, 'f', "back"), {-cut[0], -cut[1], -cut[2]}, 1e-13 * scale);
  const Vec3 moment = find_vector(j, 'm', "cut");
  expect_near(find_vector(j, 'm', "back"), {-moment[0], -moment[1], -moment[2]}, 1e-12 * scale);
  const Vec3 fold = find_vector(j, 'f', "fold"), clamp = find_vector(j, 'f', "clamp");
  expect_near(minus(sum_momentum(scene, is_sheet_behind), sheet), minus(fold, {-clamp[0], -clamp[1], -clamp[2]}),
              1e-12 * scale);
  EXPECT_NE(find_vector(j, 'm', "clamp")[1], 0);
}

TEST(ForceBooks, SectionOfABarThatMeetsAWallCarriesTheWavesForce) {
  // Uniaxial strain by symmetry: the wave carries rho c v, with c^2 = M / rho.
  Scene scene(R"(
time: {end: 1}
parts: {bar: {box: {size: [4, 0.1, 0.1], cells: [400, 1, 1]}, material: m}}
materials: {m: {model: elastic, density: 4, youngs_modulus: 100, poissons_ratio: 0}}
initial: [{part: bar, velocity: [-0.01, 0, 0]}]
walls: [{name: stop, point: [0, 0, 0], normal: x}]
output: {history: {forces: [{name: cut, section: {point: [1, 0, 0], normal: x}}, {name: stop, wall: stop}]}}
)");
  scene.stepper.start(scene.state);
  const double c = 5, exact = 4 * c * 0.01 * 0.01;  // rho c v A
  const auto run_to = [&](double time) {
    while (scene.state.time < time) scene.stepper.advance(scene.state);
  };
  run_to(1.2 / c);  // the wave has passed the section
  double since = scene.state.time;
  take_values(scene);
  run_to(3.5 / c);
  const auto j = take_impulses(scene, since);
  EXPECT_NEAR(j.at("fx:cut"), -exact * (scene.state.time - since), 0.01 * exact * (scene.state.time - since));
  EXPECT_NEAR(j.at("fx:stop"), exact * (scene.state.time - since), 0.01 * exact * (scene.state.time - since));
  // The foot is flat on the wall all the time; the viscous pressure of the front has widened it by 2e-5.
  EXPECT_NEAR(j.at("area:stop"), 0.01 * (scene.state.time - since), 1e-4 * j.at("area:stop"));
  EXPECT_NEAR(j.at("pressure:stop") * 0.01, j.at("normal:stop"), 1e-4 * j.at("normal:stop"));
  EXPECT_NEAR(j.at("my:cut"), -exact * 0.05 * (scene.state.time - since), 1e-3 * exact * (scene.state.time - since));
}

TEST(ForceBooks, AreaAndPressureOfABlockPressedFlat) {
  for (const char* friction : {"0", "0.3"}) {
    double force = 0;
    const auto mean = press_flat(make_flat(friction, equal_base), force);
    const double area = 0.6 * 0.4;
    EXPECT_NEAR(mean.at("fz:top"), force, 1e-11 * force) << friction;
    for (const std::string side : {"top", "base"}) {
      EXPECT_NEAR(mean.at("area:" + side), area, 1e-9 * area) << friction << side;
      EXPECT_NEAR(mean.at("pressure:" + side), force / area, 1e-7 * force / area) << friction << side;
    }
  }
}

TEST(ForceBooks, AreaOnAWiderFaceIsThatOfItsNodesThatArePushed) {
  double force = 0;
  const auto mean = press_flat(make_flat("0", wide_base), force);
  EXPECT_NEAR(mean.at("area:top"), 0.6 * 0.4, 1e-4 * 0.6 * 0.4);
  EXPECT_NEAR(mean.at("area:base"), 0.8 * 0.6, 1e-3 * 0.8 * 0.6);  // half a face farther on each side
  EXPECT_GT(mean.at("pressure:top"), force / (0.6 * 0.4));         // it is larger at the edge of the block
}

TEST(ForceBooks, ImpulsesAreExactWhereTheStepChanges) {
  // A held block weighs m g = 24 all the time. Velocities are half a step before their rows: the impulse of the rows is
  // that of the time between the velocities, and the mean is the force times this over the time between the rows.
  Scene scene(R"(
time: {end: 1000}
parts: {block: {box: {size: [1, 2, 3], cells: [1, 2, 3]}, material: m}, ball: {sphere: {radius: 0.4, cells: 4}, at: [0.5, 1, 3.5], material: m}}
materials: {m: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25}}
initial: [{part: ball, velocity: [0.1, 0, -3]}]
conditions: [{nodes: block, fixed: [x, y, z]}]
loads: {gravity: [0, 0, -2]}
contact: {friction: 0.3}
output: {history: {forces: [{name: foot, support: block}, {name: hit, contact: [ball, block]}]}}
)");
  scene.stepper.start(scene.state);
  const auto is_ball = [](const Vec3& x) { return x[2] > 3.05; };
  const double weight = 2 * (scene.model.total_mass - 12);  // of the ball
  double since = 0, middle_before = 0, hit = 0;
  Vec3 before = sum_momentum(scene, is_ball);
  for (int row = 0; row < 8; ++row) {
    for (int i = 0; i < 5; ++i) {
      scene.state.next_dt = 0.001 * (1 + (2 * row + i) % 4);
      scene.stepper.advance(scene.state);
    }
    const auto j = take_impulses(scene, since);
    since = scene.state.time;
    const double middle = since - 0.5 * scene.state.dt, interval = middle - std::exchange(middle_before, middle);
    const Vec3 after = sum_momentum(scene, is_ball);
    EXPECT_NEAR(j.at("fz:foot") - j.at("fz:hit"), 24 * interval, 1e-12);
    EXPECT_NEAR(j.at("fz:hit"), after[2] - before[2] + weight * interval, 1e-13);
    EXPECT_NEAR(j.at("fx:hit"), after[0] - before[0], 1e-13);
    hit += j.at("fz:hit");
    before = after;
  }
  EXPECT_GT(hit, 0.1);
}

/// A rigid plate at rest, hit by a ball askew, and a rigid block that is driven along z and may turn.
const char* const rigid_supports = R"(
time: {end: 1}
parts:
  plate: {box: {size: [2, 2, 0.5], cells: [4, 4, 1]}, material: m, rigid: {fixed: [x, y, z, rx, ry, rz]}}
  ball: {sphere: {radius: 0.4, cells: 4}, at: [1.3, 0.8, 0.95], material: m}
  block: {box: {size: [1, 2, 3], cells: [1, 2, 3]}, at: [9, 0, 0], material: m, rigid: true}
materials: {m: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25}}
initial: [{part: ball, velocity: [0.5, 0, -3]}]
conditions: [{body: block, velocity: {z: {table: [[0, 0], [1, 7]]}}}]
contact: {friction: 0.3}
output:
  history:
    forces:
      - {name: foot, support: plate}
      - {name: hit, contact: [plate, ball]}
      - {name: lift, support: block, about: [0, 0, 0]}
      - {name: both, support: all}
)";

TEST(ForceBooks, SupportOfARigidBodyIsWhatHoldsIt) {
  Scene scene(rigid_supports);
  scene.stepper.start(scene.state);
  while (scene.state.time < 0.1) scene.stepper.advance(scene.state);
  const auto j = take_impulses(scene, 0);
  const Vec3 hit = find_vector(j, 'f', "hit"), foot = find_vector(j, 'f', "foot"), lift = find_vector(j, 'f', "lift");
  EXPECT_LT(hit[2], -0.1);
  EXPECT_GT(std::abs(hit[0]), 0.01);
  expect_near(foot, {-hit[0], -hit[1], -hit[2]}, 1e-13 * std::abs(hit[2]));  // it stays at rest
  const Vec3 m_hit = find_vector(j, 'm', "hit"), m_foot = find_vector(j, 'm', "foot");
  expect_near(m_foot, {-m_hit[0], -m_hit[1], -m_hit[2]}, 1e-12 * std::abs(m_hit[0]));
  // The block of mass 12 has the velocity 7 t at the middle of the step, and its centre is at (9.5, 1).
  const double lifted = 12 * 7 * (scene.state.time - 0.5 * scene.state.dt);
  expect_near(lift, {0, 0, lifted}, 1e-12 * lifted);
  expect_near(find_vector(j, 'm', "lift"), {lifted, -9.5 * lifted, 0}, 1e-11 * lifted);
  const Vec3 both = find_vector(j, 'f', "both");
  expect_near(both, minus(foot, {-lift[0], -lift[1], -lift[2]}), 1e-12 * lifted);
}

TEST(ForceBooks, AreTheSameBitsOnAnyRanks) {
  for (const std::string& deck :
       {make_collision("kinematic"), make_flat("0.3", wide_base), std::string(clamped), std::string(rigid_supports)}) {
    Scene together(deck), alone(deck, Communicator(MPI_COMM_SELF));
    together.run(60);
    alone.run(60);
    EXPECT_EQ(take_values(together), take_values(alone));
  }
}

TEST(ForceBooks, GoOnAfterARestart) {
  const std::string deck =
      make_collision("kinematic") + "      - {name: cut, section: {point: [0.5, 0, 0], normal: x}}\n";
  const std::string bounds = "time: {end: 1}\n";
  const auto with_time = [&](const std::string& time, const std::string& more) {
    std::string text = deck;
    text.replace(text.find(bounds), bounds.size(), "time: " + time + "\n");
    text.replace(text.find("  history:\n"), 11, more + "  history:\n    every: 0.05\n");
    return text;
  };
  const SharedFolder whole, parts;
  const auto run = [&](const std::string& text, const std::string& folder, const std::string& restart) {
    RunOptions options;
    options.out_dir = folder;
    options.restart = restart;
    options.goes_on_in_place = !restart.empty();
    return run_scene(parse_deck(text, "deck.yaml"), options).summary;
  };
  const Summary expected = run(with_time("{end: 0.4}", ""), whole.path(), "");
  EXPECT_GT(expected.steps, 40);
  // A checkpoint between two rows.
  run(with_time("{end: 0.4, max_steps: 32}", "  checkpoint: {every: 0.17}\n"), parts.path(), "");
  run(with_time("{end: 0.4}", ""), parts.path(), parts.path() + "/checkpoint_previous.h5");
  if (Communicator::world().rank() != 0) return;
  EXPECT_TRUE(read_file(parts.path() + "/history.csv") == read_file(whole.path() + "/history.csv"));
}

TEST(ForceBooks, MayBeOthersAfterARestart) {
  // The checkpoint has all but one of the forces, in another order.
  const SharedFolder folder;
  const auto run = [&](const std::string& text, const std::string& out, const std::string& restart) {
    RunOptions options;
    options.out_dir = out;
    options.restart = restart;
    return run_scene(parse_deck(text, "deck.yaml"), options).summary;
  };
  const std::string fold = "      - {name: fold, section: {part: sheet, point: [2.1, 0, 0], normal: [1, 0, 0]}}\n",
                    foot = "      - {name: foot, support: bar}\n";
  const auto make = [&](const std::string& forces, const std::string& time, const std::string& every) {
    std::string text = clamped;
    text = text.substr(0, text.find("output:"));
    text.replace(text.find("time: {end: 1}"), 14, "time: " + time);
    return text + "output:\n  checkpoint: {every: 0.1}\n  history:\n    every: " + every + "\n    forces:\n" + forces;
  };
  const std::string out[] = {folder.path() + "/whole", folder.path() + "/first", folder.path() + "/later"};
  if (Communicator::world().rank() == 0)
    for (const std::string& path : out) std::filesystem::create_directory(path);
  Communicator::world().barrier();
  run(make(fold + foot, "{end: 1, max_steps: 60}", "0.15"), out[0], "");
  run(make(foot, "{end: 1, max_steps: 40}", "0.15"), out[1], "");
  run(make(fold + foot, "{end: 1, max_steps: 60}", "0.15"), out[2], out[1] + "/checkpoint_previous.h5");
  if (Communicator::world().rank() != 0) return;
  const HistoryTable whole(out[0] + "/history.csv"), later(out[2] + "/history.csv");
  ASSERT_GE(later.rows(), 2u);
  for (const char* column : {"fx:foot", "my:foot"}) {
    for (std::size_t i = 1; i <= later.rows(); ++i)
      EXPECT_EQ(later[column][later.rows() - i], whole[column][whole.rows() - i]) << column << ", row " << i;
  }
  // The other is a mean since the restart in its first row, and the same from then on.
  EXPECT_NE(later["fz:fold"][0], whole["fz:fold"][whole.rows() - later.rows()]);
  EXPECT_EQ(later.last("fz:fold"), whole.last("fz:fold"));
}

TEST(ForceBooks, RefuseSupportsAndSectionsOfNothing) {
  const auto make = [](const std::string& force) {
    return R"(
time: {end: 1}
parts: {a: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.3}}
conditions: [{nodes: a/x_min, fixed: [x]}]
output: {history: {forces: [)" +
           force + "]}}\n";
  };
  EXPECT_NO_THROW(Scene(make("{name: f, support: a/x_min}")));
  EXPECT_ERROR(Scene(make("{name: f, support: a/x_max}")), InputError, "of a support where no condition holds a node");
  EXPECT_NO_THROW(Scene(make("{name: f, section: {point: [0.5, 0, 0], normal: x}}")));
  for (const char* x : {"-0.1", "1.1", "0"}) {
    EXPECT_ERROR(Scene(make(std::string("{name: f, section: {point: [") + x + ", 0, 0], normal: x}}")), InputError,
                 "that cuts no element")
        << x;
  }
}

}  // namespace percuss::test
