// The shares of several ranks against the mesh that one rank alone makes.

#include "src/mesh/decomposition/decompose.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <numeric>
#include <set>

#include "comm/agreement.hpp"
#include "src/error.hpp"
#include "src/mesh/decomposition/chunk_graph.hpp"
#include "src/mesh/pieces/check_pieces.hpp"
#include "src/mesh/topology/connectivity.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/mesh/exodus_writer.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using testing::ElementsAre;
using testing::HasSubstr;

std::size_t at(std::int64_t index) { return static_cast<std::size_t>(index); }

/// A generated part as a file: 5 x 4 x 6 cells, so that it has several chunks, with ids of its own and two sets.
WrittenMesh make_written_block() {
  const PartMesh block = make_part_mesh(BoxShape{{1, 1, 1}, {5, 4, 6}});
  WrittenMesh written;
  written.nodes = block.nodes;
  WrittenBlock cells;
  cells.name = "cells";
  for (std::size_t e = 0; e < block.elements.size(); ++e) {
    for (const int n : block.elements.corners(e)) cells.corners.push_back(n + 1);
  }
  written.blocks.push_back(cells);
  written.node_sets.push_back({3, "some", {1, 8, 40, 100, 210}, {}});
  written.side_sets.push_back({4, "low", {1, 2, 7, 120}, {5, 5, 4, 6}});
  for (std::size_t n = 0; n < block.nodes.size(); ++n) written.node_ids.push_back(10 * static_cast<int>(n) + 7);
  for (std::size_t e = 0; e < block.elements.size(); ++e) written.element_ids.push_back(5000 - static_cast<int>(e));
  return written;
}

/// A block of solids with a sheet on it: squares, of which every third is two triangles, one in a block of its own.
WrittenMesh make_covered_block() {
  WrittenMesh written = make_written_block();
  written.node_ids.clear();
  written.element_ids.clear();
  WrittenBlock squares{20, "squares", "SHELL4", 4, {}}, halves{30, "halves", "TRI3", 3, {}};
  const PartMesh block = make_part_mesh(BoxShape{{1, 1, 1}, {5, 4, 6}});
  int count = 0;
  for (const auto& [name, faces] : block.side_sets) {
    for (const ElementFace& face : faces) {
      const std::array<int, 4> nodes = block.elements.face_nodes(face);
      const std::int64_t a = nodes[0] + 1, b = nodes[1] + 1, c = nodes[2] + 1, d = nodes[3] + 1;
      const bool is_cut = ++count % 3 == 0;
      squares.corners.insert(squares.corners.end(), {a, b, c, is_cut ? c : d});
      if (is_cut) halves.corners.insert(halves.corners.end(), {a, c, d});
    }
  }
  written.blocks.push_back(squares);
  written.blocks.push_back(halves);
  return written;
}

/// The file is there, on every rank, while this lives.
class SharedFile {
 public:
  explicit SharedFile(const WrittenMesh& written, const std::string& name) {
    const Communicator world = Communicator::world();
    if (world.rank() == 0) path_ = write_exodus(written, name);
    path_ = broadcast_text(world, path_, 0);
  }
  ~SharedFile() {
    Communicator::world().barrier();
    if (Communicator::world().rank() == 0) std::remove(path_.c_str());
  }
  SharedFile(const SharedFile&) = delete;
  SharedFile& operator=(const SharedFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Parts of every kind: a file between generated ones, an array, small bodies that share chunks.
Deck make_scene(const std::string& file) {
  PartDeck ball = make_part_deck("ball", SphereShape{1, 9}), block = make_part_deck("block", FileMesh{file, {}, 2});
  PartDeck bricks = make_part_deck("bricks", BoxShape{{1, 1, 1}, {4, 3, 5}});
  bricks.array = ArrayCopies{{2, 3, 2}, {1.1, 1.1, 1.1}, 0.5};
  bricks.at = {10, 0, 0};
  block.array = ArrayCopies{{2, 1, 1}, {3, 0, 0}, 0};
  block.rotate.push_back({{0, 0, 1}, 33, {}});
  PartDeck dice = make_part_deck("dice", BoxShape{{1, 1, 1}, {2, 2, 2}});
  dice.array = ArrayCopies{{5, 4, 1}, {2, 2, 2}, 0};
  return make_deck({ball, block, bricks, dice, make_part_deck("rod", CylinderShape{0.1, 5, 5, 30}),
                    make_part_deck("arch", TubeShape{2, 3, 1, {2, 17, 5}, 180})});
}

Communicator self() { return Communicator(MPI_COMM_SELF); }

class Decomposition : public testing::Test {
 protected:
  Decomposition()
      : file_(make_written_block(), "decompose.exo"),
        deck_(make_scene(file_.path())),
        whole_(load_mesh(deck_, self())),
        share_(load_mesh(deck_, Communicator::world())) {}

  /// Place in the whole mesh of each of the share's elements.
  std::vector<std::size_t> list_numbers() const {
    std::vector<std::size_t> numbers;
    for (const Chunk& chunk : share_.chunks) {
      for (int e = 0; e < chunk.element_count; ++e) {
        numbers.push_back(at(share_.numbering.first_element[at(chunk.number)] + e));
      }
    }
    return numbers;
  }

  SharedFile file_;
  Deck deck_;
  ChunkedMesh whole_, share_;
};

TEST_F(Decomposition, NumbersTheMeshAsOneRankDoes) {
  EXPECT_EQ(share_.numbering.first_element, whole_.numbering.first_element);
  EXPECT_EQ(share_.numbering.first_node, whole_.numbering.first_node);
  EXPECT_EQ(share_.numbering.element_count(), static_cast<std::int64_t>(whole_.mesh.elements.size()));
  EXPECT_EQ(share_.numbering.node_count(), static_cast<std::int64_t>(whole_.mesh.nodes.size()));
}

TEST_F(Decomposition, GivesEachRankTheChunksThatTheTableSays) {
  std::vector<int> held;
  for (std::size_t c = 0; c < share_.numbering.ranks.size(); ++c) {
    if (share_.numbering.ranks[c] == Communicator::world().rank()) held.push_back(static_cast<int>(c));
  }
  ASSERT_EQ(share_.chunks.size(), held.size());
  int next = 0;
  for (std::size_t i = 0; i < held.size(); ++i) {
    const Chunk& chunk = share_.chunks[i];
    EXPECT_EQ(chunk, (Chunk{next, whole_.chunks[at(held[i])].element_count, whole_.chunks[at(held[i])].part, held[i]}));
    next += chunk.element_count;
  }
  EXPECT_EQ(at(next), share_.mesh.elements.size());
}

TEST_F(Decomposition, HoldsTheElementsOfTheWholeMesh) {
  const std::vector<std::size_t> numbers = list_numbers();
  ASSERT_EQ(numbers.size(), share_.mesh.elements.size());
  std::set<std::int64_t> used;
  for (std::size_t e = 0; e < numbers.size(); ++e) {
    const std::size_t n = numbers[e];
    EXPECT_EQ(share_.mesh.element_ids[e], whole_.mesh.element_ids[n]);
    EXPECT_EQ(share_.mesh.elements.block_index(e), whole_.mesh.elements.block_index(n));
    EXPECT_EQ(share_.mesh.bodies[e], whole_.mesh.bodies[n]);
    EXPECT_EQ(share_.mesh.exterior[e], whole_.mesh.exterior[n]);
    ASSERT_EQ(share_.mesh.corners(e).size(), whole_.mesh.corners(n).size());
    for (std::size_t c = 0; c < share_.mesh.corners(e).size(); ++c) {
      const std::int64_t node = share_.mesh.node_numbers[at(share_.mesh.corners(e)[c])];
      EXPECT_EQ(node, whole_.mesh.corners(n)[c]);
      used.insert(node);
    }
  }
  EXPECT_EQ(share_.mesh.node_numbers, std::vector<std::int64_t>(used.begin(), used.end()));
}

TEST(DecompositionOfBlocks, TellsAllRanksOfThemAndSendsCornersAsTheTopologyHasThem) {
  const SharedFile file(make_covered_block(), "covered.exo");
  PartDeck covered = make_part_deck("covered", FileMesh{file.path(), {}, 1});
  covered.thickness = 0.1;
  const Deck deck = make_deck({make_part_deck("ball", SphereShape{1, 5}), covered});
  const ChunkedMesh whole = load_mesh(deck, self()), share = load_mesh(deck, Communicator::world());
  std::vector<std::string> told;
  for (const ElementBlock& block : share.mesh.elements.blocks) {
    told.push_back(fmt::format("{} {} {} {}", block.part, find_topology(block.topology).name, block.name,
                               block.section.thickness));
  }
  EXPECT_THAT(told, ElementsAre("0 hex8  0", "1 hex8 cells 0", "1 quad4 squares 0.1", "1 tri3 squares 0.1",
                                "1 tri3 halves 0.1"));
  const std::vector<std::int64_t> numbers = list_element_numbers(share);
  for (std::size_t e = 0; e < numbers.size(); ++e) {
    const std::size_t n = at(numbers[e]);
    EXPECT_EQ(share.mesh.elements.block_index(e), whole.mesh.elements.block_index(n));
    EXPECT_EQ(share.mesh.exterior[e], whole.mesh.exterior[n]);
    std::vector<std::int64_t> corners;
    for (const int node : share.mesh.corners(e)) corners.push_back(share.mesh.node_numbers[at(node)]);
    EXPECT_EQ(corners, std::vector<std::int64_t>(whole.mesh.corners(n).begin(), whole.mesh.corners(n).end()));
  }
  for (const Chunk& chunk : share.chunks) {
    for (int i = 0; i < chunk.element_count; ++i)
      EXPECT_EQ(share.mesh.topology_of(at(chunk.first_element + i)).family,
                find_topology(find_block(share, chunk).topology).family);
  }
}

TEST_F(Decomposition, HoldsTheNodesOfTheWholeMesh) {
  for (std::size_t n = 0; n < share_.mesh.nodes.size(); ++n) {
    const std::size_t number = at(share_.mesh.node_numbers[n]);
    EXPECT_EQ(share_.mesh.nodes[n], whole_.mesh.nodes[number]);
    EXPECT_EQ(share_.mesh.node_ids[n], whole_.mesh.node_ids[number]);
  }
  EXPECT_EQ(share_.mesh.low, whole_.mesh.low);
  EXPECT_EQ(share_.mesh.high, whole_.mesh.high);
}

TEST_F(Decomposition, CutsEverySetToTheShare) {
  ASSERT_EQ(share_.mesh.node_sets.size(), whole_.mesh.node_sets.size());
  for (const auto& [name, nodes] : share_.mesh.node_sets) {
    ASSERT_TRUE(whole_.mesh.node_sets.contains(name)) << name;
    const std::vector<int>& all = whole_.mesh.node_sets.at(name);
    std::vector<int> expected;
    for (std::size_t n = 0; n < share_.mesh.nodes.size(); ++n) {
      const auto number = static_cast<int>(share_.mesh.node_numbers[n]);
      if (std::binary_search(all.begin(), all.end(), number)) expected.push_back(static_cast<int>(n));
    }
    EXPECT_EQ(nodes, expected) << name;
  }
  const std::vector<std::size_t> numbers = list_numbers();
  ASSERT_EQ(share_.mesh.side_sets.size(), whole_.mesh.side_sets.size());
  for (const auto& [name, faces] : share_.mesh.side_sets) {
    const std::vector<ElementFace>& all = whole_.mesh.side_sets.at(name);
    std::vector<ElementFace> expected;
    for (std::size_t e = 0; e < numbers.size(); ++e) {
      for (int f = 0; f < 6; ++f) {
        if (std::binary_search(all.begin(), all.end(), ElementFace{static_cast<int>(numbers[e]), f})) {
          expected.push_back({static_cast<int>(e), f});
        }
      }
    }
    EXPECT_EQ(faces, expected) << name;
  }
}

TEST_F(Decomposition, KnowsExteriorFacesAndBodiesAsTheConnectivityOfTheWholeSays) {
  EXPECT_EQ(whole_.mesh.exterior, mark_exterior_faces(whole_.mesh.elements, whole_.mesh.nodes.size()));
  EXPECT_EQ(whole_.mesh.bodies, find_bodies(whole_.mesh.elements, whole_.mesh.nodes.size()));
}

TEST_F(Decomposition, MakesNoMoreThanItsShareOfTheGeneratedChunks) {
  const Communicator world = Communicator::world();
  const SceneParts scene = describe_parts(deck_, world);
  const ChunkPieces pieces = make_pieces(scene, world.rank(), world.size());
  int generated = 0, made = 0;
  for (const ScenePart& part : scene.parts) generated += part.generated ? part.chunks : 0;
  for (std::size_t c = 0; c < pieces.chunks.size(); ++c) {
    if (scene.parts[at(pieces.parts[c])].generated) {
      ++made;
      EXPECT_LE(pieces.first_element[c + 1] - pieces.first_element[c], least_chunk_limit);
    } else {
      EXPECT_EQ(world.rank(), 0);
    }
  }
  EXPECT_LE(made, generated / world.size() + 1);
  EXPECT_EQ(pieces.element_ids.size(), at(pieces.first_element.back()));
}

TEST_F(Decomposition, OwnersAreTheRanksOfTheLowestChunks) {
  std::vector<int> lowest(whole_.mesh.nodes.size(), whole_.numbering.chunk_count());
  for (const Chunk& chunk : whole_.chunks) {
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e) {
      for (const int n : whole_.mesh.corners(at(e))) lowest[at(n)] = std::min(lowest[at(n)], chunk.number);
    }
  }
  for (const std::int64_t n : share_.mesh.node_numbers) {
    EXPECT_EQ(share_.numbering.find_node_owner(n), share_.numbering.ranks[at(lowest[at(n)])]);
  }
}

TEST_F(Decomposition, SelectsOnAllRanksWhatOneOfThemHolds) {
  const Selector side{"ball/surface", std::nullopt, {1, 1}},
      nowhere{"dice", {{Vec3{50, 50, 50}, Vec3{60, 60, 60}}}, {1, 1}};
  EXPECT_NO_THROW(select_faces(share_.mesh, deck_, side));
  EXPECT_ERROR(select_nodes(share_.mesh, deck_, nowhere), InputError, "'dice' has no nodes inside the box");
  int count = static_cast<int>(select_faces(share_.mesh, deck_, side).size());
  MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_EQ(at(count), whole_.mesh.side_sets.at("ball/surface").size());
}

/// The text of the error that loading throws.
std::string fail_to_load(const Deck& deck, const Communicator& ranks) {
  try {
    load_mesh(deck, ranks);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(DecompositionErrors, AreThoseOfOneRankOnEveryRank) {
  WrittenMesh inverted = make_two_cubes();
  std::swap(inverted.nodes[8], inverted.nodes[0]);
  const SharedFile file(inverted, "inverted.exo");
  Deck deck =
      make_deck({make_part_deck("flat", BoxShape{{1, 0, 1}, {7, 8, 9}}), make_part_deck("good", SphereShape{1, 9}),
                 make_part_deck("read", FileMesh{file.path(), {}, 1}), make_part_deck("nameless", SphereShape{1, 3}),
                 make_part_deck("far", SphereShape{1, 8})});
  deck.parts[3].material = "steal";
  deck.parts[4].at = {1e308, 0, 1e308};
  deck.parts[4].rotate.push_back({{0, 1, 0}, 45, {1.7e308, 0, -1.7e308}});
  const std::string alone = fail_to_load(deck, self());
  EXPECT_THAT(alone, HasSubstr("part 'flat': element 1 at"));
  EXPECT_THAT(alone, HasSubstr("and 494 more"));
  EXPECT_THAT(alone, HasSubstr("part 'read'"));
  EXPECT_THAT(alone, HasSubstr("material 'steal'"));
  EXPECT_THAT(alone, HasSubstr("coordinates must be finite"));
  EXPECT_EQ(fail_to_load(deck, Communicator::world()), alone);
}

TEST(DecompositionErrors, OfAFileThatIsNotThereReachEveryRank) {
  const Deck deck = make_deck(
      {make_part_deck("good", SphereShape{1, 9}), make_part_deck("a", FileMesh{"/nonexistent/file.exo", {}, 1})});
  std::string told = "nothing";
  try {
    load_mesh(deck, Communicator::world());
  } catch (const std::runtime_error& error) {
    told = error.what();
  }
  EXPECT_THAT(told, HasSubstr("deck.yaml:3:5: error: part 'a': /nonexistent/file.exo: "));
}

}  // namespace
}  // namespace percuss
