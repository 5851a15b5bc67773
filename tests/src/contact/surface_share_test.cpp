// Contact surface, pair table and walls from mesh and deck.

#include "src/contact/surface/surface_share.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "src/contact/search/local_finder.hpp"
#include "src/contact/ties/ties.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/mesh/decomposition/decompose.hpp"

namespace percuss::test {
namespace {

// Part a: 2 x 1 x 1 elements, nodes 0 to 11. Part b: one element, nodes 12 to 19. Part c: 3 x 3 x 3 with inner nodes.
const std::string two_parts = R"(
time: {end: 1}
parts:
  a: {box: {size: [2, 1, 1], cells: [2, 1, 1]}, material: m}
  b: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [5, 0, 0], material: m}
  c: {box: {size: [3, 3, 3], cells: [3, 3, 3]}, at: [0, 5, 0], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
)";

struct Built {
  explicit Built(const std::string& more)
      : deck(parse_deck(two_parts + more, "deck.yaml")),
        chunked(load_mesh(deck, Communicator::world())),
        mesh(chunked.mesh),
        exchange(Communicator::world()),
        share(build_surface_share(chunked, deck, find_ties(chunked, deck, Communicator::world()), exchange)),
        surface(make_whole_surface(share)) {}

  double friction(int mesh_node, int face) const {
    for (int n = 0; n < surface.num_nodes; ++n)
      if (surface.nodes(n) == mesh_node) return find_friction(surface, n, face);
    return -2;
  }
  /// Some face of the body.
  int face_of(int body) const {
    for (int f = 0; f < surface.num_faces; ++f)
      if (surface.face_body(f) == body) return f;
    return -1;
  }

  Deck deck;
  ChunkedMesh chunked;
  const Mesh& mesh;
  UnstructuredExchange exchange;
  SurfaceShare share;
  ContactSurface surface;
};

TEST(SurfaceShare, HoldsExteriorFacesAndTheirNodesOnly) {
  const Built b("");
  EXPECT_EQ(b.surface.num_faces, 10 + 6 + 54);
  EXPECT_EQ(b.surface.num_nodes, 12 + 8 + 64 - 8);
}

TEST(SurfaceShare, EveryFaceOfANodeHoldsItAndTheListsAreAscending) {
  const Built b("");
  int entries = 0;
  for (int n = 0; n < b.surface.num_nodes; ++n) {
    EXPECT_TRUE(n == 0 || b.surface.nodes(n - 1) < b.surface.nodes(n));
    for (int j = b.surface.nodes_to_faces_offset(n); j < b.surface.nodes_to_faces_offset(n + 1); ++j, ++entries) {
      const int f = b.surface.nodes_to_faces(j);
      EXPECT_TRUE(j == b.surface.nodes_to_faces_offset(n) || b.surface.nodes_to_faces(j - 1) < f);
      std::set<int> corners;
      for (int i = 0; i < 4; ++i) corners.insert(b.surface.face_corners(f, i));
      EXPECT_EQ(corners.count(n), 1U);
    }
  }
  EXPECT_EQ(entries, 4 * b.surface.num_faces);
}

TEST(SurfaceShare, TheNodesBehindAFaceAreOppositeItsCorners) {
  const Built b("");
  for (int f = 0; f < b.surface.num_faces; ++f) {
    Point3 across{};
    for (int i = 0; i < 4; ++i) {
      const auto p = static_cast<std::size_t>(b.surface.nodes(b.surface.face_corners(f, i)));
      const auto q = static_cast<std::size_t>(b.surface.face_backs(f, i));
      const Vec3 &front = b.mesh.nodes[p], &back = b.mesh.nodes[q];
      const Point3 edge{front[0] - back[0], front[1] - back[1], front[2] - back[2]};
      EXPECT_TRUE(i == 0 || norm(edge - across) < 1e-14);  // the edges of a brick are parallel
      across = edge;
    }
    EXPECT_NEAR(norm(across), 1, 1e-14);
  }
}

TEST(SurfaceShare, ByDefaultEverySurfaceMayTouchEverySurface) {
  const Built b("contact: {friction: 0.3}");
  EXPECT_EQ(b.surface.searched_nodes.extent(0), static_cast<std::size_t>(b.surface.num_nodes));
  EXPECT_EQ(b.friction(0, b.face_of(0)), 0.3);
  EXPECT_EQ(b.friction(0, b.face_of(2)), 0.3);
}

TEST(SurfaceShare, WithoutContactNothingIsSearched) {
  const Built b("contact: {surfaces: none}");
  EXPECT_EQ(b.surface.searched_nodes.extent(0), 0U);
  EXPECT_EQ(b.surface.searched_faces.extent(0), 0U);
}

TEST(SurfaceShare, NamedPairsTouchBothWaysAndNothingElseDoes) {
  const Built b("contact: {surfaces: [[a, b], {a: c, b: c, friction: 0.6}], friction: 0.3}");
  const int on_a = 0, on_b = 12, on_c = 20;
  EXPECT_EQ(b.friction(on_a, b.face_of(1)), 0.3);
  EXPECT_EQ(b.friction(on_b, b.face_of(0)), 0.3);
  EXPECT_EQ(b.friction(on_c, b.face_of(2)), 0.6);
  EXPECT_LT(b.friction(on_a, b.face_of(0)), 0);
  EXPECT_LT(b.friction(on_a, b.face_of(2)), 0);
  EXPECT_LT(b.friction(on_c, b.face_of(1)), 0);
}

TEST(SurfaceShare, ASideTakesItsFacesAndTheirNodesOnly) {
  const Built b("contact: {surfaces: [[a/x_max, b/x_min]]}");
  EXPECT_EQ(b.surface.searched_nodes.extent(0), 8U);
  EXPECT_EQ(b.surface.searched_faces.extent(0), 2U);
}

TEST(SurfaceShare, TheFirstPairThatFitsGivesTheFriction) {
  const Built b("contact: {surfaces: [{a: a, b: b, friction: 0.1}, {a: a/x_max, b: b, friction: 0.9}]}");
  EXPECT_EQ(b.friction(12, b.face_of(0)), 0.1);
}

TEST(SurfaceShare, AnUnknownSurfaceIsRefusedWithItsPlace) {
  try {
    const Built b("contact: {surfaces: [[a, bb]]}");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("deck.yaml:"));
    EXPECT_THAT(e.what(), testing::HasSubstr("bb"));
  }
}

TEST(BuildWalls, AWallStopsEveryNodeOrThoseNamed) {
  const Built all("walls: [{point: [0, 0, 0], normal: [0, 0, 1]}]");
  const WallPairs every = build_walls(all.chunked, all.deck, all.share);
  EXPECT_EQ(every.node.extent(0), all.mesh.nodes.size());
  int inner = 0;
  for (std::size_t p = 0; p < every.node.extent(0); ++p) {
    EXPECT_EQ(every.size(p), 1);
    inner += every.is_inner(p);
  }
  EXPECT_EQ(inner, 8);
  const Built some("walls: [{point: [0, 0, 0], normal: [0, 0, 1], nodes: [b, a/x_min]}]");
  EXPECT_EQ(build_walls(some.chunked, some.deck, some.share).node.extent(0), 12U);
}

}  // namespace
}  // namespace percuss::test
