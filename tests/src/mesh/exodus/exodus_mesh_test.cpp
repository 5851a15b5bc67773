// Good Exodus II files in every container.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "src/error.hpp"
#include "tests/src/mesh/exodus_writer.hpp"
#include "tests/src/mesh/mesh_measures.hpp"
#include "tests/src/mesh/variable_order.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

Mesh read(const WrittenMesh& written, Container container = Container::classic, FileMesh source = {},
          PartDeck part = {}) {
  source.file = write_exodus(written, "good.exo", container);
  PartDeck named = make_part_deck("p", source);
  named.array = part.array;
  named.at = part.at;
  const Mesh mesh = build_mesh(make_deck({named}));
  std::remove(source.file.c_str());
  return mesh;
}

class ExodusContainers : public testing::TestWithParam<Container> {};

TEST_P(ExodusContainers, GiveBackWhatWasWritten) {
  WrittenMesh written = make_two_cubes();
  written.nodes[3] = {-1.0 / 3, 0.1, 1.1};
  const Mesh mesh = read(written, GetParam());
  EXPECT_EQ(mesh.nodes, written.nodes);
  EXPECT_EQ(mesh.node_ids, written.node_ids);
  ASSERT_EQ(mesh.elements.size(), 2U);
  EXPECT_THAT(mesh.elements.corners(0), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(mesh.elements.corners(1), ElementsAre(4, 5, 6, 7, 8, 9, 10, 11));
  EXPECT_EQ(mesh.elements.block_of(0).name, "left");
  EXPECT_EQ(mesh.elements.block_of(1).name, "block_20");
  EXPECT_EQ(mesh.element_ids, written.element_ids);
  EXPECT_THAT(mesh.node_sets.at("p/corner"), ElementsAre(0));
  EXPECT_THAT(mesh.side_sets.at("p/sides_6"), ElementsAre(ElementFace{0, 4}, ElementFace{1, 5}));
  EXPECT_THAT(mesh.node_sets.at("p/sides_6"), ElementsAre(0, 1, 2, 3, 8, 9, 10, 11));
  EXPECT_EQ(mesh.node_sets.at("p").size(), 12U);
  EXPECT_THAT(mesh.warnings, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(All, ExodusContainers,
                         testing::Values(Container::classic, Container::offset64, Container::netcdf4,
                                         Container::netcdf4_int64));

auto tells(const std::string& text) { return Field(&Warning::text, HasSubstr(text)); }

TEST_P(ExodusContainers, MayHoldAnyVariableFirst) {
  const WrittenMesh written = make_two_cubes();
  const std::string path = write_exodus(written, "ordered.exo", GetParam());
  for (const std::string& variable : list_variables(path)) {
    SCOPED_TRACE(variable);
    FileMesh source;
    source.file = copy_with_first(path, variable, path + ".first");
    const Mesh mesh = build_mesh(make_deck({make_part_deck("p", source)}));
    EXPECT_EQ(mesh.nodes, written.nodes);
    EXPECT_EQ(mesh.node_ids, written.node_ids);
    EXPECT_EQ(mesh.elements.corners(mesh.elements.size() - 1)[7], 11);
    EXPECT_EQ(mesh.element_ids, written.element_ids);
    EXPECT_THAT(mesh.node_sets.at("p/corner"), ElementsAre(0));
    EXPECT_THAT(mesh.side_sets.at("p/sides_6"), ElementsAre(ElementFace{0, 4}, ElementFace{1, 5}));
    std::remove(source.file.c_str());
  }
  std::remove(path.c_str());
}

TEST(ExodusMesh, SinglePrecisionCoordinatesAreRead) {
  WrittenMesh written = make_two_cubes();
  written.single_precision = true;
  written.nodes[0][0] = -0.1;
  EXPECT_EQ(read(written).nodes[0][0], double(-0.1F));
}

TEST(ExodusMesh, WithoutMapsCountsFromOne) {
  WrittenMesh written = make_two_cubes();
  written.node_ids.clear();
  written.element_ids.clear();
  const Mesh mesh = read(written);
  EXPECT_THAT(mesh.element_ids, ElementsAre(1, 2));
  EXPECT_EQ(mesh.node_ids.back(), 12);
}

TEST(ExodusMesh, ScalesCoordinates) {
  FileMesh source;
  source.scale = 0.001;
  EXPECT_EQ(read(make_two_cubes(), Container::classic, source).nodes[11][0], 0.002);
}

TEST(ExodusMesh, ReadsOnlyTheChosenBlocksAndCutsTheSets) {
  FileMesh source;
  for (const char* name : {"block_20", "left", "block_10"}) {
    source.blocks = {name};
    const bool right = source.blocks[0] == "block_20";
    const Mesh mesh = read(make_two_cubes(), Container::classic, source);
    EXPECT_THAT(mesh.element_ids, ElementsAre(right ? 102 : 101));
    EXPECT_EQ(mesh.nodes.size(), 8U);
    EXPECT_EQ(mesh.node_ids.front(), right ? 1005 : 1001);
    EXPECT_EQ(mesh.node_sets.at("p/corner").size(), right ? 0U : 1U);
    EXPECT_THAT(mesh.side_sets.at("p/sides_6"), ElementsAre(ElementFace{0, right ? 5 : 4}));
    EXPECT_THAT(mesh.warnings, IsEmpty());
  }
}

TEST(ExodusMesh, ReadsBlocksInTheOrderOfTheFile) {
  FileMesh source;
  source.blocks = {"block_20", "left"};
  EXPECT_THAT(read(make_two_cubes(), Container::classic, source).element_ids, ElementsAre(101, 102));
}

TEST(ExodusMesh, UnusedNodesAreDroppedWithAWarning) {
  WrittenMesh written = make_two_cubes();
  written.nodes.insert(written.nodes.begin() + 4, 3, {9, 9, 9});
  written.node_ids = {11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25};
  written.blocks[0].corners = {1, 2, 3, 4, 8, 9, 10, 11};
  written.blocks[1].corners = {8, 9, 10, 11, 12, 13, 14, 15};
  written.node_sets[0].entries = {5, 15, 1, 15};
  const Mesh mesh = read(written);
  EXPECT_EQ(mesh.nodes.size(), 12U);
  EXPECT_EQ(mesh.node_ids[4], 18);
  EXPECT_THAT(mesh.node_sets.at("p/corner"), ElementsAre(0, 11));
  EXPECT_THAT(mesh.warnings,
              ElementsAre(AllOf(Field(&Warning::rule, "unused_nodes"), Field(&Warning::place, "part 'p'"),
                                tells("3 nodes belong to no element"), tells("node 15"))));
}

TEST(ExodusMesh, EmptyBlocksAndSetsDoNoHarm) {
  WrittenMesh written = make_two_cubes();
  written.blocks.insert(written.blocks.begin(), WrittenBlock{3, "void", "NULL", 8, {}});
  written.node_sets.push_back({8, "nothing", {}, {}});
  const Mesh mesh = read(written);
  EXPECT_EQ(mesh.elements.size(), 2U);
  EXPECT_THAT(mesh.node_sets.at("p/nothing"), IsEmpty());
}

TEST(ExodusMesh, LongNamesAreReadWhole) {
  WrittenMesh written = make_two_cubes();
  written.node_sets[0].name = "the_node_set_at_the_corner_12345";  // 32 letters: the most of a default file
  EXPECT_EQ(read(written).node_sets.count("p/" + written.node_sets[0].name), 1U);
}

TEST(ExodusMesh, SetsThatShareANameAreKnownByTheirIds) {
  WrittenMesh written = make_two_cubes();
  written.node_sets.push_back({9, "corner", {12}, {}});
  const Mesh mesh = read(written);
  EXPECT_THAT(mesh.node_sets.at("p/nodes_5"), ElementsAre(0));
  EXPECT_THAT(mesh.node_sets.at("p/nodes_9"), ElementsAre(11));
}

TEST(ExodusMesh, IdsThatRepeatGiveWayToPlacesInTheFile) {
  WrittenMesh written = make_two_cubes();
  written.element_ids = {7, 7};
  const Mesh mesh = read(written);
  EXPECT_THAT(mesh.element_ids, ElementsAre(1, 2));
  EXPECT_THAT(mesh.warnings, ElementsAre(AllOf(Field(&Warning::rule, "file_ids"), tells("element ids"))));
}

TEST(ExodusMesh, AFlatCornerIsWarnedOf) {
  WrittenMesh written = make_two_cubes();
  written.nodes[11] = {5.0 / 3, 1.0 / 3, 2.0 / 3};  // corner 8 of the second cube, in the plane of its three neighbours
  const Mesh mesh = read(written);
  EXPECT_THAT(mesh.warnings, ElementsAre(AllOf(Field(&Warning::rule, "flat_corner"), tells("corner without volume"),
                                               tells("element 102"))));
}

TEST(ExodusMesh, CanBeCopiedAndMovedLikeAnyPart) {
  PartDeck part;
  part.array = ArrayCopies{{2, 1, 1}, {3, 0, 0}, 0};
  part.at = {0, 0, 5};
  const Mesh mesh = read(make_two_cubes(), Container::netcdf4, {}, part);
  EXPECT_THAT(mesh.element_ids, ElementsAre(101, 102, 103, 104));
  EXPECT_EQ(mesh.nodes[12], (Vec3{3, 0, 5}));
  EXPECT_EQ(mesh.node_sets.at("p/corner"), (std::vector<int>{0, 12}));
  EXPECT_EQ(mesh.side_sets.at("p/sides_6").size(), 4U);
}

TEST(ExodusMesh, BlocksOfOneFileCanBeParts) {
  FileMesh left, right;
  left.file = right.file = write_exodus(make_two_cubes(), "parts.exo");
  left.blocks = {"left"};
  right.blocks = {"block_20"};
  const Mesh mesh = build_mesh(make_deck(
      {make_part_deck("box", BoxShape{{1, 1, 1}, {1, 1, 1}}), make_part_deck("l", left), make_part_deck("r", right)}));
  EXPECT_THAT(mesh.element_ids, ElementsAre(103, 101, 102));
  // Both parts have the nodes between them: ids must stay unique.
  std::vector<std::int64_t> ids = mesh.node_ids;
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
  EXPECT_THAT(mesh.warnings, ElementsAre(AllOf(Field(&Warning::rule, "raised_ids"), Field(&Warning::place, "part 'r'"),
                                               tells("node ids"))));
  std::remove(left.file.c_str());
}

TEST(ExodusMesh, AnUnknownBlockIsRefusedWithTheNearestName) {
  FileMesh source;
  source.blocks = {"lft"};
  EXPECT_THAT([&] { read(make_two_cubes(), Container::classic, source); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("no block 'lft'"), HasSubstr("'left'"))));
}

}  // namespace
}  // namespace percuss
