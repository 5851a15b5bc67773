// Meshes of tetrahedra: cut from generated shapes, and read from files.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>

#include "src/deck/mesh_size.hpp"
#include "src/error.hpp"
#include "src/mesh/topology/connectivity.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/mesh/exodus_writer.hpp"
#include "tests/src/mesh/files/sample_files.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;

struct TetExample {
  const char* name;
  Shape shape;
};

PartDeck make_tet_deck(const Shape& shape) {
  PartDeck part = make_part_deck("p", shape);
  part.elements = PartDeck::Elements::tetrahedra;
  return part;
}

class TetShape : public testing::TestWithParam<TetExample> {};

TEST_P(TetShape, HasTheCountedNodesAndTwelveElementsACell) {
  const Mesh mesh = build_mesh(make_deck({make_tet_deck(GetParam().shape)}));
  const MeshSize count = count_cells(make_tet_deck(GetParam().shape)),
                 cells = count_cells(make_part_deck("p", GetParam().shape));
  EXPECT_EQ(double(mesh.nodes.size()), count.nodes);
  EXPECT_EQ(double(mesh.elements.size()), count.elements);
  EXPECT_EQ(count.elements, 12 * cells.elements);
  EXPECT_EQ(count.nodes, cells.nodes + cells.elements);
}

TEST_P(TetShape, HasFacesThatMatchAndSidesOutside) {
  const Mesh mesh = build_mesh(make_deck({make_tet_deck(GetParam().shape)}));
  Mesh marked;
  marked.elements = mesh.elements;
  marked.exterior = mark_exterior_faces(mesh.elements, mesh.nodes.size());
  EXPECT_EQ(mesh.exterior, marked.exterior);
  for (const int body : mesh.bodies) ASSERT_EQ(body, 0);
  const Mesh whole = build_mesh(make_deck({make_part_deck("p", GetParam().shape)}));
  for (const auto& [name, faces] : whole.side_sets) EXPECT_EQ(mesh.side_sets.at(name).size(), 2 * faces.size()) << name;
  for (const auto& [name, nodes] : whole.node_sets) {
    if (name == "p") continue;  // the middles of cells are among them
    EXPECT_EQ(mesh.node_sets.at(name).size(), nodes.size()) << name;
  }
}

TEST_P(TetShape, HasPositiveElementsThatFillIt) {
  const Mesh mesh = build_mesh(make_deck({make_tet_deck(GetParam().shape)}));
  double enclosed = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const ElementCorners x = gather_corners(mesh.elements, e, mesh.nodes);
    const CornerJacobian jacobian = find_corner_jacobian(tet4_topology, x, 0);
    EXPECT_GT(jacobian.value, 0.03 * jacobian.edge_product);
    for (int f = 0; f < 4; ++f) {
      if ((mesh.exterior[e] >> f & 1) == 0) continue;
      const std::array<int, 4> n = mesh.elements.face_nodes({static_cast<int>(e), f});
      const auto at = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(n[i])]; };
      enclosed += triple_product(at(0), at(1), at(2)) / 6;
    }
  }
  EXPECT_NEAR(own_volume(mesh) / enclosed, 1, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Shapes, TetShape,
                         testing::Values(TetExample{"cell", BoxShape{{1, 1, 1}, {1, 1, 1}}},
                                         TetExample{"box", BoxShape{{1, 2, 0.5}, {7, 4, 5}}},
                                         TetExample{"cylinder", CylinderShape{0.7, 2, 8, 3}},
                                         TetExample{"tube", TubeShape{0.4, 0.6, 1.5, {2, 9, 3}}},
                                         TetExample{"ball", SphereShape{0.7, 8}}),
                         [](const auto& test) { return test.param.name; });

TEST(TetShape, OfABoxHasItsVolume) {
  EXPECT_NEAR(own_volume(build_mesh(make_deck({make_tet_deck(BoxShape{{1, 2, 0.5}, {3, 4, 2}})}))), 1, 1e-14);
}

/// The mesh of a text that stands in a file of this name.
TEST(TetFile, OfLsDynaHasSolidsOfFourNodesInEitherForm) {
  for (const char* const nodes : {"10      50      60      80      80      80      80      80",
                                  "10      50      60      60      80      80      80      80"}) {
    const Mesh mesh =
        read_mesh_text("*KEYWORD\n*NODE\n10,0.,0.,0.\n50,1.,0.,0.\n60,0.,1.,0.\n80,0.,0.,1.\n*ELEMENT_SOLID\n" +
                           std::string("       7       1      ") + nodes + "\n*END\n",
                       "one.k");
    ASSERT_EQ(mesh.elements.size(), 1U);
    EXPECT_EQ(mesh.topology_of(0).name, "tet4");
    EXPECT_EQ(mesh.element_ids[0], 7);
    EXPECT_DOUBLE_EQ(own_volume(mesh), 1.0 / 6);
  }
}

TEST(TetFile, OfAbaqusHasC3D4WithItsFourSides) {
  const Mesh mesh = read_mesh_text(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.,0.\n4,0.,0.,1.\n*ELEMENT, TYPE=C3D4, ELSET=all\n9, 1, 2, 3, 4\n"
      "*SURFACE, NAME=base, TYPE=ELEMENT\nall, S1\n*SURFACE, NAME=skew, TYPE=ELEMENT\nall, S3\n",
      "one.inp");
  ASSERT_EQ(mesh.elements.size(), 1U);
  EXPECT_EQ(mesh.topology_of(0).name, "tet4");
  // S1 is 1-2-3, S3 is 2-4-3
  const auto list = [&](const char* set) {
    const auto key = mesh.elements.face_key(mesh.side_sets.at(set).at(0));
    std::vector<std::int64_t> ids;
    for (std::size_t i = 0; i < 3; ++i) ids.push_back(mesh.node_ids[static_cast<std::size_t>(key[i])]);
    std::sort(ids.begin(), ids.end());
    return ids;
  };
  EXPECT_EQ(list("p/base"), (std::vector<std::int64_t>{1, 2, 3}));
  EXPECT_EQ(list("p/skew"), (std::vector<std::int64_t>{2, 3, 4}));
}

TEST(TetFile, OfGmshHasElementsOfType4) {
  const Mesh mesh = read_mesh_text(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
      "$Elements\n1\n5 4 2 1 1 1 2 3 4\n$EndElements\n",
      "one.msh");
  ASSERT_EQ(mesh.elements.size(), 1U);
  EXPECT_DOUBLE_EQ(own_volume(mesh), 1.0 / 6);
}

TEST(TetFile, OfExodusStandsBesideHexahedraInOnePart) {
  WrittenMesh written = make_two_cubes();
  written.blocks[1] = {20, "tet", "TETRA", 4, {5, 9, 6, 7}};  // nodes of the first cube's side x = 1, and one ahead
  written.side_sets.clear();
  const std::string path = write_exodus(written, "mixed.exo");
  const Mesh mesh = build_mesh(make_deck({make_part_deck("p", FileMesh{path, {}, 1, true})}));
  std::remove(path.c_str());
  ASSERT_EQ(mesh.elements.size(), 2U);
  EXPECT_TRUE(has_small_solids(mesh));
  EXPECT_EQ(mesh.topology_of(1).name, "tet4");
}

TEST(TetFile, WithAnElementInsideOutIsRefusedWithItsId) {
  EXPECT_ERROR(
      read_mesh_text("*KEYWORD\n*NODE\n10,0.,0.,0.\n50,1.,0.,0.\n60,0.,1.,0.\n80,0.,0.,-1.\n*ELEMENT_SOLID\n"
                     "       7       1      10      50      60      80      80      80      80      80\n*END\n",
                     "turned.k"),
      InputError, "element 7 at (0.25, 0.25, -0.25) is inverted");
}

}  // namespace
}  // namespace percuss
