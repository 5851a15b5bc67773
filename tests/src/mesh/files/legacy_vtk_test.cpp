// Meshes of legacy VTK files: the same as those of the other formats, in every form; and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "src/error.hpp"
#include "src/mesh/reading/results_reader.hpp"
#include "tests/src/mesh/files/legacy_samples.hpp"
#include "tests/src/mesh/files/read_sample.hpp"
#include "tests/src/mesh/files/sample_files.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(LegacyVtk, IsTheMeshOfTheOtherFormatsInEveryForm) {
  const PartMesh expected = read_part(abaqus_input, "two.inp", {"left", "right", "cap"});
  for (const int bits : {0, 1, 2, 3}) {
    const PartMesh mesh = read_part(make_legacy_vtk({(bits & 1) != 0, (bits & 2) != 0}), "two.vtk");
    EXPECT_EQ(mesh.nodes, expected.nodes);
    EXPECT_EQ(mesh.node_ids, expected.node_ids);
    EXPECT_EQ(mesh.element_ids, expected.element_ids);
    ASSERT_EQ(mesh.elements.size(), expected.elements.size());
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      EXPECT_THAT(mesh.elements.corners(e), testing::ElementsAreArray(expected.elements.corners(e)));
    EXPECT_THAT(mesh.elements.own_thickness, ElementsAre(0, 0, 0.5, 0.25));
    ASSERT_EQ(mesh.elements.blocks.size(), 3U);
    EXPECT_EQ(mesh.elements.blocks[1].name, "block_2");
    EXPECT_THAT(mesh.warnings, ElementsAre(Field(&Warning::text, HasSubstr("velocity of the file are not read"))));
  }
}

TEST(LegacyVtk, HasResultsByTheirComponents) {
  for (const int bits : {0, 3}) {
    const std::string path = write_bytes(make_legacy_vtk({(bits & 1) != 0, (bits & 2) != 0}), "two.vtk");
    const FileResults results = read_file_results(path, {{"Thickness"}, {"velocity_x"}, {}});
    std::remove(path.c_str());
    EXPECT_THAT(results.of_elements.at("Thickness").values, ElementsAre(0, 0, 0.5, 0.25));
    EXPECT_THAT(results.of_nodes.at("velocity_x").values, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2));
    EXPECT_THAT(results.element_ids, ElementsAre(3, 4, 5, 6));
  }
}

TEST(LegacyVtk, IsTextWithoutALookupTableAndInSmallLetters) {
  std::string text = change(make_legacy_vtk({}), "LOOKUP_TABLE default\n", "");
  text = change(change(text, "ASCII", "ascii"), "DATASET UNSTRUCTURED_GRID", "dataset unstructured_grid");
  EXPECT_EQ(read_part(text, "two.vtk").elements.blocks.at(1).name, "block_2");
}

TEST(LegacyVtk, IsRefusedAtThePlaceOfTheFault) {
  const std::string text = make_legacy_vtk({}), offsets = make_legacy_vtk({false, true}),
                    binary = make_legacy_vtk({true, false});
  const auto refuses = [](const std::string& wrong, const std::string& why) {
    EXPECT_THAT([&] { read_part(wrong, "a.vtk"); }, ThrowsMessage<InputError>(HasSubstr(why)));
  };
  refuses(change(text, "Version 3.0", "Version 9.0"), "a.vtk:1: the version is '9.0' (1 to 5 are read)");
  refuses(change(text, "ASCII", "HEX"), "a.vtk:3: 'HEX' stands where ASCII or BINARY is expected");
  refuses(change(text, "UNSTRUCTURED_GRID", "POLYDATA"),
          "a.vtk:4: the file is a 'POLYDATA' (UNSTRUCTURED_GRID is read)");
  refuses(change(text, "DATASET UNSTRUCTURED_GRID\n", ""), "'POINTS' stands where DATASET is expected");
  refuses(change(text, "POINTS 12 float", "POINTS -1 float"), "'-1' stands where a number of 'POINTS' is expected");
  refuses(change(text, "POINTS 12 float", "POINTS 12"), "'POINTS' has 2 words (3 are expected)");
  refuses(change(text, "POINTS 12 float", "POINTS 12 string"), "POINTS are of type 'string', which is not read");
  refuses(change(text, "POINTS 12", "POINTS 99999999999"), "which the rest of the file cannot hold");
  refuses(change(binary, "POINTS 12", "POINTS 99999999999"), "which the rest of the file cannot hold");
  refuses(change(text, "CELLS 4 26", "CELLS 5 26"), "CELLS has 4 cells (5 are expected)");
  refuses(change(text, "CELLS 4 26", "CELLS 4 25"), "points, more than CELLS has left");
  refuses(change(text, "CELL_TYPES 4", "CELL_TYPES 3"), "'5' stands where a section is expected");
  refuses(change(text, "CELL_DATA 4", "CELL_DATA 5"), "'CELL_DATA' is of 5 (there are 4)");
  refuses(change(text, "Thickness 1 4", "Thickness 1 3"), "array 'Thickness' has 3 rows (4 are expected)");
  refuses(change(text, "VECTORS velocity", "VECTOR velocity"), "'VECTOR' 'velocity' is not read");
  refuses(change(offsets, "OFFSETS", "OFFSET"), "'OFFSET' stands where OFFSETS is expected");
  refuses(change(offsets, "CELLS 5 22", "CELLS 5 21"), "OFFSETS are 0 to 22 (0 to 21 are expected)");
  std::string beyond = text;
  beyond.replace(text.rfind("11", text.find("CELL_TYPES")), 2, "12");
  refuses(beyond, "a cell has point 12 (there are the points 0 to 11)");
  const std::string no_number = change(text, "CELLS 4 26\n8", "CELLS 4 26\nx");
  const auto line =
      1 + std::count(no_number.begin(), no_number.begin() + static_cast<int>(no_number.find("\nx")) + 1, '\n');
  refuses(no_number, "a.vtk:" + std::to_string(line) + ": 'x' stands where a whole number is expected");
  refuses(binary.substr(0, binary.find("CELL_TYPES") + 20), "the file ends within CELL_TYPES");
  refuses(text.substr(0, text.find("CELLS")), "no element");
}

}  // namespace
}  // namespace percuss
