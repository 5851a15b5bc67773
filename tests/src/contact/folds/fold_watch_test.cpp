// Edges that become sharp in the run, on one rank and on several.

#include "src/contact/surface/fold_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/contact/overlap/start_overlap.hpp"
#include "src/contact/ties/ties.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/mesh/decomposition/decompose.hpp"

namespace percuss::test {
namespace {

/// A strip of elements along x, in several chunks where it is long.
struct Strip {
  Strip(const std::string& shape, const Communicator& world, const std::string& surfaces = "all")
      : ranks(world),
        deck(parse_deck("time: {end: 1}\nparts: {a: {" + shape + ", material: m}}\ncontact: {surfaces: " + surfaces +
                            "}\nmaterials: {m: {model: elastic, density: 1, "
                            "youngs_modulus: 1, poissons_ratio: 0}}\n",
                        "deck.yaml")),
        chunked(load_mesh(deck, ranks)),
        exchange(ranks),
        share(build_surface_share(chunked, deck, find_ties(chunked, deck, ranks), exchange)),
        watch(chunked, deck.contact, ranks) {}

  /// Bends every line of nodes across the strip at whole x by this angle, upwards convex. Whether folds changed.
  bool bend(double degrees, long step = slow_fold_steps) {
    const double turn = degrees * 0.017453292519943295;
    const Rows3<double> x("x", chunked.mesh.nodes.size());
    const auto host = Kokkos::create_mirror_view(x);
    for (std::size_t n = 0; n < chunked.mesh.nodes.size(); ++n) {
      const Vec3& at = chunked.mesh.nodes[n];
      const int lines = static_cast<int>(std::lround(at[0]));
      double along = 0, up = 0;
      for (int i = 0; i < lines; ++i) {
        along += std::cos((i - 0.5) * turn);
        up -= std::sin((i - 0.5) * turn);
      }
      host(n, 0) = along;
      host(n, 1) = at[1];
      host(n, 2) = at[2] + up;
    }
    Kokkos::deep_copy(x, host);
    return watch.look(share, x, step);
  }

  /// Presses all to this share of its width along y. Whether folds changed.
  bool press(double share_left) {
    const Rows3<double> x("x", chunked.mesh.nodes.size());
    const auto host = Kokkos::create_mirror_view(x);
    for (std::size_t n = 0; n < chunked.mesh.nodes.size(); ++n)
      for (std::size_t d = 0; d < 3; ++d) host(n, d) = (d == 1 ? share_left : 1) * chunked.mesh.nodes[n][d];
    Kokkos::deep_copy(x, host);
    return watch.look(share, x, slow_fold_steps);
  }

  /// Lifts nodes of the lowest unit cube by x y times this. Whether folds changed.
  bool twist(double lift) {
    const Rows3<double> x("x", chunked.mesh.nodes.size());
    const auto host = Kokkos::create_mirror_view(x);
    for (std::size_t n = 0; n < chunked.mesh.nodes.size(); ++n) {
      const Vec3& at = chunked.mesh.nodes[n];
      for (std::size_t d = 0; d < 3; ++d) host(n, d) = at[d] + (d == 2 && at[2] < 2 ? lift * at[0] * at[1] : 0);
    }
    Kokkos::deep_copy(x, host);
    return watch.look(share, x, slow_fold_steps);
  }

  Communicator ranks;
  Deck deck;
  ChunkedMesh chunked;
  UnstructuredExchange exchange;
  SurfaceShare share;
  FoldWatch watch;
};

const std::string two_elements = "box: {size: [2, 1, 1], cells: [2, 1, 1]}";
const std::string long_strip = "box: {size: [40, 4, 1], cells: [40, 4, 1]}";
const std::string two_cubes =
    "box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: m}, b: {at: [0, 0, 5], box: {size: [1, 1, 1], cells: [1, 1, "
    "1]}";
const std::string shell_strip = "shell_plate: {size: [2, 1], cells: [2, 1]}, thickness: 0.01";

}  // namespace

TEST(FoldWatch, AFlatEdgeFoldsAtTenDegreesAndIsSmoothAgainAtFive) {
  Strip strip(two_elements, Communicator(MPI_COMM_SELF));
  EXPECT_FALSE(strip.bend(9.9));
  EXPECT_TRUE(strip.bend(10.1));
  ASSERT_EQ(strip.watch.folds().size(), 1U);  // the top; the bottom is concave
  EXPECT_FALSE(strip.bend(10.1));
  EXPECT_FALSE(strip.bend(5.1));
  EXPECT_TRUE(strip.bend(4.9));
  EXPECT_TRUE(strip.watch.folds().empty());
  EXPECT_TRUE(strip.bend(-10.1));  // the bottom
  EXPECT_EQ(strip.watch.folds().size(), 1U);
}

// An edge that folds fast makes a new surface at the next look, with all that fold by then.
TEST(FoldWatch, SlowFoldsWaitForALookAtAll) {
  Strip strip(two_elements, Communicator(MPI_COMM_SELF));
  EXPECT_FALSE(strip.bend(15, fold_steps));
  EXPECT_FALSE(strip.bend(19.9, fold_steps));
  EXPECT_TRUE(strip.bend(20.1, fold_steps));
  EXPECT_EQ(strip.watch.folds().size(), 1U);
  EXPECT_FALSE(strip.bend(0, fold_steps));
  EXPECT_TRUE(strip.bend(0));
}

// The triangles beside a diagonal are at the angle of cosine 1 / (1 + lift^2).
TEST(FoldWatch, TheDiagonalThatStandsOutOfAWarpedFaceIsAnEdge) {
  Strip strip(two_cubes, Communicator(MPI_COMM_SELF));
  const auto before = strip.share.total_edges;
  EXPECT_FALSE(strip.twist(0.061));
  ASSERT_TRUE(strip.twist(0.063));
  ASSERT_EQ(strip.watch.folds().size(), 2U);  // of the top and, across it, of the bottom
  EXPECT_FALSE(strip.twist(0.026));
  const TiedSurfaces ties = find_ties(strip.chunked, strip.deck, strip.ranks);
  EXPECT_TRUE(change_folds(strip.chunked, strip.deck, ties, strip.exchange, strip.watch.folds(), strip.share));
  EXPECT_EQ(strip.share.total_edges, before + 2);
  EXPECT_EQ(std::count_if(strip.share.edges.begin(), strip.share.edges.end(),
                          [](const EdgeTopology& edge) { return edge.is_blunt == warped_ridge; }),
            2);
  EXPECT_TRUE(strip.twist(0.024));
  EXPECT_TRUE(strip.watch.folds().empty());
}

TEST(FoldWatch, AFoldIsAnEdgeOfTheSurface) {
  Strip strip(two_elements, Communicator(MPI_COMM_SELF));
  const auto before = strip.share.total_edges;
  ASSERT_TRUE(strip.bend(20));
  const SurfaceShare share =
      build_surface_share(strip.chunked, strip.deck, find_ties(strip.chunked, strip.deck, strip.ranks), strip.exchange,
                          strip.watch.folds());
  EXPECT_EQ(share.total_edges, before + 1);
}

namespace {

/// Changes the folds of the strip's share, which then is as one made anew. Whether all but its edges stayed.
bool change_and_compare(Strip& strip) {
  const TiedSurfaces ties = find_ties(strip.chunked, strip.deck, strip.ranks);
  const SurfaceShare fresh = build_surface_share(strip.chunked, strip.deck, ties, strip.exchange, strip.watch.folds());
  const bool stayed = change_folds(strip.chunked, strip.deck, ties, strip.exchange, strip.watch.folds(), strip.share);
  const SurfaceShare& share = strip.share;
  EXPECT_EQ(share.classes.sets, fresh.classes.sets);
  EXPECT_EQ(share.nodes.classes, fresh.nodes.classes);
  EXPECT_EQ(share.face_searched, fresh.face_searched);
  EXPECT_EQ(share.edge_ends, fresh.edge_ends);
  EXPECT_EQ(share.edge_piece, fresh.edge_piece);
  EXPECT_EQ(share.total_edges, fresh.total_edges);
  EXPECT_EQ(share.edges.size(), fresh.edges.size());
  for (std::size_t e = 0; e < std::min(share.edges.size(), fresh.edges.size()); ++e) {
    const EdgeTopology &edge = share.edges[e], &of = fresh.edges[e];
    EXPECT_EQ(edge.number, of.number);
    EXPECT_EQ(edge.surface_class, of.surface_class);
    EXPECT_EQ(edge.pieces, of.pieces);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(edge.wings[k], of.wings[k]);
  }
  return stayed;
}

}  // namespace

TEST(FoldWatch, FoldsChangeTheEdgesOfTheSurfaceAlone) {
  Strip strip(long_strip, Communicator::world());
  for (const double degrees : {12.0, -12.0, 0.0}) {
    ASSERT_TRUE(strip.bend(degrees));
    EXPECT_TRUE(change_and_compare(strip));
  }
}

// A tube of 16 elements around: its edges of 22 degrees touch only what has crossed them. Pressed flat, four of them on
// each side fold, and what they overlap by from then on is accepted.
TEST(FoldWatch, ABluntEdgeThatFoldsIsNewAndOneThatDoesNotIsNot) {
  Strip strip("tube: {inner_radius: 0.6, outer_radius: 1, length: 1, cells: [1, 16, 1]}", Communicator(MPI_COMM_SELF));
  const std::vector<EdgeTopology> before = strip.share.edges;
  EXPECT_TRUE(list_fresh_edges({before, before, {}}).empty());
  ASSERT_TRUE(strip.press(0.5));
  ASSERT_TRUE(change_and_compare(strip));
  std::vector<std::int64_t> folded;
  for (std::size_t e = 0; e < before.size(); ++e)
    if (before[e].is_blunt > strip.share.edges[e].is_blunt) folded.push_back(before[e].number);
  EXPECT_GE(folded.size(), 2U);
  EXPECT_EQ(list_fresh_edges({before, strip.share.edges, {}}), folded);
  EXPECT_TRUE(list_fresh_edges({strip.share.edges, before, {}}).empty());  // smooth again
  const std::vector<std::int64_t> released{before[0].ends[0]};
  EXPECT_FALSE(list_fresh_edges({before, before, released}).empty());
}

// The fold lies on the surfaces of both faces, and its nodes on those of a third one: no node or face has its class.
TEST(FoldWatch, AFoldOfANewClassMakesAllAnew) {
  Strip strip(two_elements, Communicator(MPI_COMM_SELF),
              "[{a: {name: a/z_max, inside: [[-1, -1, -1], [1.1, 2, 2]]}, b: a/z_min}, "
              "{a: {name: a/z_max, inside: [[0.9, -1, -1], [3, 2, 2]]}, b: a/z_min}, {a: a/y_min, b: a/y_max}]");
  ASSERT_TRUE(strip.bend(12));
  EXPECT_FALSE(change_and_compare(strip));
  ASSERT_TRUE(strip.bend(0));
  EXPECT_FALSE(change_and_compare(strip));
}

TEST(FoldWatch, AShellFoldsBothWays) {
  Strip strip(shell_strip, Communicator(MPI_COMM_SELF));
  for (const double degrees : {-11.0, 11.0}) {
    EXPECT_TRUE(strip.bend(degrees));
    EXPECT_EQ(strip.watch.folds().size(), 1U);
    EXPECT_TRUE(strip.bend(0));
  }
}

TEST(FoldWatch, FindsTheSameOnAnyRanks) {
  Strip alone(long_strip, Communicator(MPI_COMM_SELF)), together(long_strip, Communicator::world());
  for (const double degrees : {9.0, 12.0, 7.0, -12.0, 0.0}) {
    EXPECT_EQ(alone.bend(degrees), together.bend(degrees));
    EXPECT_EQ(alone.watch.folds(), together.watch.folds());
    if (degrees == 12.0) {
      EXPECT_EQ(alone.watch.folds().size(), 4U * 39U);
    }
  }
}

}  // namespace percuss::test
