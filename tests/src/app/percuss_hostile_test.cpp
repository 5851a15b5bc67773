// The executable and files that were made to harm: what they lead to is refused, not followed, and nothing is obeyed.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/src/app/percuss_process.hpp"
#include "tests/src/mesh/exodus_writer.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;
using namespace testing_mesh;
using testing::HasSubstr;
using testing::Not;

std::string read(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

const char* const materials = "materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}\n";

class PercussHostile : public testing::Test {
 protected:
  /// A mesh of two cubes in the folder, as netCDF-4.
  std::string write_mesh(const WrittenMesh& mesh = make_two_cubes()) const {
    const std::string written = write_exodus(mesh, "hostile.e", Container::netcdf4), path = folder_.path() + "/mesh.e";
    fs::rename(written, path);
    return path;
  }

  TemporaryFolder folder_;
  std::string mesh_deck_ = folder_.write(
      "mesh.yaml", std::string("time: {end: 1e-3}\nparts: {p: {exodus: {file: mesh.e}, material: m}}\n") + materials);
  std::string box_deck_ = folder_.write(
      "box.yaml", std::string("time: {end: 1e-3}\nparts: {p: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: m}}\n"
                              "output: {fields: {every: 1}}\n") +
                      materials);
};

TEST_F(PercussHostile, AMeshTakesNothingFromAnotherFileUnasked) {
  const std::string mesh = write_mesh(), other = folder_.path() + "/other.h5";
  fs::copy_file(mesh, other);
  const hid_t file = H5Fopen(mesh.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  ASSERT_GE(H5Ldelete(file, "coordx", H5P_DEFAULT), 0);
  ASSERT_GE(H5Lcreate_external(other.c_str(), "/coordx", file, "coordx", H5P_DEFAULT, H5P_DEFAULT), 0);
  H5Fclose(file);
  for (const std::vector<std::string>& command : {std::vector<std::string>{"check", mesh_deck_},
                                                  {"run", mesh_deck_, "-o", folder_.path() + "/out"},
                                                  {"plan", mesh_deck_, "--ranks", "2"},
                                                  {"info", mesh}}) {
    const ProcessResult refused = run_percuss(command);
    EXPECT_EQ(refused.exit_code, 2) << command[0];
    EXPECT_THAT(refused.err, HasSubstr("link '/coordx' leads to another file")) << command[0];
    EXPECT_THAT(refused.err, HasSubstr("--allow-external")) << command[0];
  }
  EXPECT_THAT(run_percuss({"check", mesh_deck_}).err, HasSubstr("mesh.yaml:2:9: error: part 'p'"));
  EXPECT_THAT(run_percuss({"check", mesh_deck_, "--allow-external"}).err, Not(HasSubstr("another file")));
}

TEST_F(PercussHostile, PipesAndDevicesAreRefusedAtOnce) {
  const std::string pipe = folder_.path() + "/pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const ProcessResult deck = run_percuss({"check", pipe}), info = run_percuss({"info", pipe}),
                      zero = run_percuss({"info", "/dev/zero"}),
                      restart = run_percuss({"run", box_deck_, "--restart", pipe, "-o", folder_.path() + "/out"});
  EXPECT_THAT(deck.err, HasSubstr(pipe + ": error: the deck is a pipe"));
  EXPECT_THAT(info.err, HasSubstr(pipe + ": error: this is a pipe"));
  EXPECT_THAT(zero.err, HasSubstr("/dev/zero: error: this is a device"));
  EXPECT_THAT(restart.err, HasSubstr(pipe + ": error: the checkpoint is a pipe"));
  for (const ProcessResult* result : {&deck, &info, &zero, &restart}) EXPECT_EQ(result->exit_code, 2) << result->err;
}

class PercussHostileRestart : public PercussHostile {
 protected:
  /// A run that is to continue in its folder.
  void run_first() const {
    const ProcessResult run = run_percuss({"run", box_deck_, "-o", out_, "--set", "output.checkpoint={every: 5e-4}",
                                           "--set", "output.history={every: 0}"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  ProcessResult go_on(const std::string& from) const {
    return run_percuss({"run", box_deck_, "--restart", from, "-o", out_, "--set", "time.end=2e-3", "--set",
                        "output.history={every: 0}"});
  }

  std::string out_ = folder_.path() + "/out";
};

TEST_F(PercussHostileRestart, InPlaceWritesIntoNoOtherFile) {
  run_first();
  const std::string fields = out_ + "/fields.vtkhdf", other = folder_.path() + "/other.h5";
  fs::copy_file(fields, other);
  const std::string before = read(other);
  const hid_t file = H5Fopen(fields.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  ASSERT_GE(H5Ldelete(file, "VTKHDF/Steps", H5P_DEFAULT), 0);
  ASSERT_GE(H5Lcreate_external(other.c_str(), "/VTKHDF/Steps", file, "VTKHDF/Steps", H5P_DEFAULT, H5P_DEFAULT), 0);
  H5Fclose(file);
  const ProcessResult refused = go_on(out_);
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr(fields + ": error: link '/VTKHDF/Steps' leads to another file"));
  EXPECT_TRUE(read(other) == before);
}

TEST_F(PercussHostileRestart, InPlaceRefusesPipesAtOnce) {
  run_first();
  fs::copy_file(out_ + "/checkpoint.h5", out_ + "/saved.h5");
  for (const char* name : {"history.csv", "fields.vtkhdf", "summary.json", "checkpoint.h5"}) {
    const std::string path = out_ + "/" + name, aside = folder_.path() + "/aside";
    fs::rename(path, aside);
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    const ProcessResult refused = go_on(out_ + "/saved.h5");
    EXPECT_EQ(refused.exit_code, 2) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(path + ": error: this is a pipe"));
    fs::rename(aside, path);
  }
}

TEST_F(PercussHostile, NoNameOrTitleReachesTheTerminalAsAnOrder) {
  WrittenMesh mesh = make_two_cubes();
  mesh.blocks[0].name = "a\n\x1b]0;owned\x07";
  mesh.blocks[1].name = "\xe2\x80\xaegnp";
  const ProcessResult info = run_percuss({"info", write_mesh(mesh)});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("blocks      a \\x1b]0;owned\\x07, id 10"));
  EXPECT_THAT(info.out, HasSubstr("\\u202egnp"));
  EXPECT_EQ(info.out.find('\x1b'), std::string::npos);
  const ProcessResult check = run_percuss({"check", box_deck_, "--set", "title=\"\\e[2J\""});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr("\\x1b[2J"));
  const ProcessResult wrong = run_percuss({"check", box_deck_, "--set", "title\x1b[2J=a"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_EQ(wrong.err.find('\x1b'), std::string::npos);
}

TEST_F(PercussHostile, LinksInAFolderOfResultsAreNotFollowed) {
  const std::string out = folder_.path() + "/out", precious = folder_.write("precious", "keep");
  fs::create_directory(out);
  for (const char* name : {"summary.json", "summary.json.tmp", "fields.xdmf", "fields.xdmf.tmp", "fields.vtkhdf",
                           "history.csv", "ranks.csv.tmp", "checkpoint.h5", "checkpoint.h5.tmp"})
    fs::create_symlink(precious, out + "/" + name);
  const ProcessResult run = run_percuss({"run", box_deck_, "-o", out, "--force", "--set", "output.history={every: 0}",
                                         "--set", "output.checkpoint={every: 5e-4}"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(read(precious), "keep");
  for (const fs::directory_entry& file : fs::directory_iterator(out)) {
    EXPECT_TRUE(file.path().filename() == "ranks.csv.tmp" || !file.is_symlink()) << file.path();
  }
}

}  // namespace
}  // namespace percuss
