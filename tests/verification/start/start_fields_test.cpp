// Stresses and velocities of files at time 0: a static solution stays at rest, a velocity is that of its nodes.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "tests/verification/support/deck_folder.hpp"

namespace percuss::test::start_fields_test {
namespace {

using testing::HasSubstr;

constexpr double young = 200e9, density = 7850, gravity = 1e4;
constexpr int elements = 20;

/// A bar of 1 m that hangs from its upper end.
std::string hang(const std::string& more, const std::string& material = "elastic") {
  return fmt::format(R"yaml(
time: {{end: 2e-3}}
parts: {{bar: {{box: {{size: [0.1, 0.1, 1.0], cells: [1, 1, {}]}}, material: steel{}}}}}
materials: {{steel: {{model: {}, density: {}, youngs_modulus: {}, poissons_ratio: 0}}}}
conditions: [{{nodes: bar/z_max, fixed: [x, y, z]}}]
loads: {{gravity: [0, 0, -{}]}}
output: {{history: {{every: 1e-5, nodes: [{{name: tip, near: [0, 0, 0]}}]}}}}
)yaml",
                     elements, more, material, density, young, gravity) +
         "start: {fields: [{file: s.csv}]}\n";
}

constexpr const char* heading = "element,stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx";

/// The stress that carries the weight below the middle of each element: the exact one of lumped masses.
std::string hang_stresses() {
  std::string text = fmt::format("# a static solution\n{}\n", heading);
  for (int e = elements; e > 0; --e)
    text += fmt::format("{}, 0, 0, {}, 0, 0, 0\n", e, density * gravity * (e - 0.5) / elements);
  return text;
}

void expect_rest(const Outcome& run) {
  const double stretch = density * gravity / (2 * young);  // that the weight gives a bar without stress
  const std::vector<double>& z = run.history["tip_z"];
  for (const double at : z) ASSERT_NEAR(at, z[0], 1e-10 * stretch);
  double energy = 0;
  for (int e = 0; e < elements; ++e)
    energy += std::pow(density * gravity * (e + 0.5) / elements, 2) / (2 * young) * 0.01 / elements;
  EXPECT_NEAR(run.history["internal"][0], energy, 1e-9 * energy);
  EXPECT_NEAR(run.history["internal"].back(), energy, 1e-9 * energy);
  EXPECT_NEAR(run.summary.energy.initial, energy, 1e-9 * energy);
  EXPECT_LT(run.history.largest("kinetic"), 1e-18 * energy);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
}

}  // namespace

TEST(StartFields, ABarWithTheStressOfItsWeightStaysAtRest) {
  const DeckFolder scene;
  scene.add("s.csv", hang_stresses());
  expect_rest(scene.run(hang("")));
  expect_rest(scene.run(hang(", integration: full")));
}

TEST(StartFields, ABarThatHasYieldedStaysAtRest) {
  const DeckFolder scene;
  std::string text = hang_stresses();
  const std::string with_strain = std::string(heading) + ",equivalent_plastic_strain";
  text.replace(text.find(heading), std::string(heading).size(), with_strain);
  std::string rows = text.substr(0, text.find(with_strain) + with_strain.size() + 1);
  for (int e = 1; e <= elements; ++e)
    rows += fmt::format("{},0,0,{},0,0,0,0.01\n", e, density * gravity * (e - 0.5) / elements);
  scene.add("s.csv", rows);
  // Yield stress 60 MPa + 0.01 x 2 GPa = 80 MPa, above the largest stress, 76.5 MPa; without the strain it would yield.
  std::string deck = hang("", "j2_plasticity, yield_stress: 60e6, hardening_modulus: 2e9");
  deck.replace(deck.find("nodes: [{name: tip"), 0, "elements: [{name: top, near: [0.05, 0.05, 0.975]}], ");
  const Outcome run = scene.run(deck);
  expect_rest(run);
  EXPECT_EQ(run.history["top_eps"].back(), 0.01);
}

TEST(StartFields, AByteOrderMarkIsSkipped) {
  const DeckFolder scene;
  scene.add("s.csv", "\xEF\xBB\xBF" + hang_stresses());
  expect_rest(scene.run(hang("")));
}

TEST(StartFields, APipeAndATableThatIsTooLongAreRefused) {
  const DeckFolder scene;
  ASSERT_EQ(mkfifo(scene.path("s.csv").c_str(), 0600), 0);
  EXPECT_THAT(scene.find_error(hang("")), HasSubstr("s.csv: error: the table is a pipe (a regular file is needed)"));
  std::filesystem::remove(scene.path("s.csv"));
  scene.add("s.csv", "");
  std::filesystem::resize_file(scene.path("s.csv"), std::uintmax_t{1} << 31);  // without blocks on the disk
  EXPECT_THAT(scene.find_error(hang("")),
              HasSubstr("s.csv: error: the table has 2147483648 bytes (at most 2147483647)"));
}

TEST(StartFields, AVelocityIsThatOfItsNodes) {
  const DeckFolder scene;
  scene.add("v.csv", "node,velocity_x,velocity_y,velocity_z\n1,2,3,4\n8,-1,0,0\n");
  const Outcome run = scene.run(R"yaml(
time: {end: 1e-6}
parts: {cube: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: steel}}
materials: {steel: {model: elastic, density: 8, youngs_modulus: 1e9, poissons_ratio: 0}}
initial: [{part: cube, velocity: [1, 0, 0]}]
start: {fields: [{file: v.csv, part: cube}]}
output: {history: {every: 0}}
)yaml");
  EXPECT_NEAR(run.history["momentum_x"][0], 6 * 1 + 2 - 1, 1e-14);  // mass 1 a node
  EXPECT_NEAR(run.history["momentum_y"][0], 3, 1e-14);
  EXPECT_NEAR(run.history["kinetic"][0], 0.5 * (6 + 4 + 9 + 16 + 1), 1e-13);
}

TEST(StartFields, AWrongFileIsRefusedWithItsLine) {
  const DeckFolder scene;
  const auto refuse = [&](const std::string& rows, const std::string& line, const std::string& text) {
    scene.add("s.csv", rows);
    EXPECT_THAT(scene.find_error(hang("")), HasSubstr("s.csv:" + line + ": error: " + text));
  };
  const std::string top = std::string(heading) + "\n";
  refuse("element,xx\n1,2\n", "1", "the heading is neither 'node,velocity_x,velocity_y,velocity_z' nor 'element'");
  refuse("element,layer\n1,2\n", "1", "the heading is neither");
  refuse("element,temperature,temperature\n1,2,3\n", "1", "the heading is neither");
  refuse("element,temperatures\n1,2\n", "1", "the heading is neither");
  refuse(top + "1,0,0,0,0,0\n", "2", "the row has 6 numbers (must be 7, as the heading)");
  refuse(top + "1,0,0,0,0,0,nan\n", "2", "number 7 of the row must be");
  refuse(top + "0,0,0,0,0,0,0\n", "2", "the id is not a positive integer");
  refuse(top + "1,0,0,0,0,0,0\n\n1,0,0,0,0,0,0\n", "4", "element 1 is there twice (first in line 2)");
  refuse(top + "99,0,0,0,0,0,0\n", "2", "there is no element 99 in the mesh");
  refuse("element,layer,temperature\n1,0,0\n", "2", "the layer is not a positive integer");
  refuse("element,layer,temperature\n1,2,0\n1,1,0\n1,2,0\n", "4", "element 1 is there twice with layer 2");
  refuse("element,equivalent_plastic_strain,temperature\n1,-1,0\n", "2", "the equivalent plastic strain is negative");
  refuse(top, "2", "there are no rows");
}

TEST(StartFields, ElementsThatCannotHaveAStressAreRefused) {
  const DeckFolder scene;
  scene.add("s.csv", std::string(heading) + "\n3,0,0,1,0,0,0\n");
  EXPECT_THAT(scene.find_error(hang("", "neo_hookean")),
              HasSubstr("s.csv:2: error: element 3 is of material 'steel' (whose stress does not grow in increments)"));
  std::string rigid = hang(", rigid: true");
  rigid.erase(rigid.find("conditions:"), rigid.find("loads:") - rigid.find("conditions:"));
  EXPECT_THAT(scene.find_error(rigid), HasSubstr("element 3 is rigid and has no stress"));
  scene.add("s.csv", "element,temperature\n3,300\n");
  EXPECT_THAT(scene.find_error(rigid), HasSubstr("s.csv:2: error: element 3 is rigid and has no temperature"));
  scene.add("s.csv", "element,equivalent_plastic_strain,temperature\n3,0,300\n");
  EXPECT_THAT(scene.find_error(rigid), HasSubstr("element 3 is rigid and has no plastic strain"));
  scene.add("s.csv", std::string(heading) + ",equivalent_plastic_strain\n3,0,0,1,0,0,0,0.1\n");
  EXPECT_THAT(scene.find_error(hang("")), HasSubstr("element 3 has a plastic strain (its material has none)"));
  scene.add("s.csv", "element,temperature\n3,300\n");
  EXPECT_THAT(scene.find_error(hang("")), HasSubstr("element 3 has a temperature (its material has none)"));
  scene.add("s.csv", std::string("element,layer") + std::string(heading).substr(7) + "\n3,1,0,0,1,0,0,0\n");
  EXPECT_THAT(scene.find_error(hang("")), HasSubstr("element 3 is no shell and has no layers"));
}

namespace {

/// A plate of shells in a plane that is along no axis of space; by default it is free and flies nowhere.
std::string plate(const std::string& more, const std::string& material, const std::string& rest) {
  return fmt::format(R"yaml(
time: {{end: 1e-3}}
parts:
  plate:
    shell_plate: {{size: [1.0, 0.1], cells: [20, 2]}}
    rotate: [{{axis: [1, 2, 3], angle: 40}}]
    thickness: 0.01
    material: steel
{}
materials: {{steel: {{model: {}, density: {}, youngs_modulus: {}, poissons_ratio: 0}}}}
start: {{fields: [{{file: s.csv}}]}}
{}
)yaml",
                     more, material, density, young, rest);
}

/// The stress s along the plate's x in axes of space, by Rodrigues' formula.
std::array<double, 6> turn_stress(double s) {
  const double root = std::sqrt(14), c = std::cos(40 * std::numbers::pi / 180),
               sine = std::sin(40 * std::numbers::pi / 180);
  const double k[3] = {1 / root, 2 / root, 3 / root};
  // c e + sin k x e + (1 - c) (k . e) k of the first axis e
  const double x[3] = {c + (1 - c) * k[0] * k[0], sine * k[2] + (1 - c) * k[0] * k[1],
                       -sine * k[1] + (1 - c) * k[0] * k[2]};
  return {s * x[0] * x[0], s * x[1] * x[1], s * x[2] * x[2], s * x[0] * x[1], s * x[1] * x[2], s * x[2] * x[0]};
}

std::string join(const std::array<double, 6>& s) {
  return fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}", s[0], s[1], s[2], s[3], s[4], s[5]);
}

constexpr const char* held_ends = R"yaml(conditions:
  - {nodes: plate/x_min, fixed: [x, y, z, rx, ry, rz]}
  - {nodes: plate/x_max, fixed: [x, y, z, rx, ry, rz]}
output: {history: {every: 1e-5, elements: [{name: one, id: 7}]}})yaml";

/// At rest with this energy from beginning to end.
void expect_held(const Outcome& run, double energy) {
  EXPECT_NEAR(run.history["internal"][0], energy, 1e-9 * energy);
  EXPECT_NEAR(run.history["internal"].back(), energy, 1e-9 * energy);
  EXPECT_LT(run.history.largest("kinetic"), 1e-18 * energy);
}

}  // namespace

// Between two ends that hold it, a stretched plate is at rest, and so is one that is bent by a constant moment.
TEST(StartFields, APlateThatIsStretchedOrBentStaysAtRest) {
  const DeckFolder scene;
  const double s = 80e6, volume = 0.1 * 0.01;
  std::string stretched = std::string(heading) + "\n";
  std::string bent = std::string("element,layer") + std::string(heading).substr(7) + "\n";
  for (int e = 1; e <= 40; ++e) {
    stretched += fmt::format("{},{}\n", e, join(turn_stress(s)));
    // Points of Gauss' rule at -z, 0, z with z^2 = 3/5 and weights 5/18, 8/18, 5/18; the middle has no stress.
    for (const int side : {1, -1})
      bent += fmt::format("{},{},{}\n", e, side + 2, join(turn_stress(side * std::sqrt(0.6) * s)));
  }
  scene.add("s.csv", stretched);
  expect_held(scene.run(plate("", "elastic", held_ends)), volume * s * s / (2 * young));
  scene.add("s.csv", bent);
  const Outcome run = scene.run(plate("    points: 3", "elastic", held_ends));
  expect_held(run, volume * s * s / (6 * young));
}

TEST(StartFields, AShellHasTheStressOfItsFile) {
  const DeckFolder scene;
  // In the plane of the plate and across it: a turned stress without a part normal to the surface.
  scene.add("s.csv", std::string(heading) + ",equivalent_plastic_strain\n7," + join(turn_stress(50e6)) + ",0.02\n");
  const Outcome run = scene.run(plate("", "j2_plasticity, yield_stress: 40e6, hardening_modulus: 2e9", held_ends));
  EXPECT_NEAR(run.history["one_eps"][0], 0.02, 1e-16);  // the mean of all layers
  EXPECT_NEAR(run.history["one_von_mises"][0], 50e6, 1e-9 * 50e6);
  const std::array<double, 6> s = turn_stress(50e6);
  const char* const names[] = {"xx", "yy", "zz", "xy", "yz", "zx"};
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(run.history[std::string("one_stress_") + names[k]][0], s[k], 1e-9 * 50e6) << names[k];
}

TEST(StartFields, ShellsRefuseLayersAndStressesThatTheyDoNotHave) {
  const DeckFolder scene;
  scene.add("s.csv", std::string("element,layer") + std::string(heading).substr(7) + "\n7,4,0,0,0,0,0,0\n");
  EXPECT_THAT(scene.find_error(plate("    points: 3", "elastic", held_ends)),
              HasSubstr("s.csv:2: error: element 7 has no layer 4 (it has 3)"));
  scene.add("s.csv", std::string(heading) + "\n7,0,0,1e6,0,0,0\n");
  EXPECT_THAT(scene.find_error(plate("", "elastic", held_ends)), HasSubstr("across its surface (shells have none)"));
}

// A hot bar yields at A (1 - t^m), with t = (400 - 300) / (800 - 300) and m = 1: at 80 of 100 MPa. The law's own start
// temperature is that of the room. Without heat and hardening the stress stays there.
TEST(StartFields, AHotBodyYieldsAtItsTemperature) {
  const DeckFolder scene;
  scene.add("s.csv", "element,temperature\n1,400\n");
  const std::string law =
      "johnson_cook, a: 100e6, b: 0, n: 1, melt_temperature: 800, room_temperature: 300, start_temperature: 300, "
      "specific_heat: 500, heating_share: 0";
  const std::string shapes[] = {"box: {size: [1, 1, 1], cells: [1, 1, 1]}",
                                "shell_plate: {size: [1, 1], cells: [1, 1]}, thickness: 0.1"};
  for (const std::string& shape : shapes) {
    const Outcome run = scene.run(fmt::format(R"yaml(
time: {{end: 1e-2}}
parts: {{cube: {{{}, material: steel}}}}
materials: {{steel: {{model: {}, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}}}}
conditions: [{{nodes: cube/x_min, velocity: {{x: 0}}}}, {{nodes: cube/x_max, velocity: {{x: 0.2}}}}]
start: {{fields: [{{file: s.csv, part: cube}}]}}
output: {{history: {{every: 1e-4, elements: [{{name: one, id: 1}}]}}}}
)yaml",
                                              shape, law));
    EXPECT_NEAR(run.history["one_temperature"][0], 400, 1e-12);  // the mean of all points
    EXPECT_NEAR(run.history["one_temperature"].back(), 400, 1e-12);
    // Waves across are left by the sudden start; plastic flow has them die out.
    EXPECT_NEAR(run.history.mean(5e-3, 1e-2, "one_von_mises"), 80e6, 1e-3 * 80e6) << shape;
  }
}

// A temperature from a table as one from the deck: below melt_temperature, and with an equation of state 70 above
// absolute_zero.
TEST(StartFields, ATemperatureAtWhichItsLawMayNotStartIsRefused) {
  const DeckFolder scene;
  const std::string law =
      "johnson_cook, a: 100e6, b: 0, n: 1, melt_temperature: 800, room_temperature: 300, start_temperature: 300, "
      "specific_heat: 500";
  const std::string state = ", equation_of_state: {kind: mie_grueneisen, sound_speed: 4000, slope: 1.5, grueneisen: 2}";
  const auto find_error = [&](double temperature, const std::string& more) {
    scene.add("s.csv", fmt::format("element,temperature\n2,300\n3,{}\n", temperature));
    return scene.find_error(hang("", law + more));
  };
  const std::string start = "s.csv:3: error: element 3 begins with the temperature ";
  EXPECT_THAT(find_error(800, ""), HasSubstr(start + "800, which gives its material 'steel' a melt_temperature that is "
                                                     "not above its start_temperature"));
  EXPECT_EQ(find_error(799, ""), "");
  EXPECT_EQ(find_error(-5, ""), "");
  EXPECT_THAT(find_error(900, state), HasSubstr("900, which gives its material 'steel' a melt_temperature"));
  EXPECT_THAT(find_error(70, state), HasSubstr(start + "70, which gives its material 'steel' a start_temperature less "
                                                       "than 70 above its absolute_zero"));
  EXPECT_EQ(find_error(71, state), "");
}

TEST(StartFields, ABeamTakesNothingFromFiles) {
  const DeckFolder scene;
  const std::string deck = R"yaml(
time: {end: 1e-5}
parts: {bar: {line: {from: [0, 0, 0], to: [1, 0, 0], cells: 2}, section: {round: {radius: 0.1}}, material: steel}}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
start: {fields: [{file: s.csv}]}
)yaml";
  scene.add("s.csv", "element,temperature\n1,300\n");
  EXPECT_THAT(scene.find_error(deck), HasSubstr("element 1 is a beam (beams take no temperature from files)"));
  scene.add("s.csv", std::string(heading) + "\n1,1,0,0,0,0,0\n");
  EXPECT_THAT(scene.find_error(deck), HasSubstr("element 1 is a beam (beams take no stress from files)"));
}

TEST(StartFields, AnElementHasAStressFromOneFileOnly) {
  const DeckFolder scene;
  scene.add("s.csv", std::string(heading) + "\n2,0,0,1,0,0,0\n3,0,0,1,0,0,0\n");
  std::string twice = hang("");
  const std::string once = "{file: s.csv";
  ASSERT_NE(twice.find(once), std::string::npos) << twice;
  twice.insert(twice.find(once), "{file: s.csv}, ");
  EXPECT_THAT(scene.find_error(twice), HasSubstr("s.csv:2: error: element 2 has a stress from another file"));
}

}  // namespace percuss::test::start_fields_test
