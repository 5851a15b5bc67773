// Thickness of each shell: by an expression, and as each format of mesh files has it.

#include "src/mesh/thicknesses.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "tests/src/mesh/exodus_writer.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

Mesh build(const std::string& part) {
  return build_mesh(parse_deck(fmt::format("time: {{end: 1}}\nparts: {{p: {{{}, material: steel}}}}\n"
                                           "materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: "
                                           "200e9, poissons_ratio: 0.3}}}}\n",
                                           part),
                               "deck.yaml"));
}

std::string refuse(const std::string& part) {
  try {
    build(part);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

std::vector<double> list_thicknesses(const Mesh& mesh) {
  std::vector<double> all;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) all.push_back(mesh.thickness_of(e));
  return all;
}

/// A part of a file that is gone at the end.
template <class Use>
void use_file(const std::string& path, const std::string& keys, const Use& use) {
  use(fmt::format("mesh: {{file: {}{}}}", path, keys));
  std::remove(path.c_str());
}

const std::string keyword = R"(*KEYWORD
*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,2,0,0
6,2,1,0
*PART
sheet
1,
*ELEMENT_SHELL_THICKNESS
10,1,1,2,3,4
0.1,0.1,0.1,0.1
11,1,2,5,6,3
0.1,0.2,0.3,0.4
12,1,5,6,3,3
0.1,,0.2
*ELEMENT_SHELL
13,1,1,2,3,3
*END
)";

const std::string abaqus = R"(*HEADING
*NODE
1, 0., 0., 0.
2, 1., 0., 0.
3, 1., 1., 0.
4, 0., 1., 0.
5, 2., 0., 0.
6, 2., 1., 0.
*ELEMENT, TYPE=S4R, ELSET=SHEET
10, 1, 2, 3, 4
11, 2, 5, 6, 3
*NSET, NSET=LEFT
1, 4
*SHELL SECTION, ELSET=SHEET, MATERIAL=STEEL, NODAL THICKNESS
0.7, 5
*NODAL THICKNESS
LEFT, 0.1
2, 0.3
3, 0.3
)";

}  // namespace

TEST(Thicknesses, OfAnExpressionAreThoseAtTheMeansOfCorners) {
  const Mesh mesh = build("shell_plate: {size: [4, 1], cells: [4, 1]}, thickness: {expression: \"0.1 + x / 100 + z\"}");
  EXPECT_THAT(list_thicknesses(mesh), ElementsAre(DoubleEq(0.105), DoubleEq(0.115), DoubleEq(0.125), DoubleEq(0.135)));
  EXPECT_DOUBLE_EQ(mesh.block_of(0).section.thickness, 0.135);  // the largest
  EXPECT_THAT(mesh.notes, ElementsAre("part 'p': shells 0.105 to 0.135 thick"));
}

TEST(Thicknesses, OfOnePartLeaveOthersAsTheyAre) {
  const Mesh mesh = build("shell_plate: {size: [4, 1], cells: [4, 1]}, thickness: 0.2");
  EXPECT_THAT(mesh.elements.own_thickness, IsEmpty());
  EXPECT_EQ(mesh.thickness_of(3), 0.2);
}

TEST(Thicknesses, OfAKeywordFileAreMeansOfCorners) {
  use_file(write_bytes(keyword, "thick.k"), ", scale: 2", [](const std::string& shape) {
    const Mesh mesh = build(shape + ", thickness: {file: true, otherwise: 0.9}, at: [5, 0, 0]");
    ASSERT_EQ(mesh.elements.size(), 4U);
    for (std::size_t e = 0; e < 4; ++e) {
      const std::int64_t id = mesh.element_ids[e];
      EXPECT_DOUBLE_EQ(mesh.thickness_of(e), id == 10 ? 0.2 : id == 11 ? 0.5 : id == 12 ? 0.3 : 0.9);
    }
    EXPECT_THAT(refuse(shape + ", thickness: {file: true}"),
                HasSubstr("the file has no thickness for element 13 of part 'p': give thickness.otherwise"));
    const Mesh unused = build(shape + ", thickness: 0.4");
    EXPECT_EQ(unused.thickness_of(0), 0.4);
    EXPECT_THAT(unused.warnings,
                Contains(Field(&Warning::text, HasSubstr("the file gives 3 of its shells are not used"))));
    const Mesh copies =
        build(shape + ", thickness: {file: true, otherwise: 0.9}, array: {count: [1, 2, 1], pitch: [0, 9, 0]}");
    double sum = 0;
    for (const double t : list_thicknesses(copies)) sum += t;
    EXPECT_NEAR(sum, 2 * (0.2 + 0.5 + 0.3 + 0.9), 1e-14);
  });
}

TEST(Thicknesses, OfAbaqusNodesAreAveraged) {
  use_file(write_bytes(abaqus, "thick.inp"), "", [](const std::string& shape) {
    const Mesh mesh = build(shape + ", thickness: {file: true, otherwise: 0.7}");
    ASSERT_EQ(mesh.elements.size(), 2U);
    for (std::size_t e = 0; e < 2; ++e)
      EXPECT_DOUBLE_EQ(mesh.thickness_of(e), mesh.element_ids[e] == 10 ? 0.2 : 0.7);  // nodes 5 and 6 have none
  });
}

TEST(Thicknesses, OfExodusAreTheFirstAttribute) {
  WrittenMesh written;
  written.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
  written.blocks = {{1, "sheet", "SHELL4", 4, {1, 2, 3, 4, 2, 5, 6, 3}, {0.25, 0.5}}};
  use_file(write_exodus(written, "thick.exo"), "", [](const std::string& shape) {
    const Mesh mesh = build(shape + ", thickness: {file: true}");
    for (std::size_t e = 0; e < 2; ++e) EXPECT_EQ(mesh.thickness_of(e), mesh.element_ids[e] == 1 ? 0.25 : 0.5);
  });
  written.blocks[0].attribute = {};
  use_file(write_exodus(written, "thin.exo"), "", [](const std::string& shape) {
    EXPECT_THAT(refuse(shape + ", thickness: {file: true}"), HasSubstr("the file gives its shells no thickness"));
  });
}

TEST(Thicknesses, ThatCannotBeAreRefusedAtTheirPlace) {
  const std::string plate = "shell_plate: {size: [4, 1], cells: [4, 1]}, thickness: ";
  EXPECT_THAT(refuse(plate + "{expression: x - 1}"),
              HasSubstr("deck.yaml:2:57: error: the thickness of element 1 of part 'p' is not positive and finite"));
  EXPECT_THAT(refuse(plate + "{expression: 1 / (x - x)}"), HasSubstr("not positive and finite"));
  EXPECT_THAT(refuse(plate + "{file: true}"), HasSubstr("its shape is generated"));
  EXPECT_THAT(refuse(plate + "{otherwise: 1}"), HasSubstr("neither expression nor file: true"));
  EXPECT_THAT(refuse(plate + "{expression: 1, otherwise: 1}"), HasSubstr("otherwise has no effect"));
  EXPECT_THAT(refuse(plate + "{expression: x + 1}, reference: top"), HasSubstr("it needs one thickness of all shells"));
}

}  // namespace percuss
