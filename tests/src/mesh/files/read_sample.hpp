#pragma once
// Samples of mesh files: read as a part, changed, or changed so that they are refused.

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "src/mesh/reading/part_reader.hpp"
#include "tests/src/mesh/exodus_writer.hpp"

namespace percuss::testing_mesh {

/// Through a file of this name.
inline PartMesh read_part(const std::string& text, const std::string& name, std::vector<std::string> blocks = {}) {
  const std::string path = write_bytes(text, name);
  try {
    PartMesh mesh = read_part_mesh({path, std::move(blocks), 1, false});
    std::remove(path.c_str());
    return mesh;
  } catch (...) {
    std::remove(path.c_str());
    throw;
  }
}

inline std::string change(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// A change of a sample, and what the message says of it.
struct WrongFile {
  const char* name;
  const std::string* text;
  const char *from, *to, *file, *message;
};

}  // namespace percuss::testing_mesh
