// Plastic hinges of thick shells in one or more layers, against the limit moment of a plate in plane strain.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::thick_hinge_test {
namespace {

constexpr double length = 0.1, width = 0.02, thickness = 0.008, yield = 300e6;

/// A plate with one end clamped, the other moved across without turning: a hinge at each end.
struct Hinge {
  int layers = 2, cells = 20;
  double poisson = 0.3;
  std::string material = "model: j2_plasticity, yield_stress: 300e6";
  std::string path = "[[0, 0], [0.004, -0.006]]";
  double end = 0.004;
};

HistoryTable bend(const Hinge& hinge) {
  return run_deck(fmt::format(R"(
title: plate of thick shells between two clamps
time: {{end: {}}}
parts: {{p: {{box: {{size: [{}, {}, {}], cells: [{}, 2, {}]}}, material: m, integration: thick_shell}}}}
materials: {{m: {{{}, density: 7850, youngs_modulus: 200e9, poissons_ratio: {}}}}}
conditions:
  - {{nodes: p/x_min, fixed: [x, y, z]}}
  - {{nodes: p/x_max, displacement: {{z: {{table: {}}}}}}}
constraints: {{g: {{equal: [x], nodes: p/x_max}}}}
damping: [{{coefficient: 2000}}]
output: {{history: {{every: 1e-5, forces: [{{name: f, support: p/x_min}}]}}}}
)",
                              hinge.end, length, width, thickness, hinge.cells, hinge.layers, hinge.material,
                              hinge.poisson, hinge.path))
      .history;
}

/// The force at a time over that of two hinges with the limit moment of a plate that keeps its width.
double find_share(const HistoryTable& history, double time) {
  const double moment = 2 / std::sqrt(3.0) * yield * width * thickness * thickness / 4;
  const std::vector<double>& times = history["time"];
  const auto row = static_cast<std::size_t>(std::lower_bound(times.begin(), times.end() - 1, time) - times.begin());
  return history["fz:f"][row] / (2 * moment / length);
}

}  // namespace

// The clamp holds the thickness, which stiffens half an element of the hinge: less with more cells.
TEST(ThickHinge, CarriesTheLimitMomentInAnyNumberOfLayers) {
  struct Bound {
    int cells;
    double least, most;
  };
  for (const Bound& bound : {Bound{10, 1.0, 1.19}, Bound{20, 0.95, 1.09}, Bound{40, 0.93, 1.05}}) {
    for (int layers = 1; layers <= 4; ++layers) {
      Hinge hinge;
      hinge.cells = bound.cells;
      hinge.layers = layers;
      const HistoryTable history = bend(hinge);
      const double share = find_share(history, 4e-3);
      fmt::print("{} layers, {} cells along: {:.4f} of the limit\n", layers, bound.cells, share);
      EXPECT_GT(share, bound.least);
      EXPECT_LT(share, bound.most);
      EXPECT_LT(share, 1.02 * find_share(history, 2e-3));  // flat from 3 mm on
    }
  }
}

// Flow keeps the volume, whatever elasticity does: the bulk modulus grows without a bound.
TEST(ThickHinge, DoesNotDependOnPoissonsRatio) {
  Hinge hinge;
  const double reference = find_share(bend(hinge), 4e-3);
  for (const auto& [poisson, tolerance] : {std::pair{0.0, 0.02}, {0.45, 0.02}, {0.49, 0.08}}) {
    hinge.poisson = poisson;
    EXPECT_NEAR(find_share(bend(hinge), 4e-3), reference, tolerance * reference) << poisson;
  }
}

TEST(ThickHinge, TwoLayersAreLittleStrongerThanOneWithEachLaw) {
  for (const char* material :
       {"model: voce_plasticity, yield_stress: 300e6, saturation_stress: 1e6, saturation_rate: 10",
        "model: power_law_plasticity, yield_stress: 300e6, hardening_coefficient: 1e6, hardening_exponent: 1",
        "model: combined_hardening, yield_stress: 300e6, hardening_modulus: 5e8, kinematic_share: 1",
        "model: johnson_cook, a: 300e6, b: 0, n: 1, specific_heat: 460, melt_temperature: 1800"}) {
    Hinge hinge;
    hinge.material = material;
    const double two = find_share(bend(hinge), 4e-3);
    hinge.layers = 1;
    EXPECT_NEAR(two / find_share(bend(hinge), 4e-3), 1.11, 0.03) << material;
  }
}

TEST(ThickHinge, CarriesTheSameBackAndForth) {
  Hinge hinge;
  hinge.path = "[[0, 0], [0.004, -0.006], [0.012, 0.006], [0.02, -0.006]]";
  hinge.end = 0.02;
  const HistoryTable history = bend(hinge);
  const double first = find_share(history, 4e-3);
  EXPECT_NEAR(-find_share(history, 12e-3), first, 0.01 * first);
  EXPECT_NEAR(find_share(history, 20e-3), first, 0.01 * first);
}

}  // namespace percuss::test::thick_hinge_test
