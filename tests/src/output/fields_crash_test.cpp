// What is left of fields.vtkhdf and of fields.exo when the process dies, or the disk fails, at any write of a frame.
//
// This executable replaces the pwrite of the C library, so that HDF5's n-th write can end the process as kill -9 does,
// or fail. Every n is tried.

#include <dlfcn.h>
#include <exodusII.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "src/error.hpp"
#include "src/output/exodus/exodus_results.hpp"
#include "src/output/vtkhdf/fields_file.hpp"
#include "tests/expect_error.hpp"
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
  if (length <= 0) return false;
  const std::string_view name(path, static_cast<std::size_t>(length));
  return name.ends_with("/fields.vtkhdf") || name.ends_with("/fields.exo");
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

/// fields.vtkhdf in these tests.
struct Vtkhdf {
  using File = FieldsFile;
  static constexpr const char* name = "fields.vtkhdf";
  static File create(const std::string& folder, const Mesh& mesh) { return sample::create_file(folder, mesh); }

  // Checks that the frames before the fault are in the file, bit for bit; a frame more may be if it was complete.
  static void expect_good_frames(const std::string& path, const Mesh& mesh, int least) {
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
      const auto nodes = static_cast<long>(expected.positions.size()),
                 cells = static_cast<long>(expected.stress.size());
      EXPECT_TRUE(std::equal(expected.positions.begin(), expected.positions.end(), points.begin() + frame * nodes));
      EXPECT_TRUE(std::equal(expected.stress.begin(), expected.stress.end(), stress.begin() + frame * cells));
    }
  }
};

/// fields.exo, read by the Exodus library.
struct Exodus {
  using File = ExodusResults;
  static constexpr const char* name = "fields.exo";
  static File create(const std::string& folder, const Mesh& mesh) {
    return {folder, sample::cut_layers(mesh), sample::options(), Communicator(MPI_COMM_SELF)};
  }

  static void expect_good_frames(const std::string& path, const Mesh& mesh, int least) {
    int number_bytes = 8, stored_bytes = 0;
    float version = 0;
    // A copy, because HDF5 opens no file that this process has open for writing.
    const std::string copy = path + ".copy";
    std::filesystem::copy_file(path, copy, std::filesystem::copy_options::overwrite_existing);
    const int file = ex_open(copy.c_str(), EX_READ, &number_bytes, &stored_bytes, &version);
    ASSERT_GE(file, 0);
    const auto found = static_cast<int>(ex_inquire_int(file, EX_INQ_TIME));
    EXPECT_GE(found, least);
    EXPECT_LE(found, least + 1);
    for (int frame = 0; frame < found; ++frame) expect_frame(file, mesh, frame);
    ex_close(file);
  }

  // stress_yz of the second cube and velocity_x.
  static void expect_frame(int file, const Mesh& mesh, int frame) {
    const sample::Frame expected(mesh, frame);
    double time = -1;
    EXPECT_EQ(ex_get_time(file, frame + 1, &time), 0);
    EXPECT_EQ(time, sample::time_of(frame));
    std::vector<double> stress(mesh.elements.size() / 2), velocity(mesh.nodes.size());
    EXPECT_EQ(ex_get_var(file, frame + 1, EX_ELEM_BLOCK, 5, 2, static_cast<int64_t>(stress.size()), stress.data()), 0);
    EXPECT_EQ(ex_get_var(file, frame + 1, EX_NODAL, 4, 1, static_cast<int64_t>(velocity.size()), velocity.data()), 0);
    for (std::size_t e = 0; e < stress.size(); ++e) EXPECT_EQ(stress[e], expected.stress[6 * (stress.size() + e) + 4]);
    for (std::size_t n = 0; n < velocity.size(); ++n) EXPECT_EQ(velocity[n], expected.velocity[3 * n]);
  }
};

template <class Format>
class ResultsFile : public testing::Test {
 protected:
  using File = typename Format::File;

  static void write_good_frames(File& file, const Mesh& mesh) {
    for (int frame = 0; frame < good_frames; ++frame) sample::write_frame(file, mesh, frame);
  }

  static int count_writes_of_a_frame(const Mesh& mesh) {
    const TemporaryFolder folder;
    File file = Format::create(folder.path(), mesh);
    write_good_frames(file, mesh);
    writes_seen = 0;
    sample::write_frame(file, mesh, good_frames);
    return writes_seen;
  }

  // Writes frames until the n-th write of the last one fails; ends the process as percuss does. Exit codes: 4 for the
  // error that is expected, others for what went wrong.
  static void run_into_failing_write(const std::string& folder, const Mesh& mesh, int n) {
    File file = Format::create(folder, mesh);
    write_good_frames(file, mesh);
    fault = Fault::fail;
    writes_left = n;
    try {
      sample::write_frame(file, mesh, good_frames);
      std::exit(10);  // nobody noticed
    } catch (const SystemError& error) {
      const std::string message = error.what();
      if (message.find(folder + "/" + Format::name) == std::string::npos) std::exit(11);
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
};

using Formats = testing::Types<Vtkhdf, Exodus>;
TYPED_TEST_SUITE(ResultsFile, Formats);

TYPED_TEST(ResultsFile, KeepsTheFramesBeforeWheneverTheProcessIsKilled) {
  const Mesh mesh = sample::make_mesh();
  const int writes = this->count_writes_of_a_frame(mesh);
  ASSERT_GT(writes, 10);
  for (int n = 0; n < writes; ++n) {
    SCOPED_TRACE("killed at write " + std::to_string(n));
    const TemporaryFolder folder;
    const int status = run_in_child([&] {
      auto file = TypeParam::create(folder.path(), mesh);
      this->write_good_frames(file, mesh);
      fault = Fault::kill;
      writes_left = n;
      sample::write_frame(file, mesh, good_frames);
    });
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    TypeParam::expect_good_frames(folder.file(TypeParam::name), mesh, good_frames);
  }
}

TYPED_TEST(ResultsFile, KeepsTheFramesBeforeAndTheExitCodeWhicheverWriteFails) {
  const Mesh mesh = sample::make_mesh();
  const int writes = this->count_writes_of_a_frame(mesh);
  for (int n = 0; n < writes; ++n) {
    SCOPED_TRACE("failed at write " + std::to_string(n));
    const TemporaryFolder folder;
    const int status = run_in_child([&] { this->run_into_failing_write(folder.path(), mesh, n); });
    ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
    ASSERT_EQ(WEXITSTATUS(status), 4);
    TypeParam::expect_good_frames(folder.file(TypeParam::name), mesh, good_frames);
  }
}

TYPED_TEST(ResultsFile, TellsOfEachWriteThatADiskLoses) {
  const Mesh mesh = sample::make_mesh();
  const int writes = this->count_writes_of_a_frame(mesh);
  int told = 0;
  for (int n = 0; n < writes; ++n) {
    SCOPED_TRACE("lost write " + std::to_string(n));
    const TemporaryFolder folder;
    auto file = TypeParam::create(folder.path(), mesh);
    this->write_good_frames(file, mesh);
    fault = Fault::lose;
    writes_left = n;
    try {
      sample::write_frame(file, mesh, good_frames);
      fault = Fault::none;
      file.close();
      TypeParam::expect_good_frames(folder.file(TypeParam::name), mesh, good_frames + 1);
    } catch (const SystemError& error) {
      EXPECT_THAT(error.what(), HasSubstr("read"));
      ++told;
    }
    fault = Fault::none;
  }
  EXPECT_GT(told, writes / 2);
}

TYPED_TEST(ResultsFile, OnAFullDiskFailsBeforeAFrameIsHalfWrittenAndKeepsTheOthers) {
  const TemporaryFolder folder;
  const Mesh mesh = sample::make_mesh();
  auto file = TypeParam::create(folder.path(), mesh);
  this->write_good_frames(file, mesh);
  const std::string path = folder.file(TypeParam::name);
  const auto size = std::filesystem::file_size(path);
  {
    const FileSizeLimit limit(size);
    try {
      sample::write_frame(file, mesh, good_frames);
      ADD_FAILURE() << "a frame went beyond the limit";
    } catch (const SystemError& error) {
      EXPECT_THAT(error.what(), HasSubstr("cannot write '" + path + "' (File too large)"));
    }
  }
  EXPECT_EQ(std::filesystem::file_size(path), size);
  TypeParam::expect_good_frames(path, mesh, good_frames);
}

TYPED_TEST(ResultsFile, IsNotLeftWhenTheMeshDoesNotFit) {
  const TemporaryFolder folder;
  const FileSizeLimit limit(1000);
  EXPECT_ERROR(TypeParam::create(folder.path(), sample::make_mesh()), SystemError, "cannot write");
  EXPECT_FALSE(std::filesystem::exists(folder.file(TypeParam::name)));
}

}  // namespace
}  // namespace percuss
