// Exodus II files that must be refused: bad meshes with the element named, damaged files without a crash.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <cstdio>
#include <functional>
#include <limits>
#include <random>

#include "src/error.hpp"
#include "tests/src/mesh/exodus_writer.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using testing::HasSubstr;

std::string find_error(const std::string& path, const std::vector<std::string>& blocks = {}) {
  FileMesh source;
  source.file = path;
  source.blocks = blocks;
  try {
    build_mesh(make_deck({make_part_deck("p", source)}));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

struct BadMesh {
  std::string name;
  std::function<void(WrittenMesh&)> spoil;
  std::vector<std::string> says;
};

std::vector<BadMesh> list_bad_meshes() {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  return {
      {"mirrored",
       [](auto& m) { m.blocks[1].corners = {9, 10, 11, 12, 5, 6, 7, 8}; },
       {"element 102 at (1.5, 0.5, 0.5) is inverted", "volume is -1"}},
      {"one_corner_through",
       [](auto& m) {
         m.nodes[11] = {1.2, 0.8, 0.2};
       },
       {"element 102", "inverted at its corner 8, node 1012"}},
      {"twisted",
       [](auto& m) { std::swap(m.blocks[0].corners[6], m.blocks[0].corners[7]); },
       {"element 101", "inverted"}},
      {"flat",
       [](auto& m) {
         for (int n = 8; n < 12; ++n) m.nodes[std::size_t(n)][0] = 1;
       },
       {"element 102", "has no volume"}},
      {"all_in_a_point",
       [](auto& m) {
         m.nodes.assign(12, {1, 1, 1});
       },
       {"element 101", "element 102", "has no volume"}},
      {"collapsed_edge",
       [](auto& m) { m.blocks[0].corners = {1, 2, 3, 3, 5, 6, 7, 8}; },
       {"element 101", "names node 1003 more than once", "degenerate"}},
      {"duplicate",
       [](auto& m) { m.blocks[1].corners = {1, 2, 3, 4, 5, 6, 7, 8}; },
       {"element 102", "repeats element 101"}},
      {"turned_duplicate",
       [](auto& m) { m.blocks[1].corners = {2, 3, 4, 1, 6, 7, 8, 5}; },
       {"element 102", "repeats element 101"}},
      {"node_zero",
       [](auto& m) { m.blocks[0].corners[2] = 0; },
       {"element 101 of block 'left' has node number 0 as its corner 3", "1 to 12"}},
      {"node_13",
       [](auto& m) { m.blocks[1].corners[7] = 13; },
       {"element 102 of block 'block_20' has node number 13 as its corner 8"}},
      {"negative_node", [](auto& m) { m.blocks[1].corners[0] = -5; }, {"element 102", "node number -5"}},
      {"huge_node", [](auto& m) { m.blocks[1].corners[0] = 2147483647; }, {"element 102", "node number 2147483647"}},
      {"nan", [nan](auto& m) { m.nodes[4][1] = nan; }, {"node 1005 lies at (1, nan, 0)", "finite"}},
      {"infinity", [infinity](auto& m) { m.nodes[4][2] = -infinity; }, {"node 1005", "-inf"}},
      {"wedges",
       [](auto& m) {
         m.blocks[1] = {20, "wedges", "WEDGE15", 15, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 1, 2, 3}};
       },
       {"block 'wedges' has 1 elements of kind WEDGE15 with 15 nodes", "blocks: [left]"}},
      {"quadratic",
       [](auto& m) {
         m.blocks.pop_back();
         m.element_ids.pop_back();
         m.side_sets.clear();
         m.blocks[0] = {10, "q", "HEX20", 20, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 1, 2, 3, 4, 5, 6, 7, 8}};
       },
       {"HEX20",
        "only HEX8, SHELL4, QUAD4, SHELL3, TRI3, TET4, BEAM2, BAR2, TRUSS2, ROD2, WEDGE6, PYR5, TETRA10 can be run"}},
      {"ten_nodes_of_one",
       [](auto& m) {
         m.nodes.resize(1);
         m.node_ids.clear();
         m.node_sets.clear();
         m.side_sets.clear();
         m.blocks.pop_back();
         m.element_ids.pop_back();
         m.blocks[0] = {10, "ten", "TETRA10", 10, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}};
       },
       {"element 101 of block 'ten' has node number 2 as its corner 2", "1 to 1"}},
      {"quadratic_triangles",
       [](auto& m) {
         m.blocks[0] = {10, "t", "TRI6", 6, {1, 2, 3, 4, 5, 6}};
       },
       {"block 't'", "TRI6"}},
      {"no_elements",
       [](auto& m) {
         m.blocks.clear();
         m.element_ids.clear();
         m.side_sets.clear();
       },
       {"the file has no elements"}},
      {"no_blocks_with_elements",
       [](auto& m) {
         for (auto& b : m.blocks) b.corners.clear();
         m.element_ids.clear();
         m.side_sets.clear();
       },
       {"no elements"}},
      {"plane", [](auto& m) { m.dimensions = 2; }, {"2 dimensions"}},
      {"set_node", [](auto& m) { m.node_sets[0].entries = {44}; }, {"node set 'corner' names node number 44"}},
      {"set_element",
       [](auto& m) {
         m.side_sets[0].entries = {1, 3};
       },
       {"side set 'sides_6' names element number 3"}},
      {"set_side",
       [](auto& m) {
         m.side_sets[0].sides = {7, 5};
       },
       {"side set 'sides_6' names side 7 of element 102"}},
  };
}

class BadExodusMesh : public testing::TestWithParam<BadMesh> {};

TEST_P(BadExodusMesh, IsRefusedWithItsPlace) {
  WrittenMesh mesh = make_two_cubes();
  GetParam().spoil(mesh);
  for (const Container container : {Container::classic, Container::netcdf4_int64}) {
    const std::string path = write_exodus(mesh, "bad_" + GetParam().name + ".exo", container), error = find_error(path);
    EXPECT_THAT(error, HasSubstr("deck.yaml:3:5: error: part 'p': " + path + ": "));
    for (const std::string& text : GetParam().says) EXPECT_THAT(error, HasSubstr(text));
    std::remove(path.c_str());
  }
}

INSTANTIATE_TEST_SUITE_P(Table, BadExodusMesh, testing::ValuesIn(list_bad_meshes()),
                         [](const auto& bad) { return bad.param.name; });

TEST(BadExodusMesh, SeveralProblemsAreListedTogether) {
  WrittenMesh mesh = make_two_cubes();
  mesh.blocks[0].corners[2] = 0;
  mesh.blocks[1].corners[2] = 99;
  const std::string path = write_exodus(mesh, "several.exo"), error = find_error(path);
  EXPECT_THAT(error, HasSubstr("element 101"));
  EXPECT_THAT(error, HasSubstr("\ndeck.yaml:3:5: error: part 'p': "));
  EXPECT_THAT(error, HasSubstr("element 102"));
  std::remove(path.c_str());
}

TEST(DamagedExodusFile, IsRefusedIfItIsNoExodusFile) {
  EXPECT_THAT(find_error("/nonexistent/mesh.exo"), HasSubstr("does not exist"));
  EXPECT_THAT(find_error(testing::TempDir()), HasSubstr("this is not a file"));
  EXPECT_THAT(find_error("/dev/null"), HasSubstr("this is not a file"));
  const std::vector<std::pair<std::string, std::string>> table{
      {"", "is empty"},
      {"C", "not an Exodus II file"},
      {"*NODE\n1, 0, 0, 0\n", "not an Exodus II file"},
      {"CDF\x03", "not an Exodus II file"},
      {"CDF\x01", "damaged"},
      {std::string("CDF\x01") + std::string(28, '\0'), "not one of Exodus II"},
      {"\x89HDF\r\n\x1a\n", "damaged"},
      {std::string(4096, '\xff'), "not an Exodus II file"}};
  for (const auto& [bytes, says] : table) {
    const std::string path = write_bytes(bytes, "none.exo");
    EXPECT_THAT(find_error(path), HasSubstr(says));
    std::remove(path.c_str());
  }
}

class DamagedExodusContainer : public testing::TestWithParam<Container> {};

TEST_P(DamagedExodusContainer, IsRefusedWhereverItIsCutOff) {
  const std::string good = write_exodus(make_two_cubes(), "whole.exo", GetParam()), bytes = read_bytes(good);
  ASSERT_EQ(find_error(good), "");
  std::remove(good.c_str());
  const std::size_t step = std::max<std::size_t>(1, bytes.size() / 150);
  for (std::size_t length = 0; length + 4 < bytes.size(); length += step) {  // the last 3 bytes may be padding
    const std::string path = write_bytes(bytes.substr(0, length), "cut.exo");
    EXPECT_NE(find_error(path), "") << "cut to " << length << " of " << bytes.size() << " bytes";
    std::remove(path.c_str());
  }
}

INSTANTIATE_TEST_SUITE_P(All, DamagedExodusContainer,
                         testing::Values(Container::classic, Container::offset64, Container::netcdf4,
                                         Container::netcdf4_int64));

TEST(DamagedExodusFile, WithFlippedBytesIsReadOrRefused) {
  for (const Container container : {Container::classic, Container::offset64, Container::netcdf4}) {
    const std::string good = write_exodus(make_two_cubes(), "whole.exo", container), bytes = read_bytes(good);
    std::remove(good.c_str());
    std::mt19937 random(3);  // NOLINT: a fixed seed is wanted
    int refused = 0;
    for (int i = 0; i < 100; ++i) {
      std::string damaged = bytes;
      for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
      const std::string path = write_bytes(damaged, "flipped.exo");
      if (!find_error(path).empty()) ++refused;
      std::remove(path.c_str());
    }
    EXPECT_GT(refused, 10);
  }
}

TEST(DamagedExodusFile, ThatClaimsMoreThanItHoldsIsRefusedBeforeMemoryIsAskedFor) {
  WrittenMesh mesh = make_two_cubes();
  mesh.nodes.resize(12);
  const std::string good = write_exodus(mesh, "claims.exo");
  std::string bytes = read_bytes(good);
  std::remove(good.c_str());
  const std::size_t name = bytes.find("num_nodes");
  ASSERT_NE(name, std::string::npos);
  bytes.replace(name + 12, 4, std::string("\x7f\xff\xff\xf0", 4));  // the dimension's length follows its padded name
  const std::string path = write_bytes(bytes, "claims.exo");
  EXPECT_THAT(find_error(path), HasSubstr("truncated"));
  std::remove(path.c_str());
}

TEST(DamagedExodusFile, OnWhichALibraryCrashesIsRefused) {
  for (const Container container : {Container::classic, Container::offset64}) {
    const std::string good = write_exodus(make_two_cubes(), "status.exo", container), bytes = read_bytes(good);
    std::remove(good.c_str());
    ASSERT_NE(bytes.find("int64_status"), std::string::npos);
    const std::string path = write_bytes(lengthen_status(bytes), "status.exo");
    EXPECT_THAT(find_error(path), HasSubstr("the file is damaged"));
    std::remove(path.c_str());
  }
}

TEST(DamagedExodusFile, WithoutOneCoordinateForEachNodeIsRefused) {
  const std::string good = write_exodus(make_two_cubes(), "named.exo", Container::offset64);
  std::string bytes = read_bytes(good);
  std::remove(good.c_str());
  bytes.replace(bytes.find("coordx"), 6, "coordq");
  const std::string path = write_bytes(bytes, "named.exo");
  EXPECT_THAT(find_error(path), HasSubstr("it has neither 'coordx' nor 'coord'"));
  std::remove(path.c_str());
}

TEST(DamagedExodusFile, WhoseGroupsLoopIsRefused) {
  const std::string path = write_exodus(make_two_cubes(), "loop.exo", Container::netcdf4);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  H5Lcreate_hard(file, "/", file, "again", H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(file);
  EXPECT_THAT(find_error(path), HasSubstr("group '/again' can be reached in more than one way"));
  std::remove(path.c_str());
}

}  // namespace
}  // namespace percuss
