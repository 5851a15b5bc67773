// The contact decomposition: a rank that owns a node has every face whose box holds it, told once and placed anew in
// every search; parts go to the ranks that have their points.

#include "src/contact/ranks/contact_decomposition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "comm/gather_items.hpp"
#include "kernels/contact/geometry/point3.hpp"
#include "kernels/contact/search/capture_boxes.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/ranks/remote_items.hpp"
#include "src/contact/ties/ties.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "tests/expect_error.hpp"

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

constexpr double margin = 0.5 * face_edge;

std::vector<Pair> find_pairs(const std::vector<NodeItem>& nodes, const std::vector<FaceItem>& faces) {
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

/// The sum over all ranks.
std::int64_t add_up(std::int64_t count) {
  MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  return count;
}

/// The surface of a scene, and where its nodes are.
struct Surface {
  explicit Surface(const std::string& text)
      : deck(parse_deck(text, "deck.yaml")),
        chunked(load_mesh(deck, world)),
        exchange(world),
        share(build_surface_share(chunked, deck, find_ties(chunked, deck, world), exchange)),
        x("test::x", chunked.mesh.nodes.size()) {
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
  void update(ContactDecomposition& decomposition) const {
    const SurfaceMotion still{x, x, 0};
    decomposition.send_contact_data_to_previous_owners(still);
    decomposition.rebalance();
    decomposition.share_cuts();
    decomposition.send_points_to_owners();
    decomposition.find_reached_ranks(still, margin);
    decomposition.send_overlapping_faces();
    const std::int64_t faces = add_up(decomposition.reaching_faces());
    decomposition.decide_rebalance(faces - share.total_searched_faces);
    const std::int64_t here = decomposition.count_reaching_here();
    EXPECT_LE(here, static_cast<std::int64_t>(decomposition.faces().size()));
    EXPECT_EQ(add_up(here), faces);
  }

  /// Pairs that ranks find among what they have, all together.
  std::vector<Pair> find_pairs_of_ranks(const ContactDecomposition& decomposition) const {
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

  /// Pairs of all nodes and all faces.
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

  const Communicator world = Communicator::world();
  const Deck deck;
  const ChunkedMesh chunked;
  UnstructuredExchange exchange;
  const SurfaceShare share;
  Rows3<double> x;
};

class Decomposition : public testing::Test, protected Surface {
 protected:
  Decomposition() : Surface(scene), decomposition(world, share, ContactDeck::Rebalance::never) {}

  void update() { Surface::update(decomposition); }
  std::vector<Pair> find_pairs_of_ranks() const { return Surface::find_pairs_of_ranks(decomposition); }

  ContactDecomposition decomposition;
};

TEST_F(Decomposition, OwnersOfNodesHaveEveryFaceWhoseBoxHoldsOne) {
  update();
  EXPECT_TRUE(decomposition.has_changed());
  EXPECT_EQ(find_pairs_of_ranks(), find_all_pairs());
}

TEST_F(Decomposition, NothingIsToldAgainUntilFacesHaveMovedOn) {
  update();
  bool was_told = false;  // since the start, to ranks that wider boxes reach
  for (int i = 1; i <= 10; ++i) {
    const std::size_t faces = decomposition.faces().size();
    move_ball(0.3 * i * face_edge);
    update();
    if (was_told) {
      EXPECT_FALSE(decomposition.has_changed()) << i;
      EXPECT_EQ(decomposition.faces().size(), faces) << i;
    }
    was_told = decomposition.has_changed();
    EXPECT_EQ(find_pairs_of_ranks(), find_all_pairs()) << i;
  }
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

TEST_F(Decomposition, FacesThatReachOthersAgainAreToldWiderThanTheFirstTime) {
  update();
  const std::int64_t at_first = add_up(static_cast<std::int64_t>(decomposition.faces().size()));
  EXPECT_EQ(at_first, add_up(decomposition.reaching_faces()));
  for (int i = 1; i <= 30; ++i) {
    move_ball(0.2 * i);
    update();
    if (!decomposition.has_changed()) continue;
    EXPECT_GT(add_up(static_cast<std::int64_t>(decomposition.faces().size())), add_up(decomposition.reaching_faces()));
    return;
  }
  EXPECT_EQ(world.size(), 1);
}

TEST_F(Decomposition, PartsGoToTheRanksThatHaveMostOfTheirPoints) {
  update();
  std::int64_t own = 0;
  for (const int owner : decomposition.node_owners()) own += owner == world.rank() ? 1 : 0;
  const std::int64_t all = add_up(share.nodes.count());
  // How many nodes would have their part on their rank if parts went to ranks in another order: shifted by one.
  std::int64_t turned = 0;
  for (const int owner : decomposition.node_owners()) turned += (owner + 1) % world.size() == world.rank() ? 1 : 0;
  own = add_up(own);
  if (world.size() > 1) {
    EXPECT_GT(own, add_up(turned));
  }
  EXPECT_GT((world.size() <= 3 ? 2 : 3) * own, all);  // seven ranks have hardly a chunk each
}

/// As erosion leaves it: of the plate a part is gone.
const char* const shorter = R"(
time: {end: 1}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
parts:
  plate: {box: {size: [5, 1, 0.25], cells: [20, 4, 1]}, material: m}
  ball: {sphere: {radius: 0.5, cells: 8}, at: [0.6, 0.5, 0.8], material: m}
contact: {surfaces: all, edges: false}
)";

TEST(ContactDecomposition, ASurfaceMadeAnewGoesOnWithTheCutsAndStaysBalanced) {
  const Communicator world = Communicator::world();
  Surface whole(scene), left(shorter);
  for (const auto rebalance :
       {ContactDeck::Rebalance::never, ContactDeck::Rebalance::automatic, ContactDeck::Rebalance::always}) {
    ContactDecomposition before(world, whole.share, rebalance);
    whole.update(before);
    whole.update(before);
    ContactDecomposition after(world, left.share, rebalance);
    after.take_over(before);
    for (int i = 0; i < 3; ++i) {
      left.update(after);
      EXPECT_EQ(after.was_rebalanced(), rebalance == ContactDeck::Rebalance::always ||
                                            (rebalance == ContactDeck::Rebalance::automatic && i == 0))
          << i;
      EXPECT_EQ(left.find_pairs_of_ranks(after), left.find_all_pairs()) << i;
      if (rebalance == ContactDeck::Rebalance::never) continue;  // the cuts are those of the whole plate
      std::int64_t most = static_cast<std::int64_t>(after.nodes().size());
      const std::int64_t all = add_up(most);
      MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_INT64_T, MPI_MAX, MPI_COMM_WORLD);
      EXPECT_EQ(all, add_up(left.share.nodes.count())) << i;
      EXPECT_LT(10 * most * world.size(), 13 * all) << i;  // even are nodes and faces together
    }
  }
}

TEST(RemoteItems, ArePartlyAskedForAndRecordsFindTheirOwners) {
  const Communicator world = Communicator::world();
  UnstructuredExchange exchange(world);
  DataExchange data(world);
  // Item i is with rank i % size, at the place 10 i there; every rank requests all of them.
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
  // One for a rank that is not among the partners.
  EXPECT_ERROR(send_to_partners<int>(data, -1, ExchangePlan(), {world.rank()}, {1}), std::logic_error, "no partner");
}

}  // namespace
}  // namespace percuss::test
