// Every topology by its own table: faces outward and closed, edges shared as they should be, names that tell them
// apart.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/topology/elements.hpp"

namespace percuss {
namespace {

/// The element of reference: of a hexahedron the unit cube's corners, of a surface those of its lower face, of a
/// tetrahedron the origin and the ends of the axes, of a line the origin and the end of x; a wedge stands on half of
/// the lower face, a pyramid on all of it.
Vec3 place_corner(const Topology& topology, int corner) {
  if (topology.is_line()) return {corner == 1 ? 1.0 : 0.0, 0, 0};
  if (topology.family == ElementFamily::tetrahedra)
    return {corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0, corner == 3 ? 1.0 : 0.0};
  if (topology.family == ElementFamily::wedges)
    return {corner % 3 == 1 ? 1.0 : 0.0, corner % 3 == 2 ? 1.0 : 0.0, corner < 3 ? 0.0 : 1.0};
  if (topology.family == ElementFamily::pyramids && corner == 4) return {0.5, 0.5, 1};
  const double x[4] = {0, 1, 1, 0}, y[4] = {0, 0, 1, 1};
  return {x[corner % 4], y[corner % 4], corner < 4 ? 0.0 : 1.0};
}

Vec3 find_area(const Topology& topology, const FaceCorners& face) {
  Vec3 area{};
  const auto corners = face.corners();
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Vec3 o = place_corner(topology, corners[0]);
    const Vec3 half =
        cross(subtract(place_corner(topology, corners[i - 1]), o), subtract(place_corner(topology, corners[i]), o));
    for (std::size_t k = 0; k < 3; ++k) area[k] += 0.5 * half[k];
  }
  return area;
}

class EveryTopology : public testing::TestWithParam<std::size_t> {
 protected:
  const Topology& topology() const { return topologies[GetParam()]; }
};

TEST_P(EveryTopology, IsFoundByItsKind) {
  EXPECT_EQ(&find_topology(static_cast<TopologyKind>(GetParam())), &topology());
}

TEST_P(EveryTopology, FitsTheLargestCounts) {
  EXPECT_LE(topology().corner_count, static_cast<int>(most_corners));
  EXPECT_LE(topology().face_count, static_cast<int>(most_faces));
  EXPECT_LE(topology().edge_count, static_cast<int>(most_edges));
}

TEST_P(EveryTopology, HasFacesThatLookOutwardAndCloseIt) {
  Vec3 sum{};
  for (const FaceCorners& face : topology().faces()) {
    const Vec3 area = find_area(topology(), face);
    EXPECT_GT(dot(area, area), 0);
    sum = add(sum, area);
    for (int corner = 0; corner < topology().corner_count; ++corner) {
      const Vec3 from_face = subtract(place_corner(topology(), corner), place_corner(topology(), face.once[0]));
      EXPECT_LE(dot(area, from_face), 1e-15);
    }
  }
  EXPECT_NEAR(std::sqrt(dot(sum, sum)), 0, 1e-15);
}

TEST_P(EveryTopology, HasEveryCornerOnItsFacesAndAtItsEdges) {
  std::set<int> on_faces, at_edges;
  for (const FaceCorners& face : topology().faces()) on_faces.insert(face.corners().begin(), face.corners().end());
  for (const auto& edge : topology().edges()) at_edges.insert(edge.begin(), edge.end());
  EXPECT_EQ(at_edges.size(), static_cast<std::size_t>(topology().corner_count));
  EXPECT_EQ(*at_edges.rbegin(), topology().corner_count - 1);
  EXPECT_EQ(topology().is_line() ? std::set<int>{} : at_edges, on_faces);
}

TEST_P(EveryTopology, HasEveryEdgeInTwoFacesWhichPassItBothWays) {
  if (topology().is_line()) return;  // which has no faces
  std::multiset<std::array<int, 2>> sides;
  for (const FaceCorners& face : topology().faces()) {
    const auto corners = face.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) sides.insert({corners[i], corners[(i + 1) % corners.size()]});
  }
  for (const auto& [a, b] : topology().edges()) {
    EXPECT_EQ(sides.count({a, b}), 1U) << a << "-" << b;
    EXPECT_EQ(sides.count({b, a}), 1U) << a << "-" << b;
  }
  EXPECT_EQ(sides.size(), 2 * topology().edges().size());
}

TEST_P(EveryTopology, HasFourCornersOfAFaceOfWhichATriangleHasOneTwice) {
  for (const FaceCorners& face : topology().faces()) {
    const std::set<int> of_four(face.four.begin(), face.four.end()), once(face.corners().begin(), face.corners().end());
    EXPECT_EQ(of_four, once);
    EXPECT_EQ(once.size(), face.corners().size());
  }
}

TEST_P(EveryTopology, HasCornersBehindAFaceOnlyIfItIsASolid) {
  for (const FaceCorners& face : topology().faces()) {
    const auto corners = face.corners();
    for (const int corner : corners) {
      const int behind = topology().find_corner_behind(face, corner);
      if (topology().is_surface())
        EXPECT_EQ(behind, corner);
      else
        EXPECT_EQ(std::count(corners.begin(), corners.end(), behind), 0);
    }
  }
}

TEST_P(EveryTopology, ShowsKernelsItsCornersFirstAndHasEachSideOfExodusOnce) {
  const auto& corners = topology().kernel_corners;
  for (int c = 0; c < topology().corner_count; ++c) EXPECT_EQ(corners[static_cast<std::size_t>(c)], c);
  EXPECT_EQ(std::set<int>(corners.begin(), corners.end()).size(), static_cast<std::size_t>(topology().corner_count));
  const auto& sides = topology().exodus_sides;
  EXPECT_EQ(std::set<int>(sides.begin(), sides.begin() + topology().face_count).size(),
            static_cast<std::size_t>(topology().face_count));
}

TEST_P(EveryTopology, IsToldFromAllOthersByItsNames) {
  for (const Topology& other : topologies) {
    if (&other == &topology()) continue;
    EXPECT_NE(other.name, topology().name);
    EXPECT_NE(other.vtk_type, topology().vtk_type);
    EXPECT_NE(other.xdmf_type, topology().xdmf_type);
    EXPECT_NE(other.xdmf_name, topology().xdmf_name);
    EXPECT_NE(other.abaqus_names[0], topology().abaqus_names[0]);
    for (const std::string_view name : topology().exodus_names) {
      const auto& others = other.exodus_names;
      if (name.empty() || std::find(others.begin(), others.end(), name) == others.end()) continue;
      EXPECT_NE(other.corner_count, topology().corner_count) << name;
    }
  }
}

TEST_P(EveryTopology, OfASolidHasAVolumeWhichIsPositiveAtEachCorner) {
  if (!topology().is_solid()) return;
  ElementCorners x;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = place_corner(topology(), topology().kernel_corners[i]);
  EXPECT_GT(find_solid_volume(topology(), x), 0);
  for (int corner = 0; corner < topology().corner_count; ++corner) {
    EXPECT_GT(find_corner_jacobian(topology(), x, corner).value, 0);
    for (const int other : topology().corner_edges[static_cast<std::size_t>(corner)]) {
      const std::array up{corner, other}, down{other, corner};
      const auto edges = topology().edges();
      EXPECT_EQ(std::count(edges.begin(), edges.end(), up) + std::count(edges.begin(), edges.end(), down), 1);
    }
  }
}

TEST_P(EveryTopology, GivesAllOfItsMassToItsCorners) {
  double sum = 0;
  for (std::size_t place = 0; place < kernel_corner_count; ++place) sum += topology().find_mass_share(place);
  EXPECT_NEAR(sum, 8, 1e-14);
}

TEST_P(EveryTopology, HasEachOfItsCornersOnceInTheOrderOfVtk) {
  const auto& order = topology().vtk_corners;
  const auto count = static_cast<std::size_t>(topology().corner_count);
  const std::set<int> corners(order.begin(), order.begin() + topology().corner_count);
  EXPECT_EQ(corners.size(), count);
  EXPECT_EQ(*corners.rbegin(), topology().corner_count - 1);
}

// A pyramid: 3/16 of its mass at each corner of the base, 1/4 at the apex. Its centre is the mean of what kernels see.
TEST(Pyramid5Topology, HasItsCentreAndItsMassWhereTheyAre) {
  double base = 0, apex = 0;
  ElementCorners x;
  for (std::size_t i = 0; i < kernel_corner_count; ++i) {
    const int corner = pyramid5_topology.kernel_corners[i];
    (corner == 4 ? apex : base) += pyramid5_topology.find_mass_share(i);
    x[i] = place_corner(pyramid5_topology, corner);
  }
  EXPECT_EQ(apex, 2);
  EXPECT_EQ(base, 6);
  EXPECT_EQ(find_center(x), (Vec3{0.5, 0.5, 0.25}));
}

// (0,1,2) of VTK's wedge, by the right-hand rule, looks away from (3,4,5).
TEST(Wedge6Topology, HasTheOtherTurnInVtk) { EXPECT_EQ(wedge6_topology.vtk_corners[1], 2); }

INSTANTIATE_TEST_SUITE_P(Topologies, EveryTopology, testing::Range(std::size_t{0}, topology_count),
                         [](const auto& kind) { return std::string(topologies[kind.param].name); });

TEST(ElementsOfAMesh, KnowCornersFacesAndBlockOfEach) {
  Elements elements;
  elements.blocks = {{TopologyKind::hex8, 0, 2, {}, "solid"}, {TopologyKind::tri3, 1, 3, {0.1, 5}, "sheet"}};
  elements.add(1, {7, 8, 9});
  elements.add(0, {0, 1, 2, 3, 4, 5, 6, 7});
  ASSERT_EQ(elements.size(), 2U);
  EXPECT_EQ(elements.corners(0).size(), 3U);
  EXPECT_EQ(elements.corners(1)[7], 7);
  EXPECT_EQ(elements.block_of(0).material, 3);
  EXPECT_EQ(elements.topology_of(1).name, "hex8");
  EXPECT_EQ(elements.face_nodes({0, top_face}), (std::array{7, 8, 9, 9}));
  EXPECT_EQ(elements.face_nodes({1, 4}), (std::array{0, 3, 2, 1}));
  EXPECT_EQ(elements.face_key({0, bottom_face}), elements.face_key({0, top_face}));
  EXPECT_EQ(elements.kernel_nodes(0), (std::array{7, 8, 9, 9, 7, 8, 9, 9}));
  const Elements last = elements.select(std::array{1});
  ASSERT_EQ(last.size(), 1U);
  EXPECT_EQ(last.block_of(0).name, "solid");
}

}  // namespace
}  // namespace percuss
