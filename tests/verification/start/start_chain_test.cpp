// Results of a run, or of another program, as the state at time 0: Exodus II and VTK files of start.fields.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/verification/support/deck_folder.hpp"

namespace percuss::test::start_chain_test {
namespace {

using testing::HasSubstr;

/// A hot block and a bent plate of three layers; a rigid part and a truss that have nothing.
std::string make_scene(const std::string& start, const std::string& fields = "") {
  return fmt::format(R"yaml(
time: {{end: 2e-5}}
parts:
  block: {{box: {{size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}}, at: [0.05, 0, 0.0012], material: hot}}
  plate: {{shell_plate: {{size: [0.2, 0.1], cells: [2, 2]}}, thickness: 0.002, points: 3, material: sheet}}
  wall: {{box: {{size: [1, 1, 1], cells: [1, 1, 1]}}, at: [0, 0, 1], material: hot, rigid: true}}
  rod: {{line: {{from: [0, 0, -1], to: [1, 0, -1], cells: 2}}, section: {{truss: {{area: 1e-4}}}}, material: sheet}}
materials:
  hot: {{model: johnson_cook, density: 7850, youngs_modulus: 20e9, poissons_ratio: 0.3, a: 5e7, b: 1e8, n: 0.4, melt_temperature: 1500, specific_heat: 450}}
  sheet: {{model: j2_plasticity, density: 2700, youngs_modulus: 7e9, poissons_ratio: 0.33, yield_stress: 2.2e7, hardening_modulus: 5e8}}
start: {{fields: [{}]}}
output:
  history: {{every: 0, elements: [{{name: hot, id: 3, part: block}}, {{name: bent, id: 10, part: plate, point: 3}}]}}
{})yaml",
                     start, fields);
}

constexpr const char* written =
    "  fields: {every: 1e-5, format: exodus, write: [velocity, temperature, stress, stress_point_1, stress_point_2, "
    "stress_point_3, equivalent_plastic_strain, equivalent_plastic_strain_point_1, equivalent_plastic_strain_point_2, "
    "equivalent_plastic_strain_point_3]}\n";

const char* const block_table =
    "element,stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx,equivalent_plastic_strain,temperature\n"
    "3,1e6,2e6,3e6,1e5,2e5,3e5,0.01,400\n5,-1e6,0,0,0,0,0,0,900\n";
const char* const plate_table =
    "element,layer,stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx,equivalent_plastic_strain\n"
    "10,1,-8e6,1e6,0,2e6,1e5,3e5,0.002\n10,2,0,0,0,1e6,1e5,3e5,0\n10,3,9e6,0,0,0,1e5,3e5,0.003\n11,2,5e5,0,0,0,0,0,0\n";
const char* const velocity_table = "node,velocity_x,velocity_y,velocity_z\n1,1,2,3\n5,-4,0,1\n";

/// One cube of 1 m with the results of another program, as text.
std::string make_vtu(const std::string& stress, const std::string& velocity, const std::string& more = "") {
  return fmt::format(R"xml(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="1">
<PointData><DataArray type="Float64" Name="velocity" NumberOfComponents="3" format="ascii">{}</DataArray></PointData>
<CellData><DataArray type="Float64" Name="stress" NumberOfComponents="6" format="ascii">{}</DataArray>{}</CellData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3 4 5 6 7</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">8</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">12</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
)xml",
                     velocity, stress, more);
}

const std::string no_velocity = "0 0 0  0 0 0  0 0 0  0 0 0  0 0 0  0 0 0  0 0 0  0 0 0";

std::string make_cube(const std::string& keys = "", const std::string& mesh = "mesh: {file: cube.vtu}") {
  return fmt::format(R"yaml(
time: {{end: 1e-6}}
parts: {{cube: {{{}, material: steel}}}}
materials: {{steel: {{model: elastic, density: 8, youngs_modulus: 1e9, poissons_ratio: 0}}}}
start: {{fields: [{{file: cube.vtu{}}}]}}
output: {{history: {{every: 0}}}}
)yaml",
                     mesh, keys);
}

}  // namespace

// The first row of a run that begins with the results of another is that of the other, to round-off: plastic strains,
// temperatures, layers, velocities and energies; parts have ids of their own.
TEST(StartChain, ARunGoesOnFromTheExodusFileOfAnother) {
  const DeckFolder folder;
  folder.add("block.csv", block_table);
  folder.add("plate.csv", plate_table);
  folder.add("v.csv", velocity_table);
  const HistoryTable first = folder.run_into(
      make_scene("{file: block.csv, part: block}, {file: plate.csv, part: plate}, {file: v.csv, part: block}", written),
      "a");
  const HistoryTable second = folder.run_into(make_scene("{file: a/fields.exo, time: 0}", written), "b");
  for (const char* column : {"internal", "kinetic", "momentum_x", "momentum_z", "hot_stress_xx", "hot_stress_zx",
                             "hot_eps", "hot_temperature", "bent_stress_xx", "bent_stress_yz", "bent_eps"}) {
    EXPECT_NE(first[column][0], 0) << column;
    EXPECT_NEAR(second[column][0], first[column][0], 1e-13 * std::abs(first[column][0])) << column;
  }
  // The last step, on the mesh of time 0: energies of the stresses there.
  const Outcome last = folder.run(make_scene("{file: a/fields.exo, take: [stress]}"));
  EXPECT_NE(last.history["bent_stress_xx"][0], first["bent_stress_xx"][0]);
  EXPECT_NEAR(last.history["bent_stress_xx"][0], first.last("bent_stress_xx"),
              0.02 * std::abs(first.last("bent_stress_xx")));
  EXPECT_EQ(last.history["hot_eps"][0], 0);
  EXPECT_EQ(last.history["kinetic"][0], 0);
  // A part alone.
  const Outcome block = folder.run(make_scene("{file: a/fields.exo, time: 0, part: block}"));
  EXPECT_NEAR(block.history["hot_temperature"][0], 400, 1e-10);
  EXPECT_EQ(block.history["bent_stress_xx"][0], 0);
}

TEST(StartChain, ExodusFilesThatDoNotFitAreRefused) {
  const DeckFolder folder;
  folder.add("block.csv", block_table);
  folder.run_into(
      make_scene("{file: block.csv, part: block}", "  fields: {every: 1e-5, format: exodus, write: [stress]}\n"), "a");
  const auto find = [&](const std::string& start) { return folder.find_error(make_scene(start)); };
  EXPECT_THAT(find("{file: a/fields.exo, time: 0.5}"),
              HasSubstr("a/fields.exo: error: there is no step at the time 0.5 (the nearest of its "));
  EXPECT_THAT(find("{file: a/fields.exo, take: [temperature]}"),
              HasSubstr("a/fields.exo: error: there is no variable 'temperature' of elements (there are: "));
  EXPECT_THAT(find("{file: block.csv, part: block, time: 0}"),
              HasSubstr("block.csv: error: time has no effect on a table"));
  EXPECT_THAT(find("{file: none.exo}"), HasSubstr("start.fields.0.file is 'none.exo' (there is no file "));
  const std::string bytes = folder.read("a/fields.exo");
  folder.add("short.exo", bytes.substr(0, bytes.size() / 2));
  EXPECT_THAT(find("{file: short.exo}"), HasSubstr("short.exo: error: the file is truncated"));
  std::string other = make_scene("{file: a/fields.exo}");
  other.replace(other.find("cells: [2, 2, 2]"), 16, "cells: [1, 2, 2]");
  EXPECT_THAT(folder.find_error(other), HasSubstr("a/fields.exo: error: there is no element 5 in part 'block'"));
}

TEST(StartChain, AVtkFileGivesStressesAndVelocities) {
  const DeckFolder folder;
  folder.add("cube.vtu", make_vtu("1e6 0 0 0 0 0", "1 2 3" + no_velocity.substr(5)));
  const Outcome run = folder.run(make_cube());
  EXPECT_DOUBLE_EQ(run.history["internal"][0], 1e12 / 2e9);
  EXPECT_NEAR(run.history["momentum_z"][0], 3, 1e-14);  // mass 1 a node
  const Outcome still = folder.run(make_cube(", take: [stress]"));
  EXPECT_EQ(still.history["momentum_z"][0], 0);
  folder.add("cube.vtu", make_vtu("0 0 0 0 0 0", no_velocity,
                                  "<DataArray type=\"Float64\" Name=\"stress_xx\" format=\"ascii\">2e6</DataArray>"));
  EXPECT_DOUBLE_EQ(folder.run(make_cube()).history["internal"][0], 4e12 / 2e9);  // the later array counts
}

TEST(StartChain, DisplacementsOfAFileAreToldOf) {
  const DeckFolder folder;
  const auto list = [&](const std::string& displacement) {
    std::string file = make_vtu("1e6 0 0 0 0 0", no_velocity);
    const std::string data = "<PointData>";
    file.insert(file.find(data) + data.size(),
                "<DataArray type=\"Float64\" Name=\"displacement\" NumberOfComponents=\"3\" format=\"ascii\">" +
                    displacement + no_velocity.substr(5) + "</DataArray>");
    folder.add("cube.vtu", file);
    std::string text;
    for (const Warning& warning : folder.run(make_cube()).summary.warnings)
      if (warning.rule == "unused_displacement") text += format_warning(warning);
    return text;
  };
  EXPECT_EQ(list("0 0 0"), "");
  const std::string told = list("0 0.1 -0.25");
  EXPECT_THAT(told, HasSubstr("deck.yaml:5:18: warning: the displacements of "));
  EXPECT_THAT(told, HasSubstr("cube.vtu are not used, 'displacement_z' reaches 0.25 (stresses and velocities go onto"));
}

TEST(StartChain, VtkFilesThatDoNotFitAreRefused) {
  const DeckFolder folder;
  const auto find = [&](const std::string& text, const std::string& keys = "",
                        const std::string& mesh = "box: {size: [1, 1, 1], cells: [1, 1, 1]}") {
    folder.add("cube.vtu", text);
    return folder.find_error(make_cube(keys, mesh));
  };
  const std::string good = make_vtu("1e6 0 0 0 0 0", no_velocity);
  EXPECT_EQ(find(good), "");
  EXPECT_THAT(find(make_vtu("1e6 0 nan 0 0 0", no_velocity)), HasSubstr("cube.vtu"));
  EXPECT_THAT(find(make_vtu("1e6 0 1e200 0 0 0", no_velocity)),
              HasSubstr("cube.vtu: error: element 1 has the stress 1e+200 (must be a number up to 1e100)"));
  EXPECT_THAT(find(make_vtu("1e6 0 0 0 0", no_velocity)), HasSubstr("array 'stress' has 5 numbers (6 are expected)"));
  EXPECT_THAT(find(good, ", time: 0"), HasSubstr("cube.vtu: error: a VTK file has no times: leave out the key time"));
  EXPECT_THAT(find(good, ", take: [stress, temperature]"),
              HasSubstr("cube.vtu: error: there is no variable 'temperature' of elements (there are: stress_xx"));
  EXPECT_THAT(find(make_vtu("1e6 0 0 0 0 0", no_velocity,
                            "<DataArray type=\"Float64\" Name=\"temperature\" format=\"ascii\">300</DataArray>")),
              HasSubstr("cube.vtu: error: element 1 has a temperature (its material has none)"));
  EXPECT_THAT(find(make_vtu(
                  "1e6 0 0 0 0 0", no_velocity,
                  "<DataArray type=\"Float64\" Name=\"equivalent_plastic_strain\" format=\"ascii\">-0.1</DataArray>")),
              HasSubstr("element 1 has the equivalent plastic strain -0.1 (must be zero or positive)"));
  std::string bare = good;
  for (const char* name : {"\"stress\"", "\"velocity\""}) bare[bare.find(name) + 1] = 'X';
  EXPECT_THAT(find(bare),
              HasSubstr("cube.vtu: error: there is no stress, equivalent_plastic_strain or temperature of elements"));
  EXPECT_THAT(find(good.substr(0, good.size() / 2)), HasSubstr("cube.vtu"));
}

}  // namespace percuss::test::start_chain_test
