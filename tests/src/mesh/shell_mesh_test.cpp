// Surfaces of shells: counts, areas, normals, edges; quadrilaterals from files, alone and with hexahedra.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "src/deck/mesh_size.hpp"
#include "src/error.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/quality/check_mesh.hpp"
#include "src/mesh/topology/connectivity.hpp"
#include "tests/src/mesh/exodus_writer.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using std::numbers::pi;
using testing::ElementsAre;
using testing::HasSubstr;

using Closed = ShellBoxTubeShape::Closed;

struct Surface {
  std::string name;
  Shape shape;
  double area;     // of the faceted surface
  int open_edges;  // that one element only has
  Vec3 center{};   // from which the normals of a round or closed surface point away
  bool outward = true;
};

std::vector<Surface> list_surfaces() {
  const auto ring = [](int n) { return 2 * n * std::sin(pi / n); };  // of n chords, radius 1
  return {{"plate", ShellPlateShape{{2, 0.5}, {5, 3}}, 1, 16, {1, 0.25, -1}},
          {"tube", ShellTubeShape{0.5, {}, 2, {8, 3}}, 0.5 * ring(8) * 2, 16, {0, 0, 1}},
          {"cone",
           ShellTubeShape{0.5, 0.25, 2, {8, 3}},
           0.375 * ring(8) * std::hypot(2, 0.25 * std::cos(pi / 8)),
           16,
           {0, 0, 0.5}},
          {"sector", ShellTubeShape{0.5, {}, 2, {8, 3}, 90}, 0.5 * 16 * std::sin(pi / 32) * 2, 22, {0, 0, 1}},
          {"box tube", ShellBoxTubeShape{{0.5, 0.3}, 2, {3, 2, 4}}, 3.2, 20, {0, 0, 1}},
          {"tray", ShellBoxTubeShape{{0.5, 0.3}, 2, {3, 2, 4}, Closed::start}, 3.35, 10, {0, 0, 1}},
          {"lid", ShellBoxTubeShape{{0.5, 0.3}, 2, {1, 3, 4}, Closed::end}, 3.35, 8, {0, 0, 1}},
          {"box", ShellBoxTubeShape{{0.5, 0.3}, 2, {3, 2, 4}, Closed::both}, 3.5, 0, {0, 0, 1}},
          {"ball", ShellSphereShape{1, 12}, 0, 0, {}}};
}

class ShellSurface : public testing::TestWithParam<Surface> {};

TEST_P(ShellSurface, HasTheCountedNodesAndElements) {
  const PartMesh mesh = make_part_mesh(GetParam().shape);
  const MeshSize count = count_cells(make_part_deck("p", GetParam().shape));
  EXPECT_EQ(double(mesh.nodes.size()), count.nodes);
  EXPECT_EQ(double(mesh.elements.size()), count.elements);
}

TEST_P(ShellSurface, HasSoundElementsWhoseNormalsPointOutward) {
  const PartMesh mesh = make_part_mesh(GetParam().shape);
  EXPECT_TRUE(check_geometry(mesh).problems().empty());
  Problems problems;
  check_connectivity(mesh, problems);
  EXPECT_TRUE(problems.empty());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    ASSERT_EQ(mesh.elements.topology_of(e).name, "quad4");
    const ElementCorners x = corners_of(mesh, e);
    const Vec3 from = subtract(add(x[0], x[2]), add(GetParam().center, GetParam().center));
    const Vec3 area = find_shell_area(x);
    // Away from the axis of a tube, not from its centre, but where a plate closes it.
    const bool is_wall = !std::holds_alternative<ShellSphereShape>(GetParam().shape) &&
                         !std::holds_alternative<ShellPlateShape>(GetParam().shape) &&
                         std::hypot(area[0], area[1]) > 1e-9 * std::abs(area[2]);
    EXPECT_GT(dot(area, is_wall ? Vec3{from[0], from[1], 0} : from), 0) << e;
  }
}

TEST_P(ShellSurface, HasTheAreaOfItsFacets) {
  const PartMesh mesh = make_part_mesh(GetParam().shape);
  double area = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) area += find_shell_area_size(corners_of(mesh, e));
  if (GetParam().area > 0) {
    EXPECT_NEAR(area / GetParam().area, 1, 1e-12);
  } else {
    EXPECT_NEAR(area / (4 * pi), 1, 1e-2);  // 12 x 12 facets a sixth of the ball
    EXPECT_LT(area, 4 * pi);
  }
}

TEST_P(ShellSurface, IsOneBodyWithTwoFacesAndTheEdgesThatItShouldHave) {
  const PartMesh mesh = make_part_mesh(GetParam().shape);
  const auto bodies = find_bodies(mesh.elements, mesh.nodes.size());
  EXPECT_TRUE(std::all_of(bodies.begin(), bodies.end(), [](int b) { return b == 0; }));
  for (const auto mask : mark_exterior_faces(mesh.elements, mesh.nodes.size())) EXPECT_EQ(mask, 0b11);
  std::map<std::pair<int, int>, int> edges;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto corners = mesh.elements.corners(e);
    ASSERT_EQ(corners.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      const int a = corners[i], b = corners[(i + 1) % 4];
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  int open = 0;
  for (const auto& [edge, count] : edges) {
    EXPECT_LE(count, 2);
    open += count == 1 ? 1 : 0;
  }
  EXPECT_EQ(open, GetParam().open_edges);
}

INSTANTIATE_TEST_SUITE_P(Shapes, ShellSurface, testing::ValuesIn(list_surfaces()), [](const auto& shape) {
  std::string name = shape.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST(ShellMesh, EdgesOfAGeneratedPlateAreNodeSets) {
  PartDeck part = make_part_deck("p", ShellPlateShape{{2, 1}, {4, 3}});
  part.thickness = 0.1;
  const Mesh mesh = build_mesh(make_deck({part}));
  EXPECT_EQ(mesh.node_sets.at("p/x_min").size(), 4U);
  EXPECT_EQ(mesh.node_sets.at("p/y_max").size(), 5U);
  EXPECT_EQ(mesh.node_sets.at("p/top").size(), 20U);
  EXPECT_EQ(mesh.side_sets.at("p/top").size(), 12U);
  EXPECT_EQ(mesh.side_sets.at("p/top").front().face, top_face);
  EXPECT_TRUE(mesh.side_sets.at("p/x_min").empty());
  for (const int n : mesh.node_sets.at("p/x_max")) EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(n)][0], 2);
}

TEST(ShellMesh, APlateThatClosesAProfileSharesTheNodesOfItsWallsAndOfItsEnd) {
  PartDeck part = make_part_deck("p", ShellBoxTubeShape{{0.4, 0.2}, 0.3, {4, 2, 3}, Closed::end});
  part.thickness = 0.01;
  const Mesh mesh = build_mesh(make_deck({part}));
  EXPECT_EQ(mesh.node_sets.at("p/start").size(), 12U);  // the rim
  EXPECT_EQ(mesh.node_sets.at("p/end").size(), 15U);    // 5 x 3: rim and plate
  EXPECT_EQ(mesh.side_sets.at("p/outer").size(), 44U);  // 12 x 3 of the walls, 4 x 2 of the plate
  for (const int n : mesh.node_sets.at("p/end")) EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(n)][2], 0.3);
}

/// Two cubes, and a quadrilateral that stands on the edge of the second.
WrittenMesh make_cubes_with_fin() {
  WrittenMesh mesh = make_two_cubes();
  const auto last = static_cast<std::int64_t>(mesh.nodes.size());
  const std::int64_t a = mesh.blocks[1].corners[5], b = mesh.blocks[1].corners[6];
  for (const std::int64_t n : {a, b}) {
    Vec3 x = mesh.nodes[static_cast<std::size_t>(n - 1)];
    x[0] += 1;
    mesh.nodes.push_back(x);
  }
  mesh.blocks.push_back({30, "fin", "SHELL4", 4, {a, b, last + 2, last + 1}});
  mesh.node_ids.clear();
  mesh.element_ids.clear();
  return mesh;
}

PartDeck make_file_part(const std::string& path) { return make_part_deck("p", FileMesh{path, {}, 1}); }

TEST(ShellMesh, HexahedraAndShellsOfOneFileShareTheirNodes) {
  PartDeck part = make_file_part(write_exodus(make_cubes_with_fin(), "fin.exo"));
  part.thickness = 0.01;
  const ChunkedMesh chunked = load_mesh(make_deck({part}), Communicator(MPI_COMM_SELF));
  ASSERT_EQ(chunked.mesh.elements.size(), 3U);
  EXPECT_EQ(chunked.mesh.nodes.size(), 14U);
  ASSERT_EQ(chunked.chunks.size(), 2U);  // one of hexahedra, one of shells
  EXPECT_EQ(chunked.mesh.topology_of(0).name, "hex8");
  EXPECT_EQ(chunked.mesh.topology_of(2).name, "quad4");
  EXPECT_EQ(chunked.mesh.block_of(0).section.thickness, 0);
  EXPECT_EQ(chunked.mesh.block_of(2).section.thickness, 0.01);
  EXPECT_EQ(chunked.mesh.block_of(2).name, "fin");
  EXPECT_EQ(chunked.mesh.bodies, (std::vector<int>{0, 0, 0}));
}

TEST(ShellMesh, ShellsOfAFileHaveNamedSidesUnlessTheFileNamesThem) {
  WrittenMesh mesh = make_cubes_with_fin();
  for (const bool named : {false, true}) {
    if (named) mesh.side_sets.push_back({9, "top", {1}, {6}});
    PartDeck part = make_file_part(write_exodus(mesh, "fin.exo"));
    part.thickness = 0.01;
    const Mesh built = build_mesh(make_deck({part}));
    const ElementFace top = named ? ElementFace{0, 5} : ElementFace{2, top_face};
    EXPECT_THAT(built.side_sets.at("p/top"), ElementsAre(top));
    EXPECT_THAT(built.side_sets.at("p/bottom"), ElementsAre(ElementFace{2, bottom_face}));
  }
}

std::string take_error(const PartDeck& part) {
  try {
    build_mesh(make_deck({part}));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ShellMesh, ShellsOfAFileNeedAThicknessAndNothingElseHasOne) {
  EXPECT_THAT(take_error(make_file_part(write_exodus(make_cubes_with_fin(), "fin.exo"))),
              HasSubstr("thickness is missing (the shells of the file need one)"));
  PartDeck solid = make_file_part(write_exodus(make_two_cubes(), "cubes.exo"));
  solid.thickness = 0.1;
  EXPECT_THAT(take_error(solid), HasSubstr("the file has no shells"));
}

TEST(ShellMesh, TrianglesOfAFileHaveThreeCornersHoweverTheyAreWritten) {
  // A roof of two: a triangle block, and a quadrilateral that names a corner twice in a row, at each place in turn.
  for (std::size_t place = 0; place < 4; ++place) {
    WrittenMesh mesh;
    mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}};
    WrittenBlock quad{2, "degenerate", "SHELL4", 4, {1, 3, 4}};
    quad.corners.insert(quad.corners.begin() + static_cast<std::ptrdiff_t>(place % 3), quad.corners[place % 3]);
    if (place == 3) quad.corners = {1, 3, 4, 1};  // the last and the first
    mesh.blocks = {{1, "plain", "TRI3", 3, {1, 2, 3}}, quad};
    mesh.side_sets = {{1, "tops", {1, 2}, {1, 1}}};
    PartDeck part = make_file_part(write_exodus(mesh, "roof.exo"));
    part.thickness = 0.01;
    const Mesh built = build_mesh(make_deck({part}));
    ASSERT_EQ(built.elements.size(), 2U);
    EXPECT_EQ(built.nodes.size(), 4U);
    EXPECT_EQ(built.bodies, (std::vector<int>{0, 0}));
    for (std::size_t e = 0; e < built.elements.size(); ++e) {
      EXPECT_EQ(built.topology_of(e).name, "tri3");
      EXPECT_GT(find_shell_area(corners_of(built, e))[2], 0);  // the normal is that of the file
    }
    const auto& tops = built.side_sets.at("p/tops");
    ASSERT_EQ(tops.size(), 2U);
    for (const ElementFace& face : tops) EXPECT_EQ(face.face, top_face);
  }
}

TEST(ShellMesh, RefusesATriangleWithoutArea) {
  WrittenMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.blocks = {{1, "line", "TRI3", 3, {1, 2, 3}}, {2, "rest", "TRI3", 3, {1, 2, 4}}};
  PartDeck part = make_file_part(write_exodus(mesh, "line.exo"));
  part.thickness = 0.01;
  EXPECT_THAT(take_error(part), HasSubstr("has no area"));
}

TEST(ShellMesh, RefusesATriangleThatRepeatsAnotherWhicheverCornerIsFirstOrTwice) {
  const std::vector<std::int64_t> same[] = {{1, 2, 3},    {2, 3, 1},    {1, 3, 2},   {1, 1, 2, 3},
                                            {1, 2, 2, 3}, {1, 2, 3, 3}, {1, 2, 3, 1}};
  for (const auto& corners : same) {
    WrittenMesh mesh;
    mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const int count = static_cast<int>(corners.size());
    mesh.blocks = {{1, "one", "TRI3", 3, {1, 2, 3}}, {2, "again", count == 3 ? "TRI3" : "SHELL4", count, corners}};
    PartDeck part = make_file_part(write_exodus(mesh, "twice.exo"));
    part.thickness = 0.01;
    EXPECT_THAT(take_error(part), HasSubstr("repeats element 1 (both have the same three corners)"));
  }
}

TEST(ShellMesh, RefusesShellsWithoutAreaAndThoseThatAreNotConvex) {
  WrittenMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}};
  mesh.blocks.push_back({1, "bent", "QUAD4", 4, {1, 2, 3, 4, 1, 2, 5, 6}});
  PartDeck part = make_file_part(write_exodus(mesh, "bent.exo"));
  part.thickness = 0.1;
  const std::string error = take_error(part);
  EXPECT_THAT(error, HasSubstr("element 1 at (0.3, 0.3, 0) is not convex at its corner 3, node 3"));
  EXPECT_THAT(error, HasSubstr("element 2 at (1.5, 0, 0) has no area"));
  mesh.blocks[0].corners = {1, 2, 1, 4};
  part = make_file_part(write_exodus(mesh, "bent.exo"));
  part.thickness = 0.1;
  EXPECT_THAT(take_error(part), HasSubstr("names node 1 more than once (a shell needs four different corners, or three "
                                          "of which one stands twice in a row)"));
}

TEST(ShellMesh, SidesOneAndTwoOfAQuadrilateralAreItsTopAndItsBottom) {
  WrittenMesh mesh = make_cubes_with_fin();
  mesh.side_sets = {{1, "faces", {3, 3}, {1, 2}}};
  PartDeck part = make_file_part(write_exodus(mesh, "fin.exo"));
  part.thickness = 0.1;
  const Mesh built = build_mesh(make_deck({part}));
  const auto& faces = built.side_sets.at("p/faces");
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_EQ(faces[0].face, bottom_face);
  EXPECT_EQ(faces[1].face, top_face);
  mesh.side_sets[0].sides = {1, 3};
  part = make_file_part(write_exodus(mesh, "fin.exo"));
  part.thickness = 0.1;
  EXPECT_THAT(take_error(part), HasSubstr("of a shell the sides 1 and 2"));
}

}  // namespace
}  // namespace percuss
