#pragma once
// The formats of mesh files, and the choice among them: by the first bytes, which names cannot belie, then by
// extension. A new format is a MeshFile of its own and a row in mesh_readers().

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/mesh/files/mesh_file.hpp"

namespace percuss {

struct MeshReader {
  std::string name;                     // "Exodus II"
  std::vector<std::string> extensions;  // ".e", ...
  bool uses_libraries = false;          // which may crash on a damaged file: it is tried in a process of its own first
  bool (*recognizes)(std::string_view first_bytes) = nullptr;
  std::unique_ptr<MeshFile> (*open)(const std::string& path) = nullptr;

  /// Seconds that are more than reading the file takes.
  unsigned find_patience(const std::string& path) const;
};

std::span<const MeshReader> mesh_readers();

/// The one whose libraries read Exodus II, whatever the file is called.
const MeshReader& exodus_reader();

/// Throws InputError if the file is of no known format, SystemError if it cannot be read; neither names the file.
const MeshReader& find_mesh_reader(const std::string& path);

}  // namespace percuss
