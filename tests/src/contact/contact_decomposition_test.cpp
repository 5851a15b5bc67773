// The contact decomposition: a rank that owns a node has every face whose box holds it, told once and placed anew in
// every search; parts go to the ranks that have their points.

#include "src/contact/contact_decomposition.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/contact/capture_boxes.hpp"
#include "kernels/contact/point3.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/gather_items.hpp"
#include "src/contact/remote_items.hpp"
#include "src/contact/ties.hpp"
#include "src/deck/read_deck.hpp"
#include "src/mesh/decompose.hpp"

namespace percuss::test {
namespace {

constexpr double face_edge = 0.25;

/// A ball over a long plate, both divided among all ranks.
const char* const scene = R"(
time: {end: 1}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
parts:
  plate: {box: {size: [8, 1, 0.25], cells: [32, 4, 1]}, material: m}
  ball: {sphere: {radius: 0.5, cells: 8}, at: [0.6, 0.5, 0.8], material: m}
contact: {surfaces: all, edges: false}
)";

/// A pair of a node and a box that holds it.
struct Pair {
  std::int64_t node = 0, face = 0;
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

struct NodeItem {
  std::int64_t number;
  double x[3];
};
struct FaceItem {
  std::int64_t number;
  double box[6];
};

class Decomposition : public testing::Test {
 protected:
  Decomposition()
      : world(Communicator::world()),
        deck(parse_deck(scene, "deck.yaml")),
        chunked(load_mesh(deck, world)),
        exchange(world),
        share(build_surface_share(chunked, deck, find_ties(chunked, deck, world), exchange)),
        x("test::x", chunked.mesh.nodes.size()),
        decomposition(world, share, ContactDeck::Rebalance::never) {
    move_ball(0);
  }

  /// The ball at a place along the plate; everything rests.
  void move_ball(double along) {
    for (std::size_t n = 0; n < chunked.mesh.nodes.size(); ++n) {
      const Vec3& p = chunked.mesh.nodes[n];
      store_row(x, static_cast<int>(n), {p[0] + (p[2] > 0.27 ? along : 0), p[1], p[2]});
    }
  }
  /// As a search does.
  void update() {
    decomposition.update({x, x, 0}, margin);
    std::int64_t faces = decomposition.reaching_faces();
    MPI_Allreduce(MPI_IN_PLACE, &faces, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
    decomposition.note_ghost_faces(faces - share.total_searched_faces);
    std::int64_t here = decomposition.count_reaching_here();
    EXPECT_LE(here, static_cast<std::int64_t>(decomposition.faces().size()));
    MPI_Allreduce(MPI_IN_PLACE, &here, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_EQ(here, faces);
  }

  static std::vector<Pair> find_pairs(const std::vector<NodeItem>& nodes, const std::vector<FaceItem>& faces) {
    std::vector<Pair> pairs;
    for (const NodeItem& node : nodes) {
      for (const FaceItem& face : faces) {
        bool holds = true;
        for (int k = 0; k < 3; ++k) holds &= node.x[k] >= face.box[k] && node.x[k] <= face.box[k + 3];
        if (holds) pairs.push_back({node.number, face.number});
      }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  /// Those that ranks find among what they have, all together.
  std::vector<Pair> find_pairs_of_ranks() const {
    std::vector<NodeItem> nodes;
    std::vector<FaceItem> faces;
    const auto places = to_host(decomposition.places());
    const auto boxes = to_host(decomposition.boxes());
    for (std::size_t n = 0; n < decomposition.nodes().size(); ++n)
      nodes.push_back({decomposition.nodes()[n].number, {places(n, 0), places(n, 1), places(n, 2)}});
    for (std::size_t f = 0; f < decomposition.faces().size(); ++f) {
      faces.push_back({decomposition.faces()[f].number, {}});
      for (std::size_t k = 0; k < 6; ++k) faces.back().box[k] = boxes(f, k);
    }
    std::vector<Pair> pairs = gather_items(world, find_pairs(nodes, faces));
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  /// Those of all nodes and all faces.
  std::vector<Pair> find_all_pairs() const {
    std::vector<NodeItem> nodes;
    for (int n = 0; n < share.nodes.count(); ++n) {
      const auto i = static_cast<std::size_t>(n);
      const Point3 p = load_row(x, share.nodes.mesh_nodes[i]);
      nodes.push_back({share.nodes.numbers[i], {p.x, p.y, p.z}});
    }
    const Boxes boxes("test::boxes", share.searched_faces.size());
    bound_faces(ExecSpace(), share.bounded_faces(), {x, x, 0}, margin, boxes);
    const auto host = to_host(boxes);
    std::vector<FaceItem> faces;
    for (std::size_t f = 0; f < share.searched_faces.size(); ++f) {
      faces.push_back({share.faces[static_cast<std::size_t>(share.searched_faces[f])].number, {}});
      for (std::size_t k = 0; k < 6; ++k) faces.back().box[k] = host(f, k);
    }
    return find_pairs(gather_items(world, nodes), gather_items(world, faces));
  }

  static constexpr double margin = 0.5 * face_edge;
  const Communicator world;
  const Deck deck;
  const ChunkedMesh chunked;
  UnstructuredExchange exchange;
  const SurfaceShare share;
  Rows3<double> x;
  ContactDecomposition decomposition;
};

TEST_F(Decomposition, OwnersOfNodesHaveEveryFaceWhoseBoxHoldsOne) {
  update();
  EXPECT_TRUE(decomposition.has_changed());
  EXPECT_EQ(find_pairs_of_ranks(), find_all_pairs());
}

TEST_F(Decomposition, NothingIsToldAgainUntilFacesHaveMovedOn) {
  update();
  const std::size_t faces = decomposition.faces().size();
  move_ball(0.3 * face_edge);
  update();
  EXPECT_FALSE(decomposition.has_changed());
  EXPECT_EQ(decomposition.faces().size(), faces);
  EXPECT_EQ(find_pairs_of_ranks(), find_all_pairs());
}

TEST_F(Decomposition, FacesThatMoveOnReachTheRanksWhoseNodesTheyMeet) {
  update();
  const std::vector<Pair> at_first = find_all_pairs();
  int told = 0;
  for (int i = 1; i <= 30; ++i) {
    move_ball(0.2 * i);
    update();
    told += decomposition.has_changed() ? 1 : 0;
    ASSERT_EQ(find_pairs_of_ranks(), find_all_pairs()) << i;
  }
  EXPECT_NE(find_all_pairs(), at_first);  // else the scene tests nothing
  EXPECT_GE(told, world.size() > 1 ? 1 : 0);
  EXPECT_LT(told, 30);
}

TEST_F(Decomposition, PartsGoToTheRanksThatHaveMostOfTheirPoints) {
  update();
  const std::vector<int>& rank_of_part = decomposition.parts().rank_of_part();
  std::int64_t counts[3] = {0, 0, 0};  // nodes with one owner in both, with parts in order of ranks, and all
  for (const int owner : decomposition.node_owners()) {
    counts[0] += owner == world.rank() ? 1 : 0;
    counts[1] += rank_of_part[static_cast<std::size_t>(world.rank())] == owner ? 1 : 0;
    ++counts[2];
  }
  MPI_Allreduce(MPI_IN_PLACE, counts, 3, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_GE(counts[0], counts[1]);
  EXPECT_GT(3 * counts[0], counts[2]);  // seven ranks have hardly a chunk each
  if (world.size() <= 3) {
    EXPECT_GT(2 * counts[0], counts[2]);
  }
}

TEST(RemoteItems, ArePartlyAskedForAndRecordsFindTheirOwners) {
  const Communicator world = Communicator::world();
  UnstructuredExchange exchange(world);
  DataExchange data(world);
  // Item i is with rank i % size, at the place 10 i there; every rank asks for all of them.
  std::vector<std::int64_t> numbers;
  std::vector<int> owners;
  for (int i = 0; i < 23; ++i) {
    numbers.push_back(i);
    owners.push_back(i % world.size());
  }
  RemoteItems items;
  items.name(exchange, data, owners, numbers, [](std::int64_t number) { return static_cast<int>(10 * number); });
  EXPECT_EQ(items.all().asked.size() + items.all().own.size(), numbers.size());

  const auto is_wanted_by = [](int rank, int item) { return (item + rank) % 3 == 0; };
  std::vector<char> is_wanted;
  for (int i = 0; i < 23; ++i) is_wanted.push_back(is_wanted_by(world.rank(), i) ? 1 : 0);
  const ItemPart part = items.select(data, is_wanted);
  std::vector<int> sent;
  for (const int place : part.published) sent.push_back(place + 1);
  const std::vector<int> answers = data.exchange(reverse(part.request), sent);
  ASSERT_EQ(answers.size(), part.asked.size());
  std::vector<int> found(23, 0);
  for (std::size_t k = 0; k < answers.size(); ++k) found[static_cast<std::size_t>(part.asked[k])] = answers[k];
  for (std::size_t k = 0; k < part.own.size(); ++k)
    found[static_cast<std::size_t>(part.own[k])] = part.own_places[k] + 1;
  for (int i = 0; i < 23; ++i)
    EXPECT_EQ(found[static_cast<std::size_t>(i)], is_wanted_by(world.rank(), i) ? 10 * i + 1 : 0) << i;

  // A record about every second item of those wanted goes to the owner of the item.
  std::vector<int> to, records;
  for (int i = 0; i < 23; i += 2) {
    if (!is_wanted_by(world.rank(), i)) continue;
    to.push_back(i % world.size());
    records.push_back(100 * world.rank() + i);
  }
  std::vector<int> received = send_to_partners(data, world.rank(), part.request, to, records), expected;
  std::sort(received.begin(), received.end());
  for (int rank = 0; rank < world.size(); ++rank)
    for (int i = 0; i < 23; i += 2)
      if (is_wanted_by(rank, i) && i % world.size() == world.rank()) expected.push_back(100 * rank + i);
  EXPECT_EQ(received, expected);
}

}  // namespace
}  // namespace percuss::test
