// What `percuss info` tells of an Exodus II file, line by line.

#include "src/app/reports/mesh_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/error.hpp"
#include "tests/src/mesh/exodus_writer.hpp"

namespace percuss {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing_mesh::make_two_cubes;
using testing_mesh::write_exodus;
using testing_mesh::WrittenMesh;

TEST(MeshReport, ListsBlocksAndEachSetOnce) {
  const std::string file = write_exodus(make_two_cubes(), "info_cubes.e");
  EXPECT_EQ(describe_mesh_file(file), "mesh        " + file + R"(: Exodus II
size        2 elements, 12 nodes
extent      x 0 to 2, y 0 to 1, z 0 to 1
blocks      left, id 10: 1 element of kind HEX8 with 8 nodes
            block_20, id 20: 1 element of kind hex with 8 nodes
node sets   corner, id 5: 1 node
side sets   sides_6, id 6: 2 faces
percuss     reads 12 nodes, 2 solid elements of volume 2
)");
}

TEST(MeshReport, SaysWhatCannotBeRunAndHowToChooseTheRest) {
  WrittenMesh mesh = make_two_cubes();
  mesh.blocks.push_back({30, "ends", "PYRAMID13", 13, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 1,
                                                       1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 1}});
  mesh.element_ids = {};
  mesh.node_sets = {};
  const std::string text = describe_mesh_file(write_exodus(mesh, "info_pyramids.e"));
  EXPECT_THAT(text, HasSubstr("4 elements, 12 nodes\n"));
  EXPECT_THAT(
      text, HasSubstr("\n            ends, id 30: 2 elements of kind PYRAMID13 with 13 nodes, which cannot be run\n"));
  EXPECT_THAT(text, HasSubstr("\nnode sets   none\n"));
  EXPECT_THAT(text, EndsWith("\npercuss     reads 12 nodes, 2 solid elements of volume 2\n"
                             "            with blocks: [left, block_20]\n"));
  mesh.blocks.erase(mesh.blocks.begin(), mesh.blocks.begin() + 2);
  mesh.side_sets = {};
  EXPECT_THAT(describe_mesh_file(write_exodus(mesh, "info_only_pyramids.e")),
              HasSubstr("\npercuss     runs none of this"));
}

TEST(MeshReport, TellsShellsAndTheirArea) {
  WrittenMesh mesh;
  mesh.nodes = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {4, 0, 0}};
  mesh.blocks = {{1, "", "SHELL4", 4, {1, 2, 3, 4}}, {2, "", "TRI3", 3, {2, 5, 3}}};
  EXPECT_THAT(
      describe_mesh_file(write_exodus(mesh, "info_shells.e")),
      EndsWith("\npercuss     reads 5 nodes, 2 shells of area 9 (the part needs a thickness), 1 of them triangles\n"));
}

TEST(MeshReport, RefusesWhatIsTurnedInsideOut) {
  WrittenMesh mesh = make_two_cubes();
  std::swap(mesh.blocks[0].corners[0], mesh.blocks[0].corners[6]);
  try {
    describe_mesh_file(write_exodus(mesh, "info_inverted.e"));
    FAIL() << "was not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("HEX8"));  // what is in the file is told before
    EXPECT_THAT(error.what(), HasSubstr("error: "));
  }
}

}  // namespace
}  // namespace percuss
