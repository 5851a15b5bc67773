// Every generator: counts, volumes, shapes, sides, symmetry.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "src/deck/mesh_size.hpp"
#include "src/mesh/topology/connectivity.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using std::numbers::pi;

struct Example {
  std::string name;
  Shape shape;
  double least_jacobian;  // scaled
};

std::vector<Example> list_examples() {
  std::vector<Example> examples{{"box", BoxShape{{1, 2, 0.5}, {3, 4, 2}}, 1 - 1e-12},
                                {"one cell", BoxShape{{1, 1, 1}, {1, 1, 1}}, 1 - 1e-12}};
  for (const int across : {3, 4, 5, 6, 7, 8, 11, 12, 16, 24}) {
    examples.push_back({"cylinder " + std::to_string(across), CylinderShape{0.7, 2, across, 3}, 0.70});
    examples.push_back({"sphere " + std::to_string(across), SphereShape{0.7, across}, 0.57});
  }
  // A wedge of a tube with n cells around is sheared by 180 / n degrees.
  for (const int around : {3, 5, 8, 16}) {
    examples.push_back(
        {"tube " + std::to_string(around), TubeShape{0.4, 0.6, 1.5, {2, around, 3}}, std::cos(pi / around) - 1e-12});
  }
  for (const double arc : {10.0, 90.0, 180.0, 359.5}) {
    const double wedge = pi * arc / 360 / 7;
    examples.push_back({"sector " + std::to_string(static_cast<int>(arc)), TubeShape{0.4, 0.6, 1.5, {2, 7, 3}, arc},
                        std::cos(wedge) - 1e-12});
  }
  return examples;
}

class GeneratedMesh : public testing::TestWithParam<Example> {};

TEST_P(GeneratedMesh, HasTheCountedNodesAndElements) {
  const PartMesh mesh = make_part_mesh(GetParam().shape);
  const MeshSize count = count_cells(make_part_deck("p", GetParam().shape));
  EXPECT_EQ(double(mesh.nodes.size()), count.nodes);
  EXPECT_EQ(double(mesh.elements.size()), count.elements);
}

TEST_P(GeneratedMesh, HasOnlyWellShapedElements) {
  EXPECT_GE(worst_scaled_jacobian(make_part_mesh(GetParam().shape)), GetParam().least_jacobian);
}

TEST_P(GeneratedMesh, IsOneBodyWhoseSidesAreItsExteriorFaces) {
  const PartMesh mesh = make_part_mesh(GetParam().shape);
  Mesh joined;
  joined.elements = mesh.elements;
  joined.exterior = mark_exterior_faces(mesh.elements, mesh.nodes.size());
  EXPECT_EQ(join_side_sets(mesh), find_exterior_faces(joined));
  for (const int body : find_bodies(mesh.elements, mesh.nodes.size())) ASSERT_EQ(body, 0);
}

TEST_P(GeneratedMesh, KnowsTheSidesOfANodeFromThoseOfItsFaces) {
  const std::unique_ptr<ShapeSource> source = make_source(GetParam().shape);
  PartMesh mesh = make_part_mesh(GetParam().shape);
  add_side_nodes(mesh);
  std::map<std::string, std::vector<int>> sides;
  const std::vector<std::string> names = side_names(GetParam().shape);
  for (int n = 0; n < source->node_count(); ++n) {
    for (std::size_t s = 0; s < names.size(); ++s) {
      if ((source->node_sides(n) >> s & 1) != 0) sides[names[s]].push_back(n);
    }
  }
  EXPECT_EQ(mesh.node_sets, sides);
}

TEST_P(GeneratedMesh, HasEveryElementInOneOfItsBlocks) {
  const std::unique_ptr<ShapeSource> source = make_source(GetParam().shape);
  std::vector<int> listed, all(static_cast<std::size_t>(source->element_count()));
  for (const CellBlock& block : source->blocks()) {
    for (int k = 0; k < block.cells[2]; ++k) {
      for (int j = 0; j < block.cells[1]; ++j) {
        for (int i = 0; i < block.cells[0]; ++i) {
          listed.push_back(block.first + i * block.strides[0] + j * block.strides[1] + k * block.strides[2]);
        }
      }
    }
    EXPECT_GT(std::min({block.edges[0], block.edges[1], block.edges[2]}), 0);
  }
  std::sort(listed.begin(), listed.end());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(listed, all);
}

TEST_P(GeneratedMesh, HasTheVolumeThatItsSurfaceEncloses) {
  const PartMesh mesh = make_part_mesh(GetParam().shape);
  double enclosed = 0;  // divergence theorem with the field x / 3 over bilinear faces
  for (const ElementFace& f : join_side_sets(mesh)) {
    std::array<Vec3, 4> p;
    const std::array<int, 4> corners = mesh.elements.face_nodes(f);
    for (std::size_t c = 0; c < 4; ++c) p[c] = mesh.nodes[static_cast<std::size_t>(corners[c])];
    enclosed += (triple_product(p[0], p[1], add(p[2], p[3])) + triple_product(add(p[0], p[1]), p[2], p[3])) / 12;
  }
  EXPECT_NEAR(total_volume(mesh), enclosed, 1e-13 * enclosed);
  EXPECT_GT(enclosed, 0);  // the faces look outward
}

TEST_P(GeneratedMesh, HasASurfaceWithoutCracks) {
  const PartMesh mesh = make_part_mesh(GetParam().shape);
  std::set<std::pair<int, int>> edges;
  std::set<int> nodes;
  const std::vector<ElementFace> faces = join_side_sets(mesh);
  for (const ElementFace& f : faces) {
    const std::array<int, 4> corners = mesh.elements.face_nodes(f);
    for (std::size_t c = 0; c < 4; ++c) {
      const int a = corners[c], b = corners[(c + 1) % 4];
      EXPECT_TRUE(edges.emplace(a, b).second) << "an edge runs twice the same way";
      nodes.insert(a);
    }
  }
  for (const auto& [a, b] : edges) ASSERT_TRUE(edges.contains({b, a}));
  const long euler = long(nodes.size()) - long(edges.size() / 2) + long(faces.size());
  const auto* tube = std::get_if<TubeShape>(&GetParam().shape);
  EXPECT_EQ(euler, tube && tube->arc == 360 ? 0 : 2);
}

INSTANTIATE_TEST_SUITE_P(Shapes, GeneratedMesh, testing::ValuesIn(list_examples()), [](const auto& example) {
  std::string name = example.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST(BoxMesh, HasItsVolumeAndSidesInPlace) {
  const Mesh mesh = build_mesh(make_deck({make_part_deck("b", BoxShape{{0.3, 0.7, 1.1}, {3, 7, 2}})}));
  EXPECT_NEAR(total_volume(mesh), 0.3 * 0.7 * 1.1, 1e-15);
  EXPECT_EQ(find_exterior_faces(mesh).size(), 2U * (3 * 7 + 7 * 2 + 3 * 2));
  for (const int n : mesh.node_sets.at("b/x_min")) EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(n)][0], 0);
  for (const int n : mesh.node_sets.at("b/x_max")) EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(n)][0], 0.3);
  for (const int n : mesh.node_sets.at("b/y_max")) EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(n)][1], 0.7);
  for (const int n : mesh.node_sets.at("b/z_max")) EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(n)][2], 1.1);
  EXPECT_EQ(mesh.node_sets.at("b/z_max").size(), 4U * 8);
  EXPECT_EQ(mesh.node_sets.at("b").size(), mesh.nodes.size());
}

TEST(CylinderMesh, OfTheBrickWallHas840Elements) {
  EXPECT_EQ(make_part_mesh(CylinderShape{0.05, 0.4, 5, 40}).elements.size(), 840U);
}

TEST(CylinderMesh, HasTheVolumeOfItsPolygonAndConvergesAtSecondOrder) {
  double last_error = 0;
  for (const int across : {8, 16, 32}) {
    const double sides = 4.0 * across / 2, radius = 0.3, length = 2;
    const double volume = total_volume(make_part_mesh(CylinderShape{radius, length, across, 2}));
    EXPECT_NEAR(volume, length * sides / 2 * radius * radius * std::sin(2 * pi / sides), 1e-14);
    const double error = pi * radius * radius * length - volume;
    // The error goes as h^2 (1 - h^2 / 20 ...): the ratio is a little under 4.
    if (last_error > 0) {
      EXPECT_NEAR(last_error / error, 4, 0.03);
    }
    last_error = error;
  }
}

TEST(CylinderMesh, SideNodesLieAtTheRadiusAndEndsInTheirPlanes) {
  const Mesh mesh = build_mesh(make_deck({make_part_deck("c", CylinderShape{0.3, 2, 7, 4})}));
  for (const int n : mesh.node_sets.at("c/side")) {
    const Vec3& x = mesh.nodes[static_cast<std::size_t>(n)];
    EXPECT_NEAR(std::hypot(x[0], x[1]), 0.3, 1e-16);  // two units in the last place
  }
  for (const int n : mesh.node_sets.at("c/start")) EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(n)][2], 0);
  for (const int n : mesh.node_sets.at("c/end")) EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(n)][2], 2);
}

TEST(CylinderMesh, IsSymmetricToTheLastBit) {
  for (const int across : {3, 5, 6, 12}) {
    const std::vector<Vec3> nodes = make_part_mesh(CylinderShape{0.37, 1.3, across, 2}).nodes,
                            places = sorted_places(nodes);
    EXPECT_EQ(mapped_places(nodes,
                            [](Vec3 x) {
                              return Vec3{-x[1], x[0], x[2]};
                            }),
              places)
        << "quarter turn, " << across;
    EXPECT_EQ(mapped_places(nodes, [](Vec3 x) { return Vec3{-x[0], x[1], x[2]}; }), places) << "mirror, " << across;
    EXPECT_EQ(mapped_places(nodes, [](Vec3 x) { return Vec3{x[1], x[0], x[2]}; }), places) << "diagonal, " << across;
  }
}

TEST(TubeMesh, HasTheVolumeOfItsPolygons) {
  const double volume = total_volume(make_part_mesh(TubeShape{0.4, 0.6, 1.5, {2, 12, 3}}));
  EXPECT_NEAR(volume, 1.5 * 6 * (0.36 - 0.16) * std::sin(pi / 6), 1e-14);
}

TEST(TubeMesh, InnerAndOuterNodesLieAtTheirRadii) {
  const Mesh mesh = build_mesh(make_deck({make_part_deck("t", TubeShape{0.4, 0.6, 1.5, {2, 13, 3}})}));
  const auto radius = [&](int n) {
    return std::hypot(mesh.nodes[static_cast<std::size_t>(n)][0], mesh.nodes[static_cast<std::size_t>(n)][1]);
  };
  for (const int n : mesh.node_sets.at("t/inner")) EXPECT_NEAR(radius(n), 0.4, 2e-16);
  for (const int n : mesh.node_sets.at("t/outer")) EXPECT_NEAR(radius(n), 0.6, 2e-16);
}

TEST(TubeMesh, IsSymmetricToTheLastBit) {
  for (const int around : {3, 5, 8, 12, 20}) {
    const std::vector<Vec3> nodes = make_part_mesh(TubeShape{0.4, 0.6, 1.5, {2, around, 1}}).nodes,
                            places = sorted_places(nodes);
    EXPECT_EQ(mapped_places(nodes, [](Vec3 x) { return Vec3{x[0], -x[1], x[2]}; }), places) << around;
    if (around % 4 != 0) continue;
    EXPECT_EQ(mapped_places(nodes, [](Vec3 x) { return Vec3{-x[1], x[0], x[2]}; }), places) << around;
  }
}

TEST(TubeMesh, FirstNodeLineLiesAtPlusXAndTheNextCounterClockwise) {
  const PartMesh mesh = make_part_mesh(TubeShape{1, 2, 1, {1, 12, 1}});
  EXPECT_EQ(mesh.nodes[0], (Vec3{1, 0, 0}));
  EXPECT_EQ(mesh.nodes[1], (Vec3{2, 0, 0}));
  EXPECT_NEAR(mesh.nodes[2][0], std::cos(pi / 6), 1e-16);
  EXPECT_NEAR(mesh.nodes[2][1], 0.5, 1e-16);
  EXPECT_EQ(mesh.nodes[6], (Vec3{0, 1, 0}));
}

TEST(TubeMesh, SectorsEndExactlyOnTheAxesAndHaveTwoMoreSides) {
  for (const double arc : {90.0, 180.0, 270.0}) {
    PartMesh mesh = make_part_mesh(TubeShape{0.4, 0.6, 1.5, {2, 9, 3}, arc});
    add_side_nodes(mesh);
    EXPECT_EQ(mesh.node_sets.at("first").size(), 3U * 4);
    EXPECT_EQ(mesh.node_sets.at("last").size(), 3U * 4);
    for (const int n : mesh.node_sets.at("first")) EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(n)][1], 0);
    for (const int n : mesh.node_sets.at("last")) {
      EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(n)][arc == 180 ? 1 : 0], 0);
      EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(n)][0] < 0, arc == 180);
    }
  }
}

TEST(TubeMesh, HalfATurnIsSymmetricToTheLastBit) {
  const std::vector<Vec3> nodes = make_part_mesh(TubeShape{0.4, 0.6, 1.5, {2, 9, 3}, 180}).nodes;
  EXPECT_EQ(mapped_places(nodes, [](Vec3 x) { return Vec3{-x[0], x[1], x[2]}; }), sorted_places(nodes));
}

TEST(TubeMesh, ASectorIsThatPartOfTheTurn) {
  const double whole = total_volume(make_part_mesh(TubeShape{0.4, 0.6, 1.5, {2, 360, 3}}));
  EXPECT_NEAR(total_volume(make_part_mesh(TubeShape{0.4, 0.6, 1.5, {2, 55, 3}, 55})), whole * 55 / 360, 1e-13);
}

TEST(SphereMesh, ConvergesToTheBallAtSecondOrder) {
  double last_error = 0;
  for (const int across : {8, 16, 32}) {
    const double error = 4 * pi / 3 - total_volume(make_part_mesh(SphereShape{1, across}));
    EXPECT_GT(error, 0);
    // The core has 4, 8 and 16 cells: terms in h^4 still show.
    if (last_error > 0) {
      EXPECT_NEAR(last_error / error, 4, 0.15);
    }
    last_error = error;
  }
}

TEST(SphereMesh, SurfaceNodesLieAtTheRadius) {
  const Mesh mesh = build_mesh(make_deck({make_part_deck("s", SphereShape{0.3, 9})}));
  for (const int n : mesh.node_sets.at("s/surface")) {
    const Vec3& x = mesh.nodes[static_cast<std::size_t>(n)];
    EXPECT_NEAR(std::hypot(x[0], x[1], x[2]), 0.3, 2e-16);
  }
}

TEST(SphereMesh, HasTheSymmetriesOfTheCubeToTheLastBit) {
  for (const int across : {3, 4, 7, 10}) {
    const std::vector<Vec3> nodes = make_part_mesh(SphereShape{0.37, across}).nodes, places = sorted_places(nodes);
    // These three generate all 48.
    EXPECT_EQ(mapped_places(nodes, [](Vec3 x) { return Vec3{-x[0], x[1], x[2]}; }), places) << "mirror, " << across;
    EXPECT_EQ(mapped_places(nodes, [](Vec3 x) { return Vec3{x[1], x[0], x[2]}; }), places) << "diagonal, " << across;
    EXPECT_EQ(mapped_places(nodes, [](Vec3 x) { return Vec3{x[1], x[2], x[0]}; }), places) << "third turn, " << across;
  }
}

}  // namespace
}  // namespace percuss
