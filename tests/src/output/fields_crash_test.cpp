// What is left of fields.vtkhdf when the process dies, or the disk fails, at any write of a frame.
//
// This executable replaces the pwrite of the C library, so that HDF5's n-th write can end the process as kill -9 does,
// or fail. Every n is tried.

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string>

#include "src/error.hpp"
#include "src/output/fields/fields_file.hpp"
#include "tests/src/output/file_size_limit.hpp"
#include "tests/src/output/hdf5_file_view.hpp"
#include "tests/src/output/sample_run.hpp"

namespace {

enum class Fault { none, kill, fail, lose };
Fault fault = Fault::none;
int writes_left = 0;  // until the fault
int writes_seen = 0;

// Others are written as well, the index for one.
bool is_fields_file(int file) {
  char path[4096];
  const ssize_t length = ::readlink(("/proc/self/fd/" + std::to_string(file)).c_str(), path, sizeof path);
  return length > 0 && std::string(path, static_cast<std::size_t>(length)).ends_with("/fields.vtkhdf");
}

using Pwrite = ssize_t (*)(int, const void*, std::size_t, off_t);

ssize_t write_or_fail(const char* symbol, int file, const void* data, std::size_t size, off_t offset) {
  static const auto real = reinterpret_cast<Pwrite>(::dlsym(RTLD_NEXT, symbol));
  if (!is_fields_file(file)) return real(file, data, size, offset);
  ++writes_seen;
  if (fault != Fault::none && writes_left-- <= 0) {
    if (fault == Fault::kill) {
      if (size > 1) real(file, data, size / 2, offset);  // the write under way may be half done
      ::kill(::getpid(), SIGKILL);
    }
    if (fault == Fault::lose) {  // told as done
      fault = Fault::none;
      return static_cast<ssize_t>(size);
    }
    errno = EIO;
    return -1;
  }
  return real(file, data, size, offset);
}

}  // namespace

extern "C" ssize_t pwrite(int file, const void* data, std::size_t size, off_t offset) {
  return write_or_fail("pwrite", file, data, size, offset);
}
extern "C" ssize_t pwrite64(int file, const void* data, std::size_t size, off_t offset) {
  return write_or_fail("pwrite64", file, data, size, offset);
}

namespace percuss {
namespace {

using sample::FileSizeLimit;
using sample::Hdf5FileView;
using sample::TemporaryFolder;
using testing::HasSubstr;

constexpr int good_frames = 2;

// Runs `body` in a process of its own and tells how that ended (as waitpid says).
template <class Body>
int run_in_child(Body&& body) {
  const pid_t child = ::fork();
  if (child == 0) {
    body();
    std::_Exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

// Checks that the frames before the fault are in the file, bit for bit; a frame more may be if it was complete.
void expect_good_frames(const std::string& path, const Mesh& mesh, int least) {
  const Hdf5FileView file(path);
  ASSERT_TRUE(file.is_open());
  const long found = file.attribute("VTKHDF/Steps", "NSteps").front();
  ASSERT_GE(found, least);
  ASSERT_LE(found, least + 1);
  const auto times = file.numbers("VTKHDF/Steps/Values");
  const auto points = file.numbers("VTKHDF/Points");
  const auto stress = file.numbers("VTKHDF/CellData/stress");
  for (int frame = 0; frame < found; ++frame) {
    const sample::Frame expected(mesh, frame);
    EXPECT_EQ(times.at(static_cast<std::size_t>(frame)), sample::time_of(frame));
    const auto nodes = static_cast<long>(expected.positions.size()), cells = static_cast<long>(expected.stress.size());
    EXPECT_TRUE(std::equal(expected.positions.begin(), expected.positions.end(), points.begin() + frame * nodes));
    EXPECT_TRUE(std::equal(expected.stress.begin(), expected.stress.end(), stress.begin() + frame * cells));
  }
}

int count_writes_of_a_frame(const Mesh& mesh) {
  const TemporaryFolder folder;
  FieldsFile file = sample::create_file(folder.path(), mesh);
  for (int frame = 0; frame < good_frames; ++frame) sample::write_frame(file, mesh, frame);
  writes_seen = 0;
  sample::write_frame(file, mesh, good_frames);
  return writes_seen;
}

TEST(FieldsFileInACrash, KeepsTheFramesBeforeWheneverTheProcessIsKilled) {
  const Mesh mesh = sample::make_mesh();
  const int writes = count_writes_of_a_frame(mesh);
  ASSERT_GT(writes, 10);
  for (int n = 0; n < writes; ++n) {
    SCOPED_TRACE("killed at write " + std::to_string(n));
    const TemporaryFolder folder;
    const int status = run_in_child([&] {
      FieldsFile file = sample::create_file(folder.path(), mesh);
      for (int frame = 0; frame < good_frames; ++frame) sample::write_frame(file, mesh, frame);
      fault = Fault::kill;
      writes_left = n;
      sample::write_frame(file, mesh, good_frames);
    });
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    expect_good_frames(folder.file("fields.vtkhdf"), mesh, good_frames);
  }
}

// Writes frames until the n-th write of the last one fails; ends the process as percuss does. Exit codes: 4 for the
// error that is expected, others for what went wrong.
void run_into_failing_write(const std::string& folder, const Mesh& mesh, int n) {
  FieldsFile file = sample::create_file(folder, mesh);
  for (int frame = 0; frame < good_frames; ++frame) sample::write_frame(file, mesh, frame);
  fault = Fault::fail;
  writes_left = n;
  try {
    sample::write_frame(file, mesh, good_frames);
    std::exit(10);  // nobody noticed
  } catch (const SystemError& error) {
    const std::string message = error.what();
    if (message.find(folder + "/fields.vtkhdf") == std::string::npos) std::exit(11);
    if (message.find("Input/output error") == std::string::npos) std::exit(12);
  }
  fault = Fault::none;
  try {
    sample::write_frame(file, mesh, good_frames);
    std::exit(13);  // a file that was given up takes a frame
  } catch (const SystemError&) {
    file.close();
    std::exit(4);
  }
}

TEST(FieldsFileInACrash, KeepsTheFramesBeforeAndTheExitCodeWhicheverWriteFails) {
  const Mesh mesh = sample::make_mesh();
  const int writes = count_writes_of_a_frame(mesh);
  for (int n = 0; n < writes; ++n) {
    SCOPED_TRACE("failed at write " + std::to_string(n));
    const TemporaryFolder folder;
    const int status = run_in_child([&] { run_into_failing_write(folder.path(), mesh, n); });
    ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
    ASSERT_EQ(WEXITSTATUS(status), 4);
    expect_good_frames(folder.file("fields.vtkhdf"), mesh, good_frames);
  }
}

TEST(FieldsFileOnADiskThatLosesWrites, TellsOfEachThatIsMissing) {
  const Mesh mesh = sample::make_mesh();
  const int writes = count_writes_of_a_frame(mesh);
  int told = 0;
  for (int n = 0; n < writes; ++n) {
    SCOPED_TRACE("lost write " + std::to_string(n));
    const TemporaryFolder folder;
    FieldsFile file = sample::create_file(folder.path(), mesh);
    for (int frame = 0; frame < good_frames; ++frame) sample::write_frame(file, mesh, frame);
    fault = Fault::lose;
    writes_left = n;
    try {
      sample::write_frame(file, mesh, good_frames);
      fault = Fault::none;
      file.close();
      expect_good_frames(folder.file("fields.vtkhdf"), mesh, good_frames + 1);
    } catch (const SystemError& error) {
      EXPECT_THAT(error.what(), HasSubstr("read"));
      ++told;
    }
    fault = Fault::none;
  }
  EXPECT_GT(told, writes / 2);
}

TEST(FieldsFileOnAFullDisk, FailsBeforeAFrameIsHalfWrittenAndKeepsTheOthers) {
  const TemporaryFolder folder;
  const Mesh mesh = sample::make_mesh();
  FieldsFile file = sample::create_file(folder.path(), mesh);
  for (int frame = 0; frame < good_frames; ++frame) sample::write_frame(file, mesh, frame);
  const auto size = std::filesystem::file_size(folder.file("fields.vtkhdf"));
  writes_seen = 0;
  {
    const FileSizeLimit limit(size);
    try {
      sample::write_frame(file, mesh, good_frames);
      ADD_FAILURE() << "a frame went beyond the limit";
    } catch (const SystemError& error) {
      EXPECT_THAT(error.what(), HasSubstr("cannot write '" + folder.file("fields.vtkhdf") + "' (File too large)"));
    }
  }
  EXPECT_EQ(std::filesystem::file_size(folder.file("fields.vtkhdf")), size);
  expect_good_frames(folder.file("fields.vtkhdf"), mesh, good_frames);
}

TEST(FieldsFileOnAFullDisk, LeavesNoFileWhenTheMeshDoesNotFit) {
  const TemporaryFolder folder;
  const FileSizeLimit limit(1000);
  EXPECT_THROW(sample::create_file(folder.path(), sample::make_mesh()), SystemError);
  EXPECT_FALSE(std::filesystem::exists(folder.file("fields.vtkhdf")));
}

}  // namespace
}  // namespace percuss
