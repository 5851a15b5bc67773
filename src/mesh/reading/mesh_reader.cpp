#include "src/mesh/reading/mesh_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>

#include "src/error.hpp"
#include "src/mesh/files/text_numbers.hpp"
#include "src/mesh/formats/abaqus_file.hpp"
#include "src/mesh/formats/exodus/exodus_file.hpp"
#include "src/mesh/formats/exodus/trial_process.hpp"
#include "src/mesh/formats/gmsh_file.hpp"
#include "src/mesh/formats/keyword_file.hpp"
#include "src/mesh/formats/nastran/nastran_file.hpp"
#include "src/mesh/formats/vtu/legacy_vtk.hpp"
#include "src/mesh/formats/vtu/vtu_file.hpp"
#include "src/regular_file.hpp"

namespace percuss {
namespace {

template <class File>
std::unique_ptr<MeshFile> open_as(const std::string& path) {
  return std::make_unique<File>(path);
}

bool is_gmsh(std::string_view first) {
  const std::string_view text = strip_blanks(first);
  return text.starts_with("$MeshFormat") || text.starts_with("$Comments");
}

bool is_exodus(std::string_view first) { return first.starts_with("CDF") || first.starts_with("\x89HDF\r\n\x1a\n"); }

std::string read_first_bytes(const std::string& path) {
  if (const std::string kind = describe_irregular_file(path); !kind.empty())
    throw InputError(fmt::format("this is {} (a mesh must be a regular file)", kind));
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw SystemError("the file cannot be opened");
  std::array<char, 4096> bytes{};
  stream.read(bytes.data(), bytes.size());
  return {bytes.data(), static_cast<std::size_t>(stream.gcount())};
}

std::string find_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace

unsigned MeshReader::find_patience(const std::string& path) const {
  std::error_code ignored;
  const std::uintmax_t bytes = std::filesystem::file_size(path, ignored);
  return percuss::find_patience(ignored ? 0 : bytes);
}

std::span<const MeshReader> mesh_readers() {
  static const std::vector<MeshReader> readers = {
      {"Exodus II", {".e", ".exo", ".ex2", ".exii", ".g", ".gen", ".nc"}, true, is_exodus, open_as<ExodusFile>},
      {"Gmsh", {".msh"}, false, is_gmsh, open_gmsh_file},
      {"LS-DYNA keyword", {".k", ".key", ".dyn"}, false, is_keyword_file, open_keyword_file},
      {"Abaqus", {".inp"}, false, is_abaqus_file, open_abaqus_file},
      {"Nastran", {".bdf", ".nas", ".dat", ".fem"}, false, is_nastran_file, open_nastran_file},
      {"VTK", {".vtu"}, false, is_vtu_file, open_vtu_file},
      {"legacy VTK", {".vtk"}, false, is_legacy_vtk_file, open_legacy_vtk_file},
  };
  return readers;
}

const MeshReader& exodus_reader() { return mesh_readers().front(); }

const MeshReader& find_mesh_reader(const std::string& path) {
  const std::string first = read_first_bytes(path), extension = find_extension(path);
  const std::span<const MeshReader> readers = mesh_readers();
  for (const MeshReader& reader : readers) {
    if (reader.recognizes(first)) return reader;
  }
  std::string known;
  for (const MeshReader& reader : readers) {
    if (std::find(reader.extensions.begin(), reader.extensions.end(), extension) != reader.extensions.end())
      return reader;
    known += (known.empty() ? "" : ", ") + reader.name;
  }
  throw InputError(fmt::format("neither its first bytes nor its extension are those of a mesh format ({})", known));
}

}  // namespace percuss
