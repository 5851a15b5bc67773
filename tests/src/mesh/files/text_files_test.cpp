// Meshes of Gmsh, of LS-DYNA keyword decks and of Abaqus: what is read, and what is refused at its line.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "src/error.hpp"
#include "src/mesh/files/text_numbers.hpp"
#include "src/mesh/reading/part_reader.hpp"
#include "tests/src/mesh/exodus_writer.hpp"
#include "tests/src/mesh/files/read_sample.hpp"
#include "tests/src/mesh/files/sample_files.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

TEST(TextNumbers, AreReadAsFortranAndCWriteThem) {
  EXPECT_EQ(parse_real("1.5-10"), 1.5e-10);
  EXPECT_EQ(parse_real(" -2.5D+03 "), -2500);
  EXPECT_EQ(parse_real("+7"), 7);
  EXPECT_EQ(parse_real("-.5"), -0.5);
  EXPECT_EQ(parse_integer(" 12. "), 12);
  EXPECT_EQ(parse_integer("9223372036854775807"), 9223372036854775807);
  for (const char* wrong : {"", "-", "1e", "1.2.3", "0x10", "nan", "inf", "1e999", "1,2", "--1"})
    EXPECT_FALSE(parse_real(wrong)) << wrong;
  for (const char* wrong : {"", "1.5", "9223372036854775808", "1e3", "a"}) EXPECT_FALSE(parse_integer(wrong)) << wrong;
}

TEST(GmshFile, OfVersion22HasGroupsAsBlocksAndSets) {
  const PartMesh mesh = read_part(gmsh_22, "two.msh", {"left", "block_2"});
  ASSERT_THAT(mesh.elements.blocks, SizeIs(2));
  EXPECT_EQ(mesh.elements.blocks[0].name, "left");
  EXPECT_EQ(mesh.elements.blocks[1].name, "block_2");
  EXPECT_THAT(mesh.element_ids, ElementsAre(3, 4));
  EXPECT_THAT(mesh.node_ids, ElementsAre(10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120));
  EXPECT_THAT(mesh.node_sets.at("tip"), ElementsAre(11));
  EXPECT_THAT(mesh.side_sets.at("near side"), ElementsAre(ElementFace{0, 3}));
  EXPECT_DOUBLE_EQ(gauss_volume(corners_of(mesh, 0)), 1);
}

TEST(GmshFile, HasShellsWhereAGroupIsNotOfFaces) {
  const PartMesh all = read_part(gmsh_22, "two.msh");
  EXPECT_THAT(all.elements.blocks, SizeIs(3));
  EXPECT_EQ(all.elements.blocks[2].name, "cap");
  EXPECT_EQ(all.elements.blocks[2].topology, TopologyKind::tri3);
  EXPECT_THAT(all.warnings, ElementsAre(testing::Field(&Warning::text, HasSubstr("the first is node 5000000000"))));
}

TEST(GmshFile, OfVersion41HasTheSame) {
  const PartMesh mesh = read_part(gmsh_41, "two.msh");
  EXPECT_THAT(mesh.elements.blocks, SizeIs(3));
  EXPECT_THAT(mesh.element_ids, ElementsAre(3, 4, 5));
  EXPECT_EQ(mesh.elements.blocks[0].name, "left");
  EXPECT_EQ(mesh.elements.blocks[2].name, "cap");
  EXPECT_THAT(mesh.node_sets.at("points_9"), ElementsAre(11));
  EXPECT_THAT(mesh.side_sets.at("sides_3"), ElementsAre(ElementFace{0, 3}));
  EXPECT_THAT(mesh.side_sets.at("block_8"), SizeIs(6));  // the second group of the first cube
  EXPECT_THAT(mesh.warnings, IsEmpty());
}

TEST(GmshFile, CanBeBinary) {
  for (const bool is_41 : {false, true}) {
    const PartMesh mesh = read_part(make_binary_gmsh(is_41), "binary.msh");
    EXPECT_THAT(mesh.nodes, SizeIs(8));
    EXPECT_THAT(mesh.element_ids, ElementsAre(77));
    EXPECT_DOUBLE_EQ(gauss_volume(corners_of(mesh, 0)), 1);
  }
}

TEST(KeywordFile, HasPartsAsBlocksAndSets) {
  const PartMesh mesh = read_part(keyword_deck, "two.k");
  ASSERT_THAT(mesh.elements.blocks, SizeIs(3));
  EXPECT_EQ(mesh.elements.blocks[0].name, "left");
  EXPECT_EQ(mesh.elements.blocks[1].name, "right side");
  EXPECT_EQ(mesh.elements.blocks[2].name, "cap");
  EXPECT_THAT(mesh.nodes, SizeIs(12));
  EXPECT_EQ(mesh.nodes[2], (Vec3{0, 1, 1}));
  EXPECT_EQ(mesh.nodes[6], (Vec3{1, 1, 1}));
  EXPECT_EQ(mesh.node_ids[11], 120);
  EXPECT_THAT(mesh.node_sets.at("corner"), ElementsAre(0, 11));
  EXPECT_THAT(mesh.node_sets.at("nodes_5"), ElementsAre(1, 2, 3));
  EXPECT_THAT(mesh.side_sets.at("sides_9"), ElementsAre(ElementFace{0, 3}));
  EXPECT_THAT(mesh.side_sets.at("parts_8"), SizeIs(12));
  EXPECT_THAT(mesh.side_sets.at("elements_6"), ElementsAre(ElementFace{2, 0}, ElementFace{2, 1}));
  EXPECT_DOUBLE_EQ(gauss_volume(corners_of(mesh, 1)), 1);
  EXPECT_THAT(mesh.warnings,
              testing::Contains(testing::Field(&Warning::text, HasSubstr("*MAT_ELASTIC of the file are not read"))));
}

TEST(KeywordFile, IsNamedOnceInMessagesWithItsLine) {
  const std::string path = write_bytes(change(keyword_deck, "1.0D0", "1.0X0"), "named.k");
  EXPECT_THAT(
      [&] {
        build_mesh(make_deck({make_part_deck("p", FileMesh{path, {}, 1, false})}));
      },
      ThrowsMessage<InputError>(
          testing::StartsWith("deck.yaml:3:5: error: part 'p': " + path + ":15: field 4 of *NODE is '1.0X0'")));
  std::remove(path.c_str());
}

TEST(KeywordFile, KeepsIdsOfSolidsAlone) {
  const PartMesh mesh = read_part(keyword_deck, "two.k", {"left", "block_2"});
  EXPECT_THAT(mesh.node_ids, SizeIs(12));
  EXPECT_THAT(mesh.elements.blocks, SizeIs(2));
}

TEST(KeywordFile, IncludesFilesBesideIt) {
  const std::size_t nodes = keyword_deck.find("*NODE\n"), elements = keyword_deck.find("*ELEMENT_SOLID");
  const std::string inner = write_bytes(keyword_deck.substr(nodes, elements - nodes) + "*END\nignored\n", "inner.k");
  const std::string name = std::filesystem::path(inner).filename().string();
  const std::string outer = keyword_deck.substr(0, nodes) + "*INCLUDE\n" + name + "\n" + keyword_deck.substr(elements);
  EXPECT_THAT(read_part(outer, "outer.k").nodes, SizeIs(12));
  EXPECT_THAT(
      [&] { read_part(change(outer, name, "../" + name), "outer.k"); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("outer.k:14: "), HasSubstr("in the folder of the first file"))));
  EXPECT_THAT([&] { read_part(change(outer, name, change(name, "inner", "outer")), "outer.k"); },
              ThrowsMessage<InputError>(HasSubstr("too deeply, or without end")));
  std::remove(inner.c_str());
}

TEST(AbaqusFile, HasSetsOfElementsAsBlocksAndSurfaces) {
  const PartMesh mesh = read_part(abaqus_input, "two.inp", {"left", "right", "cap"});
  ASSERT_THAT(mesh.elements.blocks, SizeIs(3));
  EXPECT_EQ(mesh.elements.blocks[0].name, "left");
  EXPECT_EQ(mesh.elements.blocks[2].topology, TopologyKind::tri3);
  EXPECT_THAT(mesh.element_ids, ElementsAre(3, 4, 5, 6));
  EXPECT_THAT(mesh.nodes, SizeIs(12));
  EXPECT_THAT(mesh.node_sets.at("All"), SizeIs(12));
  EXPECT_THAT(mesh.node_sets.at("ends"), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(mesh.node_sets.at("more"), ElementsAre(0, 1, 2, 3, 11));
  EXPECT_THAT(mesh.node_sets.at("tip"), ElementsAre(11));
  EXPECT_THAT(mesh.side_sets.at("near"), ElementsAre(ElementFace{0, 3}));
  EXPECT_THAT(mesh.side_sets.at("outside"), ElementsAre(ElementFace{1, 5}, ElementFace{2, 1}, ElementFace{3, 1}));
  EXPECT_DOUBLE_EQ(gauss_volume(corners_of(mesh, 0)), 1);
  EXPECT_THAT(mesh.warnings, testing::Contains(testing::Field(
                                 &Warning::text, HasSubstr("*DENSITY, *MATERIAL of the file are not read"))));
}

// Earlier 2.x differ in tags of partitions, which are not read, and 2.0 in names, which have no dimensions.
TEST(GmshFile, OfVersion2IsReadAsThatOf22) {
  const PartMesh now = read_part(gmsh_22, "two.msh", {"left"});
  std::string plain = gmsh_22;
  for (const auto& [from, to] : {std::pair{"0 9 \"tip", "9 \"tip"},
                                 {"2 3 \"near", "3 \"near"},
                                 {"2 4 \"cap", "4 \"cap"},
                                 {"3 1 \"left", "1 \"left"}})
    plain = change(plain, from, to);
  for (const std::string version : {"2", "2.0", "2.1"}) {
    const std::string& text = version == "2.1" ? gmsh_22 : plain;
    const PartMesh before = read_part(change(text, "2.2 0 8", version + " 0 8"), "old.msh", {"left"});
    EXPECT_EQ(before.nodes, now.nodes);
    EXPECT_EQ(before.element_ids, now.element_ids);
  }
}

// Some programs say version 2 and give names a dimension all the same.
TEST(GmshFile, OfVersion2MayGiveNamesADimension) {
  for (const std::string version : {"2", "2.0"}) {
    const PartMesh mesh = read_part(change(gmsh_22, "2.2 0 8", version + " 0 8"), "old.msh", {"left", "block_2"});
    EXPECT_EQ(mesh.element_ids, read_part(gmsh_22, "two.msh", {"left", "block_2"}).element_ids);
    EXPECT_THAT(mesh.node_sets.at("tip"), ElementsAre(11));
    EXPECT_THAT(mesh.side_sets.at("near side"), ElementsAre(ElementFace{0, 3}));
  }
}

TEST(GmshFile, RefusesOtherWordsBeforeAName) {
  for (const std::string wrong : {"3 1 1 \"left", "3 x \"left", "3 1x\"left", "5 1 \"left"}) {
    for (const std::string version : {"2", "2.2"}) {
      const std::string text = change(change(gmsh_22, "2.2 0 8", version + " 0 8"), "3 1 \"left", wrong);
      const std::string expected = version == "2" ? "group" : "dimension group";
      EXPECT_THAT([&] { read_part(text, "a.msh"); },
                  ThrowsMessage<InputError>(HasSubstr("a.msh:9: a name is not as: " + expected + " \"name\"")));
    }
  }
}

TEST(AbaqusFile, GivesTheElementsOfASet) {
  const PartMesh mesh = read_part(abaqus_input, "two.inp", {"half of it"});
  EXPECT_THAT(mesh.element_ids, ElementsAre(3, 5));
  EXPECT_THAT(mesh.nodes, SizeIs(11));
}

class WrongTextFile : public testing::TestWithParam<WrongFile> {};

TEST_P(WrongTextFile, IsRefusedAtItsLine) {
  const WrongFile& wrong = GetParam();
  EXPECT_THAT([&] { read_part(change(*wrong.text, wrong.from, wrong.to), wrong.file); },
              ThrowsMessage<InputError>(HasSubstr(wrong.message)));
}

INSTANTIATE_TEST_SUITE_P(
    Table, WrongTextFile,
    testing::Values(
        WrongFile{"Version", &gmsh_22, "2.2 0 8", "4.0 0 8", "a.msh", "a.msh:2: the version is '4.0' (2 to 2.2 and"},
        WrongFile{"Node", &gmsh_22, "20 0 1 0", "20 0 x 0", "a.msh", "a.msh:14: a coordinate is 'x' (a number"},
        WrongFile{"NodeOfElement", &gmsh_22, "10 50 60 20", "10 50 61 20", "a.msh", "a.msh:31: there is no node 61"},
        WrongFile{"Count", &gmsh_22, "$Nodes\n13", "$Nodes\n14", "a.msh", "a.msh:26: the id of a node is '$EndNodes'"},
        WrongFile{"HugeCount", &gmsh_22, "$Nodes\n13", "$Nodes\n999999999", "a.msh",
                  "a.msh:12: the number of nodes is 999999999"},
        WrongFile{"NodeTwice", &gmsh_22, "20 0 1 0", "10 0 1 0", "a.msh",
                  "a.msh:14: node 10 stands elsewhere in line 13"},
        WrongFile{"Type", &gmsh_22, "4 5 2 2 2 50", "4 99 2 2 2 50", "a.msh", "elements of type 99"},
        WrongFile{"Kind", &gmsh_22, "4 5 2 2 2 50 90 100 60 80 120 110 70",
                  "4 19 2 2 2 50 90 100 60 80 120 110 70 10 20 30 40 50", "a.msh",
                  "block 'block_2' has 1 elements of kind 13-node pyramid"},
        WrongFile{"Partitions", &gmsh_41, "$Entities", "$PartitionedEntities", "a.msh",
                  "a.msh:9: $PartitionedEntities is not read"},
        WrongFile{"Number", &keyword_deck, "1.0D0", "1.0X0", "a.k", "a.k:15: field 4 of *NODE is '1.0X0' (a number"},
        WrongFile{"Parameter", &keyword_deck, "50, 1.", "50, &a", "a.k",
                  "a.k:17: field 2 of *NODE is '&a' (a number is expected; parameters are not read)"},
        WrongFile{"Unknown", &keyword_deck, "        10       120", "        10       121", "a.k",
                  "a.k:36: there is no node 121"},
        WrongFile{"Segment", &keyword_deck, "        10        20        30        40",
                  "        10        20        30        50", "a.k", "a.k:48: no element has a face with these nodes"},
        WrongFile{"Degenerate", &keyword_deck, "10      50      60      20      40      80      70      30",
                  "10      50      60      20      40      40      70      30", "a.k",
                  "*ELEMENT_SOLID, degenerate, of 7 nodes (first "},
        WrongFile{"Belt", &keyword_deck, "*SET_NODE_LIST_TITLE",
                  "*ELEMENT_SEATBELT\n20, 4, 10, 20, 30\n*SET_NODE_LIST_TITLE", "a.k",
                  "kind *ELEMENT_SEATBELT (first "},
        WrongFile{"BeamOptions", &keyword_deck, "*SET_NODE_LIST_TITLE",
                  "*ELEMENT_BEAM_OFFSET\n20, 4, 10, 20, 30\n*SET_NODE_LIST_TITLE", "a.k",
                  "*ELEMENT_BEAM_OFFSET is not read (it changes the mesh)"},
        WrongFile{"AbaqusNumber", &abaqus_input, "20, 0., 1.", "20, 0., one", "a.inp",
                  "a.inp:7: item 3 of *NODE is 'one' (a number"},
        WrongFile{"AbaqusFewNodes", &abaqus_input, " 4, 50, 90,", " 4, 50,", "a.inp",
                  "a.inp:23: element 4 has 7 nodes (a C3D8R has 8)"},
        WrongFile{"AbaqusSide", &abaqus_input, "4, S2", "4, S7", "a.inp", "a.inp:39: there is no side 'S7'"},
        WrongFile{"AbaqusSideOfShell", &abaqus_input, "cap, SPOS", "cap, S3", "a.inp",
                  "a.inp:38: element 5 has no such side (it is a shell)"},
        WrongFile{"AbaqusSet", &abaqus_input, " ENDS, 120", " ENDZ, 120", "a.inp",
                  "a.inp:32: there is no node set 'ENDZ'"},
        WrongFile{"AbaqusSetOfItself", &abaqus_input, " ENDS, 120", " MORE, 120", "a.inp", "names itself"},
        WrongFile{"AbaqusMoved", &abaqus_input, "PART=bar\n*END INSTANCE", "PART=bar\n 1., 0., 0.\n*END INSTANCE",
                  "a.inp", "a.inp:43: the instance is moved"},
        WrongFile{"AbaqusKind", &abaqus_input, "TYPE=B31", "TYPE=CONN3D2", "a.inp",
                  "block 'wire' has 1 elements of kind CONN3D2 (line 27)"},
        WrongFile{"AbaqusGenerated", &abaqus_input, "*NSET, NSET=ends", "*NGEN, NSET=ends", "a.inp",
                  "a.inp:29: *NGEN is not read (it changes the mesh)"},
        WrongFile{"NoMesh", &keyword_deck, "*KEYWORD", "*KEYWURD", "a.txt",
                  "neither its first bytes nor its extension"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace percuss
