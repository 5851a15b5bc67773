#include "src/output/hdf5/frame_table.hpp"

#include <algorithm>
#include <array>

namespace percuss::hdf5 {
namespace {

// A frame of a field in a chunk; several of a small block, so that its index stays small; of a huge one equal parts.
constexpr hsize_t least_chunk_numbers = 512, most_chunk_numbers = hsize_t{1} << 27;
// A file of many small blocks has no more room than this for frames that may never come.
constexpr hsize_t most_chunk_frames = 16;
constexpr hsize_t list_chunk = 512;  // of numbers of which a file has a few lists

GrowingDataset::Layout make_layout(const FrameTable::Shape& shape) {
  if (shape.items == 1 && shape.is_alone) return {1, shape.is_list, list_chunk, 1};
  const hsize_t parts = (shape.items + most_chunk_numbers - 1) / most_chunk_numbers;
  const hsize_t chunk_items = (shape.items + parts - 1) / parts;
  return {shape.items, shape.is_list, std::clamp<hsize_t>(least_chunk_numbers / chunk_items, 1, most_chunk_frames),
          chunk_items};
}

}  // namespace

FrameTable::FrameTable(hid_t parent, const std::string& name, const Shape& shape)
    : dataset_(parent, name, H5T_IEEE_F64LE, make_layout(shape)) {}

FrameTable::FrameTable(hid_t parent, const std::string& name) : dataset_(parent, name) {}

void FrameTable::append(std::span<const double> values, const RowBlock& block) {
  const std::string action = "write dataset " + dataset_.name();
  const hsize_t frame = dataset_.rows();
  dataset_.extend(1);
  if (block.record != nullptr)
    block.record->add_part(id(), {frame, block.first, block.count}, H5T_NATIVE_DOUBLE, values.data());
  const Handle in_file(check(H5Dget_space(id()), action), H5Sclose);
  const std::array<hsize_t, 2> first{frame, block.first}, count{1, block.count};
  // The shape in memory is that of the file: HDF5 looks up shapes that differ number by number.
  const Handle in_memory(
      check(H5Screate_simple(H5Sget_simple_extent_ndims(in_file.get()), count.data(), nullptr), action), H5Sclose);
  if (block.count == 0) {  // takes part all the same
    check(H5Sselect_none(in_file.get()), action);
    check(H5Sselect_none(in_memory.get()), action);
  } else {
    check(H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr), action);
  }
  check(H5Dwrite(id(), H5T_NATIVE_DOUBLE, in_memory.get(), in_file.get(), block.transfer, values.data()), action);
}

}  // namespace percuss::hdf5
