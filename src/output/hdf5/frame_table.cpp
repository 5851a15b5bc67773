#include "src/output/hdf5/frame_table.hpp"

#include <algorithm>
#include <array>

namespace percuss::hdf5 {
namespace {

// As those of Table: a frame of a field in a chunk; several of a tiny mesh; of a huge one equal parts.
constexpr hsize_t least_chunk_numbers = 512, most_chunk_numbers = hsize_t{1} << 27;

}  // namespace

FrameTable::FrameTable(hid_t parent, const std::string& name, const Shape& shape)
    : name_(name), dimensions_(shape.is_list ? 1 : 2), items_(shape.items) {
  const std::string action = "create dataset " + name;
  const hsize_t parts = (items_ + most_chunk_numbers - 1) / most_chunk_numbers;
  chunk_items_ = (items_ + parts - 1) / parts;
  chunk_frames_ = std::max<hsize_t>(1, least_chunk_numbers / chunk_items_);
  const std::array<hsize_t, 2> none{0, items_}, unlimited{H5S_UNLIMITED, items_}, chunk{chunk_frames_, chunk_items_};
  const Handle space(check(H5Screate_simple(dimensions_, none.data(), unlimited.data()), action), H5Sclose);
  const Handle properties(check(H5Pcreate(H5P_DATASET_CREATE), action), H5Pclose);
  check(H5Pset_obj_track_times(properties.get(), false), action);
  check(H5Pset_chunk(properties.get(), dimensions_, chunk.data()), action);
  // For the reasons that Table::Table() gives.
  check(H5Pset_fill_time(properties.get(), H5D_FILL_TIME_NEVER), action);
  check(H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY), action);
  dataset_ = {
      check(H5Dcreate2(parent, name.c_str(), H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
            action),
      H5Dclose};
}

FrameTable::FrameTable(hid_t parent, const std::string& name)
    : dataset_(check(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), "open dataset " + name), H5Dclose), name_(name) {
  const std::string action = "read the shape of " + name;
  const Handle space(check(H5Dget_space(dataset_.get()), action), H5Sclose);
  const Handle properties(check(H5Dget_create_plist(dataset_.get()), action), H5Pclose);
  std::array<hsize_t, 2> dims{0, 1}, chunk{1, 1};
  dimensions_ = H5Sget_simple_extent_ndims(space.get());
  if (dimensions_ != 1 && dimensions_ != 2) throw Error(action, "it has neither one nor two dimensions");
  if (H5Pget_layout(properties.get()) != H5D_CHUNKED) throw Error(action, "it cannot grow");
  check(H5Sget_simple_extent_dims(space.get(), dims.data(), nullptr), action);
  check(H5Pget_chunk(properties.get(), dimensions_, chunk.data()), action);
  frames_ = dims[0];
  items_ = dims[1];
  chunk_frames_ = std::max<hsize_t>(1, chunk[0]);
  chunk_items_ = std::max<hsize_t>(1, chunk[1]);
}

void FrameTable::append(std::span<const double> values, const RowBlock& block) {
  const std::string action = "write dataset " + name_;
  const std::array<hsize_t, 2> extent{frames_ + 1, items_};
  check(H5Dset_extent(dataset_.get(), extent.data()), "extend dataset " + name_);
  if (block.record != nullptr)
    block.record->add_part(dataset_.get(), {frames_, block.first, block.count}, H5T_NATIVE_DOUBLE, values.data());
  const Handle in_file(check(H5Dget_space(dataset_.get()), action), H5Sclose);
  const Handle in_memory(check(H5Screate_simple(1, &block.count, nullptr), action), H5Sclose);
  const std::array<hsize_t, 2> first{frames_, block.first}, count{1, block.count};
  if (block.count == 0) {  // takes part all the same
    check(H5Sselect_none(in_file.get()), action);
    check(H5Sselect_none(in_memory.get()), action);
  } else {
    check(H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr), action);
  }
  check(H5Dwrite(dataset_.get(), H5T_NATIVE_DOUBLE, in_memory.get(), in_file.get(), block.transfer, values.data()),
        action);
  ++frames_;
}

void FrameTable::cut(hsize_t frames) {
  if (frames > frames_) throw Error("cut dataset " + name_, "it has too few frames");
  if (frames == frames_) return;
  const std::array<hsize_t, 2> extent{frames, items_};
  check(H5Dset_extent(dataset_.get(), extent.data()), "cut dataset " + name_);
  frames_ = frames;
}

hsize_t FrameTable::growth_bytes() const {
  if (frames_ % chunk_frames_ != 0) return 0;
  return (items_ + chunk_items_ - 1) / chunk_items_ * chunk_items_ * chunk_frames_ * sizeof(double);
}

}  // namespace percuss::hdf5
