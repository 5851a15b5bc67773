// Fields of shells at the points across their thickness, of a plate that is bent by its edges.

#include "src/step/results/fields/element_fields.hpp"

#include <gmock/gmock.h>

#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

using ::testing::DoubleNear;
using ::testing::Each;

constexpr double youngs_modulus = 200e9, poissons_ratio = 0.25, thickness = 0.1, rate = 2;  // rad/s of each edge
constexpr std::size_t elements = 4;

// Its edges turn against each other about y, and no node moves or turns otherwise; beside it a block at rest.
const std::string bent_plate = R"yaml(
time: {end: 1, max_step: 1.0e-6}
parts:
  plate: {shell_plate: {size: [1, 1], cells: [1, 4]}, thickness: 0.1, points: 5, material: steel}
  thin: {shell_plate: {size: [1, 1], cells: [1, 1]}, at: [0, 5, 0], thickness: 0.1, points: 2, material: steel}
  block: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [0, 10, 0], material: steel}
conditions:
  - {nodes: plate, fixed: [x, y, z, rx, rz]}
  - {nodes: plate/x_min, velocity: {ry: -2}}
  - {nodes: plate/x_max, velocity: {ry: 2}}
)yaml";

std::string with_steel(const std::string& model) {
  return bent_plate + "materials: {steel: {density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.25, " + model +
         "}}\n";
}

/// Stress along x of the elements of the bent plate.
std::vector<double> find_bending_stresses(const Scene& scene, int point) {
  const std::vector<double> rows = find_point_stresses(scene.model, scene.state, point);
  std::vector<double> out;
  for (std::size_t e = 0; e < elements; ++e) out.push_back(rows[6 * e]);
  return out;
}

// sigma_x = E / (1 - nu^2) z kappa, with kappa the angle between the edges over their distance.
TEST(ElementFields, OfAnElasticPlateAreLinearAcrossItsThickness) {
  Scene scene(with_steel("model: elastic"));
  scene.run(5);
  const double curvature = 2 * rate * scene.state.time;
  const ThicknessPoints rule = find_thickness_points(5);
  for (int p = 0; p < rule.count; ++p) {
    const double z = 0.5 * thickness * rule.place[p];
    const double expected = youngs_modulus / (1 - poissons_ratio * poissons_ratio) * z * curvature;
    const double largest = 0.5 * thickness * youngs_modulus * curvature;
    for (const double stress : find_bending_stresses(scene, p)) EXPECT_NEAR(stress, expected, 1e-6 * largest) << p;
  }
  EXPECT_EQ(find_bending_stresses(scene, ShellPoint::highest), find_bending_stresses(scene, 4));
  EXPECT_EQ(find_bending_stresses(scene, ShellPoint::lowest), find_bending_stresses(scene, 0));
}

TEST(ElementFields, AreZeroAtPointsThatAShellDoesNotHave) {
  Scene scene(with_steel("model: elastic"));
  scene.run(5);
  EXPECT_THAT(find_point_stresses(scene.model, scene.state, 5), Each(0));
}

// What yields is what lies far from the middle, as much on one side as on the other; the mean is that of the rule.
TEST(ElementFields, TellWhichPointsHaveYielded) {
  Scene scene(with_steel("model: j2_plasticity, yield_stress: 4e5, hardening_modulus: 1e9"));
  scene.run(100);
  const ThicknessPoints rule = find_thickness_points(5);
  std::vector<std::vector<double>> strains;
  for (int p = 0; p < rule.count; ++p) strains.push_back(find_point_plastic_strains(scene.model, scene.state, p));
  const std::vector<double> means = find_plastic_strains(scene.model, scene.state);
  for (std::size_t e = 0; e < elements; ++e) {
    EXPECT_GT(strains[0][e], 1e-6);
    EXPECT_GT(strains[0][e], strains[1][e]);
    EXPECT_EQ(strains[2][e], 0);
    EXPECT_NEAR(strains[4][e], strains[0][e], 1e-12);
    double mean = 0;
    for (std::size_t p = 0; p < strains.size(); ++p) mean += rule.weight[p] * strains[p][e];
    EXPECT_NEAR(means[e], mean, 1e-15);
  }
}

// Outer points yield and warm up, the middle stays as it is; of the solid beside it nothing has happened.
TEST(ElementFields, TellTheTemperatureOfTheLayers) {
  Scene scene(
      with_steel("model: johnson_cook, a: 4.0e5, b: 1.0e6, n: 0.3, c: 0.01, melt_temperature: 1500, "
                 "specific_heat: 0.01, start_temperature: 300"));
  scene.run(0);
  EXPECT_THAT(find_history(scene.model, scene.state, HistoryScalar::temperature), Each(DoubleNear(300, 1e-9)));
  for (int i = 0; i < 100; ++i) scene.stepper.advance(scene.state);
  const std::vector<double> strain = find_point_plastic_strains(scene.model, scene.state, 0);
  const std::vector<double> middle = find_point_plastic_strains(scene.model, scene.state, 2);
  const std::vector<double> temperature = find_history(scene.model, scene.state, HistoryScalar::temperature);
  for (std::size_t e = 0; e < elements; ++e) {
    EXPECT_GT(strain[e], 1e-6);
    EXPECT_EQ(middle[e], 0);
    EXPECT_GT(temperature[e], 300);
  }
  EXPECT_DOUBLE_EQ(temperature.back(), 300);
}

TEST(ElementFields, HaveTheirPointInTheirName) {
  EXPECT_EQ(find_field_number("stress_point_12", stress_points), 12);
  EXPECT_EQ(find_field_number("equivalent_plastic_strain_point_1", plastic_strain_points), 1);
  for (const char* other : {"stress", "stress_point_", "stress_point_2x", "stress_top"}) {
    EXPECT_EQ(find_field_number(other, stress_points), std::nullopt) << other;
  }
}

}  // namespace
}  // namespace percuss::test
