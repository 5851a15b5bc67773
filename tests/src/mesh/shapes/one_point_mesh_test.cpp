// Meshes of wedges and pyramids, and of six or five tetrahedra a cell: cut from generated shapes, and read from files.

#include <gtest/gtest.h>

#include <algorithm>
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
using Elements = PartDeck::Elements;

struct CutExample {
  const char* name;
  Shape shape;
  PartDeck::Elements elements;
  int of_cell;  // elements of a cell
};

PartDeck make_cut_deck(const Shape& shape, PartDeck::Elements elements) {
  PartDeck part = make_part_deck("p", shape);
  part.elements = elements;
  return part;
}

/// Within the exterior triangles of a mesh of tetrahedra.
double enclosed_volume(const Mesh& mesh) {
  double enclosed = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (int f = 0; f < 4; ++f) {
      if ((mesh.exterior[e] >> f & 1) == 0) continue;
      const std::array<int, 4> n = mesh.elements.face_nodes({static_cast<int>(e), f});
      const auto at = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(n[i])]; };
      enclosed += triple_product(at(0), at(1), at(2)) / 6;
    }
  }
  return enclosed;
}

class CutShape : public testing::TestWithParam<CutExample> {
 protected:
  PartDeck deck() const { return make_cut_deck(GetParam().shape, GetParam().elements); }
};

TEST_P(CutShape, HasTheCountedNodesAndElements) {
  const Mesh mesh = build_mesh(make_deck({deck()}));
  const MeshSize count = count_cells(deck()), cells = count_cells(make_part_deck("p", GetParam().shape));
  EXPECT_EQ(double(mesh.nodes.size()), count.nodes);
  EXPECT_EQ(double(mesh.elements.size()), count.elements);
  EXPECT_EQ(count.elements, GetParam().of_cell * cells.elements);
}

TEST_P(CutShape, HasFacesThatMatchAndSidesOutside) {
  const Mesh mesh = build_mesh(make_deck({deck()}));
  EXPECT_EQ(mesh.exterior, mark_exterior_faces(mesh.elements, mesh.nodes.size()));
  for (const int body : mesh.bodies) ASSERT_EQ(body, 0);
  const Mesh whole = build_mesh(make_deck({make_part_deck("p", GetParam().shape)}));
  for (const auto& [name, faces] : whole.side_sets) {
    const bool is_end = name == "p/z_min" || name == "p/z_max" || name == "p/start" || name == "p/end";
    const std::size_t of_face =
        deck().has_bare_tetrahedra() || (is_end && GetParam().elements == Elements::wedges) ? 2 : 1;
    EXPECT_EQ(mesh.side_sets.at(name).size(), of_face * faces.size()) << name;
  }
  for (const auto& [name, nodes] : whole.node_sets) {
    if (name == "p") continue;  // the middles of cells are among them
    EXPECT_EQ(mesh.node_sets.at(name).size(), nodes.size()) << name;
  }
}

TEST_P(CutShape, HasPositiveElementsThatFillTheCells) {
  const Mesh mesh = build_mesh(make_deck({deck()}));
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const ElementCorners x = gather_corners(mesh.elements, e, mesh.nodes);
    const Topology& topology = mesh.topology_of(e);
    for (int c = 0; c < topology.corner_count; ++c) {
      const CornerJacobian jacobian = find_corner_jacobian(topology, x, c);
      EXPECT_GT(jacobian.value, 0.03 * jacobian.edge_product);
    }
  }
  // Faces of a cell that are not flat are triangles in another place: the volume within them is then what is filled.
  const bool has_triangles = deck().has_bare_tetrahedra();
  const double whole = has_triangles ? enclosed_volume(mesh)
                                     : own_volume(build_mesh(make_deck({make_part_deck("p", GetParam().shape)})));
  EXPECT_NEAR(own_volume(mesh) / whole, 1, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, CutShape,
    testing::Values(
        CutExample{"wedges_of_a_cell", BoxShape{{1, 1, 1}, {1, 1, 1}}, Elements::wedges, 2},
        CutExample{"wedges_of_a_box", BoxShape{{1, 2, 0.5}, {7, 4, 5}}, Elements::wedges, 2},
        CutExample{"wedges_of_a_cylinder", CylinderShape{0.7, 2, 8, 3}, Elements::wedges, 2},
        CutExample{"wedges_of_a_tube", TubeShape{0.4, 0.6, 1.5, {2, 9, 3}}, Elements::wedges, 2},
        CutExample{"six_tetrahedra_of_a_cell", BoxShape{{1, 1, 1}, {1, 1, 1}}, Elements::six_tetrahedra, 6},
        CutExample{"six_tetrahedra_of_a_box", BoxShape{{1, 2, 0.5}, {7, 4, 5}}, Elements::six_tetrahedra, 6},
        CutExample{"six_tetrahedra_of_a_cylinder", CylinderShape{0.7, 2, 8, 3}, Elements::six_tetrahedra, 6},
        CutExample{"six_tetrahedra_of_a_tube", TubeShape{0.4, 0.6, 1.5, {2, 9, 3}}, Elements::six_tetrahedra, 6},
        CutExample{"six_tetrahedra_of_a_ball", SphereShape{0.7, 8}, Elements::six_tetrahedra, 6},
        CutExample{"five_tetrahedra_of_a_cell", BoxShape{{1, 1, 1}, {1, 1, 1}}, Elements::five_tetrahedra, 5},
        CutExample{"five_tetrahedra_of_a_box", BoxShape{{1, 2, 0.5}, {7, 4, 5}}, Elements::five_tetrahedra, 5},
        CutExample{"five_tetrahedra_of_a_cylinder", CylinderShape{0.7, 2, 8, 3}, Elements::five_tetrahedra, 5},
        CutExample{"five_tetrahedra_of_an_odd_cylinder", CylinderShape{0.7, 2, 7, 3}, Elements::five_tetrahedra, 5},
        CutExample{"five_tetrahedra_of_a_tube", TubeShape{0.4, 0.6, 1.5, {2, 10, 3}}, Elements::five_tetrahedra, 5},
        CutExample{"five_tetrahedra_of_a_sector", TubeShape{0.4, 0.6, 1.5, {2, 9, 3}, 120}, Elements::five_tetrahedra,
                   5},
        CutExample{"five_tetrahedra_of_a_ball", SphereShape{0.7, 8}, Elements::five_tetrahedra, 5},
        CutExample{"pyramids_of_a_box", BoxShape{{1, 2, 0.5}, {7, 4, 5}}, Elements::pyramids, 6},
        CutExample{"pyramids_of_a_cylinder", CylinderShape{0.7, 2, 8, 3}, Elements::pyramids, 6},
        CutExample{"pyramids_of_a_ball", SphereShape{0.7, 8}, Elements::pyramids, 6}),
    [](const auto& test) { return test.param.name; });

/// The mesh of a text that stands in a file of this name.
const std::string keyword_nodes =
    "*KEYWORD\n*NODE\n10,0.,0.,0.\n20,1.,0.,0.\n30,1.,1.,0.\n40,0.,1.,0.\n50,0.,.5,1.\n60,1.,.5,1.\n*ELEMENT_SOLID\n";

TEST(OnePointFile, OfLsDynaHasSolidsWithCollapsedEdges) {
  struct Case {
    const char *nodes, *topology;
    double volume;
  };
  for (const Case& c :
       {Case{"10,20,30,40,50,60,60,50", "wedge6", 0.5}, Case{"20,30,40,10,60,60,50,50", "wedge6", 0.5},
        Case{"10,40,50,50,20,30,60,60", "wedge6", 0.5}, Case{"10,20,30,40,50,50,50,50", "pyramid5", 1.0 / 3},
        Case{"50,50,50,50,40,30,20,10", "pyramid5", 1.0 / 3}, Case{"10,20,30,30,50,50,50,50", "tet4", 1.0 / 6},
        Case{"50,50,50,50,30,30,20,10", "tet4", 1.0 / 6}}) {
    const Mesh mesh = read_mesh_text(keyword_nodes + "7,1," + c.nodes + "\n*END\n", "one.k");
    ASSERT_EQ(mesh.elements.size(), 1U);
    EXPECT_EQ(mesh.topology_of(0).name, c.topology) << c.nodes;
    EXPECT_EQ(mesh.element_ids[0], 7);
    EXPECT_NEAR(own_volume(mesh), c.volume, 1e-15) << c.nodes;
  }
}

TEST(OnePointFile, OfLsDynaIsRefusedWhereTheEdgesLeaveNoSolid) {
  EXPECT_ERROR(read_mesh_text(keyword_nodes + "7,1,10,10,20,30,40,50,60,60\n*END\n", "one.k"), InputError,
               "of 6 nodes");
}

/// Ids of the nodes of the only face of a set.
std::vector<std::int64_t> list_face(const Mesh& mesh, const std::string& set) {
  std::vector<std::int64_t> ids;
  const auto key = mesh.elements.face_key(mesh.side_sets.at(set).at(0));
  for (const int node : key) {
    if (node < static_cast<int>(mesh.nodes.size())) ids.push_back(mesh.node_ids[static_cast<std::size_t>(node)]);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

const std::string abaqus_nodes = "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.,.5,1.\n6,1.,.5,1.\n";

std::string write_surfaces() {
  std::string text;
  for (const char* side : {"S1", "S2", "S3", "S4", "S5"})
    text += std::string("*SURFACE, NAME=") + side + ", TYPE=ELEMENT\nall, " + side + "\n";
  return text;
}

TEST(OnePointFile, OfAbaqusHasC3D6WithItsFiveSides) {
  const Mesh mesh = read_mesh_text(
      abaqus_nodes + "*ELEMENT, TYPE=C3D6, ELSET=all\n9, 1, 4, 5, 2, 3, 6\n" + write_surfaces(), "one.inp");
  ASSERT_EQ(mesh.elements.size(), 1U);
  EXPECT_EQ(mesh.topology_of(0).name, "wedge6");
  EXPECT_NEAR(own_volume(mesh), 0.5, 1e-15);
  using Ids = std::vector<std::int64_t>;
  EXPECT_EQ(list_face(mesh, "p/S1"), (Ids{1, 4, 5}));
  EXPECT_EQ(list_face(mesh, "p/S2"), (Ids{2, 3, 6}));
  EXPECT_EQ(list_face(mesh, "p/S3"), (Ids{1, 2, 3, 4}));
  EXPECT_EQ(list_face(mesh, "p/S4"), (Ids{3, 4, 5, 6}));
  EXPECT_EQ(list_face(mesh, "p/S5"), (Ids{1, 2, 5, 6}));
}

TEST(OnePointFile, OfAbaqusHasC3D5WithItsFiveSides) {
  const Mesh mesh =
      read_mesh_text(abaqus_nodes + "*ELEMENT, TYPE=C3D5, ELSET=all\n9, 1, 2, 3, 4, 5\n" + write_surfaces(), "one.inp");
  EXPECT_EQ(mesh.topology_of(0).name, "pyramid5");
  using Ids = std::vector<std::int64_t>;
  EXPECT_EQ(list_face(mesh, "p/S1"), (Ids{1, 2, 3, 4}));
  EXPECT_EQ(list_face(mesh, "p/S2"), (Ids{1, 2, 5}));
  EXPECT_EQ(list_face(mesh, "p/S3"), (Ids{2, 3, 5}));
  EXPECT_EQ(list_face(mesh, "p/S4"), (Ids{3, 4, 5}));
  EXPECT_EQ(list_face(mesh, "p/S5"), (Ids{1, 4, 5}));
}

// Sides of the hexahedron are those of the wedge that it is; S2, 5-8-7-6, has no area and is left out.
TEST(OnePointFile, OfAbaqusHasC3D8WithCollapsedEdgesAndItsSides) {
  const Mesh mesh = read_mesh_text(abaqus_nodes + "*ELEMENT, TYPE=C3D8, ELSET=all\n9, 1, 2, 3, 4, 5, 6, 6, 5\n" +
                                       write_surfaces() + "*SURFACE, NAME=S6, TYPE=ELEMENT\nall, S6\n",
                                   "one.inp");
  EXPECT_EQ(mesh.topology_of(0).name, "wedge6");
  using Ids = std::vector<std::int64_t>;
  EXPECT_EQ(list_face(mesh, "p/S1"), (Ids{1, 2, 3, 4}));
  EXPECT_TRUE(mesh.side_sets.at("p/S2").empty());
  EXPECT_EQ(list_face(mesh, "p/S3"), (Ids{1, 2, 5, 6}));
  EXPECT_EQ(list_face(mesh, "p/S4"), (Ids{2, 3, 6}));
  EXPECT_EQ(list_face(mesh, "p/S6"), (Ids{1, 4, 5}));
}

TEST(OnePointFile, OfGmshHasElementsOfTypes6And7) {
  const Mesh mesh = read_mesh_text(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n7\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 .5 1\n6 1 .5 1\n"
      "7 .5 .5 -1\n$EndNodes\n$Elements\n2\n5 6 2 1 1 1 4 5 2 3 6\n6 7 2 1 1 1 4 3 2 7\n$EndElements\n",
      "one.msh");
  ASSERT_EQ(mesh.elements.size(), 2U);
  EXPECT_NEAR(own_volume(mesh), 0.5 + 1.0 / 3, 1e-15);
}

TEST(OnePointFile, OfExodusHasWedgesAndPyramidsBesideHexahedraOfOnePart) {
  WrittenMesh written = make_two_cubes();
  written.nodes.push_back({2.5, 0.5, 0.5});
  written.node_ids.clear();
  written.element_ids.clear();
  const std::vector<std::int64_t> c = written.blocks[1].corners;  // the second cube, x from 1 to 2
  written.blocks[1] = {
      20, "half", "WEDGE6", 6, {c[0], c[1], c[2], c[4], c[5], c[6], c[0], c[2], c[3], c[4], c[6], c[7]}};
  written.blocks.push_back({30, "tip", "PYRAMID5", 5, {c[4], c[5], c[6], c[7], 13}});
  written.side_sets = {{6, "wedge sides", {2, 2, 2}, {2, 4, 5}}, {7, "pyramid sides", {4, 4}, {1, 5}}};
  const std::string path = write_exodus(written, "mixed.exo");
  const Mesh mesh = build_mesh(make_deck({make_part_deck("p", FileMesh{path, {}, 1, true})}));
  std::remove(path.c_str());
  ASSERT_EQ(mesh.elements.size(), 4U);
  EXPECT_NEAR(own_volume(mesh), 2 + 1.0 / 6, 1e-14);
  EXPECT_EQ(mesh.exterior, mark_exterior_faces(mesh.elements, mesh.nodes.size()));
  EXPECT_EQ(mesh.side_sets.at("p/wedge sides").size(), 3U);
  EXPECT_EQ(mesh.side_sets.at("p/pyramid sides").size(), 2U);
}

TEST(OnePointFile, OfExodusMayHaveHexahedraWithCollapsedEdges) {
  WrittenMesh written = make_two_cubes();
  std::vector<std::int64_t>& c = written.blocks[1].corners;
  c[6] = c[5];
  c[7] = c[4];
  const std::string path = write_exodus(written, "collapsed.exo");
  const Mesh mesh = build_mesh(make_deck({make_part_deck("p", FileMesh{path, {}, 1, true})}));
  std::remove(path.c_str());
  ASSERT_EQ(mesh.elements.size(), 2U);
  EXPECT_EQ(mesh.topology_of(1).name, "wedge6");
  EXPECT_NEAR(own_volume(mesh), 1.5, 1e-14);
}

}  // namespace
}  // namespace percuss
