// How often the ranks wait for each other in a step of contact: MPI's own calls are counted (its profiling interface).

#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>

#include "src/contact/contact_stage.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/mesh/decomposition/decompose.hpp"

namespace {

struct Counts {
  int collectives = 0, sends = 0;
};
Counts counted;

}  // namespace

extern "C" {

int MPI_Allreduce(const void* send, void* receive, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  ++counted.collectives;
  return PMPI_Allreduce(send, receive, count, type, op, comm);
}

int MPI_Reduce_scatter_block(const void* send, void* receive, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  ++counted.collectives;
  return PMPI_Reduce_scatter_block(send, receive, count, type, op, comm);
}

int MPI_Bcast(void* buffer, int count, MPI_Datatype type, int root, MPI_Comm comm) {
  ++counted.collectives;
  return PMPI_Bcast(buffer, count, type, root, comm);
}

int MPI_Comm_create_group(MPI_Comm comm, MPI_Group group, int tag, MPI_Comm* made) {
  ++counted.collectives;
  return PMPI_Comm_create_group(comm, group, tag, made);
}

int MPI_Isend(const void* buffer, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* request) {
  ++counted.sends;
  return PMPI_Isend(buffer, count, type, to, tag, comm, request);
}
}

namespace percuss::test {
namespace {

const std::string head =
    "time: {end: 1}\nmaterials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}\n";

/// Two stacks of two bricks, far apart.
const std::string stacks = R"(
parts:
  low: {box: {size: [1, 1, 0.4], cells: [4, 4, 2]}, material: m}
  high: {box: {size: [1, 1, 0.4], cells: [4, 4, 2]}, at: [0, 0, 0.4005], material: m}
  far_low: {box: {size: [1, 1, 0.4], cells: [4, 4, 2]}, at: [50, 0, 0], material: m}
  far_high: {box: {size: [1, 1, 0.4], cells: [4, 4, 2]}, at: [50, 0, 0.5], material: m}
contact: {surfaces: all}
)";

/// Two bricks that the search pairs, but out of reach of the check.
const std::string apart = R"(
parts:
  low: {box: {size: [1, 1, 0.4], cells: [4, 4, 2]}, material: m}
  high: {box: {size: [1, 1, 0.4], cells: [4, 4, 2]}, at: [0, 0, 0.52], material: m}
contact: {surfaces: all}
)";

/// The scene, in which each step presses `high` on `low` from the same places.
struct Scene {
  explicit Scene(const std::string& text)
      : deck(parse_deck(text + head, "deck.yaml")),
        chunked(load_mesh(deck, world)),
        stage(chunked, deck, world),
        x("test::x", count()),
        v("test::v", count()),
        before("test::before", count()),
        inverse_mass("test::inverse_mass", count()),
        impulse("test::impulse", count()) {
    Kokkos::deep_copy(inverse_mass, 1);
    for (std::size_t n = 0; n < count(); ++n)
      for (std::size_t k = 0; k < 3; ++k) x(n, k) = chunked.mesh.nodes[n][k];
    stage.prepare(x, v);
  }

  std::size_t count() const { return chunked.mesh.nodes.size(); }
  ContactReport step() {
    for (std::size_t n = 0; n < count(); ++n) v(n, 2) = x(n, 0) < 10 && x(n, 2) > 0.4 ? -1 : 0;
    Kokkos::deep_copy(before, v);
    counted = {};
    return stage.apply({x, before, v, inverse_mass, impulse, 1e-3});
  }

  const Communicator world = Communicator::world();
  const Deck deck;
  ChunkedMesh chunked;
  ContactStage stage;
  Rows3<double> x, v, before, inverse_mass, impulse;
};

int find_least(int value) {
  PMPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return value;
}
int find_most(int value) {
  PMPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return value;
}

}  // namespace

// The bound of the search, who has rows, what was done; besides, one for each iteration where there are rows.
TEST(ContactCollectives, AreThreeAStepAndOneAnIterationWhereThereAreRows) {
  Scene scene(stacks);
  for (int i = 0; i < 3; ++i) scene.step();
  const ContactReport report = scene.step();
  ASSERT_FALSE(report.searched);
  ASSERT_GT(report.interactions, 0);
  ASSERT_GT(report.iterations, 0);
  if (scene.world.size() == 1) {
    EXPECT_EQ(counted.sends, 0);
    return;
  }
  const int least = find_least(counted.collectives), most = find_most(counted.collectives);
  EXPECT_TRUE(most == 3 || most == 3 + report.iterations) << most;  // 3: one rank has all rows
  if (scene.world.size() >= 4) {
    EXPECT_EQ(least, 3);  // the far stack has none
  }
}

TEST(ContactCollectives, AreTwoAStepWhereNothingTouches) {
  Scene scene(stacks);
  for (int i = 0; i < 3; ++i) scene.step();
  for (std::size_t n = 0; n < scene.count(); ++n)
    if (scene.x(n, 0) < 10 && scene.x(n, 2) > 0.4) scene.x(n, 2) += 0.01;  // lifted
  scene.step();
  const ContactReport report = scene.step();
  ASSERT_EQ(report.interactions, 0);
  if (scene.world.size() == 1 || report.searched) return;
  EXPECT_LE(find_most(counted.collectives), 2);
}

// Nodes, faces and edges alike: what is out of reach until surfaces have moved costs no message.
TEST(ContactCollectives, NothingIsSentForPairsOutOfReach) {
  Scene scene(apart);
  for (int i = 0; i < 3; ++i) scene.step();
  const ContactReport report = scene.step();
  ASSERT_FALSE(report.searched);
  ASSERT_GT(report.candidates, 0);
  EXPECT_EQ(find_most(counted.sends), 0);
  EXPECT_EQ(find_most(counted.collectives), scene.world.size() > 1 ? 2 : 0);
}

}  // namespace percuss::test
