#include "src/output/hdf5/hdf5_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace percuss::hdf5 {
namespace {

// A chunk holds one frame of a field, so that its index stays small. A tiny mesh has several frames in one; HDF5 allows
// chunks below 4 GiB.
constexpr hsize_t min_chunk_bytes = 4096;
constexpr hsize_t max_chunk_bytes = hsize_t{1} << 30;

GrowingDataset::Layout make_layout(hsize_t number_bytes, int components, hsize_t rows_at_once) {
  const auto length = static_cast<hsize_t>(components);
  const hsize_t lowest = std::max<hsize_t>(1, min_chunk_bytes / (number_bytes * length));
  const hsize_t highest = std::max<hsize_t>(lowest, max_chunk_bytes / (number_bytes * length));
  return {length, components == 1, std::clamp(rows_at_once, lowest, highest), length};
}

struct Extent {
  std::array<hsize_t, 2> dims{};
  int rank = 1;
};

Extent make_extent(hsize_t rows, int components) {
  return {{rows, static_cast<hsize_t>(components)}, components == 1 ? 1 : 2};
}

Handle create_space(const Extent& extent) {
  return {check(H5Screate_simple(extent.rank, extent.dims.data(), nullptr), "describe the shape of a dataset"),
          H5Sclose};
}

Handle create_dataset(hid_t parent, const std::string& name, hid_t type, hid_t space, hid_t properties) {
  return {check(H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
                fmt::format("create dataset {}", name)),
          H5Dclose};
}

// Rows in memory.
struct RowValues {
  int components;
  hid_t type;
  const void* values;
};

// Writes a block of the rows of a dataset that begin at row `start`.
void write_rows(hid_t dataset, const std::string& name, hsize_t start, const RowBlock& block, const RowValues& rows) {
  const auto [components, type, values] = rows;
  if (block.record != nullptr) block.record->add(dataset, start + block.first, block.count, type, values);
  if (block.all == 0) return;
  const std::string action = fmt::format("write dataset {}", name);
  const Handle in_file(check(H5Dget_space(dataset), action), H5Sclose);
  const Extent count = make_extent(block.count, components);
  const Handle in_memory = create_space(count);
  const std::array<hsize_t, 2> first{start + block.first, 0};
  if (block.count == 0) {  // takes part all the same
    check(H5Sselect_none(in_file.get()), action);
    check(H5Sselect_none(in_memory.get()), action);
  } else {
    check(H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, first.data(), nullptr, count.dims.data(), nullptr),
          action);
  }
  check(H5Dwrite(dataset, type, in_memory.get(), in_file.get(), block.transfer, values), action);
}

Handle create_text_type(std::size_t length) {
  Handle type(check(H5Tcopy(H5T_C_S1), "describe a text"), H5Tclose);
  check(H5Tset_size(type.get(), std::max<std::size_t>(1, length)), "describe a text");
  check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "describe a text");
  return type;
}

void write_attribute(hid_t object, const std::string& name, hid_t file_type, hid_t space, hid_t memory,
                     const void* data) {
  const std::string action = fmt::format("write attribute {}", name);
  const bool exists = check(H5Aexists(object, name.c_str()), action) > 0;
  const hid_t id = exists ? H5Aopen(object, name.c_str(), H5P_DEFAULT)
                          : H5Acreate2(object, name.c_str(), file_type, space, H5P_DEFAULT, H5P_DEFAULT);
  Handle attribute(check(id, action), H5Aclose);
  check(H5Awrite(attribute.get(), memory, data), action);
  check(attribute.reset(), action);
}

}  // namespace

Handle create_group(hid_t parent, const std::string& name) {
  return {check(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                fmt::format("create group {}", name)),
          H5Gclose};
}

void write_dataset(hid_t parent, const std::string& name, hid_t file_type, const RowBlock& block, hid_t memory_type,
                   const void* values) {
  const Handle space = create_space(make_extent(block.all, 1));
  Handle dataset =
      create_dataset(parent, name, file_type, space.get(), create_dataset_properties("create dataset " + name).get());
  write_rows(dataset.get(), name, 0, block, {1, memory_type, values});
  check(dataset.reset(), fmt::format("close dataset {}", name));
}

void write_rows_once(hid_t parent, const std::string& name, const RowBlock& block, int components,
                     std::span<const double> values) {
  const Handle space = create_space(make_extent(block.all, components));
  const Handle dataset = create_dataset(parent, name, H5T_IEEE_F64LE, space.get(), H5P_DEFAULT);
  write_rows(dataset.get(), name, 0, block, {components, H5T_NATIVE_DOUBLE, values.data()});
}

void write_rows_once(hid_t parent, const std::string& name, const RowBlock& block, int components,
                     std::span<const std::int64_t> values) {
  // Two dimensions, whatever their lengths.
  const Extent extent{{block.all, static_cast<hsize_t>(components)}, 2};
  const Handle space = create_space(extent);
  const Handle dataset = create_dataset(parent, name, H5T_STD_I64LE, space.get(),
                                        create_dataset_properties("create dataset " + name).get());
  write_rows(dataset.get(), name, 0, block, {components, H5T_NATIVE_INT64, values.data()});
}

void write_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values) {
  const hsize_t count = values.size();
  const Handle space(check(count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr), "write " + name),
                     H5Sclose);
  write_attribute(object, name, H5T_STD_I64LE, space.get(), H5T_NATIVE_INT64, values.data());
}

void write_attribute(hid_t object, const std::string& name, const std::string& text) {
  const Handle type = create_text_type(text.size());
  const Handle space(check(H5Screate(H5S_SCALAR), "write " + name), H5Sclose);
  write_attribute(object, name, type.get(), space.get(), type.get(), text.c_str());
}

void write_texts(hid_t parent, const std::string& name, std::span<const std::string> texts, const RowBlock& block) {
  std::size_t length = 1;
  for (const auto& text : texts) length = std::max(length, text.size());
  std::vector<char> padded(texts.size() * length, '\0');
  for (std::size_t i = 0; i < texts.size(); ++i)
    std::copy(texts[i].begin(), texts[i].end(), padded.begin() + static_cast<std::ptrdiff_t>(i * length));
  const Handle type = create_text_type(length);
  write_dataset(parent, name, type.get(), block, type.get(), padded.data() + block.first * length);
}

void Table::note_unit(const std::string& unit) {
  if (!unit.empty()) write_attribute(dataset_.id(), "unit", unit);
}

Table::Table(hid_t parent, const std::string& name, hid_t file_type, int components, hsize_t rows_at_once)
    : dataset_(parent, name, file_type, make_layout(H5Tget_size(file_type), components, rows_at_once)) {}

Table::Table(hid_t parent, const std::string& name) : dataset_(parent, name) {}

void Table::append(const void* values, hid_t type, const RowBlock& block) {
  const hsize_t before = rows();
  dataset_.extend(block.all);
  write_rows(dataset_.id(), dataset_.name(), before, block, {components(), type, values});
}

}  // namespace percuss::hdf5
