#include "src/output/hdf5/write_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "comm/all_reduce.hpp"
#include "kernels/core/same_bits.hpp"
#include "src/hdf5/hdf5_structure.hpp"
#include "src/output/hdf5/hdf5_reading.hpp"

namespace percuss::hdf5 {
namespace {

constexpr hsize_t largest_read = hsize_t{1} << 20;  // bytes: stays in the cache of a core

/// The share of some numbers of `Unit`'s size in the hash of a dataset. first: place of the first one.
template <class Unit>
std::uint64_t hash_units(const void* data, std::uint64_t first, std::size_t count) {
  const auto* bytes = static_cast<const std::byte*>(data);
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Unit unit;
    std::memcpy(&unit, bytes + i * sizeof(Unit), sizeof(Unit));
    sum += mix_bits(unit + (first + i) * 0x9e3779b97f4a7c15ull);
  }
  return sum;
}

/// Hash of rows of a dataset: numbers of 8, 4 or 1 bytes, or texts, which are hashed byte by byte.
std::uint64_t hash_rows(const void* data, std::size_t number_bytes, hsize_t numbers_per_row, hsize_t first,
                        hsize_t rows) {
  const auto at = [&](std::size_t per_number) { return first * numbers_per_row * per_number; };
  const auto count = [&](std::size_t per_number) {
    return static_cast<std::size_t>(rows * numbers_per_row) * per_number;
  };
  if (number_bytes == 8) return hash_units<std::uint64_t>(data, at(1), count(1));
  if (number_bytes == 4) return hash_units<std::uint32_t>(data, at(1), count(1));
  return hash_units<std::uint8_t>(data, at(number_bytes), count(number_bytes));
}

struct Layout {
  int dimensions = 1;
  hsize_t rows = 0, numbers_per_row = 1;
  Handle memory_type;  // whose numbers have the bits of those in the file
  std::size_t number_bytes = 0;
};

Layout find_layout(hid_t dataset, const std::string& action) {
  const Handle space(check(H5Dget_space(dataset), action), H5Sclose);
  std::array<hsize_t, 2> dims{0, 1};
  const int dimensions = H5Sget_simple_extent_ndims(space.get());
  if (dimensions != 1 && dimensions != 2) throw Error(action, "it has neither one nor two dimensions");
  check(H5Sget_simple_extent_dims(space.get(), dims.data(), nullptr), action);
  const Handle type(check(H5Dget_type(dataset), action), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type.get());
  if ((kind != H5T_INTEGER && kind != H5T_FLOAT && kind != H5T_STRING) || H5Tis_variable_str(type.get()) > 0)
    throw Error(action, "it holds neither numbers nor texts of fixed length");
  Layout layout{
      dimensions, dims[0], dims[1], {check(H5Tget_native_type(type.get(), H5T_DIR_ASCEND), action), H5Tclose}, 0};
  layout.number_bytes = H5Tget_size(layout.memory_type.get());
  return layout;
}

/// Some numbers of a dataset, in memory as they are in the file.
struct Piece {
  std::array<hsize_t, 2> start, extent;
};

void read_piece(hid_t dataset, const Layout& layout, const Piece& piece, std::vector<char>& values,
                const std::string& action) {
  values.resize(static_cast<std::size_t>(piece.extent[0] * piece.extent[1]) * layout.number_bytes);
  const Handle in_file(check(H5Dget_space(dataset), action), H5Sclose);
  check(H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, piece.start.data(), nullptr, piece.extent.data(), nullptr),
        action);
  // The shape in memory is that of the file: HDF5 looks up shapes that differ number by number.
  const Handle in_memory(check(H5Screate_simple(layout.dimensions, piece.extent.data(), nullptr), action), H5Sclose);
  check(H5Dread(dataset, layout.memory_type.get(), in_memory.get(), in_file.get(), H5P_DEFAULT, values.data()), action);
}

/// The hash of a part of a row, read a piece at a time.
std::uint64_t read_part_hash(hid_t dataset, const Layout& layout, const WriteRecord::PartOfRow& part,
                             const std::string& action) {
  const hsize_t at_once = std::max<hsize_t>(1, largest_read / layout.number_bytes),
                before = part.row * layout.numbers_per_row;
  std::vector<char> values;
  std::uint64_t hash = 0;
  for (hsize_t first = part.first, end = part.first + part.count; first < end; first += at_once) {
    const hsize_t count = std::min(at_once, end - first);
    read_piece(dataset, layout, {{part.row, first}, {1, count}}, values, action);
    hash += hash_rows(values.data(), layout.number_bytes, 1, before + first, count);
  }
  return hash;
}

/// The hash of rows [first, first + rows), read a piece at a time.
std::uint64_t read_hash(hid_t dataset, const Layout& layout, hsize_t first, hsize_t rows, const std::string& action) {
  const hsize_t row_bytes = std::max<hsize_t>(1, layout.numbers_per_row * layout.number_bytes);
  const hsize_t at_once = std::max<hsize_t>(1, largest_read / row_bytes);
  std::vector<char> values;
  std::uint64_t hash = 0;
  for (const hsize_t end = first + rows; first < end; first += at_once) {
    const hsize_t count = std::min(at_once, end - first);
    read_piece(dataset, layout, {{first, 0}, {count, layout.numbers_per_row}}, values, action);
    hash += hash_rows(values.data(), layout.number_bytes, layout.numbers_per_row, first, count);
  }
  return hash;
}

std::string find_path(hid_t dataset) {
  const ssize_t length = H5Iget_name(dataset, nullptr, 0);
  if (length <= 0) throw Error("name a dataset");
  std::string path(static_cast<std::size_t>(length) + 1, '\0');
  H5Iget_name(dataset, path.data(), path.size());
  path.pop_back();
  return path;
}

/// Hash of a dataset, as it enters that of the file's content.
std::uint64_t hash_dataset(const std::string& path, hsize_t rows, std::uint64_t numbers) {
  const std::uint64_t name = hash_units<std::uint8_t>(path.data(), 0, path.size());
  return mix_bits(mix_bits(mix_bits(name) + rows) + numbers);
}

}  // namespace

void WriteRecord::add(hid_t dataset, hsize_t first, hsize_t rows, hid_t memory_type, const void* values) {
  const std::string path = find_path(dataset);
  const Layout layout = find_layout(dataset, "record dataset " + path);
  std::uint64_t hash = 0;
  if (H5Tget_size(memory_type) == layout.number_bytes) {
    hash = hash_rows(values, layout.number_bytes, layout.numbers_per_row, first, rows);
  } else {  // doubles that are stored as floats
    const auto* doubles = static_cast<const double*>(values);
    const std::vector<float> floats(doubles, doubles + rows * layout.numbers_per_row);
    hash = hash_rows(floats.data(), sizeof(float), layout.numbers_per_row, first, rows);
  }
  blocks_.push_back({path, first, rows, layout.rows, hash});
}

void WriteRecord::add_part(hid_t dataset, const PartOfRow& part, hid_t memory_type, const void* values) {
  const std::string path = find_path(dataset);
  const Layout layout = find_layout(dataset, "record dataset " + path);
  if (H5Tget_size(memory_type) != layout.number_bytes) throw Error("record dataset " + path, "its numbers are others");
  const hsize_t before = part.row * layout.numbers_per_row;
  const std::uint64_t hash = hash_rows(values, layout.number_bytes, 1, before + part.first, part.count);
  blocks_.push_back({path, part.row, 1, part.row + 1, hash, true, part.first, part.count});
}

void WriteRecord::compare(hid_t file) const {
  for (const Block& block : blocks_) {
    const std::string action = "read back dataset " + block.path;
    const Handle dataset(check(H5Dopen2(file, block.path.c_str(), H5P_DEFAULT), action), H5Dclose);
    const Layout layout = find_layout(dataset.get(), action);
    if (layout.rows < block.all) throw Error(action, "it is shorter than what was written");
    const std::uint64_t hash =
        block.is_part ? read_part_hash(dataset.get(), layout, {block.first, block.first_number, block.numbers}, action)
                      : read_hash(dataset.get(), layout, block.first, block.rows, action);
    if (hash != block.hash) throw Error(action, "it does not hold what was written");
  }
}

std::uint64_t WriteRecord::find_content(const Communicator& ranks) const {
  std::vector<std::uint64_t> hashes;
  for (const Block& block : blocks_) hashes.push_back(block.hash);
  all_reduce(ranks, Reduce::sum, hashes);
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < hashes.size(); ++i) sum += hash_dataset(blocks_[i].path, blocks_[i].all, hashes[i]);
  return sum;
}

namespace {

std::uint64_t find_content(hid_t group, std::uint64_t file_bytes, int depth) {
  if (depth > deepest_group)
    throw Error("read the groups", fmt::format("they are nested more than {} deep", deepest_group));
  std::uint64_t sum = 0;
  for (const std::string& name : list_names(group, ".")) {
    const Handle object(check(H5Oopen(group, name.c_str(), H5P_DEFAULT), "open " + name), H5Oclose);
    if (H5Iget_type(object.get()) == H5I_GROUP) {
      sum += find_content(object.get(), file_bytes, depth + 1);
      continue;
    }
    const std::string action = "read " + name;
    const Layout layout = find_layout(object.get(), action);
    if (layout.numbers_per_row > 9 || layout.number_bytes > 65536 || layout.rows > file_bytes)
      throw Error(action, "it has more values than the file");
    sum += hash_dataset(find_path(object.get()), layout.rows, read_hash(object.get(), layout, 0, layout.rows, action));
  }
  return sum;
}

}  // namespace

std::uint64_t find_content(hid_t group, std::uint64_t file_bytes) { return find_content(group, file_bytes, 0); }

Handle open_to_compare(const std::string& path) {
  const std::string action = "open the file to read it back";
  const Handle access(check(H5Pcreate(H5P_FILE_ACCESS), action), H5Pclose);
  // HDF5 shares what it has in memory between openings by the same driver; the files written go through others.
  check(H5Pset_fapl_stdio(access.get()), action);
  check(H5Pset_file_locking(access.get(), false, true), action);
  check(H5Pset_cache(access.get(), 0, 1, 0, 1.0), action);
  check(H5Pset_sieve_buf_size(access.get(), 0), action);
  return {check(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), action), H5Fclose};
}

}  // namespace percuss::hdf5
