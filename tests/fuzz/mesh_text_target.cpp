// Text formats of meshes: from bytes to the chunks of a mesh that can be run. The first bytes choose the format.

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <utility>

#include "src/error.hpp"
#include "src/mesh/reading/results_reader.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/src/mesh/files/legacy_samples.hpp"
#include "tests/src/mesh/files/nastran_samples.hpp"
#include "tests/src/mesh/files/sample_files.hpp"
#include "tests/src/mesh/files/vtu_samples.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss::fuzz {
namespace {

using namespace testing_mesh;

/// One file for all inputs of a process, in a folder of its own, which included files cannot leave; gone at its end.
class InputFile {
 public:
  InputFile() { std::filesystem::create_directories(folder_); }
  ~InputFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  std::string write(const std::string& bytes) const {
    const std::string path = (folder_ / "mesh.k").string();
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
    return path;
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("percuss_fuzz_text_" + std::to_string(getpid()));
};

/// Arrays of cells and points in front of others.
std::string add_results(std::string text) {
  for (const auto& [section, name] : {std::pair("<CellData", "stress_xx"), std::pair("<PointData", "velocity")}) {
    const std::size_t place = text.find(section);
    const std::string components = name[0] == 'v' ? " NumberOfComponents=\"3\"" : "";
    const std::string array = std::string("<DataArray type=\"Float64\" Name=\"") + name + "\"" + components +
                              " format=\"ascii\">1 2 3</DataArray>";
    if (place != std::string::npos) text.insert(text.find('>', place) + 1, array);
  }
  return text;
}

}  // namespace

void try_bytes(const std::string& bytes) {
  static const InputFile file;
  PartDeck part = make_part_deck("p", FileMesh{file.write(bytes), {}, 1, false});
  part.thickness = 0.1;
  try {
    build_mesh(make_deck({part}));
  } catch (const InputError&) {
  }
  try {
    if (bytes.find("<VTKFile") < 4096 || bytes.starts_with("# vtk"))
      read_file_results(file.write(bytes), {{"stress_xx", "temp"}, {"velocity_z"}, {}});
  } catch (const InputError&) {
  }
}

std::vector<std::string> make_seeds() {
  return {gmsh_22,
          gmsh_41,
          make_binary_gmsh(false),
          make_binary_gmsh(true),
          keyword_deck,
          abaqus_input,
          gmsh_of_ten,
          keyword_of_ten,
          keyword_deck + "*INCLUDE\nmesh.k\n",
          nastran_short,
          nastran_long,
          nastran_free,
          nastran_of_ten,
          nastran_free + "INCLUDE 'mesh.k'\n",
          make_vtu({}),
          make_vtu({VtuForm::base64, true, false}),
          make_vtu({VtuForm::appended_base64, false, true}),
          make_vtu({VtuForm::appended_raw, true, true}),
          add_results(make_vtu({})),
          make_legacy_vtk({}),
          make_legacy_vtk({true, false}),
          make_legacy_vtk({false, true}),
          make_legacy_vtk({true, true})};
}

std::vector<std::string> make_words() {
  return {"$MeshFormat",
          "$Nodes",
          "$EndNodes",
          "$Elements",
          "$Entities",
          "$PhysicalNames",
          "*KEYWORD",
          "*NODE",
          "*INCLUDE",
          "*PART",
          "*SET_NODE",
          "_GENERATE",
          "_TITLE",
          "*SET_SEGMENT",
          "*END",
          "*ELEMENT_SOLID",
          "LONG=Y",
          "*ELEMENT_SHELL",
          "I10=Y",
          "*HEADING",
          "*SURFACE",
          "*ELSET",
          "*INSTANCE",
          "SPOS",
          "\xff\xff\xff\xff",
          "BEGIN BULK\n",
          "\nGRID*",
          "\nCHEXA",
          "\nSET1",
          "THRU",
          "\nCORD2S",
          "\n+",
          "\n*",
          ",",
          "EXCEPT",
          "\nINCLUDE 'mesh.k'\n",
          "$HMSET",
          "<VTKFile ",
          "<DataArray ",
          "</Piece>",
          "format=\"appended\" ",
          "offset=\"9\" ",
          "<AppendedData encoding=\"raw\">_",
          "<!--",
          "\nCELL_DATA ",
          "\nOFFSETS ",
          "\nMETADATA\n",
          "\nFIELD f 1\n",
          "vtktypeint64",
          "&quot;"};
}

}  // namespace percuss::fuzz
