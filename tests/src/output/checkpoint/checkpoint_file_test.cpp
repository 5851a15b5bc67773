// Checkpoints: what is put in comes out on any ranks, and the one before stays until the new one is whole.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "tests/expect_error.hpp"
#include "tests/src/output/checkpoint/checkpoint_fixture.hpp"

namespace percuss {

using testing::HasSubstr;

TEST_F(CheckpointFile, GivesBackWhatWasPutIn) {
  Contents given(share_);
  given.work.add(0.25 * (world().rank() + 1));
  write(path(), share_, given, "A title");

  Contents taken(share_);
  Kokkos::deep_copy(taken.x, -1);
  std::fill(taken.numbers.begin(), taken.numbers.end(), -1);
  taken.time = 0;
  taken.step = 0;
  for (Contents::Row& row : taken.list) row = {};
  CheckpointReader reader(path(), share_, world());
  taken.archive(reader);
  EXPECT_EQ(taken.time, 0.1);
  EXPECT_EQ(taken.step, -7);
  EXPECT_EQ(taken.list, given.list);
  EXPECT_EQ(taken.numbers, given.numbers);
  for (const int n : given.nodes.places)
    EXPECT_EQ(taken.x(static_cast<std::size_t>(n), 2), given.x(static_cast<std::size_t>(n), 2));
  const int ranks = world().size();
  EXPECT_EQ(taken.work.round(), world().rank() == 0 ? 0.125 * ranks * (ranks + 1) : 0);
  EXPECT_EQ(reader.header().title, "A title");
  EXPECT_EQ(reader.header().deck, "a = 1\nb = 2");
  EXPECT_EQ(reader.header().time, 1.0 / 3);
  EXPECT_EQ(reader.header().step, 42);
  EXPECT_FALSE(std::filesystem::exists(path() + ".tmp"));
}

TEST_F(CheckpointFile, IsTheSameOnAnyRanks) {
  write(path(), share_, Contents(share_));
  const ChunkedMesh whole = sample::cut_layers(mesh_);
  if (world().rank() == 0) {
    Contents expected(whole), taken(whole);
    Kokkos::deep_copy(taken.x, -1);
    CheckpointReader reader(path(), whole, Communicator(MPI_COMM_SELF));
    taken.archive(reader);
    for (std::size_t n = 0; n < expected.x.extent(0); ++n) EXPECT_EQ(taken.x(n, 1), expected.x(n, 1));
    EXPECT_EQ(taken.numbers, expected.numbers);
  }
}

TEST_F(CheckpointFile, KeepsTheOneBefore) {
  write(path(), share_, Contents(share_), "first");
  write(path(), share_, Contents(share_), "second");
  EXPECT_EQ(read_checkpoint_header(path()).title, "second");
  EXPECT_EQ(read_checkpoint_header(find_previous_checkpoint(path())).title, "first");
  EXPECT_THAT(describe_checkpoint(path()), HasSubstr("t = 0.333333, step 42"));
}

// As where a run continues from the one before, since the newest is damaged, or from one with another name.
TEST_F(CheckpointFile, ThatIsDamagedDoesNotTakeThePlaceOfAWholeOne) {
  const auto write_next = [&](const std::string& known_whole) {
    CheckpointWriter writer(path(), {}, share_, world());
    Contents(share_).archive(writer);
    writer.finish(known_whole);
  };
  const std::string previous = find_previous_checkpoint(path());
  for (const std::string& known_whole : {previous, folder_ + "/another.h5"}) {
    write(path(), share_, Contents(share_), "first");
    write(path(), share_, Contents(share_), "second");
    change([](std::string& bytes) { bytes[bytes.size() / 2] ^= 1; });
    write_next(known_whole);
    EXPECT_EQ(read_checkpoint_header(previous).title, "first");
  }
  write(path(), share_, Contents(share_), "third");
  write_next(folder_ + "/another.h5");
  EXPECT_EQ(read_checkpoint_header(previous).title, "third");
}

TEST_F(CheckpointFile, WithoutFinishLeavesTheOneBefore) {
  write(path(), share_, Contents(share_), "first");
  {
    CheckpointWriter writer(path(), {}, share_, world());
    Contents(share_).archive(writer);
  }
  world().barrier();
  EXPECT_EQ(read_checkpoint_header(path()).title, "first");
  EXPECT_FALSE(std::filesystem::exists(path() + ".tmp"));
}

// As where ranks on several machines have folders of the same name.
TEST_F(CheckpointFile, InAFolderThatOneRankLacksFailsOnAll) {
  const int last = world().size() - 1;
  std::string message;
  try {
    CheckpointWriter(world().rank() == last ? folder_ + "/none/checkpoint.h5" : path(), {}, share_, world());
  } catch (const SystemError& error) {
    message = error.what();
  }
  EXPECT_THAT(message, HasSubstr("/none/checkpoint.h5"));
  EXPECT_THAT(message, HasSubstr("No such file or directory"));
  if (last > 0) {
    EXPECT_THAT(message,
                HasSubstr("rank " + std::to_string(last) + " of " + std::to_string(last + 1) + " cannot open"));
  }
  world().barrier();
  EXPECT_FALSE(std::filesystem::exists(path() + ".tmp"));
}

// A seal is no proof: it is found from the file, and fits one that holds another state, too.
TEST_F(CheckpointFile, WithOtherNumbersThanThoseOfTheStateIsRefusedThoughItsSealFits) {
  write(path(), share_, Contents(share_));
  world().barrier();
  if (world().rank() == 0) {
    const hid_t file = H5Fopen(path().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(file, "state/nodes/x", H5P_DEFAULT);
    std::vector<double> x(3 * mesh_.nodes.size());
    H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, x.data());
    std::swap(x[4], x[7]);  // a sum alone would not see it
    EXPECT_GE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, x.data()), 0);
    H5Dclose(dataset);
    EXPECT_GE(H5Fclose(file), 0);
  }
  world().barrier();
  seal_file(world(), path());
  EXPECT_THAT(take_refusal(path(), share_), HasSubstr("its content is not the state that was saved"));
  EXPECT_ERROR(describe_checkpoint(path()), InputError, "its content is not the state that was saved");
}

// Whoever follows its groups would go round until the stack is full.
TEST_F(CheckpointFile, WithALoopOfGroupsIsRefusedThoughItsSealFits) {
  write(path(), share_, Contents(share_));
  world().barrier();
  if (world().rank() == 0) {
    const hid_t file = H5Fopen(path().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    EXPECT_GE(H5Lcreate_hard(file, "/", file, "state/up", H5P_DEFAULT, H5P_DEFAULT), 0);
    EXPECT_GE(H5Fclose(file), 0);
  }
  world().barrier();
  seal_file(world(), path());
  EXPECT_THAT(take_refusal(path(), share_), HasSubstr("can be reached in more than one way"));
  EXPECT_ERROR(read_checkpoint_header(path()), InputError, "can be reached in more than one way");
}

TEST_F(CheckpointFile, HasAHashOfItsContentThatDoesNotDependOnRanks) {
  write(path(), share_, Contents(share_));
  const std::string content = read_checkpoint_header(path()).content;
  EXPECT_EQ(content.size(), 16);
  if (world().rank() != 0) return;
  const ChunkedMesh whole = sample::cut_layers(mesh_);
  CheckpointHeader header = read_checkpoint_header(path());
  CheckpointWriter alone(folder_ + "/alone.h5", header, whole, Communicator(MPI_COMM_SELF));
  Contents(whole).archive(alone);
  alone.finish();
  EXPECT_EQ(read_checkpoint_header(folder_ + "/alone.h5").content, content);
}

}  // namespace percuss
