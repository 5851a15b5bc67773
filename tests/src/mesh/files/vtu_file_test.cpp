// Meshes of VTK unstructured grids: in every form of arrays, with ids, blocks and thicknesses; and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "src/error.hpp"
#include "src/mesh/reading/part_reader.hpp"
#include "tests/src/mesh/files/read_sample.hpp"
#include "tests/src/mesh/files/sample_files.hpp"
#include "tests/src/mesh/files/vtu_samples.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(VtuFile, IsTheSameMeshInEveryForm) {
  const PartMesh expected = read_part(abaqus_input, "two.inp", {"left", "right", "cap"});
  for (const VtuForm form : {VtuForm::ascii, VtuForm::base64, VtuForm::appended_base64, VtuForm::appended_raw}) {
    for (const int bits : {0, 1, 2, 3}) {
      const PartMesh mesh = read_part(make_vtu({form, (bits & 1) != 0, (bits & 2) != 0}), "two.vtu");
      EXPECT_EQ(mesh.nodes, expected.nodes);
      EXPECT_EQ(mesh.node_ids, expected.node_ids);
      EXPECT_EQ(mesh.element_ids, expected.element_ids);
      ASSERT_EQ(mesh.elements.size(), expected.elements.size());
      for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        EXPECT_THAT(mesh.elements.corners(e), testing::ElementsAreArray(expected.elements.corners(e)));
      EXPECT_THAT(mesh.elements.own_thickness, ElementsAre(0, 0, 0.5, 0.25));
      ASSERT_EQ(mesh.elements.blocks.size(), 3U);
      EXPECT_EQ(mesh.elements.blocks[1].name, "block_2");
      EXPECT_EQ(mesh.elements.blocks[2].topology, TopologyKind::tri3);
      EXPECT_THAT(mesh.warnings, ElementsAre(Field(&Warning::text, HasSubstr("velocity of the file are not read"))));
    }
  }
}

TEST(VtuFile, CountsFromOneWithoutIds) {
  const PartMesh mesh = read_part(make_vtu_of(10, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 1, 2, 3}), "one.vtu");
  EXPECT_THAT(mesh.node_ids, ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(mesh.element_ids, ElementsAre(1));
  EXPECT_EQ(mesh.elements.blocks[0].name, "block_1");
  EXPECT_EQ(mesh.elements.blocks[0].topology, TopologyKind::tet4);
}

TEST(VtuFile, TakesWedgesInBothOrders) {
  const std::vector<double> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1};
  const PartMesh along = read_part(make_vtu_of(13, points, {0, 1, 2, 3, 4, 5}), "one.vtu"),
                 against = read_part(make_vtu_of(13, points, {0, 2, 1, 3, 5, 4}), "one.vtu");
  EXPECT_THAT(along.elements.corners(0), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(against.elements.corners(0), ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(VtuFile, HasTheOtherCells) {
  const std::vector<double> points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 1};
  const auto kind = [&](int type, const std::vector<int>& cell) {
    return read_part(make_vtu_of(type, points, cell), "one.vtu").elements.blocks.at(0).topology;
  };
  EXPECT_EQ(kind(14, {0, 1, 2, 3, 4}), TopologyKind::pyramid5);
  EXPECT_EQ(kind(9, {0, 1, 2, 3}), TopologyKind::quad4);
  EXPECT_EQ(kind(3, {0, 1}), TopologyKind::line2);
  const std::vector<double> ten = {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 1, 0, 0,
                                   1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1};
  EXPECT_EQ(read_part(make_vtu_of(24, ten, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}), "ten.vtu").elements.size(), 8U);
}

TEST(VtuFile, IsRefusedAtThePlaceOfTheFault) {
  const auto refuses = [](const std::string& text, const std::string& from, const std::string& to,
                          const std::string& why) {
    EXPECT_THAT([&] { read_part(change(text, from, to), "a.vtu"); }, ThrowsMessage<InputError>(HasSubstr(why))) << to;
  };
  const std::string ascii = make_vtu({}), inlined = make_vtu({VtuForm::base64, false, false}),
                    packed = make_vtu({VtuForm::base64, true, false}),
                    raw = make_vtu({VtuForm::appended_raw, false, true});
  refuses(ascii, "\"UnstructuredGrid\"", "\"PolyData\"", "a.vtu:2: the file is a 'PolyData'");
  refuses(ascii, "<UnstructuredGrid>", "<!DOCTYPE a>", "a.vtu:4: '<!DOCTYPE a>' is not read");
  refuses(ascii, "</Points>", "</Cells>", "</Cells> closes <Points>");
  refuses(ascii, "</VTKFile>", "", "the file ends within <VTKFile>");
  refuses(ascii, "<Piece", "<Piece Note=x", "a.vtu:5: the value of attribute 'Note' is not in quotes");
  refuses(ascii, "NumberOfPoints=\"12\"", "NumberOfPoints=\"-1\"", "a.vtu:5: NumberOfPoints is '-1'");
  refuses(ascii, "NumberOfPoints=\"12\"", "NumberOfPoints=\"13\"", "array 'Points' has fewer than 39 numbers");
  refuses(ascii, "NumberOfPoints=\"12\"", "NumberOfPoints=\"99999999999\"", "array 'Points' has fewer than");
  refuses(ascii, "Name=\"types\"", "Name=\"kinds\"", "the piece has no array 'types' of its cells");
  refuses(ascii, "10 20", "10 x", "a.vtu:8: array 'node_id' has 'x' (a whole number is expected)");
  refuses(ascii, "\"Int32\" Name=\"offsets\"", "\"Float32\" Name=\"offsets\"",
          "array 'offsets' has the type 'Float32'");
  refuses(ascii, "8 16 ", "8 7 ", "the offset of cell 1 is below the one before");
  refuses(ascii, "8 16 ", "7 16 ", "cell 0 has 7 points (a cell of type 12 has 8)");
  refuses(ascii, "12 12 ", "12 25 ", "block 'block_2' has 1 elements of kind VTK cell type 25");
  refuses(ascii, "0 4 5", "0 4 12", "a cell has point 12 (there are the points 0 to 11)");
  refuses(ascii, "</Piece>", "</Piece><Piece NumberOfPoints=\"1\" NumberOfCells=\"1\"></Piece>", "has several pieces");
  refuses(inlined, "NumberOfPoints=\"12\"", "NumberOfPoints=\"13\"", "array 'Points' has 144 bytes (156 are expected)");
  refuses(inlined, "LittleEndian", "BigEndian", "is big-endian");
  refuses(inlined, "format=\"binary\">\n  ", "format=\"binary\">\n  ?", "array 'node_id' is no base64");
  refuses(inlined, "\"Int32\"", "\"Int33\"", "array 'node_id' has the type 'Int33', which is unknown");
  refuses(packed, "vtkZLibDataCompressor", "vtkLZ4DataCompressor",
          "compressor is 'vtkLZ4DataCompressor': save the file");
  refuses(packed, "NumberOfPoints=\"12\"", "NumberOfPoints=\"11\"", "array 'Points' has more than 132 bytes");
  refuses(packed, "NumberOfPoints=\"12\"", "NumberOfPoints=\"99999999999\"",
          "array 'Points' cannot be filled by the file");
  refuses(raw, "encoding=\"raw\"", "encoding=\"row\"", "encoding is 'row' (raw and base64 are read)");
  refuses(raw, "\n_", "\n", "appended data do not begin with an underscore");
  refuses(raw, "offset=\"0\"", "offset=\"999999\"", "begins behind the end of the file");
  refuses(raw, "header_type=\"UInt64\"", "header_type=\"UInt32\"", "bytes (");
  refuses(raw.substr(0, raw.size() - 40), "", "", "bytes more than the file has");
}

}  // namespace
}  // namespace percuss
