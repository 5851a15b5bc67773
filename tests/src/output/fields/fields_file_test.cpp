// fields.vtkhdf as written: structure and every number, read back through the HDF5 library.

#include "src/output/vtkhdf/fields_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "src/error.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/output/hdf5_file_view.hpp"
#include "tests/src/output/sample_run.hpp"

namespace percuss {
namespace {

using sample::Hdf5FileView;
using sample::TemporaryFolder;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing_mesh::add_element;

constexpr int frames = 3;

std::string read_text(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_run(const TemporaryFolder& folder, const Mesh& mesh, const FieldsOptions& options = sample::options()) {
  FieldsFile file = sample::create_file(folder.path(), mesh, options);
  for (int frame = 0; frame < frames; ++frame) sample::write_frame(file, mesh, frame);
  file.close();
}

// The rows that a frame has in a dataset, by the offsets that a reader would use.
std::vector<double> rows_of_frame(const Hdf5FileView& file, const std::string& group, const std::string& name,
                                  int frame, std::size_t items, std::size_t components) {
  const auto offsets = file.whole_numbers("VTKHDF/Steps/" + group + "Offsets/" + name);
  const auto all = file.numbers("VTKHDF/" + group + "/" + name);
  const auto first = all.begin() + offsets.at(static_cast<std::size_t>(frame)) * static_cast<long>(components);
  return {first, first + static_cast<long>(items * components)};
}

TEST(FieldsFile, SaysThatItIsATemporalUnstructuredGridOfVersionTwo) {
  const TemporaryFolder folder;
  write_run(folder, sample::make_mesh());
  const Hdf5FileView file(folder.file("fields.vtkhdf"));
  EXPECT_THAT(file.attribute("VTKHDF", "Version"), ElementsAre(2, 0));
  EXPECT_EQ(file.text_attribute("VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_THAT(file.attribute("VTKHDF/Steps", "NSteps"), ElementsAre(frames));
  EXPECT_THAT(file.numbers("VTKHDF/Steps/Values"), ElementsAre(0.0, sample::time_of(1), sample::time_of(2)));
  EXPECT_THAT(file.whole_numbers("percuss/step"), ElementsAre(0, 10, 20));
  EXPECT_EQ(file.text_attribute("percuss", "units"), "m, kg, s");
}

TEST(FieldsFile, StoresShellsAsQuadrilaterals) {
  Mesh mesh = sample::make_mesh();
  const Elements hexahedra = std::exchange(mesh.elements, {});
  std::vector<int> types;
  for (std::size_t e = 0; e < hexahedra.size(); ++e) {
    const auto h = hexahedra.corners(e);
    const int part = hexahedra.block_of(e).part;
    if (e % 3 == 1)
      add_element(mesh.elements, TopologyKind::quad4, {h[0], h[1], h[2], h[3]}, part);
    else
      add_element(mesh.elements, TopologyKind::hex8, {h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7]}, part);
    types.push_back(e % 3 == 1 ? 9 : 12);
  }
  const TemporaryFolder folder;
  write_run(folder, mesh);
  const Hdf5FileView file(folder.file("fields.vtkhdf"));
  const auto connectivity = file.whole_numbers("VTKHDF/Connectivity");
  const auto offsets = file.whole_numbers("VTKHDF/Offsets");
  const auto mixed = file.whole_numbers("percuss/xdmf_topology");
  EXPECT_THAT(file.whole_numbers("VTKHDF/Types"), testing::ElementsAreArray(types));
  ASSERT_EQ(offsets.size(), mesh.elements.size() + 1);
  EXPECT_EQ(offsets.front(), 0);
  EXPECT_EQ(offsets.back(), static_cast<long>(connectivity.size()));
  EXPECT_THAT(file.whole_numbers("VTKHDF/NumberOfConnectivityIds"), ElementsAre(connectivity.size()));
  std::size_t at = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto corners = static_cast<std::size_t>(types[e] == 9 ? 4 : 8), first = static_cast<std::size_t>(offsets[e]);
    EXPECT_EQ(static_cast<std::size_t>(offsets[e + 1]) - first, corners);
    EXPECT_EQ(mixed.at(at++), types[e] == 9 ? 5 : 9);  // XDMF's numbers
    for (std::size_t i = 0; i < corners; ++i) {
      EXPECT_EQ(connectivity.at(first + i), mesh.corners(e)[i]);
      EXPECT_EQ(mixed.at(at++), mesh.corners(e)[i]);
    }
  }
  EXPECT_EQ(at, mixed.size());
  EXPECT_THAT(read_text(folder.file("fields.xdmf")), HasSubstr("TopologyType=\"Mixed\""));
}

TEST(FieldsFile, KeepsTheKindsOfElementsForXdmfWhateverTheirNumbers) {
  Mesh mesh =
      sample::make_mesh();  // of 16 elements: eight corners and three have a mean of four if three are hexahedra
  const Elements hexahedra = std::exchange(mesh.elements, {});
  mesh.elements.blocks = hexahedra.blocks;
  mesh.elements.add(0, hexahedra.corners(0));
  mesh.element_ids.resize(5);
  for (std::size_t e = 1; e < 5; ++e) {
    const auto h = hexahedra.corners(e);
    add_element(mesh.elements, TopologyKind::tri3, {h[0], h[1], h[2]});
  }
  ChunkedMesh chunked;
  chunked.numbering = {{0, 5}, {0, static_cast<std::int64_t>(mesh.nodes.size())}, {0}};
  chunked.chunks = {{0, 5, 0, 0}};
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) mesh.node_numbers.push_back(static_cast<std::int64_t>(n));
  mesh.parts.resize(1);
  chunked.mesh = mesh;
  const TemporaryFolder folder;
  FieldsFile file(folder.path(), chunked, sample::options(), Communicator(MPI_COMM_SELF));
  file.close();
  EXPECT_THAT(Hdf5FileView(folder.file("fields.vtkhdf")).shape("percuss/xdmf_topology"), ElementsAre(8 + 4 * 3 + 5));
}

TEST(FieldsFile, SaysTheUnitOfEveryFieldWhereTheDeckNamesKnownOnes) {
  const TemporaryFolder folder;
  write_run(folder, sample::make_mesh());
  const Hdf5FileView file(folder.file("fields.vtkhdf"));
  EXPECT_EQ(file.text_attribute("VTKHDF/Points", "unit"), "m");
  EXPECT_EQ(file.text_attribute("VTKHDF/Steps/Values", "unit"), "s");
  EXPECT_EQ(file.text_attribute("VTKHDF/PointData/velocity", "unit"), "m/s");
  EXPECT_EQ(file.text_attribute("VTKHDF/CellData/stress", "unit"), "Pa");
  EXPECT_FALSE(file.has_attribute("VTKHDF/CellData/flag", "unit"));
  const TemporaryFolder other;
  write_run(other, sample::make_mesh(), {"", "inch and pound", FieldPrecision::float64});
  EXPECT_FALSE(Hdf5FileView(other.file("fields.vtkhdf")).has_attribute("VTKHDF/PointData/velocity", "unit"));
}

TEST(FieldsFile, KeepsTheRigidWalls) {
  const TemporaryFolder folder;
  FieldsOptions options = sample::options();
  options.walls = {{{1, 2, 3}, {0, 0, 1}}, {{4, 5, 6}, {-1, 0, 0}}};
  write_run(folder, sample::make_mesh(), options);
  const Hdf5FileView file(folder.file("fields.vtkhdf"));
  EXPECT_THAT(file.shape("percuss/walls"), ElementsAre(2, 6));
  EXPECT_THAT(file.numbers("percuss/walls"), ElementsAre(1, 2, 3, 0, 0, 1, 4, 5, 6, -1, 0, 0));
  EXPECT_FALSE(file.has("percuss/round_walls"));
  const TemporaryFolder without;
  write_run(without, sample::make_mesh(), {"", "", FieldPrecision::float64});
  EXPECT_FALSE(Hdf5FileView(without.file("fields.vtkhdf")).has("percuss/walls"));
}

TEST(FieldsFile, KeepsCylindersAndSpheres) {
  const TemporaryFolder folder;
  FieldsOptions options = sample::options();
  options.round_walls = {{{1, 2, 3}, {0, 0, 1}, 0.5, 4, {}}, {{7, 8, 9}, {}, 0.25, 0, {}}};
  write_run(folder, sample::make_mesh(), options);
  const Hdf5FileView file(folder.file("fields.vtkhdf"));
  EXPECT_THAT(file.shape("percuss/round_walls"), ElementsAre(2, 11));
  EXPECT_THAT(file.numbers("percuss/round_walls"),
              ElementsAre(1, 2, 3, 0, 0, 1, 0.5, 4, 0, 0, 0, 7, 8, 9, 0, 0, 0, 0.25, 0, 0, 0, 0));
}

TEST(FieldsFile, StoresTheCellsOnceAndSendsEveryStepBackToThem) {
  const TemporaryFolder folder;
  const Mesh mesh = sample::make_mesh();
  write_run(folder, mesh);
  const Hdf5FileView file(folder.file("fields.vtkhdf"));
  const auto elements = mesh.elements.size();
  EXPECT_THAT(file.shape("VTKHDF/Connectivity"), ElementsAre(8 * elements));
  const auto connectivity = file.whole_numbers("VTKHDF/Connectivity");
  for (std::size_t e = 0; e < elements; ++e)
    EXPECT_TRUE(
        std::equal(mesh.corners(e).begin(), mesh.corners(e).end(), connectivity.begin() + static_cast<long>(8 * e)));
  EXPECT_EQ(file.whole_numbers("VTKHDF/Offsets").back(), static_cast<long>(8 * elements));
  EXPECT_THAT(file.whole_numbers("VTKHDF/Types"), Each(12));
  EXPECT_THAT(file.whole_numbers("VTKHDF/NumberOfCells"), ElementsAre(elements));
  EXPECT_THAT(file.whole_numbers("VTKHDF/NumberOfPoints"), ElementsAre(mesh.nodes.size()));
  for (const char* name : {"PartOffsets", "CellOffsets", "ConnectivityIdOffsets", "PointDataOffsets/node_id",
                           "CellDataOffsets/element_id", "CellDataOffsets/part"})
    EXPECT_THAT(file.whole_numbers(std::string("VTKHDF/Steps/") + name), ElementsAre(0, 0, 0)) << name;
  EXPECT_THAT(file.whole_numbers("VTKHDF/Steps/NumberOfParts"), ElementsAre(1, 1, 1));
}

TEST(FieldsFile, KeepsTheBitsOfEveryPositionAndField) {
  const TemporaryFolder folder;
  const Mesh mesh = sample::make_mesh();
  write_run(folder, mesh);
  const Hdf5FileView file(folder.file("fields.vtkhdf"));
  const std::size_t nodes = mesh.nodes.size(), elements = mesh.elements.size();
  const auto points = file.numbers("VTKHDF/Points");
  const auto offsets = file.whole_numbers("VTKHDF/Steps/PointOffsets");
  for (int frame = 0; frame < frames; ++frame) {
    const sample::Frame expected(mesh, frame);
    const auto first = points.begin() + 3 * offsets.at(static_cast<std::size_t>(frame));
    EXPECT_TRUE(std::equal(expected.positions.begin(), expected.positions.end(), first)) << "frame " << frame;
    EXPECT_EQ(rows_of_frame(file, "PointData", "velocity", frame, nodes, 3), expected.velocity);
    EXPECT_EQ(rows_of_frame(file, "CellData", "stress", frame, elements, 6), expected.stress);
    EXPECT_EQ(rows_of_frame(file, "CellData", "von_mises", frame, elements, 1), expected.von_mises);
    EXPECT_EQ(rows_of_frame(file, "CellData", "flag", frame, elements, 1), expected.flag);
  }
}

TEST(FieldsFile, KeepsTheIdsAndPartsOfTheMesh) {
  const TemporaryFolder folder;
  const Mesh mesh = sample::make_mesh();
  write_run(folder, mesh);
  const Hdf5FileView file(folder.file("fields.vtkhdf"));
  EXPECT_THAT(file.whole_numbers("VTKHDF/PointData/node_id"), testing::ElementsAreArray(mesh.node_ids));
  EXPECT_THAT(file.whole_numbers("VTKHDF/CellData/element_id"), testing::ElementsAreArray(mesh.element_ids));
  EXPECT_THAT(file.whole_numbers("VTKHDF/CellData/part"),
              testing::ElementsAreArray(testing_mesh::list_parts(mesh.elements)));
}

TEST(FieldsFile, AddsTheDisplacementFromThePositions) {
  const TemporaryFolder folder;
  const Mesh mesh = sample::make_mesh();
  write_run(folder, mesh);
  const Hdf5FileView file(folder.file("fields.vtkhdf"));
  const auto displacement = rows_of_frame(file, "PointData", "displacement", 2, mesh.nodes.size(), 3);
  const sample::Frame last(mesh, 2);
  for (std::size_t i = 0; i < displacement.size(); ++i)
    EXPECT_EQ(displacement[i], last.positions[i] - mesh.nodes[i / 3][i % 3]);
}

TEST(FieldsFile, TakesADisplacementThatIsGivenInsteadOfItsOwn) {
  const TemporaryFolder folder;
  const Mesh mesh = sample::make_mesh();
  const sample::Frame data(mesh, 1);
  const FieldData given{"displacement", FieldPlace::node, 3, data.velocity};
  FieldsFile file = sample::create_file(folder.path(), mesh);
  file.write_frame(0, 0, data.positions, std::span(&given, 1));
  file.close();
  EXPECT_EQ(Hdf5FileView(folder.file("fields.vtkhdf")).numbers("VTKHDF/PointData/displacement"), data.velocity);
}

TEST(FieldsFile, StoresFieldsAsFloatsButPositionsAsDoublesWhenAskedTo) {
  const TemporaryFolder folder;
  const Mesh mesh = sample::make_mesh();
  write_run(folder, mesh, {"", "", FieldPrecision::float32});
  const Hdf5FileView file(folder.file("fields.vtkhdf"));
  EXPECT_EQ(file.bytes_of_number("VTKHDF/Points"), 8u);
  EXPECT_EQ(file.bytes_of_number("VTKHDF/CellData/stress"), 4u);
  const auto stored = rows_of_frame(file, "CellData", "von_mises", 2, mesh.elements.size(), 1);
  const sample::Frame expected(mesh, 2);
  for (std::size_t i = 0; i < stored.size(); ++i)
    EXPECT_EQ(stored[i], static_cast<double>(static_cast<float>(expected.von_mises[i])));
  EXPECT_THAT(read_text(folder.file("fields.xdmf")), HasSubstr("Precision=\"4\""));
}

TEST(FieldsFile, StoresFlagsInAByteEachWhateverThePrecision) {
  for (const FieldPrecision precision : {FieldPrecision::float64, FieldPrecision::float32}) {
    const TemporaryFolder folder;
    write_run(folder, sample::make_mesh(), {"", "", precision});
    EXPECT_EQ(Hdf5FileView(folder.file("fields.vtkhdf")).bytes_of_number("VTKHDF/CellData/flag"), 1u);
    EXPECT_THAT(read_text(folder.file("fields.xdmf")), HasSubstr("NumberType=\"UChar\" Precision=\"1\""));
  }
}

TEST(FieldsFile, IsReadableAfterEveryFrameWithoutBeingClosed) {
  const TemporaryFolder folder;
  const Mesh mesh = sample::make_mesh();
  FieldsFile file = sample::create_file(folder.path(), mesh);
  for (int frame = 0; frame < frames; ++frame) {
    sample::write_frame(file, mesh, frame);
    // A copy, because one process that opens a file twice would see what HDF5 holds in memory.
    std::filesystem::copy_file(folder.file("fields.vtkhdf"), folder.file("copy"),
                               std::filesystem::copy_options::overwrite_existing);
    const Hdf5FileView copy(folder.file("copy"));
    ASSERT_TRUE(copy.is_open());
    EXPECT_THAT(copy.attribute("VTKHDF/Steps", "NSteps"), ElementsAre(frame + 1));
    EXPECT_EQ(rows_of_frame(copy, "CellData", "stress", frame, mesh.elements.size(), 6),
              sample::Frame(mesh, frame).stress);
  }
}

TEST(FieldsFile, ReplacesAnOlderRun) {
  const TemporaryFolder folder;
  write_run(folder, sample::make_mesh(3));
  const Mesh mesh = sample::make_mesh(1);
  write_run(folder, mesh);
  EXPECT_THAT(Hdf5FileView(folder.file("fields.vtkhdf")).shape("VTKHDF/Points"),
              ElementsAre(frames * mesh.nodes.size(), 3));
}

TEST(FieldsFile, RefusesAFrameWithOtherFieldsThanTheFirst) {
  const TemporaryFolder folder;
  const Mesh mesh = sample::make_mesh();
  FieldsFile file = sample::create_file(folder.path(), mesh);
  sample::write_frame(file, mesh, 0);
  const sample::Frame data(mesh, 1);
  auto fields = data.fields();
  fields.pop_back();
  EXPECT_ERROR(file.write_frame(1, 1, data.positions, fields), std::logic_error, "has other fields than the first one");
  fields = data.fields();
  fields[0].values = fields[0].values.first(3);
  EXPECT_ERROR(file.write_frame(1, 1, data.positions, fields), std::logic_error,
               "field velocity has 3 values (it has 3 components on 54 items)");
  sample::write_frame(file, mesh, 1);  // a refused frame leaves no trace
  file.close();
  EXPECT_THAT(Hdf5FileView(folder.file("fields.vtkhdf")).attribute("VTKHDF/Steps", "NSteps"), ElementsAre(2));
}

TEST(FieldsFile, NamesTheFileAndTheReasonWhenTheFolderIsMissing) {
  const TemporaryFolder folder;
  try {
    FieldsFile file = sample::create_file(folder.file("missing"), sample::make_mesh());
    FAIL() << "a file was created in a folder that does not exist";
  } catch (const SystemError& error) {
    EXPECT_THAT(error.what(), HasSubstr(folder.file("missing/fields.vtkhdf")));
    EXPECT_THAT(error.what(), HasSubstr("No such file or directory"));
  }
}

TEST(FieldsFile, NamesTheFileAndTheReasonWhenTheFolderIsAFile) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("plain")) << "text";
  try {
    FieldsFile file = sample::create_file(folder.file("plain"), sample::make_mesh());
    FAIL() << "a file was created below a file";
  } catch (const SystemError& error) {
    EXPECT_THAT(error.what(), HasSubstr("Not a directory"));
  }
}

TEST(FieldsXdmf, ListsEveryFrameWithItsTimeAndEscapesNames) {
  const TemporaryFolder folder;
  write_run(folder, sample::make_mesh());
  const std::string text = read_text(folder.file("fields.xdmf"));
  for (int frame = 0; frame < frames; ++frame)
    EXPECT_THAT(text, HasSubstr("<Grid Name=\"frame " + std::to_string(frame) + "\""));
  EXPECT_THAT(text, HasSubstr("<Time Value=\"0.1\"/>"));
  EXPECT_THAT(text, HasSubstr("Value=\"right &lt;&amp;&quot;&gt; one\""));
  EXPECT_FALSE(std::filesystem::exists(folder.file("fields.xdmf.tmp")));
}

TEST(FieldsXdmf, SaysUnitsAndWallsBesideTheFields) {
  const TemporaryFolder folder;
  write_run(folder, sample::make_mesh());
  const std::string text = read_text(folder.file("fields.xdmf"));
  EXPECT_THAT(text, HasSubstr("<Information Name=\"unit of velocity\" Value=\"m/s\"/>"));
  EXPECT_THAT(text, HasSubstr("<Information Name=\"wall 0\" Value=\"point 0 0 -1, normal 0 0 1\"/>"));
  EXPECT_THAT(text, HasSubstr("<Attribute Name=\"velocity\"")) << "names are those of the datasets";
}

// read_with_vtk.py compares every number of the index by parts.
TEST(FieldsXdmf, GivesEachPartABlockWithItsNameAndEachFieldItsUnit) {
  const TemporaryFolder folder;
  write_run(folder, sample::make_mesh());
  const std::string text = read_text(folder.file("fields.xdmf2"));
  EXPECT_THAT(text, HasSubstr("<Grid Name=\"left\" GridType=\"Collection\" CollectionType=\"Temporal\">"));
  EXPECT_THAT(text, HasSubstr("<Attribute Name=\"velocity [m/s]\""));
  EXPECT_THAT(text, HasSubstr("<Attribute Name=\"flag\""));
}

TEST(FieldsXdmf, LetsTheIndexByPartsFallBehindByASixteenthAtMost) {
  const TemporaryFolder folder;
  const Mesh mesh = sample::make_mesh(1);
  FieldsFile file = sample::create_file(folder.path(), mesh);
  const auto count_frames = [&] {
    const std::string text = read_text(folder.file("fields.xdmf2"));
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find("<Time ", at)) != std::string::npos; ++at) ++found;
    return found / mesh.parts.size();
  };
  std::size_t texts = 0, before = 0;
  for (std::size_t frame = 1; frame <= 200; ++frame) {
    sample::write_frame(file, mesh, static_cast<int>(frame));
    const std::size_t there = count_frames();
    ASSERT_GE(there + there / 16, frame);
    texts += there != before ? 1 : 0;
    before = there;
  }
  EXPECT_LT(texts, 70u) << "it is not replaced with every frame";
  EXPECT_LT(before, 200u);
  file.close();
  EXPECT_EQ(count_frames(), 200u);
}

}  // namespace
}  // namespace percuss
