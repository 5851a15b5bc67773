// fields.vtkhdf and fields.exo as several ranks write them: the files of one rank, number by number, and errors
// that all ranks see.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

#include "comm/agreement.hpp"
#include "src/error.hpp"
#include "src/output/exodus/exodus_results.hpp"
#include "src/output/vtkhdf/fields_file.hpp"
#include "tests/src/output/file_size_limit.hpp"
#include "tests/src/output/hdf5_file_view.hpp"
#include "tests/src/output/sample_run.hpp"

namespace percuss {
namespace {

using sample::FileSizeLimit;
using sample::Hdf5FileView;
using sample::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr int frames = 3;
constexpr int cells = 6;  // 12 chunks, so that 7 ranks all have some

// A folder that rank 0 makes and removes, for all.
class SharedFolder {
 public:
  explicit SharedFolder(const Communicator& ranks) : ranks_(ranks) {
    if (ranks.rank() == 0) own_.emplace();
    path_ = broadcast_text(ranks, own_ ? own_->path() : "", 0);
  }
  ~SharedFolder() { ranks_.barrier(); }
  SharedFolder(const SharedFolder&) = delete;
  SharedFolder& operator=(const SharedFolder&) = delete;
  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  Communicator ranks_;
  std::optional<TemporaryFolder> own_;
  std::string path_;
};

ChunkedMesh take_share(const Communicator& ranks) {
  return sample::take_share(sample::cut_layers(sample::make_mesh(cells)), ranks);
}

void write_run(const std::string& folder, const Communicator& ranks, const FieldsOptions& options = sample::options()) {
  const ChunkedMesh share = take_share(ranks);
  FieldsFile file(folder, share, options, ranks);
  for (int frame = 0; frame < frames; ++frame) sample::write_frame(file, share.mesh, frame);
  file.close();
}

std::string read_text(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

void expect_equal_files(const std::string& path, const std::string& reference) {
  const Hdf5FileView file(path), expected(reference);
  ASSERT_TRUE(file.is_open());
  const auto names = expected.datasets();
  ASSERT_GT(names.size(), 20u);
  EXPECT_EQ(file.datasets(), names);
  for (const auto& name : names) {
    EXPECT_EQ(file.shape(name), expected.shape(name)) << name;
    EXPECT_EQ(file.bytes(name), expected.bytes(name)) << name;
  }
}

void expect_equal_results(const std::string& path, const std::string& reference) {
  expect_equal_files(path, reference);
  const Hdf5FileView file(path), expected(reference);
  EXPECT_EQ(file.attribute("VTKHDF/Steps", "NSteps"), expected.attribute("VTKHDF/Steps", "NSteps"));
  EXPECT_EQ(file.text_attribute("percuss", "title"), expected.text_attribute("percuss", "title"));
}

TEST(FieldsFileOfManyRanks, IsThatOfOneRankNumberByNumber) {
  const auto ranks = Communicator::world();
  const SharedFolder together(ranks);
  write_run(together.path(), ranks);
  if (ranks.rank() != 0) return;
  const TemporaryFolder alone;
  write_run(alone.path(), Communicator(MPI_COMM_SELF));
  expect_equal_results(together.file("fields.vtkhdf"), alone.file("fields.vtkhdf"));
  for (const char* index : {"fields.xdmf", "fields.xdmf2"})
    EXPECT_EQ(read_text(together.file(index)), read_text(alone.file(index))) << index;
}

TEST(FieldsFileOfManyRanks, StoresFloatsAsOneRankDoes) {
  const auto ranks = Communicator::world();
  const SharedFolder together(ranks);
  const FieldsOptions floats{"", "", FieldPrecision::float32};
  write_run(together.path(), ranks, floats);
  if (ranks.rank() != 0) return;
  const TemporaryFolder alone;
  write_run(alone.path(), Communicator(MPI_COMM_SELF), floats);
  expect_equal_results(together.file("fields.vtkhdf"), alone.file("fields.vtkhdf"));
}

void write_exodus(const std::string& folder, const Communicator& ranks, int first_frame = 0, int end = frames) {
  const ChunkedMesh share = take_share(ranks);
  const std::vector<std::string> fields{"displacement", "velocity", "stress", "von_mises", "flag"};
  std::optional<ExodusResults> file;
  if (first_frame == 0)
    file.emplace(folder, share, sample::options(), ranks);
  else
    file.emplace(folder, share, sample::options(), ranks, first_frame, fields);
  for (int frame = first_frame; frame < end; ++frame) sample::write_frame(*file, share.mesh, frame);
  file->close();
}

TEST(ExodusResultsOfManyRanks, AreThoseOfOneRankNumberByNumber) {
  const auto ranks = Communicator::world();
  const SharedFolder together(ranks);
  write_exodus(together.path(), ranks);
  if (ranks.rank() != 0) return;
  const TemporaryFolder alone;
  write_exodus(alone.path(), Communicator(MPI_COMM_SELF));
  expect_equal_files(together.file("fields.exo"), alone.file("fields.exo"));
}

TEST(ExodusResultsOfManyRanks, GoOnBehindAFrameAsIfNothingHadBeenBehindIt) {
  const auto ranks = Communicator::world();
  const SharedFolder together(ranks);
  write_exodus(together.path(), ranks);
  write_exodus(together.path(), ranks, 1);
  if (ranks.rank() != 0) return;
  const TemporaryFolder alone;
  write_exodus(alone.path(), Communicator(MPI_COMM_SELF));
  expect_equal_files(together.file("fields.exo"), alone.file("fields.exo"));
}

TEST(FieldsFileOfManyRanks, IsReadableAfterEveryFrameWithoutBeingClosed) {
  const auto ranks = Communicator::world();
  const SharedFolder folder(ranks);
  const ChunkedMesh share = take_share(ranks);
  FieldsFile file(folder.path(), share, sample::options(), ranks);
  for (int frame = 0; frame < frames; ++frame) {
    sample::write_frame(file, share.mesh, frame);
    if (ranks.rank() == 0) {
      // A copy, because one process that opens a file twice would see what HDF5 holds in memory.
      std::filesystem::copy_file(folder.file("fields.vtkhdf"), folder.file("copy"),
                                 std::filesystem::copy_options::overwrite_existing);
      const Hdf5FileView copy(folder.file("copy"));
      ASSERT_TRUE(copy.is_open());
      EXPECT_THAT(copy.attribute("VTKHDF/Steps", "NSteps"), ElementsAre(frame + 1));
      const sample::Frame expected(sample::make_mesh(cells), frame);
      const auto points = copy.numbers("VTKHDF/Points");
      const auto count = static_cast<long>(expected.positions.size());
      EXPECT_TRUE(std::equal(expected.positions.begin(), expected.positions.end(), points.begin() + frame * count));
      // What was reserved and not used is given back: HDF5 opens a file that is longer than it says, and tells how
      // long.
      EXPECT_EQ(std::filesystem::file_size(folder.file("copy")), copy.end_of_data());
    }
    ranks.barrier();
  }
  file.close();
}

// The message of a system error that the work ends with.
template <class Work>
std::string message_of(const Work& work) {
  try {
    work();
  } catch (const SystemError& error) {
    return error.what();
  }
  return "no error";
}

TEST(FieldsFileOfManyRanks, NamesTheReasonOnEveryRankWhenTheFolderIsMissing) {
  const auto ranks = Communicator::world();
  const SharedFolder folder(ranks);
  const auto message = message_of([&] { write_run(folder.file("missing"), ranks); });
  EXPECT_THAT(message, HasSubstr(folder.file("missing/fields.vtkhdf")));
  EXPECT_THAT(message, HasSubstr("No such file or directory"));
}

void expect_frames(const std::string& path, int count) {
  const Hdf5FileView file(path);
  ASSERT_TRUE(file.is_open());
  EXPECT_THAT(file.attribute("VTKHDF/Steps", "NSteps"), ElementsAre(count));
  const auto stress = file.numbers("VTKHDF/CellData/stress");
  for (int frame = 0; frame < count; ++frame) {
    const sample::Frame expected(sample::make_mesh(cells), frame);
    const auto size = static_cast<long>(expected.stress.size());
    EXPECT_TRUE(std::equal(expected.stress.begin(), expected.stress.end(), stress.begin() + frame * size));
  }
}

TEST(FieldsFileOfManyRanks, KeepsTheFramesBeforeAndFailsOnEveryRankWhenTheDiskIsFull) {
  const auto ranks = Communicator::world();
  const SharedFolder folder(ranks);
  const ChunkedMesh share = take_share(ranks);
  FieldsFile file(folder.path(), share, sample::options(), ranks);
  for (int frame = 0; frame < 2; ++frame) sample::write_frame(file, share.mesh, frame);
  const auto size = std::filesystem::file_size(folder.file("fields.vtkhdf"));
  ranks.barrier();
  std::string message;
  {
    const FileSizeLimit limit(size);
    message = message_of([&] { sample::write_frame(file, share.mesh, 2); });
    EXPECT_THAT(message, HasSubstr("cannot write '" + folder.file("fields.vtkhdf") + "' (File too large)"));
    EXPECT_NE(message_of([&] { sample::write_frame(file, share.mesh, 2); }), "no error");
    file.close();
  }
  ranks.barrier();
  EXPECT_EQ(std::filesystem::file_size(folder.file("fields.vtkhdf")), size);
  if (ranks.rank() == 0) expect_frames(folder.file("fields.vtkhdf"), 2);
}

TEST(FieldsFileOfManyRanks, LeavesNoFileWhenTheMeshDoesNotFit) {
  const auto ranks = Communicator::world();
  const SharedFolder folder(ranks);
  std::string message;
  {
    const FileSizeLimit limit(1000);
    message = message_of([&] { write_run(folder.path(), ranks); });
  }
  EXPECT_THAT(message, HasSubstr("File too large"));
  ranks.barrier();
  EXPECT_FALSE(std::filesystem::exists(folder.file("fields.vtkhdf")));
}

}  // namespace
}  // namespace percuss
