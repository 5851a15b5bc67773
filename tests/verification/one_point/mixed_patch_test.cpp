// The patch test of a mesh of hexahedra, wedges, pyramids and tetrahedra: random nodes, a linear velocity field.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "src/deck/reading/read_deck.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "tests/verification/support/random_mesh.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::mixed_patch_test {
namespace {

using Cell = std::array<std::int64_t, 8>;

/// Adds an element to the block of its corners.
void add(testing_mesh::WrittenMesh& mesh, const std::vector<std::int64_t>& corners) {
  const auto block = std::find_if(mesh.blocks.begin(), mesh.blocks.end(), [&](const auto& b) {
    return b.nodes_per_element == static_cast<int>(corners.size());
  });
  block->corners.insert(block->corners.end(), corners.begin(), corners.end());
}

/// Six pyramids around a new node; the top one as two tetrahedra if requested.
void add_pyramids(RandomMesh& mesh, const Cell& c, bool splits_top) {
  Vec3 middle{};
  for (const std::int64_t node : c)
    middle = percuss::add(middle, mesh.written.nodes[static_cast<std::size_t>(node - 1)]);
  for (double& x : middle) x /= 8;
  middle[0] += 0.01;  // off the mean of the corners
  mesh.written.nodes.push_back(middle);
  mesh.is_interior.push_back(true);
  const auto apex = static_cast<std::int64_t>(mesh.written.nodes.size());
  static constexpr std::size_t faces[6][4] = {{0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3},
                                              {0, 3, 7, 4}, {0, 1, 2, 3}, {4, 7, 6, 5}};  // inward
  for (std::size_t f = 0; f < 6; ++f) {
    const auto& [p, q, r, s] = faces[f];
    if (f == 5 && splits_top) {
      add(mesh.written, {c[p], c[q], c[r], apex});
      add(mesh.written, {c[p], c[r], c[s], apex});
    } else {
      add(mesh.written, {c[p], c[q], c[r], c[s], apex});
    }
  }
}

/// A cube of three cells a side: the middle column of wedges, three cells of pyramids, on top of one two tetrahedra,
/// and hexahedra.
RandomMesh make_mixed_mesh(unsigned long seed) {
  RandomMesh mesh = make_random_mesh(3, 0.15, seed);
  const std::vector<std::int64_t> cells = mesh.written.blocks[0].corners;
  mesh.written.blocks[0].corners.clear();
  mesh.written.blocks.push_back({2, "wedges", "WEDGE", 6, {}});
  mesh.written.blocks.push_back({3, "pyramids", "PYRAMID", 5, {}});
  mesh.written.blocks.push_back({4, "tets", "TETRA", 4, {}});
  for (std::size_t cell = 0; cell < 27; ++cell) {
    Cell c{};
    std::copy_n(cells.begin() + static_cast<std::ptrdiff_t>(8 * cell), 8, c.begin());
    if (cell % 9 == 4) {
      add(mesh.written, {c[0], c[1], c[2], c[4], c[5], c[6]});
      add(mesh.written, {c[0], c[2], c[3], c[4], c[6], c[7]});
    } else if (cell == 10 || cell == 14 || cell == 21) {
      add_pyramids(mesh, c, cell == 21);
    } else {
      add(mesh.written, {c.begin(), c.end()});
    }
  }
  return mesh;
}

/// Every node starts with v = g x; those of the surface keep it, those inside are free.
void impose_linear_velocity(const RandomMesh& mesh, const double (&g)[3][3], Deck& deck) {
  for (std::size_t n = 0; n < mesh.written.nodes.size(); ++n) {
    const Vec3& p = mesh.written.nodes[n];
    Vec3 v{};
    for (std::size_t i = 0; i < 3; ++i) v[i] = g[i][0] * p[0] + g[i][1] * p[1] + g[i][2] * p[2];
    Selector node;
    node.inside = {{p, p}};
    InitialDeck initial;
    initial.where = node;
    initial.velocity = v;
    deck.initial.push_back(initial);
    if (mesh.is_interior[n]) continue;
    ConditionDeck condition;
    condition.where = node;
    condition.kind = ConditionDeck::Kind::velocity;
    condition.active = {true, true, true};
    for (std::size_t i = 0; i < 3; ++i) condition.value[i] = Curve::constant(v[i]);
    deck.conditions.push_back(condition);
  }
}

TEST(MixedPatch, ALinearVelocityFieldStrainsEveryElementAlike) {
  const RandomMesh mesh = make_mixed_mesh(7);
  int count = 0;
  for (const auto& block : mesh.written.blocks)
    count += static_cast<int>(block.corners.size()) / block.nodes_per_element;
  EXPECT_EQ(count, 21 + 6 + 17 + 2);
  std::string points;
  for (int e = 1; e <= count; ++e) points += fmt::format("{{name: e{}, id: {}}}, ", e, e);
  const TemporaryFile file(testing_mesh::write_exodus(mesh.written, "mixed_patch.exo"));
  Deck deck = parse_deck(fmt::format(R"(
title: patch test of four kinds of solids
time: {{end: 4e-3}}
parts: {{body: {{exodus: {{file: {}}}, material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
elements: {{bulk_viscosity: {{linear: 0, quadratic: 0}}}}
output: {{history: {{every: 1, elements: [{}]}}}}
)",
                                     file.path(), points),
                         "deck.yaml");
  impose_linear_velocity(mesh, {{9, 30, -2}, {-20, -6, 14}, {12, -4, 5}}, deck);
  const Outcome run = run_deck(deck);
  for (const char* component : {"_stress_xx", "_stress_yy", "_stress_zz", "_stress_xy", "_stress_yz", "_stress_zx"}) {
    const double first = run.history.last(std::string("e1") + component);
    EXPECT_GT(std::abs(first), 1e6);
    // as in patch_test.cpp: round-off of positions over some hundred steps
    for (int e = 2; e <= count; ++e)
      EXPECT_NEAR(run.history.last(fmt::format("e{}{}", e, component)), first, 1e-12 * 0.05 * 200e9)
          << "element " << e << component;
  }
  EXPECT_LT(std::abs(run.summary.energy.hourglass()), 1e-12 * run.summary.energy.internal());
}

}  // namespace
}  // namespace percuss::test::mixed_patch_test
