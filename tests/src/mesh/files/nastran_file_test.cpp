// Meshes of Nastran bulk data: in every form of fields, with its names, sets, systems and thicknesses; and what is
// refused at its line.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "src/error.hpp"
#include "src/mesh/reading/part_reader.hpp"
#include "tests/src/mesh/exodus_writer.hpp"
#include "tests/src/mesh/files/nastran_samples.hpp"
#include "tests/src/mesh/files/read_sample.hpp"
#include "tests/src/mesh/files/sample_files.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;

TEST(NastranFile, IsTheSameMeshInEveryFormOfFields) {
  const PartMesh expected = read_part(abaqus_input, "two.inp", {"left", "right", "cap"});
  for (const std::string* text : {&nastran_short, &nastran_long, &nastran_free}) {
    const PartMesh mesh = read_part(*text, "two.bdf", {"block_1", "block_2", "block_3"});
    EXPECT_EQ(mesh.nodes, expected.nodes);
    EXPECT_EQ(mesh.node_ids, expected.node_ids);
    EXPECT_EQ(mesh.element_ids, expected.element_ids);
    ASSERT_EQ(mesh.elements.size(), expected.elements.size());
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      EXPECT_THAT(mesh.elements.corners(e), testing::ElementsAreArray(expected.elements.corners(e)));
      EXPECT_EQ(mesh.elements.block_of(e).topology, expected.elements.block_of(e).topology);
    }
    EXPECT_THAT(mesh.elements.own_thickness, ElementsAre(0, 0, 0.5, 1.25 / 3));
  }
}

TEST(NastranFile, HasPropertiesAsBlocksByTheirNames) {
  const auto names = [](const std::string& text) {
    std::vector<std::string> found;
    for (const ElementBlock& block : read_part(text, "two.nas").elements.blocks) found.push_back(block.name);
    return found;
  };
  EXPECT_THAT(names(nastran_short), ElementsAre("left", "right side", "cap"));
  EXPECT_THAT(names(nastran_long), ElementsAre("left", "right side", "cap"));
  EXPECT_THAT(names(nastran_free), ElementsAre("left", "block_2", "block_3", "block_4"));
}

TEST(NastranFile, HasSetsByTheirKind) {
  const PartMesh mesh = read_part(nastran_short, "two.bdf");
  EXPECT_THAT(mesh.node_sets.at("corner"), ElementsAre(0, 11));
  EXPECT_THAT(mesh.node_sets.at("nodes_5"), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(mesh.side_sets.at("elements_6"), ElementsAre(ElementFace{2, 0}, ElementFace{2, 1}));
  EXPECT_THAT(mesh.side_sets.at("parts_8"), SizeIs(12));
  EXPECT_THAT(read_part(nastran_free, "two.bdf").side_sets.at("some"), SizeIs(14));
  EXPECT_FALSE(mesh.side_sets.contains("elements_5"));
}

TEST(NastranFile, TakesIdsFromSetsOfTheCaseControlButThose) {
  const std::string all = change(nastran_short, "SET 4 = 10,\n  120", "SET 4 = 10 THRU 90 EXCEPT 20, 50, 120");
  EXPECT_THAT(read_part(all, "two.bdf").node_sets.at("corner"), ElementsAre(0, 2, 3, 5, 6, 7, 8, 11));
  const std::string every = change(nastran_short, "SET 4 = 10,\n  120", "SET 4 = ALL");
  EXPECT_THAT(read_part(every, "two.bdf").node_sets.at("corner"), SizeIs(12));
}

TEST(NastranFile, TellsWhatIsNotRead) {
  const PartMesh mesh = read_part(nastran_free, "two.bdf");
  EXPECT_THAT(mesh.warnings, Contains(Field(&Warning::text, HasSubstr("CBAR (orientation), CONM2 of the file"))));
  EXPECT_THAT(read_part(nastran_short, "two.bdf").warnings,
              Contains(Field(&Warning::text, HasSubstr("MAT1, SET (of no ids) of the file are not read"))));
}

TEST(NastranFile, HasTetrahedraOfTenNodes) {
  const PartMesh mesh = read_part(nastran_of_ten, "ten.bdf"), expected = read_part(keyword_of_ten, "ten.k");
  ASSERT_EQ(mesh.elements.size(), 8U);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    EXPECT_THAT(mesh.elements.corners(e), testing::ElementsAreArray(expected.elements.corners(e)));
  EXPECT_EQ(mesh.element_ids, expected.element_ids);
}

TEST(NastranFile, HasPointsInSystemsOfSystems) {
  // A spherical system around (0, 0, 1), whose z axis is x of the mesh, given in a cylindrical one.
  const std::string systems =
      "CORD2C,3,,0.,0.,1.,0.,0.,2.\n,1.,0.,1.\nCORD2S,4,3,0.,0.,0.,1.,0.,0.\n,1.,90.,0.\nGRID,30,4,1.,90.,0.\n";
  const std::string text =
      change(nastran_short, "GRID          30               0      1.    1.D0        $ a remark\n", systems);
  EXPECT_EQ(read_part(text, "two.bdf").nodes[2], (Vec3{0, 1, 1}));
  const std::string turned = change(text, "GRID,30,4,1.,90.,0.", "GRID,30,4,2.,90.,30.");
  const Vec3 x = read_part(turned, "two.bdf").nodes[2];
  EXPECT_NEAR(x[0], 0, 1e-15);
  EXPECT_NEAR(x[1], std::sqrt(3.0), 1e-15);  // 2 cos 30, along y
  EXPECT_NEAR(x[2], 2, 1e-15);               // 2 sin 30 along z
}

TEST(NastranFile, IncludesFilesBesideIt) {
  const std::size_t nodes = nastran_short.find("GRID "), elements = nastran_short.find("CHEXA");
  const std::string inner = write_bytes(nastran_short.substr(nodes, elements - nodes), "inner.bdf");
  const std::string name = std::filesystem::path(inner).filename().string();
  const std::string outer =
      nastran_short.substr(0, nodes) + "INCLUDE '" + name + "'\n" + nastran_short.substr(elements);
  EXPECT_THAT(read_part(outer, "outer.bdf").nodes, SizeIs(12));
  EXPECT_THAT(read_part(change(outer, "percuss_", "percuss\n  _"), "outer.bdf").nodes, SizeIs(12));
  EXPECT_THAT(read_part(change(outer, "'" + name + "'", name + " $ a note"), "outer.bdf").nodes, SizeIs(12));
  EXPECT_THAT([&] { read_part(change(outer, name, "../" + name), "outer.bdf"); },
              ThrowsMessage<InputError>(
                  testing::AllOf(HasSubstr("outer.bdf:12: "), HasSubstr("in the folder of the first file"))));
  const std::string itself = "GRID,1,,0.,0.,0.\nINCLUDE '" + change(name, "inner", "outer") + "'\n";
  EXPECT_THAT([&] { read_part(itself, "outer.bdf"); },
              ThrowsMessage<InputError>(HasSubstr("too deeply, or without end")));
  std::remove(inner.c_str());
}

TEST(NastranFile, LeavesOtherEntriesAlone) {
  const std::string others =
      "DEQATN  301     Z(A,B,C,D,E,F,G,H,I,J,K)=SUM(A,B,C,D,E,F,G)\nFLFACT,2,1.,,,,,,,KFREQ\n+MACH,3.\n";
  EXPECT_EQ(read_part(change(nastran_free, "GRDSET", others + "GRDSET"), "two.bdf").nodes,
            read_part(nastran_free, "two.bdf").nodes);
  const std::string marks = change(change(nastran_short, "80+A\n", "80CA1\n"), "+A            70", "+A1           70");
  EXPECT_EQ(read_part(marks, "two.bdf").element_ids, read_part(nastran_short, "two.bdf").element_ids);
}

TEST(NastranFile, IsKnownByItsFirstLines) {
  EXPECT_THAT(read_part(nastran_free, "two.mesh").nodes, SizeIs(12));
  EXPECT_THAT(read_part(nastran_short, "two.mesh").nodes, SizeIs(12));
  EXPECT_THAT(read_part(nastran_long, "two.dat").nodes, SizeIs(12));
}

class WrongNastranFile : public testing::TestWithParam<WrongFile> {};

TEST_P(WrongNastranFile, IsRefusedAtItsLine) {
  const WrongFile& wrong = GetParam();
  EXPECT_THAT([&] { read_part(change(*wrong.text, wrong.from, wrong.to), wrong.file); },
              ThrowsMessage<InputError>(HasSubstr(wrong.message)));
}

INSTANTIATE_TEST_SUITE_P(
    Table, WrongNastranFile,
    testing::Values(
        WrongFile{"Number", &nastran_short, "1.D0", "1.X0", "a.bdf",
                  "a.bdf:14: field 6 of GRID is '1.X0' (a number is expected)"},
        WrongFile{"NumberOfSecondLine", &nastran_short, "+A            70", "+A            7b", "a.bdf",
                  "a.bdf:25: field 12 of CHEXA is '7b' (a whole number"},
        WrongFile{"Node", &nastran_short, "+A            70", "+A            71", "a.bdf",
                  "a.bdf:24: there is no node 71"},
        WrongFile{"FewNodes", &nastran_short, "+A            70      30\n", "", "a.bdf",
                  "a.bdf:24: CHEXA 3 has 6 nodes at its 8 corners"},
        WrongFile{"BlankNode", &nastran_short, "5       3      90     100", "5       3      90        ", "a.bdf",
                  "a.bdf:28: CTRIA3 5 has a blank among its 3 nodes"},
        WrongFile{"Mark", &nastran_short, "+A            70", "+B            70", "a.bdf",
                  "a.bdf:25: the continuation 'B' stands where 'A' is expected"},
        WrongFile{"NoEntry", &nastran_short, "$ 345678 2345678 2345678", "+ABC", "a.bdf",
                  "a.bdf:11: the line continues no entry"},
        WrongFile{"HalfALine", &nastran_long,
                  "*B1                   60              20              40              80*B2",
                  "+B1           60      20", "a.bdf", "a.bdf:34: a line of short fields follows half a line of long"},
        WrongFile{"Quadratic", &nastran_free, "+,110,70", "+,110,70,10,20", "a.bdf",
                  "block 'block_2' has 1 elements of kind CHEXA of 10 nodes (first "},
        WrongFile{"FewMiddles", &nastran_of_ten, ",7,8,9,10", ",7,8,,10", "a.bdf", "kind CTETRA of 9 nodes (first "},
        WrongFile{"Shear", &nastran_free, "CTRIA3,5,", "CSHEAR,5,", "a.bdf", "kind CSHEAR (first "},
        WrongFile{"ManyFields", &nastran_free, "CTRIA3,5,3,90,100,110", "CTRIA3,5,3,90,100,110,,,,,1", "a.bdf",
                  "a.bdf:22: the line has 11 fields"},
        WrongFile{"System", &nastran_free, "GRID,20,,1.", "GRID,20,8,1.", "a.bdf",
                  "a.bdf:6: there is no coordinate system 8"},
        WrongFile{"SystemOfPoints", &nastran_free, "GRID,10,0", "CORD1R,8,10,20,30,9,10,20,30\nGRID,10,9", "a.bdf",
                  "a.bdf:5: coordinate system 9 is a CORD1R (CORD2R, CORD2C and CORD2S are read)"},
        WrongFile{"SystemOfItself", &nastran_free, "CORD2C,7,,", "CORD2C,7,7,", "a.bdf",
                  "a.bdf:3: coordinate system 7 refers to itself"},
        WrongFile{"FlatSystem", &nastran_free, ",1.,0.,0.", ",0.,0.,7.", "a.bdf",
                  "a.bdf:3: the three points of coordinate system 7 lie on one line"},
        WrongFile{"SystemTwice", &nastran_free, "GRDSET,,7", "CORD2C,7,,0,0,0,0,0,1\n,1.,0.,0.", "a.bdf",
                  "a.bdf:4: coordinate system 7 is defined twice"},
        WrongFile{"RelativeThickness", &nastran_free, "PSHELL,3,1,0.5", "PSHELL,4,1,0.5", "a.bdf",
                  "a.bdf:23: TFLAG is 1, but there is no PSHELL 3 with a thickness"},
        WrongFile{"Repetition", &nastran_free, "GRID,70,0", "=,70,0", "a.bdf",
                  "a.bdf:11: fields that repeat those of the line before (=) are not read"},
        WrongFile{"Superelement", &nastran_short, "BEGIN BULK", "BEGIN SUPER=1", "a.bdf",
                  "a.bdf:8: BEGIN 'SUPER=1' is not read"},
        WrongFile{"Bars", &nastran_free, "CBAR,7,4", "BAROR,,4\nCBAR,7,4", "a.bdf", "a.bdf:25: BAROR with a property"},
        WrongFile{"MemberOfASet", &nastran_short, "SET3           8    PROP       1",
                  "SET3           8    GRID      10", "a.bdf", "a.bdf:33: there is no node 2"},
        WrongFile{"SetTwice", &nastran_short, "SET1           6", "SET1           5", "a.bdf",
                  "a.bdf:32: set 5 is defined twice"},
        WrongFile{"SetOfWords", &nastran_short, "SET1           6       5", "SET1           6    SKIN", "a.bdf",
                  "a.bdf:32: set 6 is not a list of ids"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace percuss
