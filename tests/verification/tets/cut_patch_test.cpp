// The patch test of a generated cylinder cut into six tetrahedra a cell: a linear velocity field.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/deck/reading/read_deck.hpp"
#include "src/mesh/mesh.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::cut_patch_test {
namespace {

/// Every node starts with v = g x; those of the surface keep it, those inside are free.
void impose_linear_velocity(const Mesh& mesh, const double (&g)[3][3], Deck& deck) {
  std::vector<bool> is_interior(mesh.nodes.size(), true);
  for (const auto& [name, faces] : mesh.side_sets)
    for (const ElementFace& face : faces)
      for (const int node : mesh.elements.face_nodes(face)) is_interior[static_cast<std::size_t>(node)] = false;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Vec3& p = mesh.nodes[n];
    InitialDeck initial;
    initial.where.inside = {{p, p}};
    for (std::size_t i = 0; i < 3; ++i) initial.velocity[i] = g[i][0] * p[0] + g[i][1] * p[1] + g[i][2] * p[2];
    deck.initial.push_back(initial);
    if (is_interior[n]) continue;
    ConditionDeck condition;
    condition.where = initial.where;
    condition.kind = ConditionDeck::Kind::velocity;
    condition.active = {true, true, true};
    for (std::size_t i = 0; i < 3; ++i) condition.value[i] = Curve::constant(initial.velocity[i]);
    deck.conditions.push_back(condition);
  }
}

TEST(CutPatch, ALinearVelocityFieldStrainsSixTetrahedraOfEachCellAlike) {
  std::string points;
  const int count = 6 * 12 * 3;  // elements of the cells below
  for (int e = 1; e <= count; ++e) points += fmt::format("{{name: e{}, id: {}}}, ", e, e);
  Deck deck = parse_deck(fmt::format(R"(
title: patch test of tetrahedra
time: {{end: 4e-3}}
parts: {{body: {{cylinder: {{radius: 0.5, length: 1, cells: [4, 3]}}, at: [0, 0, -0.5], elements: six_tetrahedra, material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
elements: {{bulk_viscosity: {{linear: 0, quadratic: 0}}}}
output: {{history: {{every: 1, elements: [{}]}}}}
)",
                                     points),
                         "deck.yaml");
  const Mesh mesh = build_mesh(deck);
  ASSERT_EQ(mesh.elements.size(), static_cast<std::size_t>(count));
  impose_linear_velocity(mesh, {{9, 30, -2}, {-20, -6, 14}, {12, -4, 5}}, deck);
  const Outcome run = run_deck(deck);
  for (const char* component : {"_stress_xx", "_stress_yy", "_stress_zz", "_stress_xy", "_stress_yz", "_stress_zx"}) {
    const double first = run.history.last(std::string("e1") + component);
    EXPECT_GT(std::abs(first), 1e6);
    // as in mixed_patch_test.cpp: round-off of positions over some hundred steps
    for (int e = 2; e <= count; ++e)
      EXPECT_NEAR(run.history.last(fmt::format("e{}{}", e, component)), first, 1e-12 * 0.05 * 200e9)
          << "element " << e << component;
  }
}

}  // namespace
}  // namespace percuss::test::cut_patch_test
