// What a dataset says that it will take of the disk is what it takes.

#include "src/output/hdf5/growing_dataset.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "src/output/hdf5/frame_table.hpp"
#include "src/output/hdf5/hdf5_file.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/output/sample_run.hpp"

namespace percuss::hdf5 {
namespace {

constexpr hsize_t of_aggregation = 4096;  // HDF5 gives small metadata room in blocks of 2 KiB

hsize_t find_bytes(const Handle& file) {
  check(H5Fflush(file.get(), H5F_SCOPE_GLOBAL), "flush");
  hsize_t bytes = 0;
  check(H5Fget_filesize(file.get(), &bytes), "ask");
  return bytes;
}

class GrowingDatasetTest : public testing::Test {
 protected:
  /// A new file whose index has so many entries in a node.
  Handle create(unsigned entries) const {
    return create_durable_file(folder_.path() + "/growing.h5", Communicator::world(), LinkOrder::by_name, entries / 2);
  }
  sample::TemporaryFolder folder_;
};

// One chunk a row: nodes of 64 entries split, and the level above them does.
TEST_F(GrowingDatasetTest, TakesNoMoreThanItSaid) {
  const Handle file = create(64);
  GrowingDataset dataset(file.get(), "x", H5T_IEEE_F64LE, {16, false, 1, 16});
  hsize_t bytes = find_bytes(file);
  for (int row = 0; row < 64 * 70; ++row) {
    const hsize_t said = dataset.growth_bytes(1);
    dataset.extend(1);
    const hsize_t now = find_bytes(file);
    ASSERT_LE(now - bytes, said + of_aggregation) << row;
    bytes = now;
  }
}

TEST_F(GrowingDatasetTest, TakesNoMoreThanItSaidOfManyChunksAtOnce) {
  const Handle file = create(64);
  GrowingDataset dataset(file.get(), "x", H5T_IEEE_F64LE, {1000, false, 2, 10});
  hsize_t bytes = find_bytes(file);
  for (int row = 0; row < 100; ++row) {
    const hsize_t said = dataset.growth_bytes(1);
    EXPECT_EQ(said == 0, row % 2 == 1);
    dataset.extend(1);
    const hsize_t now = find_bytes(file);
    ASSERT_LE(now - bytes, said + of_aggregation) << row;
    bytes = now;
  }
}

// 64 bytes a frame of 8 numbers, 16 frames in a chunk: nothing but the chunk while the node of the index has room.
TEST_F(GrowingDatasetTest, OfASmallBlockTakesRoomForAFewFrames) {
  const Handle file = create(64);
  FrameTable table(file.get(), "x", {8});
  const hsize_t node = 24 + 64 * 40 + 40;
  EXPECT_EQ(table.growth_bytes(), 16 * 8 * sizeof(double) + node);
  const std::vector<double> values(8, 1.0);
  for (int frame = 0; frame < 32; ++frame) {
    table.append(values, {8, 0, 8});
    const bool is_full = (frame + 1) % 16 == 0;
    EXPECT_EQ(table.growth_bytes(), is_full ? 16 * 8 * sizeof(double) : 0) << frame;
  }
}

TEST_F(GrowingDatasetTest, IsTheSameWhenItIsOpenedAgain) {
  const Handle file = create(64);
  const auto describe = [](const GrowingDataset& d) {
    return std::vector<hsize_t>{d.rows(), d.row_length(), d.growth_bytes(1), d.growth_bytes(500)};
  };
  GrowingDataset dataset(file.get(), "x", H5T_IEEE_F32LE, {7, false, 3, 7});
  dataset.extend(100);
  EXPECT_EQ(describe(GrowingDataset(file.get(), "x")), describe(dataset));
  dataset.cut(5);
  EXPECT_EQ(GrowingDataset(file.get(), "x").rows(), 5);
  EXPECT_ERROR(dataset.cut(6), Error, "cut dataset x");
}

}  // namespace
}  // namespace percuss::hdf5
