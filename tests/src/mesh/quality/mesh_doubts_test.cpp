// Slivers and shells that are turned over are told of, and nothing of sound meshes.

#include "src/mesh/quality/mesh_doubts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include "tests/src/mesh/hand_made.hpp"

namespace percuss {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_mesh::add_element;

/// A sheet of n x n unit squares; ids from 101 on. As hexahedra: the sheet one unit thick.
PartMesh make_sheet(int n, bool solid) {
  PartMesh mesh;
  const int row = n + 1, layer = row * row;
  for (int k = 0; k < (solid ? 2 : 1); ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) mesh.nodes.push_back({double(i), double(j), double(k)});
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = i + row * j, b = a + 1, c = b + row, d = a + row;
      if (solid)
        add_element(mesh.elements, TopologyKind::hex8, {a, b, c, d, a + layer, b + layer, c + layer, d + layer});
      else
        add_element(mesh.elements, TopologyKind::quad4, {a, b, c, d});
      mesh.element_ids.push_back(100 + static_cast<std::int64_t>(mesh.elements.size()));
    }
  }
  return mesh;
}

std::vector<std::string> find_doubts(const PartMesh& mesh) {
  std::vector<Warning> warnings;
  warn_of_doubts(mesh, mesh.elements.size(), warnings);
  std::vector<std::string> texts;
  for (const Warning& warning : warnings) texts.push_back(warning.rule + ": " + warning.text);
  return texts;
}

/// Moves the lines of nodes x = 1 to x = `x`: the first column of elements is x wide.
PartMesh squeeze_first_column(PartMesh mesh, double x) {
  for (Vec3& node : mesh.nodes) node[0] = node[0] == 1 ? x : node[0];
  return mesh;
}

TEST(MeshDoubts, AreNoneOfEvenAndOfGradedMeshes) {
  for (const bool solid : {false, true}) {
    EXPECT_THAT(find_doubts(make_sheet(12, solid)), IsEmpty());
    EXPECT_THAT(find_doubts(squeeze_first_column(make_sheet(4, solid), 0.21)), IsEmpty());   // not thin enough
    EXPECT_THAT(find_doubts(squeeze_first_column(make_sheet(12, solid), 0.01)), IsEmpty());  // 12 of 144: meant
    PartMesh graded = make_sheet(12, solid);
    for (Vec3& node : graded.nodes) node = {node[0] * node[0], node[1] * node[1], 30 * node[2]};
    EXPECT_THAT(find_doubts(graded), IsEmpty());
    PartMesh row = make_sheet(12, solid);  // of one row, whose cells are 1.5 times as long from one to the next
    row.elements = row.elements.select(std::array{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
    for (Vec3& node : row.nodes) node = {std::pow(1.5, node[0]), 1000 * node[1], 1000 * node[2]};
    EXPECT_THAT(find_doubts(row), IsEmpty());
  }
}

TEST(MeshDoubts, NameTheThinnestOfAFewSlivers) {
  for (const bool solid : {false, true}) {
    EXPECT_THAT(
        find_doubts(squeeze_first_column(make_sheet(4, solid), 0.025)),
        ElementsAre(HasSubstr("sliver_element: element 101 is a sliver: 0.025 across, the median element 1 (4 elements "
                              "are like it) (it limits the time step of the whole scene to about 1/40 of that")));
  }
}

TEST(MeshDoubts, MeasureTrianglesByTheirHeight) {
  PartMesh mesh = make_sheet(4, false);
  mesh.nodes.push_back({4.1, 4, 0});  // a needle on the last square's edge x = 4: height 0.1 over an edge of 1.005
  add_element(mesh.elements, TopologyKind::tri3, {19, 25, 24});
  mesh.element_ids.push_back(500);
  EXPECT_THAT(find_doubts(mesh), ElementsAre(HasSubstr("element 500 is a sliver: 0.0995 across")));
}

TEST(MeshDoubts, NameShellsThatAreTurnedAgainstMostOfTheirPiece) {
  PartMesh mesh = make_sheet(4, false);
  const auto turn_over = [&](std::size_t e) { std::swap(mesh.elements.corners(e)[1], mesh.elements.corners(e)[3]); };
  turn_over(0);
  EXPECT_THAT(find_doubts(mesh),
              ElementsAre(HasSubstr(
                  "shell_normals: 1 shell is turned against its neighbours, with opposite normals: element 101 (")));
  for (std::size_t e = 1; e < 7; ++e) turn_over(e);
  EXPECT_THAT(find_doubts(mesh), ElementsAre(HasSubstr("7 shells are turned against their neighbours, with opposite "
                                                       "normals: elements 101, 102, 103, 104, 105, ...")));
  for (std::size_t e = 7; e < 16; ++e) turn_over(e);
  EXPECT_THAT(find_doubts(mesh), IsEmpty());  // all are
}

TEST(MeshDoubts, LeaveEdgesOfThreeShellsAndPiecesOfTheirOwnAlone) {
  PartMesh mesh = make_sheet(2, false);
  mesh.nodes.push_back({1, 0, 1});
  mesh.nodes.push_back({1, 1, 1});
  add_element(mesh.elements, TopologyKind::quad4, {1, 4, 10, 9});  // upright on the edge of elements 101 and 102
  mesh.element_ids.push_back(105);
  std::swap(mesh.elements.corners(0)[1], mesh.elements.corners(0)[3]);
  EXPECT_THAT(find_doubts(mesh), ElementsAre(HasSubstr("1 shell is turned")));  // against 103, not 102
  for (int n = 0; n < 4; ++n) mesh.nodes.push_back({double(n % 3 == 0), double(n > 1), 9.0});
  mesh.elements = mesh.elements.select(std::array{1});
  add_element(mesh.elements, TopologyKind::quad4, {14, 13, 12, 11});
  mesh.element_ids = {1, 2};
  EXPECT_THAT(find_doubts(mesh), IsEmpty());
}

TEST(MeshDoubts, AreCountedInOneCopy) {
  PartMesh mesh = squeeze_first_column(make_sheet(4, true), 0.025);
  const std::size_t own = mesh.elements.size();
  std::vector<int> copies;
  for (int copy = 0; copy < 4; ++copy)
    for (std::size_t e = 0; e < own; ++e) copies.push_back(static_cast<int>(e));
  mesh.elements = mesh.elements.select(copies);
  for (int copy = 0; copy < 3; ++copy) {
    for (std::size_t e = 0; e < own; ++e) {
      mesh.element_ids.push_back(static_cast<std::int64_t>(1000 + mesh.element_ids.size()));
    }
  }
  std::vector<Warning> warnings;
  warn_of_doubts(mesh, own, warnings);
  EXPECT_THAT(warnings, ElementsAre(testing::Field(&Warning::text, HasSubstr("(4 elements are like it)"))));
}

}  // namespace
}  // namespace percuss
