// Tetrahedra of ten nodes from every format: the same eight pieces of each, which fit together and fill the body.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>

#include "src/error.hpp"
#include "src/mesh/reading/cut_elements.hpp"
#include "src/mesh/reading/part_reader.hpp"
#include "src/mesh/topology/connectivity.hpp"
#include "tests/src/mesh/exodus_writer.hpp"
#include "tests/src/mesh/files/sample_files.hpp"
#include "tests/src/mesh/files/ten_nodes.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr int cells = 3;
constexpr std::int64_t tets = 6 * cells * cells * cells;

std::int64_t node_at(int i, int j, int k) { return 1 + i + (cells + 1) * (j + (cells + 1) * k); }

/// A cube of unit edges, each cell cut into six tetrahedra around its diagonal. Nodes are moved by `noise` where they
/// are inside the cube. Ids of elements run from 1001, those of nodes are three times their numbers.
WrittenMesh make_cube(double noise) {
  WrittenMesh mesh;
  for (int k = 0; k <= cells; ++k)
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i) mesh.nodes.push_back({double(i) / cells, double(j) / cells, double(k) / cells});
  WrittenBlock block{7, "cube", "TET4", 4, {}};
  WrittenSet foot{3, "foot", {}, {}};
  for (int k = 0; k < cells; ++k)
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i) {
        std::array<int, 3> order{0, 1, 2};
        do {  // from the lowest corner of the cell to the highest along its edges
          std::array<int, 3> at{i, j, k};
          std::array<std::int64_t, 4> corners{node_at(i, j, k)};
          for (std::size_t step = 0; step < 3; ++step) {
            ++at[static_cast<std::size_t>(order[step])];
            corners[step + 1] = node_at(at[0], at[1], at[2]);
          }
          const bool is_even = (order[1] - order[0] + 3) % 3 == 1;
          if (!is_even) std::swap(corners[1], corners[2]);
          block.corners.insert(block.corners.end(), corners.begin(), corners.end());
        } while (std::next_permutation(order.begin(), order.end()));
      }
  for (std::int64_t n = 1; n <= node_at(cells, cells, 0); ++n) foot.entries.push_back(n);
  mesh.blocks.push_back(block);
  mesh.node_sets.push_back(foot);
  raise_to_ten_nodes(mesh);
  std::uint64_t seed = 1;
  for (Vec3& x : mesh.nodes) {
    const bool is_inside = std::all_of(x.begin(), x.end(), [](double c) { return c > 1e-9 && c < 1 - 1e-9; });
    for (double& c : x) {
      seed = seed * 6364136223846793005U + 1442695040888963407U;
      if (is_inside) c += noise * (double(seed >> 40) / double(1 << 24) - 0.5);
    }
  }
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) mesh.node_ids.push_back(3 * static_cast<std::int64_t>(n + 1));
  for (std::int64_t e = 0; e < tets; ++e) mesh.element_ids.push_back(1001 + e);
  return mesh;
}

/// Elements of the foot, and the face of each that lies there.
std::vector<std::pair<std::int64_t, int>> list_foot(const WrittenMesh& mesh) {
  std::vector<std::pair<std::int64_t, int>> foot;
  for (std::int64_t e = 0; e < tets; ++e) {
    for (int f = 0; f < 4; ++f) {
      bool is_low = true;
      for (const int c : tet4_topology.face_table[static_cast<std::size_t>(f)].corners()) {
        const std::int64_t node = mesh.blocks[0].corners[static_cast<std::size_t>(10 * e + c)];
        is_low = is_low && mesh.nodes[static_cast<std::size_t>(node - 1)][2] < 1e-9;
      }
      if (is_low) foot.emplace_back(e, f);
    }
  }
  return foot;
}

std::string list_nodes(const WrittenMesh& mesh, const char* separator) {
  std::string text;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const auto& [x, y, z] = mesh.nodes[n];
    text += fmt::format("{}{s}{:.17g}{s}{:.17g}{s}{:.17g}\n", mesh.node_ids[n], x, y, z, fmt::arg("s", separator));
  }
  return text;
}

/// Ids of the nodes of an element at these of its ten places.
std::string list_ids(const WrittenMesh& mesh, std::int64_t element, const std::vector<int>& places,
                     const char* separator) {
  std::string text;
  for (const int place : places)
    text += fmt::format("{}{}", text.empty() ? "" : separator,
                        3 * mesh.blocks[0].corners[static_cast<std::size_t>(10 * element + place)]);
  return text;
}

const std::vector<int> in_order{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, of_gmsh{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};

std::vector<int> list_six(int face) {
  const auto& corner = tet4_topology.face_table[static_cast<std::size_t>(face)].once;
  return {corner[0],
          corner[1],
          corner[2],
          find_middle(corner[0], corner[1]),
          find_middle(corner[1], corner[2]),
          find_middle(corner[2], corner[0])};
}

PartMesh read_exodus(WrittenMesh mesh, bool single = false) {
  mesh.single_precision = single;
  WrittenSet low{4, "low", {}, {}};
  constexpr std::array<int, 4> side_of_face{1, 2, 3, 4};
  for (const auto& [e, f] : list_foot(mesh)) {
    low.entries.push_back(e + 1);
    low.sides.push_back(side_of_face[static_cast<std::size_t>(f)]);
  }
  mesh.side_sets.push_back(low);
  const std::string path = write_exodus(mesh, "ten.exo");
  PartMesh part = read_part_mesh({path, {}, 1, true});
  std::remove(path.c_str());
  return part;
}

PartMesh read_text(const std::string& text, const char* name) {
  const std::string path = write_bytes(text, name);
  PartMesh part = read_part_mesh({path, {}, 1, false});
  std::remove(path.c_str());
  return part;
}

PartMesh read_gmsh(const WrittenMesh& mesh) {
  const auto foot = list_foot(mesh);
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 7 \"cube\"\n2 4 \"low\"\n";
  text += fmt::format("$EndPhysicalNames\n$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n", mesh.nodes.size(),
                      list_nodes(mesh, " "), tets + static_cast<std::int64_t>(foot.size()));
  for (std::int64_t e = 0; e < tets; ++e)
    text += fmt::format("{} 11 2 7 1 {}\n", 1001 + e, list_ids(mesh, e, of_gmsh, " "));
  std::int64_t id = 1;
  for (const auto& [e, f] : foot) text += fmt::format("{} 9 2 4 1 {}\n", id++, list_ids(mesh, e, list_six(f), " "));
  return read_text(text + "$EndElements\n", "ten.msh");
}

PartMesh read_abaqus(const WrittenMesh& mesh, const char* type) {
  std::string text = "*HEADING\n*NODE\n" + list_nodes(mesh, ", ");
  text += fmt::format("*ELEMENT, TYPE={}, ELSET=cube\n", type);
  for (std::int64_t e = 0; e < tets; ++e) text += fmt::format("{}, {}\n", 1001 + e, list_ids(mesh, e, in_order, ", "));
  text += "*SURFACE, NAME=low\n";
  constexpr std::array<int, 4> side_of_face{2, 3, 4, 1};
  for (const auto& [e, f] : list_foot(mesh))
    text += fmt::format("{}, S{}\n", 1001 + e, side_of_face[static_cast<std::size_t>(f)]);
  return read_text(text, "ten.inp");
}

/// The sides by whole faces, or by the four triangles of each.
PartMesh read_keyword(const WrittenMesh& mesh, bool by_triangles) {
  std::string text = "*KEYWORD\n*NODE\n" + list_nodes(mesh, ",") + "*PART\ncube\n7,\n*ELEMENT_SOLID\n";
  for (std::int64_t e = 0; e < tets; ++e)
    text += fmt::format("{},7,\n{}\n", 1001 + e, list_ids(mesh, e, in_order, ","));
  text += "*SET_SEGMENT_TITLE\nlow\n4,\n";
  for (const auto& [e, f] : list_foot(mesh)) {
    const auto corners = tet4_topology.face_table[static_cast<std::size_t>(f)].corners();
    if (!by_triangles) text += list_ids(mesh, e, {corners[0], corners[1], corners[2], corners[2]}, ",") + "\n";
    for (const auto& [a, b, c] : cut_tet10_face(f))
      if (by_triangles) text += list_ids(mesh, e, {a, b, c, c}, ",") + "\n";
  }
  return read_text(text + "*END\n", "ten.k");
}

double find_volume(const PartMesh& mesh) {
  double volume = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    volume += find_solid_volume(tet4_topology, corners_of(mesh, e));
  return volume;
}

double find_least_volume(const PartMesh& mesh) {
  double least = INFINITY;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    least = std::min(least, find_solid_volume(tet4_topology, corners_of(mesh, e)));
  return least;
}

/// Ids of the nodes of each element, by its id.
std::map<std::int64_t, std::multiset<std::int64_t>> list_by_ids(const PartMesh& mesh) {
  std::map<std::int64_t, std::multiset<std::int64_t>> elements;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const int node : mesh.elements.corners(e))
      elements[mesh.element_ids[e]].insert(mesh.node_ids[static_cast<std::size_t>(node)]);
  return elements;
}

void expect_foot(const PartMesh& mesh) {
  const std::vector<ElementFace>& faces = mesh.side_sets.at("low");
  ASSERT_EQ(faces.size(), std::size_t{4 * 2 * cells * cells});
  double area = 0;
  for (const ElementFace& face : faces) {
    const std::array<int, 4> n = mesh.elements.face_nodes(face);
    const auto at = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(n[i])]; };
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(at(i)[2], 0);
    // outward: downward
    area -= 0.5 * ((at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) - (at(1)[1] - at(0)[1]) * (at(2)[0] - at(0)[0]));
  }
  EXPECT_NEAR(area, 1, 1e-12);
}

}  // namespace

TEST(Tet10, IsCutIntoEightPiecesOfPositiveVolumeAroundEachDiagonal) {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<Vec3> x = corners;
  for (const auto& [a, b] : tet4_topology.edges()) {
    const Vec3 &p = corners[static_cast<std::size_t>(a)], &q = corners[static_cast<std::size_t>(b)];
    x.push_back({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])});
  }
  for (std::size_t diagonal = 0; diagonal < 3; ++diagonal) {
    double volume = 0;
    for (const Tet4Corners& piece : cut_tet10(diagonal)) {
      const auto at = [&](std::size_t i) { return x[static_cast<std::size_t>(piece[i])]; };
      const auto edge = [&](std::size_t i) {
        return Vec3{at(i)[0] - at(0)[0], at(i)[1] - at(0)[1], at(i)[2] - at(0)[2]};
      };
      const double six = triple_product(edge(1), edge(2), edge(3));
      EXPECT_NEAR(six, 1.0 / 8, 1e-15);
      volume += six / 6;
    }
    EXPECT_NEAR(volume, 1.0 / 6, 1e-15);
  }
}

TEST(Tet10, IsCutAlongTheShortestDiagonalOrByIdsWhereSeveralAre) {
  std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}, {0.5, 0.75, 0}, {0.5, 0.25, 0.7}};  // all its diagonals differ
  for (const auto& [a, b] : tet4_topology.edges()) {
    const Vec3 &p = x[static_cast<std::size_t>(a)], &q = x[static_cast<std::size_t>(b)];
    x.push_back({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])});
  }
  std::vector<std::int64_t> ids{1, 2, 3, 4, 50, 51, 52, 53, 54, 55};
  x[8] = x[6];
  x[8][0] += 0.1;
  EXPECT_EQ(find_shortest_diagonal(in_order, x, ids), 2U);
  x[9] = x[4];
  x[9][1] += 0.1 * (1 + 1e-8);
  EXPECT_EQ(find_shortest_diagonal(in_order, x, ids), 0U);  // node 50
  ids[6] = 49;
  EXPECT_EQ(find_shortest_diagonal(in_order, x, ids), 2U);
}

TEST(Tet10, OfCubesFillsThemAndFitsTogether) {
  for (const double noise : {0.0, 0.05}) {
    const WrittenMesh cube = make_cube(noise);
    const PartMesh mesh = read_exodus(cube);
    ASSERT_EQ(mesh.elements.size(), std::size_t{8 * tets});
    EXPECT_EQ(mesh.nodes.size(), cube.nodes.size());
    EXPECT_NEAR(find_volume(mesh), 1, 1e-12);
    const double least = find_least_volume(mesh), equal = 1.0 / double(8 * tets);
    EXPECT_GT(least, noise > 0 ? 0 : (1 - 1e-12) * equal);
    std::size_t exterior = 0;
    for (const std::uint8_t bits : mark_exterior_faces(mesh.elements, mesh.nodes.size()))
      for (int f = 0; f < 4; ++f) exterior += bits >> f & 1;
    EXPECT_EQ(exterior, std::size_t{6 * 2 * cells * cells * 4});
    for (const int body : find_bodies(mesh.elements, mesh.nodes.size())) ASSERT_EQ(body, 0);
    EXPECT_THAT(
        mesh.notes,
        ElementsAre(HasSubstr(
            "cut into eight of four: 162 into 1296 (pieces of element N: N, N + 10000, N + 20000, ..., N + 70000)")));
  }
}

TEST(Tet10, KeepsIdsAndSets) {
  const PartMesh mesh = read_exodus(make_cube(0));
  EXPECT_EQ(mesh.element_ids[0], 1001);
  EXPECT_EQ(mesh.element_ids[1], 11001);
  EXPECT_EQ(mesh.element_ids[7], 71001);
  EXPECT_EQ(mesh.element_ids[8], 1002);
  EXPECT_EQ(mesh.node_ids[4], 15);
  EXPECT_EQ(mesh.node_sets.at("foot").size(), std::size_t{(2 * cells + 1) * (2 * cells + 1)});
  expect_foot(mesh);
}

TEST(Tet10, IsTheSameFromAllFormats) {
  const WrittenMesh cube = make_cube(0.05);
  const PartMesh mesh = read_exodus(cube);
  const auto elements = list_by_ids(mesh);
  const auto single = list_by_ids(read_exodus(make_cube(0), true));
  EXPECT_EQ(single, list_by_ids(read_exodus(make_cube(0))));
  for (const PartMesh& other : {read_gmsh(cube), read_abaqus(cube, "C3D10"), read_abaqus(cube, "C3D10M"),
                                read_keyword(cube, false), read_keyword(cube, true)}) {
    EXPECT_EQ(list_by_ids(other), elements);
    EXPECT_EQ(other.element_ids, mesh.element_ids);
    EXPECT_EQ(other.notes, mesh.notes);
    EXPECT_EQ(other.side_sets.at("low"), mesh.side_sets.at("low"));
    expect_foot(other);
  }
}

TEST(Tet10, HasASideByItsCornersOrItsTriangles) {
  for (const std::string& text : {gmsh_of_ten, keyword_of_ten}) {
    const PartMesh mesh = read_text(text, text == gmsh_of_ten ? "one.msh" : "one.k");
    EXPECT_EQ(mesh.element_ids, (std::vector<std::int64_t>{2, 12, 22, 32, 42, 52, 62, 72}));
    EXPECT_EQ(mesh.side_sets.at("sides_3").size(), 4U);
    EXPECT_NEAR(find_volume(mesh), 8.0 / 6, 1e-14);
  }
}

TEST(Tet10, HasTheSetsOfItsElements) {
  std::string text = "*HEADING\n*NODE\n" + list_nodes(make_cube(0), ", ") + "*ELEMENT, TYPE=C3D10, ELSET=cube\n";
  for (std::int64_t e = 0; e < 2; ++e)
    text += fmt::format("{}, {}\n", 1 + e, list_ids(make_cube(0), e, in_order, ", "));
  const PartMesh mesh = read_text(text + "*ELSET, ELSET=second\n2\n*SURFACE, NAME=all\nsecond,\n", "ten.inp");
  EXPECT_EQ(mesh.side_sets.at("second").size(), 32U);
  EXPECT_EQ(mesh.side_sets.at("second").front(), (ElementFace{8, 0}));
  EXPECT_EQ(mesh.side_sets.at("all").size(), 16U);
}

TEST(Tet10, WithoutRoomForIdsIsNumberedByPlace) {
  WrittenMesh cube = make_cube(0);
  cube.element_ids[5] = 999'999'999'999'999;
  const std::string path = write_exodus(cube, "ten.exo", Container::netcdf4_int64);
  const PartMesh mesh = read_part_mesh({path, {}, 1, true});
  std::remove(path.c_str());
  EXPECT_EQ(mesh.element_ids[1], 1001);
  EXPECT_EQ(mesh.element_ids[8], 2);
  EXPECT_THAT(mesh.warnings, ElementsAre(testing::Field(&Warning::text, HasSubstr("leave no room"))));
}

TEST(Tet10, IsRefusedWhereItsMiddlesAreInAnotherOrderOrSide) {
  WrittenMesh cube = make_cube(0);
  std::swap(cube.blocks[0].corners[8], cube.blocks[0].corners[9]);
  const std::string path = write_exodus(cube, "ten.exo");
  EXPECT_THAT(
      [&] {
        build_mesh(make_deck({make_part_deck("p", FileMesh{path, {}, 1, true})}));
      },
      ThrowsMessage<InputError>(HasSubstr("is inverted")));
  cube = make_cube(0);
  cube.side_sets.push_back({4, "low", {1}, {5}});
  write_exodus(cube, "ten.exo");
  EXPECT_THAT(
      [&] {
        read_part_mesh({path, {}, 1, true});
      },
      ThrowsMessage<InputError>(HasSubstr("side set 'low' names side 5 of element 1001 (a tetrahedron has")));
  std::remove(path.c_str());
}

}  // namespace percuss
