// Rigid walls that end, that move by a curve, and that bodies push: against exact answers.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/error.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/step/two_scenes.hpp"

namespace percuss::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double density = 7850, modulus = 200e9, length = 0.1, width = 0.005, area = width * width;
constexpr double bar_mass = density * area * length;
const double wave_speed = std::sqrt(modulus / density);

/// A bar along x of material without cross contraction: its waves are plain. It begins `gap` before x = 0 ...
std::string write_bar(double speed, const std::string& wall, double gap = 1e-6) {
  return fmt::format(R"yaml(
time: {{end: 1, max_step: 2e-7}}
parts: {{bar: {{box: {{size: [{0}, {1}, {1}], cells: [80, 2, 2]}}, at: [{2:.17g}, 0, 0], material: bar}}}}
materials: {{bar: {{model: elastic, density: {3}, youngs_modulus: {4}, poissons_ratio: 0}}}}
elements: {{bulk_viscosity: {{linear: 0, quadratic: 0}}}}
initial: [{{velocity: [{5:.17g}, 0, 0]}}]
walls: [{{normal: x, {6}}}]
)yaml",
                     length, width, gap, density, modulus, speed, wall);
}

struct Motion {
  double momentum = 0, kinetic = 0, wall_displacement = 0, wall_speed = 0, external = 0, contact = 0;
};

/// Momentum and velocities at n+1/2 along x, and what the walls did.
Motion find_motion(const Scene& scene) {
  Motion motion;
  const auto mass = to_host(scene.state.mass);
  const auto v = to_host(scene.state.v);
  for (std::size_t n = 0; n < mass.extent(0); ++n) {
    motion.momentum += mass(n) * v(n, 0);
    motion.kinetic += 0.5 * mass(n) * (v(n, 0) * v(n, 0) + v(n, 1) * v(n, 1) + v(n, 2) * v(n, 2));
  }
  const std::vector<double> wall = scene.contact.list_wall_motions();
  if (!wall.empty()) {
    motion.wall_displacement = wall[0];
    motion.wall_speed = wall[1];
  }
  motion.external = ExactSum(scene.state.books.external_work).round();
  motion.contact = scene.state.books.contact_work;
  return motion;
}

Communicator alone() { return Communicator(MPI_COMM_SELF); }

}  // namespace

// Galileo: seen from the wall nothing differs, but for the round-off of places.
TEST(MovingWall, AtConstantSpeedActsAsAWallAtRestOnABarThatIsSlowerByThat) {
  Scene moving(write_bar(-7, "speed: 3"), alone()), resting(write_bar(-10, "friction: 0"), alone());
  moving.run(300);
  resting.run(300);
  ASSERT_EQ(moving.state.time, resting.state.time);
  double largest = 0;
  for (std::size_t n = 0; n < moving.chunked.mesh.nodes.size(); ++n)
    largest = std::max(largest, std::abs(moving.state.x(n, 0) - 3 * moving.state.time - resting.state.x(n, 0)));
  EXPECT_LT(largest, 1e-9 * length);
  EXPECT_GT(find_motion(resting).momentum, 9 * bar_mass);  // it has bounced
  EXPECT_NEAR(find_motion(moving).wall_displacement, 3 * moving.state.time, 1e-15);
}

// An elastic bar bounces off a wall at speed w as v -> 2 w - v, and the wall's work is w times the momentum it gave.
TEST(MovingWall, GivesTheWorkOfItsImpulse) {
  Scene scene(write_bar(-7, "speed: 3"), alone());
  scene.run(0);
  const Motion before = find_motion(scene);
  for (int i = 0; i < 300; ++i) scene.stepper.advance(scene.state);
  const Motion after = find_motion(scene);
  EXPECT_NEAR(after.momentum, bar_mass * 13, 0.02 * bar_mass * 13);
  EXPECT_NEAR(after.external, 3 * (after.momentum - before.momentum), 1e-10 * after.external);
  // Contact itself only loses: what half a row of elements brings along when it meets the wall, or some of that again.
  const double met = 0.5 * (bar_mass / 160) * 10 * 10;
  EXPECT_LT(after.contact, 0);
  EXPECT_GT(after.contact, -2 * met);
}

TEST(MovingWall, FollowsItsCurveExactly) {
  // x = 1e5 t^2: the middle of a step gives the exact way of a speed that is linear in time.
  Scene scene(write_bar(0, "speed: {table: [[0, 0], [1, 2e5]]}", 1), alone());
  scene.run(100);
  EXPECT_NEAR(find_motion(scene).wall_displacement, 1e5 * std::pow(scene.state.time, 2), 1e-13);
}

// A bar that hits a mass: until the wave is back from its far end, M dw/dt = -rho c A (v + w) away from the bar.
TEST(WallWithAMass, TakesWhatABarLoses) {
  const double mass = 2 * bar_mass, speed = 10, impedance = std::sqrt(density * modulus) * area;
  Scene scene(write_bar(-speed, fmt::format("mass: {:.17g}, start_speed: 2", mass)), alone());
  scene.run(0);
  const double sum = find_motion(scene).momentum + mass * 2;
  double began = -1;
  for (int i = 0; i < 300; ++i) {
    scene.stepper.advance(scene.state);
    const Motion now = find_motion(scene);
    ASSERT_NEAR(now.momentum + mass * now.wall_speed, sum, 1e-13 * mass * speed) << i;
    ASSERT_EQ(now.external, 0) << i;  // what it gives is its own
    ASSERT_NEAR(scene.contact.find_wall_energy(), 0.5 * mass * now.wall_speed * now.wall_speed,
                1e-12 * mass * speed * speed);
    if (began < 0 && now.wall_speed < 2) began = scene.state.time;
    const double since = scene.state.time - began;
    if (began < 0 || since > 1.8 * length / wave_speed) continue;
    const double exact = -speed + (speed + 2) * std::exp(-impedance * since / mass);
    ASSERT_NEAR(now.wall_speed, exact, 0.02 * (speed + 2)) << i;
  }
  EXPECT_LT(find_motion(scene).wall_speed, -3);
}

// Lighter than the nodes that meet it: these move on, and it goes with them or ahead, never faster than what hit it.
TEST(WallWithAMass, MayBeMuchLighterThanNodes) {
  const double mass = 1e-4 * bar_mass;
  Scene scene(write_bar(-10, fmt::format("mass: {:.17g}", mass)), alone());
  scene.run(0);
  const double sum = find_motion(scene).momentum;
  for (int i = 0; i < 100; ++i) {
    scene.stepper.advance(scene.state);
    const Motion now = find_motion(scene);
    ASSERT_NEAR(now.momentum + mass * now.wall_speed, sum, 1e-12 * std::abs(sum));
    ASSERT_GT(now.wall_speed, -10.5);
  }
  EXPECT_LT(find_motion(scene).wall_speed, -9.5);
}

namespace {

/// A sheet of shells on a fixed wall, and one with a mass [kg] that comes down on it at 5 m/s.
std::string write_press(const char* mass) {
  return fmt::format(R"yaml(
time: {{end: 1, max_step: 5e-7}}
parts: {{sheet: {{shell_plate: {{size: [0.02, 0.02], cells: [4, 4]}}, thickness: 0.001, material: steel}}}}
walls: [{{normal: z}}, {{name: ram, normal: -z, point: [0, 0, 1e-6], mass: {}, start_speed: 5}}]
)yaml",
                     mass) +
         steel_text;
}

}  // namespace

// Nodes that meet two walls cannot go along with either: no push fulfils both rows.
TEST(WallWithAMass, IsNeverThrownBackByNodesThatCannotGiveWay) {
  for (const char* mass : {"1e-6", "1e-2", "1"}) {
    Scene scene(write_press(mass), alone());
    EXPECT_THAT([&] { scene.run(20); },
                ThrowsMessage<RunError>(AllOf(HasSubstr("wall 'ram' would be thrown back"), HasSubstr("rigid part"))))
        << mass;
  }
  Scene on_all_ranks(write_press("1"));
  EXPECT_ERROR(on_all_ranks.run(20), RunError, "would be thrown back");
  Scene heavy(write_press("100"), alone());
  heavy.run(20);
  EXPECT_LE(std::abs(find_motion(heavy).wall_speed), 5);
  EXPECT_LT(find_motion(heavy).wall_speed, 0);  // stopped and let go
}

namespace {

/// Two cubes that fall on a plane at z = 0, of which `wall` says where it ends.
std::string write_cubes(const std::string& wall) {
  return R"yaml(
time: {end: 1, max_step: 5e-7}
parts:
  here: {box: {size: [0.02, 0.02, 0.02], cells: [3, 3, 3]}, at: [0, 0, 1e-5], material: steel}
  there: {box: {size: [0.02, 0.02, 0.02], cells: [3, 3, 3]}, at: [0.05, 0, 1e-5], material: steel}
initial: [{velocity: [0, 0, -20]}]
walls: [{normal: z)yaml" +
         wall + "}]" + steel_text;
}

/// Mean velocity along z of the nodes that began on one side of x = 0.04.
double find_fall(const Scene& scene, bool is_there) {
  double sum = 0;
  int count = 0;
  for (std::size_t n = 0; n < scene.chunked.mesh.nodes.size(); ++n) {
    if ((scene.chunked.mesh.nodes[n][0] > 0.04) != is_there) continue;
    sum += scene.state.v(n, 2);
    ++count;
  }
  return sum / count;
}

}  // namespace

TEST(RectangularWall, StopsWhatMeetsItAndLetsPassWhatDoesNot) {
  Scene ends(write_cubes(", point: [-0.002, -0.002, 0], rectangle: {along: x, size: [0.03, 0.024]}"), alone()),
      endless(write_cubes(""), alone());
  ends.run(100);
  endless.run(100);
  EXPECT_EQ(find_fall(ends, false), find_fall(endless, false));
  EXPECT_GT(find_fall(ends, false), 0);
  EXPECT_NEAR(find_fall(ends, true), -20, 1e-12);
}

TEST(RectangularWall, DoesNotTakeUpWhatHasPassedIt) {
  // The second cube falls past the wall and then moves below it.
  const std::string deck = write_cubes(", point: [0, 0, 0], rectangle: {along: [1, 0, 5], size: [0.03, 0.02]}");
  std::string sideways = deck;
  sideways.replace(sideways.find("[{velocity: [0, 0, -20]}]"), 25, "[{part: there, velocity: [-500, 0, -1200]}]");
  Scene scene(sideways, alone());
  EXPECT_EQ(scene.contact.prepare(scene.state.x, scene.state.v), "");
  scene.run(160);
  EXPECT_NEAR(find_fall(scene, true), -1200, 1e-9);
}

// All kinds at once, in contact with each other and with friction.
TEST(MovingWall, HasTheBitsOfOneRank) {
  TwoScenes scenes(R"yaml(
time: {end: 1}
parts:
  low: {box: {size: [0.06, 0.05, 0.02], cells: [9, 8, 3]}, at: [0, 0, 1e-6], material: steel}
  high: {box: {size: [0.03, 0.03, 0.03], cells: [5, 5, 5]}, at: [0.013, 0.011, 0.02003], material: steel}
initial: [{velocity: [5, 3, -40]}, {part: high, velocity: [-3, 8, -100]}]
walls:
  - {normal: z, point: [-0.1, 0.021, 0], rectangle: {along: x, size: [1, 1]}, mass: 0.2, start_speed: 3, friction: 0.3}
  - {normal: y, point: [0, -1e-5, 0], speed: {expression: "20 * sin(1e5 * t)"}}
  - {normal: -z, point: [0, 0, 0.0503], mass: 1e-4, start_speed: 300, friction: 0.1}
contact: {surfaces: all, friction: 0.2}
)yaml" + steel_text);
  scenes.run(120);
  expect_same_rows(scenes, scenes.together.state.x, scenes.alone.state.x, "position");
  EXPECT_EQ(hash_state(scenes.together.model, scenes.together.state),
            hash_state(scenes.alone.model, scenes.alone.state));
  const std::vector<double> walls = scenes.together.contact.list_wall_motions();
  EXPECT_EQ(walls, scenes.alone.contact.list_wall_motions());
  ASSERT_EQ(walls.size(), 6u);
  EXPECT_LT(walls[1], 3);  // pushed
}

}  // namespace percuss::test
