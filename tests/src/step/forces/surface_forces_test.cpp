// Forces on named surfaces: their sums against those of parts, and what lies flat on one of them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/step/forces/force_scenes.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

constexpr std::array<const char*, 6> sides{"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};

/// Forces on each side of the parts a and b from the whole other one, and from all.
std::string list_side_forces() {
  std::string forces;
  for (const char* side : sides)
    forces += fmt::format(
        "      - {{name: a_{0}, contact: [a/{0}, b]}}\n      - {{name: b_{0}, contact: [b/{0}, a]}}\n"
        "      - {{name: all_{0}, contact: [a/{0}, all]}}\n",
        side);
  return forces;
}

std::string make_sides(const std::string& enforcement) { return make_collision(enforcement) + list_side_forces(); }

/// Boxes of which each has an edge towards the other, crossed.
const std::string crossed_edges = R"(
time: {end: 1}
parts:
  a: {box: {size: [2, 1, 1], cells: [6, 3, 3]}, rotate: [{axis: x, angle: 45}], at: [-1, 0, 0], material: m}
  b: {box: {size: [1, 2, 1], cells: [3, 6, 3]}, rotate: [{axis: y, angle: 45}], at: [-0.7071, -1, 1.4152], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.3}}
initial: [{part: b, velocity: [0.1, 0.2, -1]}]
contact: {friction: 0.1}
output:
  history:
    forces:
      - {name: ab, contact: [a, b]}
      - {name: ba_origin, contact: [b, a]}
      - {name: a_all, contact: [a, all]}
)" + list_side_forces();

/// What the sides get adds up to what the part gets, in each column that adds up.
void expect_sums_of_sides(const std::map<std::string, double>& impulses, const std::string& prefix,
                          const std::string& part) {
  for (const char* column : {"fx:", "fy:", "fz:", "mx:", "my:", "mz:", "normal:", "tangential:"}) {
    double sum = 0, scale = 0;
    for (const char* side : sides) {
      const double of_side = impulses.at(column + prefix + side);
      sum += of_side;
      scale += std::abs(of_side);
    }
    EXPECT_NEAR(sum, impulses.at(column + part), 1e-15 * 6 * scale) << column << prefix;
  }
}

}  // namespace

TEST(SurfaceForces, SurfacesOfAPartAddUpToIt) {
  for (const char* enforcement : {"kinematic", "penalty", "lagrange"}) {
    Scene scene(make_sides(enforcement));
    scene.run(60);
    const auto j = take_impulses(scene, 0);
    EXPECT_LT(j.at("fx:a_x_max"), -0.05) << enforcement;
    EXPECT_EQ(j.at("fx:a_y_min"), 0) << enforcement;
    EXPECT_EQ(j.at("fx:all_x_min"), j.at("fx:wall")) << enforcement;
    expect_sums_of_sides(j, "a_", "ab");
    expect_sums_of_sides(j, "b_", "ba_origin");
    expect_sums_of_sides(j, "all_", "a_all");
  }
}

TEST(SurfaceForces, EdgesThatCrossCountForTheirFaces) {
  Scene scene(crossed_edges);
  scene.run(30);
  const auto j = take_impulses(scene, 0);
  EXPECT_LT(j.at("fz:ab"), -0.05);
  expect_sums_of_sides(j, "a_", "ab");
  expect_sums_of_sides(j, "b_", "ba_origin");
  // The upper edge of a is that of two of its faces, which get all but what comes past the ends of the edges.
  EXPECT_NEAR(j.at("fz:a_y_max") + j.at("fz:a_z_max"), j.at("fz:ab"), 0.01 * std::abs(j.at("fz:ab")));
}

TEST(SurfaceForces, SurfacesUnderABlockPressedFlatCarryAllOfIt) {
  std::string deck = make_flat("0.3", equal_base);
  const std::string more = R"(, {name: foot, contact: [top/z_min, base]}, {name: side, contact: [top/x_min, all]},
  {name: faces, contact: [top/z_min, base/z_max]}, {name: none, contact: [top/z_min, [base/x_min, base/z_min]]},
  {name: half, contact: [{name: top/z_min, inside: [[0, 0, 1], [0.4, 1, 1.1]]}, base]},
  {name: rest, contact: [{name: top/z_min, inside: [[0.4, 0, 1], [1, 1, 1.1]]}, base]},
  {name: box, contact: [base, {inside: [[0, 0, 1], [1, 1, 1.002]]}]})";
  deck.insert(deck.find("]}}\n", deck.find("forces")), more);
  double force = 0;
  const auto mean = press_flat(deck, force);
  for (const char* name : {"foot", "faces"}) {
    EXPECT_NEAR(mean.at(std::string("fz:") + name), force, 1e-11 * force) << name;
    EXPECT_NEAR(mean.at(std::string("area:") + name), 0.24, 1e-9 * 0.24) << name;
    EXPECT_NEAR(mean.at(std::string("pressure:") + name), force / 0.24, 1e-7 * force / 0.24) << name;
  }
  for (const char* name : {"side", "none"}) {
    for (const char* column : {"fx:", "fz:", "my:", "normal:", "area:", "pressure:"})
      EXPECT_EQ(mean.at(std::string(column) + name), 0) << column << name;
  }
  // A node between both halves counts for one of them: by areas of nodes, a third or two thirds of the foot.
  EXPECT_NEAR(mean.at("fz:half") + mean.at("fz:rest"), force, 1e-11 * force);
  EXPECT_GT(mean.at("fz:half"), 0.3 * force);
  EXPECT_GT(mean.at("fz:rest"), 0.1 * force);
  EXPECT_NEAR(mean.at("fz:box"), mean.at("fz:base"), 1e-11 * force);
}

TEST(SurfaceForces, SurfacesOfTiedPartsCarryWhatTheTieDoes) {
  Scene scene(R"(
time: {end: 1}
parts:
  a: {box: {size: [1, 1, 1], cells: [3, 3, 3]}, material: m}
  b: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [0, 0, 1], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.3}}
initial: [{part: b, velocity: [0.1, 0.2, 1]}]
contact: {surfaces: none, ties: [{a: a/z_max, b: b/z_min}]}
output:
  history:
    forces:
      - {name: parts, contact: [b, a]}
      - {name: faces, contact: [b/z_min, a/z_max]}
      - {name: back, contact: [a/z_max, b/z_min]}
      - {name: side, contact: [b/x_min, a]}
)");
  scene.run(40);
  const auto j = take_impulses(scene, 0);
  EXPECT_LT(j.at("fz:parts"), -0.1);
  for (const char kind : {'f', 'm'}) {
    const Vec3 of_parts = find_vector(j, kind, "parts");
    EXPECT_EQ(find_vector(j, kind, "faces"), of_parts);
    expect_near(find_vector(j, kind, "back"), {-of_parts[0], -of_parts[1], -of_parts[2]}, 1e-14);
    EXPECT_EQ(find_vector(j, kind, "side"), Vec3{});
  }
}

TEST(SurfaceForces, AreTheSameBitsOnAnyRanks) {
  for (const std::string& deck : {make_sides("kinematic"), make_sides("penalty"), crossed_edges}) {
    Scene together(deck), alone(deck, Communicator(MPI_COMM_SELF));
    together.run(60);
    alone.run(60);
    EXPECT_EQ(take_values(together), take_values(alone));
  }
}

TEST(SurfaceForces, GoOnAfterARestart) {
  const SharedFolder whole, parts;
  const auto run = [&](const std::string& time, const std::string& more, const std::string& folder,
                       const std::string& restart) {
    std::string text = make_sides("kinematic");
    text.replace(text.find("time: {end: 1}"), 14, "time: " + time);
    text.replace(text.find("  history:\n"), 11, more + "  history:\n    every: 0.05\n");
    RunOptions options;
    options.out_dir = folder;
    options.restart = restart;
    options.goes_on_in_place = !restart.empty();
    return run_scene(parse_deck(text, "deck.yaml"), options).summary;
  };
  EXPECT_GT(run("{end: 0.4}", "", whole.path(), "").steps, 40);
  run("{end: 0.4, max_steps: 32}", "  checkpoint: {every: 0.17}\n", parts.path(), "");
  run("{end: 0.4}", "", parts.path(), parts.path() + "/checkpoint_previous.h5");
  if (Communicator::world().rank() != 0) return;
  EXPECT_TRUE(read_file(parts.path() + "/history.csv") == read_file(whole.path() + "/history.csv"));
}

TEST(SurfaceForces, DoNotChangeTheMotion) {
  Scene with(make_sides("kinematic")), without(make_collision("kinematic"));
  with.run(60);
  without.run(60);
  EXPECT_EQ(sum_rows(with.state.v), sum_rows(without.state.v));
  EXPECT_EQ(find_largest(with.state.x), find_largest(without.state.x));
}

TEST(SurfaceForces, RefuseWhatIsNoSurface) {
  const auto make = [](const std::string& sides) {
    std::string text = make_collision("kinematic");
    return text + "      - {name: f, contact: " + sides + "}\n";
  };
  EXPECT_NO_THROW(Scene(make("[a/x_max, b]")));
  EXPECT_ERROR(Scene(make("[a/x_mox, b]")), InputError, "'x_mox'");
  EXPECT_ERROR(Scene(make("[{name: a/x_max, inside: [[5, 5, 5], [6, 6, 6]]}, b]")), InputError, "has no");
}

}  // namespace percuss::test
