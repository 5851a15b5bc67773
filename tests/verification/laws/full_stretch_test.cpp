// Fully integrated cells, tetrahedra, wedges and pyramids that are stretched, drawn in two directions or sheared far
// stay uniform, whatever disturbs them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/kernels/element/random_element.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::full_stretch_test {
namespace {

/// Constants of a neo-Hookean body: E = 3, nu = 0.3.
constexpr double mu = 3 / 2.6, lambda = 3 * 0.3 / (1.3 * 0.4);
constexpr double bulk_c10 = 0.3, bulk_c01 = 0.2, bulk = 20;

/// Principal Cauchy stress along direction i of the stretches.
using Stress = std::function<double(const double (&)[3], int)>;

double neo_hookean(const double (&l)[3], int i) {
  const double j = l[0] * l[1] * l[2];
  return (mu * (l[i] * l[i] - 1) + lambda * std::log(j)) / j;
}

double mooney_rivlin(const double (&l)[3], int i) {
  const double j = l[0] * l[1] * l[2], scale = std::pow(j, -2.0 / 3.0);
  const double b[3] = {scale * l[0] * l[0], scale * l[1] * l[1], scale * l[2] * l[2]};
  const double first = b[0] + b[1] + b[2];
  const auto whole = [&](double bi) { return 2 / j * ((bulk_c10 + first * bulk_c01) * bi - bulk_c01 * bi * bi); };
  return whole(b[i]) - (whole(b[0]) + whole(b[1]) + whole(b[2])) / 3 + bulk * (j - 1);
}

double yeoh(const double (&l)[3], int i) {
  const double j = l[0] * l[1] * l[2], scale = std::pow(j, -2.0 / 3.0);
  const double b[3] = {scale * l[0] * l[0], scale * l[1] * l[1], scale * l[2] * l[2]};
  const double first = b[0] + b[1] + b[2];
  const double slope = 0.3 + 2 * -0.01 * (first - 3) + 3 * 0.005 * (first - 3) * (first - 3);
  return 2 / j * slope * (b[i] - first / 3) + bulk * (j - 1);
}

double find_ogden(double b) { return 0.6 * std::pow(b, 2.5) - 0.1 * std::pow(b, -2.0); }

double ogden(const double (&l)[3], int i) {
  const double j = l[0] * l[1] * l[2], scale = std::pow(j, -1.0 / 3.0);
  const double mean = (find_ogden(scale * l[0]) + find_ogden(scale * l[1]) + find_ogden(scale * l[2])) / 3;
  return (find_ogden(scale * l[i]) - mean) / j + bulk * (j - 1);
}

double hyperfoam(const double (&l)[3], int i) {
  const double j = l[0] * l[1] * l[2];  // beta = 1 / 3
  return (find_ogden(l[i]) - 0.6 * std::pow(j, -2.5 / 3) + 0.1 * std::pow(j, 2.0 / 3)) / j;
}

/// J sigma of rates in the unrotated frame, along axes that do not turn: logarithmic strains.
double hypoelastic(const double (&l)[3], int i) {
  const double j = l[0] * l[1] * l[2];
  return (lambda * std::log(j) + 2 * mu * std::log(l[i])) / j;
}

struct Law {
  const char* text;
  Stress stress;
  double most;  // stretch up to which the force grows
};

const Law laws[] = {
    {"{model: neo_hookean, density: 1e-2, youngs_modulus: 3, poissons_ratio: 0.3}", neo_hookean, 3},
    {"{model: mooney_rivlin, density: 1e-2, c10: 0.3, c01: 0.2, bulk_modulus: 20}", mooney_rivlin, 3},
    {"{model: yeoh, density: 1e-2, c10: 0.3, c20: -0.01, c30: 0.005, bulk_modulus: 20}", yeoh, 3},
    {"{model: ogden, density: 1e-2, bulk_modulus: 20, terms: [[-2, -0.1], [2.5, 0.6]]}", ogden, 3},
    {"{model: hyperfoam, density: 1e-2, poissons_ratio: 0.2, terms: [[-2, -0.1], [2.5, 0.6]]}", hyperfoam, 3},
    {"{model: elastic, density: 1e-2, youngs_modulus: 3, poissons_ratio: 0.3}", hypoelastic, 2},
};

/// The stretch of the free directions from the second on.
double find_free_stretch(const Stress& stress, double stretch, int driven) {
  double low = 0.05, high = 1.5;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    const double l[3] = {stretch, driven == 2 ? stretch : middle, middle};
    (stress(l, 2) > 0 ? high : low) = middle;
  }
  return low;
}

std::string at(const Vec3& p) {
  return fmt::format("{{inside: [[{0}, {1}, {2}], [{0}, {1}, {2}]]}}", p[0], p[1], p[2]);
}

/// Calls f with the place of each node of a unit cube.
template <class F>
void for_each_node(int cells, const F& f) {
  for (int k = 0; k <= cells; ++k)
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i) f(Vec3{1.0 * i / cells, 1.0 * j / cells, 1.0 * k / cells});
}

/// A random velocity of every node at the start.
std::string make_noise(int cells) {
  Random random(7);
  std::string text = "initial:\n";
  for_each_node(cells, [&](const Vec3& p) {
    text += fmt::format("  - {{nodes: {}, velocity: [{:.6f}, {:.6f}, {:.6f}]}}\n", at(p), 1e-3 * random(),
                        1e-3 * random(), 1e-3 * random());
  });
  return text;
}

/// Motion that grows to `change` in 20 and then rests.
std::string grow(double change) {
  return fmt::format("{{expression: \"{:.17g} * sin(pi * min(t, 20) / 40)^2\"}}", change);
}

HistoryTable run(const Law& law, int cells, const std::string& conditions, const char* elements) {
  return run_deck(fmt::format(R"(
title: cells drawn far
time: {{end: 25}}
parts: {{b: {{box: {{size: [1, 1, 1], cells: [{0}, {0}, {0}]}}, {6}, material: m}}}}
materials: {{m: {1}}}
damping: [{{coefficient: 2}}]
{2}conditions:
{3}output:
  history: {{every: 0.5, nodes: [{{name: c, near: [1, 1, 1]}}, {{name: e, near: [1, 1, 0]}}, {{name: i, near: [{4}, {4}, {4}]}}], forces: [{{name: f, support: {5}}}]}}
)",
                              cells, law.text, make_noise(cells), conditions, cells > 1 ? 0.5 : 1,
                              conditions.find("x_max") == std::string::npos ? "b/y_max" : "b/x_max", elements))
      .history;
}

constexpr const char* fully = "integration: full";

HistoryTable draw(const Law& law, int cells, double stretch, int driven, const char* elements) {
  std::string conditions =
      "  - {nodes: b/x_min, symmetry: x}\n  - {nodes: b/y_min, symmetry: y}\n  - {nodes: b/z_min, symmetry: z}\n";
  conditions += fmt::format("  - {{nodes: b/x_max, displacement: {{x: {}}}}}\n", grow(stretch - 1));
  if (driven == 2) conditions += fmt::format("  - {{nodes: b/y_max, displacement: {{y: {}}}}}\n", grow(stretch - 1));
  return run(law, cells, conditions, elements);
}

/// u_x = shear y at all nodes of the surface.
HistoryTable shear(const Law& law, int cells, double shear) {
  std::string conditions;
  for_each_node(cells, [&](const Vec3& p) {
    const auto is_end = [](double x) { return x == 0 || x == 1; };
    if (!is_end(p[0]) && !is_end(p[1]) && !is_end(p[2])) return;
    conditions += fmt::format("  - {{nodes: {}, displacement: {{x: {}, y: 0, z: 0}}}}\n", at(p), grow(shear * p[1]));
  });
  return run(law, cells, conditions, fully);
}

TEST(FullStretch, StaysUniformAlongOneDirectionAndTwo) {
  for (const Law& law : laws) {
    for (const int driven : {1, 2}) {
      for (const int cells : {1, 2, 4}) {
        const double stretch = law.most, free = find_free_stretch(law.stress, stretch, driven);
        const HistoryTable h = draw(law, cells, stretch, driven, fully);
        const double l[3] = {stretch, driven == 2 ? stretch : free, free};
        const double force = law.stress(l, 0) * l[1] * l[2];
        fmt::print("{} cells, {} driven: force {:.5f} ({:.5f}), free stretch {:.5f} ({:.5f})\n", cells, driven,
                   h.last("fx:f"), force, h.last("c_z"), free);
        EXPECT_NEAR(h.last("fx:f"), force, 1e-3 * force);
        EXPECT_NEAR(h.last("c_z"), free, 1e-4);
        EXPECT_NEAR(h.last("c_y"), l[1], 1e-4);
        EXPECT_NEAR(h.last("e_y"), l[1], 1e-4);
        EXPECT_NEAR(h.last("i_z"), (cells > 1 ? 0.5 : 1) * free, 1e-4);
      }
    }
  }
}

TEST(AveragedStretch, StaysUniform) {
  for (const Law& law : laws) {
    if (law.most < 3) continue;  // elastic: rates are no law of large strain
    for (const char* elements : {"elements: six_tetrahedra", "elements: wedges", "elements: pyramids"}) {
      for (const int cells : {1, 4}) {
        const double free = find_free_stretch(law.stress, law.most, 1);
        const HistoryTable h = draw(law, cells, law.most, 1, elements);
        const double l[3] = {law.most, free, free}, force = law.stress(l, 0) * l[1] * l[2];
        fmt::print("{}, {} cells: force {:.5f} ({:.5f}), free stretch {:.5f} ({:.5f})\n", elements, cells,
                   h.last("fx:f"), force, h.last("c_z"), free);
        EXPECT_NEAR(h.last("fx:f"), force, 1e-3 * force);
        EXPECT_NEAR(h.last("c_z"), free, 1e-3);
      }
    }
  }
}

// The energy of the law, which averages would not conserve if stresses acted in the volume of the element.
TEST(AveragedStretch, HoldsTheEnergyOfTheLaw) {
  const double l = laws[0].most, free = find_free_stretch(neo_hookean, l, 1), log_j = std::log(l * free * free);
  const double energy = 0.5 * mu * (l * l + 2 * free * free - 3) - mu * log_j + 0.5 * lambda * log_j * log_j;
  for (const char* elements : {"elements: six_tetrahedra", "elements: wedges", "elements: pyramids"})
    EXPECT_NEAR(draw(laws[0], 3, l, 1, elements).last("internal"), energy, 1e-3 * energy) << elements;
}

// Elements and their averages differ in volume in a bar that swings by its length.
TEST(AveragedStretch, GivesNoEnergyInALargeSwing) {
  for (const char* law :
       {"elastic, youngs_modulus: 3, poissons_ratio: 0.45", "neo_hookean, youngs_modulus: 3, poissons_ratio: 0.45",
        "orthotropic, moduli: [3, 3, 3], poissons_ratios: [0.45, 0.45, 0.45], shear_moduli: [1.034483, 1.034483, "
        "1.034483]"}) {
    const HistoryTable h = run_deck(fmt::format(R"(
title: a bar of tetrahedra swings
time: {{end: 20}}
parts: {{b: {{box: {{size: [4, 1, 1], cells: [8, 2, 2]}}, elements: tetrahedra, material: m}}}}
materials: {{m: {{model: {}, density: 1e-2}}}}
elements: {{bulk_viscosity: {{linear: 0, quadratic: 0}}}}
conditions: [{{nodes: b/x_min, fixed: [x, y, z]}}]
initial: [{{nodes: {{inside: [[3.9, -1, -1], [5, 2, 2]]}}, velocity: [0, 15, 5]}}]
output: {{history: {{every: 0.25}}}}
)",
                                                law))
                               .history;
    const double start = h["kinetic"].front();
    double least = 0, most = 0;
    for (std::size_t i = 0; i < h["kinetic"].size(); ++i) {
      least = std::min(least, h["internal"][i]);
      most = std::max(most, h["internal"][i] + h["kinetic"][i]);
    }
    fmt::print("{}: internal at least {:.4f}, with kinetic at most {:.4f} of {:.4f}\n", law, least, most, start);
    EXPECT_GT(least, -0.01 * start) << law;
    EXPECT_LT(most, 1.03 * start) << law;
  }
}

// A law of large strain or not: at small strain a bar bends alike.
TEST(AveragedStretch, IsNoStifferForOrthotropicConstantsThatAreIsotropic) {
  const auto bend = [](const char* law) {
    return run_deck(fmt::format(R"(
title: a bar of tetrahedra bends
time: {{end: 20}}
parts: {{b: {{box: {{size: [8, 1, 1], cells: [8, 2, 2]}}, elements: tetrahedra, material: m}}}}
materials: {{m: {{model: {}, density: 1e-2}}}}
conditions: [{{nodes: b/x_min, fixed: [x, y, z]}}]
loads: {{gravity: [0, 0, -1e-4]}}
output: {{history: {{every: 1, nodes: [{{name: tip, near: [8, 0.5, 0.5]}}]}}}}
)",
                                law))
        .history.last("tip_z");
  };
  const double elastic = bend("elastic, youngs_modulus: 3, poissons_ratio: 0.25");
  EXPECT_NEAR(
      bend("orthotropic, moduli: [3, 3, 3], poissons_ratios: [0.25, 0.25, 0.25], shear_moduli: [1.2, 1.2, 1.2]"),
      elastic, 1e-6);
}

TEST(FullStretch, StaysUniformInShear) {
  // of mu, by gamma = 2: the shear stress of rates in the unrotated frame is 2 ln 2 (Dienes, Acta Mechanica 32, 1979)
  // of ogden (s(l) - s(1 / l)) / (l + 1 / l), l - 1 / l = gamma; of hyperfoam the same
  // of yeoh 2 W'(I1) gamma with I1 - 3 = gamma^2
  const double l = 1 + std::sqrt(2.0), by_stretches = (find_ogden(l) - find_ogden(1 / l)) / (l + 1 / l);
  const double rights[] = {
      2 * mu,       4 * (bulk_c10 + bulk_c01), 4 * (0.3 - 2 * 0.01 * 4 + 3 * 0.005 * 16), by_stretches,
      by_stretches, 2 * mu * std::log(2.0)};
  for (std::size_t k = 0; k < std::size(laws); ++k) {
    for (const int cells : {2, 4}) {
      const HistoryTable h = shear(laws[k], cells, 2);
      fmt::print("{} cells: shear force {:.5f} ({:.5f})\n", cells, h.last("fx:f"), rights[k]);
      EXPECT_NEAR(h.last("fx:f"), rights[k], 2e-3 * rights[k]);
      EXPECT_NEAR(h.last("i_x"), 1.5, 1e-3);
      EXPECT_NEAR(h.last("i_y"), 0.5, 1e-3);
      EXPECT_NEAR(h.last("i_z"), 0.5, 1e-3);
    }
  }
}

}  // namespace
}  // namespace percuss::test::full_stretch_test
