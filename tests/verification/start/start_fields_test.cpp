// Stresses and velocities of files at time 0: a static solution stays at rest, a velocity is that of its nodes.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

using testing::HasSubstr;

constexpr double young = 200e9, density = 7850, gravity = 1e4;
constexpr int elements = 20;

/// A deck in a folder beside its tables.
class FieldsScene {
 public:
  void add_file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() + "/" + name) << text;
  }
  std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
  Outcome run(const std::string& text) const { return run_deck(parse_deck(text, folder_.path() + "/deck.yaml", {})); }
  std::string find_error(const std::string& text) const {
    try {
      run(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  TemporaryFolder folder_;
};

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
  const FieldsScene scene;
  scene.add_file("s.csv", hang_stresses());
  expect_rest(scene.run(hang("")));
  expect_rest(scene.run(hang(", integration: full")));
}

TEST(StartFields, ABarThatHasYieldedStaysAtRest) {
  const FieldsScene scene;
  std::string text = hang_stresses();
  const std::string with_strain = std::string(heading) + ",equivalent_plastic_strain";
  text.replace(text.find(heading), std::string(heading).size(), with_strain);
  std::string rows = text.substr(0, text.find(with_strain) + with_strain.size() + 1);
  for (int e = 1; e <= elements; ++e)
    rows += fmt::format("{},0,0,{},0,0,0,0.01\n", e, density * gravity * (e - 0.5) / elements);
  scene.add_file("s.csv", rows);
  // Yield stress 60 MPa + 0.01 x 2 GPa = 80 MPa, above the largest stress, 76.5 MPa; without the strain it would yield.
  std::string deck = hang("", "j2_plasticity, yield_stress: 60e6, hardening_modulus: 2e9");
  deck.replace(deck.find("nodes: [{name: tip"), 0, "elements: [{name: top, near: [0.05, 0.05, 0.975]}], ");
  const Outcome run = scene.run(deck);
  expect_rest(run);
  EXPECT_EQ(run.history["top_eps"].back(), 0.01);
}

TEST(StartFields, AByteOrderMarkIsSkipped) {
  const FieldsScene scene;
  scene.add_file("s.csv", "\xEF\xBB\xBF" + hang_stresses());
  expect_rest(scene.run(hang("")));
}

TEST(StartFields, APipeAndATableThatIsTooLongAreRefused) {
  const FieldsScene scene;
  ASSERT_EQ(mkfifo(scene.path("s.csv").c_str(), 0600), 0);
  EXPECT_THAT(scene.find_error(hang("")), HasSubstr("s.csv: error: the table is a pipe (a regular file is needed)"));
  std::filesystem::remove(scene.path("s.csv"));
  scene.add_file("s.csv", "");
  std::filesystem::resize_file(scene.path("s.csv"), std::uintmax_t{1} << 31);  // without blocks on the disk
  EXPECT_THAT(scene.find_error(hang("")),
              HasSubstr("s.csv: error: the table has 2147483648 bytes (must have less than 2 GiB)"));
}

TEST(StartFields, AVelocityIsThatOfItsNodes) {
  const FieldsScene scene;
  scene.add_file("v.csv", "node,velocity_x,velocity_y,velocity_z\n1,2,3,4\n8,-1,0,0\n");
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
  const FieldsScene scene;
  const auto refuse = [&](const std::string& rows, const std::string& line, const std::string& text) {
    scene.add_file("s.csv", rows);
    EXPECT_THAT(scene.find_error(hang("")), HasSubstr("s.csv:" + line + ": error: " + text));
  };
  const std::string top = std::string(heading) + "\n";
  refuse("element,xx\n1,2\n", "1", "the heading is not one of");
  refuse(top + "1,0,0,0,0,0\n", "2", "the row has 6 numbers (must be 7, as the heading)");
  refuse(top + "1,0,0,0,0,0,nan\n", "2", "number 7 of the row must be");
  refuse(top + "0,0,0,0,0,0,0\n", "2", "the id is not a positive integer");
  refuse(top + "1,0,0,0,0,0,0\n\n1,0,0,0,0,0,0\n", "4", "element 1 is there twice (first in line 2)");
  refuse(top + "99,0,0,0,0,0,0\n", "2", "there is no element 99 in the mesh");
  refuse(top, "2", "there are no rows");
}

TEST(StartFields, ElementsThatCannotHaveAStressAreRefused) {
  const FieldsScene scene;
  scene.add_file("s.csv", std::string(heading) + "\n3,0,0,1,0,0,0\n");
  EXPECT_THAT(scene.find_error(hang("", "neo_hookean")),
              HasSubstr("s.csv:2: error: element 3 is of material 'steel' (whose stress does not grow in increments)"));
  std::string rigid = hang(", rigid: true");
  rigid.erase(rigid.find("conditions:"), rigid.find("loads:") - rigid.find("conditions:"));
  EXPECT_THAT(scene.find_error(rigid), HasSubstr("element 3 is rigid and has no stress"));
  scene.add_file("s.csv", std::string(heading) + ",equivalent_plastic_strain\n3,0,0,1,0,0,0,0.1\n");
  EXPECT_THAT(scene.find_error(hang("")), HasSubstr("element 3 has a plastic strain (its material has none)"));
}

TEST(StartFields, AnElementHasAStressFromOneFileOnly) {
  const FieldsScene scene;
  scene.add_file("s.csv", std::string(heading) + "\n2,0,0,1,0,0,0\n3,0,0,1,0,0,0\n");
  std::string twice = hang("");
  const std::string once = "{file: s.csv";
  ASSERT_NE(twice.find(once), std::string::npos) << twice;
  twice.insert(twice.find(once), "{file: s.csv}, ");
  EXPECT_THAT(scene.find_error(twice), HasSubstr("s.csv:2: error: element 2 has a stress from another file"));
}

}  // namespace percuss::test
