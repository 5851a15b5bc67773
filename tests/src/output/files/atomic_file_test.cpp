// Files that are replaced in one step.

#include "src/output/files/atomic_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace percuss {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(AtomicFile, FollowsNoLinkThatStandsInThePlaceOfItsTemporary) {
  const fs::path folder = fs::path(testing::TempDir()) / ("percuss_atomic_" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "precious") << "keep";
  fs::create_symlink(folder / "precious", folder / "summary.json.tmp");
  write_file_atomically(folder / "summary.json", "new", Durability::system);
  EXPECT_EQ(read(folder / "precious"), "keep");
  EXPECT_EQ(read(folder / "summary.json"), "new");
  EXPECT_FALSE(fs::is_symlink(folder / "summary.json"));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace percuss
