// The patch test: random nodes, a linear velocity field, one stress in every element.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/tensor.hpp"
#include "kernels/material/elastic.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "tests/verification/support/random_mesh.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::patch_test {
namespace {

constexpr double young = 200e9, poisson = 0.3;
const char* const components[] = {"_stress_xx", "_stress_yy", "_stress_zz", "_stress_xy", "_stress_yz", "_stress_zx"};

/// Every node starts with v = g x; those of the surface keep it, those inside are free.
void impose_linear_velocity(const RandomMesh& mesh, const Matrix3<double>& g, Deck& deck) {
  for (std::size_t n = 0; n < mesh.written.nodes.size(); ++n) {
    const Vec3& p = mesh.written.nodes[n];
    const Vector3<double> v = g * Vector3<double>{p[0], p[1], p[2]};
    Selector node;
    node.inside = {{p, p}};
    InitialDeck initial;
    initial.where = node;
    initial.velocity = {v.x, v.y, v.z};
    deck.initial.push_back(initial);
    if (mesh.is_interior[n]) continue;
    ConditionDeck condition;
    condition.where = node;
    condition.kind = ConditionDeck::Kind::velocity;
    condition.active = {true, true, true};
    condition.value = {Curve::constant(v.x), Curve::constant(v.y), Curve::constant(v.z)};
    deck.conditions.push_back(condition);
  }
}

/// Runs the field to a strain of some per cent. Bulk viscosity is off: its pressure depends on the element's size.
Outcome run_patch(const RandomMesh& mesh, const Matrix3<double>& g, const std::string& elements) {
  std::string points;
  for (int e = 1; e <= 27; ++e) points += fmt::format("{{name: e{}, id: {}}}, ", e, e);
  const TemporaryFile file(testing_mesh::write_exodus(mesh.written, "patch.exo"));
  Deck deck = parse_deck(fmt::format(R"(
title: patch test
time: {{end: 4e-3}}
parts: {{body: {{exodus: {{file: {}}}, material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
elements: {{{}, bulk_viscosity: {{linear: 0, quadratic: 0}}}}
output: {{history: {{every: 1, elements: [{}]}}}}
)",
                                     file.path(), elements, points),
                         "deck.yaml");
  impose_linear_velocity(mesh, g, deck);
  return run_deck(deck);
}

void expect_uniform(const HistoryTable& history, double scale) {
  for (const char* component : components) {
    const double first = history.last(std::string("e1") + component);
    for (int e = 2; e <= 27; ++e) {
      // Round-off of positions (1e-16 of 1 m) over elements of 0.2 m, gathered over some hundred steps, times the
      // stiffness against the stress at a strain of 1e-2: 1e-12 with room for the waves that it sets off.
      EXPECT_NEAR(history.last(fmt::format("e{}{}", e, component)), first, 1e-12 * scale)
          << "element " << e << component;
    }
  }
}

class Patch : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Elements, Patch,
                         testing::Values("hourglass: assumed_strain", "hourglass: stiffness", "hourglass: viscous",
                                         "integration: full"));

}  // namespace

TEST_P(Patch, ALinearVelocityFieldStrainsEveryElementAlikeAndExactly) {
  const RandomMesh mesh = make_random_mesh(3, 0.2, 7);
  // A symmetric gradient of the start's coordinates stretches along fixed axes: J times the stress is that of ln(1 + t
  // g).
  const Matrix3<double> g{{{9, 3, -2}, {3, -6, 4}, {-2, 4, 5}}};
  const Outcome run = run_patch(mesh, g, GetParam());
  expect_uniform(run.history, 0.05 * young);
  EXPECT_LT(std::abs(run.summary.energy.hourglass()), 1e-12 * run.summary.energy.internal());

  // ln(1 + a) by its series, a = 4e-3 g: |a| < 0.06, so eight terms leave 1e-11
  const Matrix3<double> a = 4e-3 * g;
  Matrix3<double> power = a, log = a;
  for (int n = 2; n <= 8; ++n) {
    power = power * a;
    log = log + ((n % 2 == 0 ? -1.0 : 1.0) / n) * power;
  }
  const LameConstants c = find_lame_constants(young, poisson);
  const double volume = std::exp(log.row[0].x + log.row[1].y + log.row[2].z);  // J
  const double mean = c.lambda * (log.row[0].x + log.row[1].y + log.row[2].z);
  const double expected[6] = {mean + 2 * c.mu * log.row[0].x, mean + 2 * c.mu * log.row[1].y,
                              mean + 2 * c.mu * log.row[2].z, 2 * c.mu * log.row[0].y,
                              2 * c.mu * log.row[1].z,        2 * c.mu * log.row[2].x};
  for (std::size_t k = 0; k < 6; ++k) {
    // Mid-point strain rates: each of some hundred steps of strain 5e-4 is off by the cube of it over 12, 1e-9 in sum.
    EXPECT_NEAR(run.history.last(std::string("e1") + components[k]), expected[k] / volume, 1e-8 * young);
  }
}

TEST_P(Patch, AFieldThatStretchesShearsAndTurnsKeepsEveryElementAlike) {
  const RandomMesh mesh = make_random_mesh(3, 0.2, 8);
  const Outcome run = run_patch(mesh, {{{9, 30, -2}, {-20, -6, 14}, {12, -4, 5}}}, GetParam());
  expect_uniform(run.history, 0.05 * young);
  EXPECT_LT(std::abs(run.summary.energy.hourglass()), 1e-12 * run.summary.energy.internal());
}

}  // namespace percuss::test::patch_test
