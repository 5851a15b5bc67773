#include "src/output/hdf5/hdf5_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace percuss::hdf5 {
namespace {

Handle open_dataset(hid_t parent, const std::string& name) {
  return {check(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), "open dataset " + name), H5Dclose};
}

Shape shape_of(hid_t dataset, const std::string& name) {
  const Handle space(check(H5Dget_space(dataset), "read the shape of " + name), H5Sclose);
  std::array<hsize_t, 2> dims{0, 1};
  const int rank = H5Sget_simple_extent_ndims(space.get());
  if (rank != 1 && rank != 2) throw Error("read " + name, "it has neither one nor two dimensions");
  check(H5Sget_simple_extent_dims(space.get(), dims.data(), nullptr), "read the shape of " + name);
  return {dims[0], dims[1]};
}

/// Bytes that a value takes in the file, at least 1.
hsize_t find_value_bytes(hid_t dataset, const std::string& name) {
  const Handle type(check(H5Dget_type(dataset), "read " + name), H5Tclose);
  return std::max<hsize_t>(H5Tget_size(type.get()), 1);
}

/// Length of the file that an object is in.
hsize_t find_file_bytes(hid_t object, const std::string& name) {
  const Handle file(check(H5Iget_file_id(object), "read " + name), H5Fclose);
  hsize_t bytes = 0;
  check(H5Fget_filesize(file.get(), &bytes), "read " + name);
  return bytes;
}

constexpr std::size_t longest_text = 65536;

// A text of fixed length, or several of them.
std::vector<std::string> split_texts(const std::vector<char>& bytes, std::size_t length) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; at + length <= bytes.size(); at += length) {
    const std::string text(bytes.data() + at, length);
    texts.push_back(text.substr(0, text.find('\0')));
  }
  return texts;
}

Handle copy_text_type(hid_t type, std::size_t count, const std::string& name) {
  const Handle owned(type, H5Tclose);
  check(type, "read " + name);
  const std::size_t length = H5Tget_size(type);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 || length == 0 || length > longest_text ||
      count > longest_text)
    throw Error("read " + name, "it is not a text of fixed length");
  return {check(H5Tcopy(type), "read " + name), H5Tclose};
}

herr_t collect_name(hid_t, const char* name, const H5L_info_t*, void* data) {
  static_cast<std::vector<std::string>*>(data)->emplace_back(name);
  return 0;
}

}  // namespace

Handle open_unlocked(const std::string& path, unsigned mode) {
  const Handle access(check(H5Pcreate(H5P_FILE_ACCESS), "open the file"), H5Pclose);
  check(H5Pset_file_locking(access.get(), false, true), "open the file");
  return {check(H5Fopen(path.c_str(), mode, access.get()), "open it as HDF5"), H5Fclose};
}

Handle open_group(hid_t parent, const std::string& name) {
  return {check(H5Gopen2(parent, name.c_str(), H5P_DEFAULT), "open group " + name), H5Gclose};
}

Shape read_shape(hid_t parent, const std::string& name) { return shape_of(open_dataset(parent, name).get(), name); }

// A damaged file may claim any size: what it claims must be in the dataset, and
// what is in the dataset must fit into the file.
template <class T>
std::vector<T> read_rows(hid_t parent, const std::string& name, hsize_t first, hsize_t rows, hsize_t file_bytes) {
  const Handle dataset = open_dataset(parent, name);
  const Shape shape = shape_of(dataset.get(), name);
  if (shape.components == 0) throw Error("read " + name, "its rows are empty");
  const hsize_t row_bytes = shape.components * find_value_bytes(dataset.get(), name);
  if (first > shape.rows || rows > shape.rows - first || shape.components > 9 || rows > file_bytes / row_bytes)
    throw Error("read " + name, fmt::format("it has no rows {} to {}", first, first + rows));
  std::vector<T> values(rows * shape.components);
  if (values.empty()) return values;
  const Handle in_file(check(H5Dget_space(dataset.get()), "read " + name), H5Sclose);
  const std::array<hsize_t, 2> start{first, 0}, count{rows, shape.components};
  check(H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
        "read " + name);
  // The shape in memory is that of the file: HDF5 looks up shapes that differ number by number.
  const int dimensions = H5Sget_simple_extent_ndims(in_file.get());
  const Handle in_memory(check(H5Screate_simple(dimensions, count.data(), nullptr), "read " + name), H5Sclose);
  check(H5Dread(dataset.get(), memory_type<T>(), in_memory.get(), in_file.get(), H5P_DEFAULT, values.data()),
        "read " + name);
  return values;
}

template std::vector<double> read_rows(hid_t, const std::string&, hsize_t, hsize_t, hsize_t);
template std::vector<std::int64_t> read_rows(hid_t, const std::string&, hsize_t, hsize_t, hsize_t);
template std::vector<std::uint8_t> read_rows(hid_t, const std::string&, hsize_t, hsize_t, hsize_t);

std::int64_t read_whole_number(hid_t object, const std::string& name) {
  std::int64_t value = 0;
  const Handle attribute(check(H5Aopen(object, name.c_str(), H5P_DEFAULT), "open attribute " + name), H5Aclose);
  const Handle space(check(H5Aget_space(attribute.get()), "read attribute " + name), H5Sclose);
  if (H5Sget_simple_extent_npoints(space.get()) != 1) throw Error("read attribute " + name, "it is not a single value");
  check(H5Aread(attribute.get(), H5T_NATIVE_INT64, &value), "read attribute " + name);
  return value;
}

std::string read_text(hid_t object, const std::string& name) {
  const Handle attribute(check(H5Aopen(object, name.c_str(), H5P_DEFAULT), "open attribute " + name), H5Aclose);
  const Handle space(check(H5Aget_space(attribute.get()), "read attribute " + name), H5Sclose);
  if (H5Sget_simple_extent_npoints(space.get()) != 1) throw Error("read attribute " + name, "it is not a single value");
  const Handle type = copy_text_type(H5Aget_type(attribute.get()), 1, name);
  std::vector<char> bytes(H5Tget_size(type.get()));
  check(H5Aread(attribute.get(), type.get(), bytes.data()), "read attribute " + name);
  return split_texts(bytes, bytes.size()).front();
}

std::vector<std::string> read_texts(hid_t parent, const std::string& name) {
  const Handle dataset = open_dataset(parent, name);
  const Shape shape = shape_of(dataset.get(), name);
  const Handle type = copy_text_type(H5Dget_type(dataset.get()), shape.rows, name);
  const std::size_t length = H5Tget_size(type.get());
  if (shape.components != 1) throw Error("read " + name, "its texts are not a list of one dimension");
  if (shape.rows > find_file_bytes(dataset.get(), name) / length)
    throw Error("read " + name, "the file is too short for so many texts");
  std::vector<char> bytes(shape.rows * length);
  if (!bytes.empty())
    check(H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), "read " + name);
  return split_texts(bytes, length);
}

std::vector<std::string> read_character_rows(hid_t parent, const std::string& name) {
  const Shape shape = read_shape(parent, name);
  constexpr hsize_t longest = 65536;
  if (shape.components > longest || shape.rows > longest) throw Error("read " + name, "it has too many texts");
  const Handle dataset = open_dataset(parent, name);
  const Handle type(check(H5Dget_type(dataset.get()), "read " + name), H5Tclose);
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tget_size(type.get()) != 1 || H5Tis_variable_str(type.get()) != 0)
    throw Error("read " + name, "it does not hold characters");
  std::vector<char> padded(shape.rows * shape.components);
  if (!padded.empty())
    check(H5Dread(dataset.get(), H5T_C_S1, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()), "read " + name);
  std::vector<std::string> texts;
  for (hsize_t i = 0; i < shape.rows; ++i) {
    const auto begin = padded.begin() + static_cast<std::ptrdiff_t>(i * shape.components);
    const auto end = begin + static_cast<std::ptrdiff_t>(shape.components);
    texts.emplace_back(begin, std::find(begin, end, '\0'));
  }
  return texts;
}

std::vector<std::string> list_names(hid_t parent, const std::string& group) {
  std::vector<std::string> names;
  check(
      H5Literate_by_name(parent, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect_name, &names, H5P_DEFAULT),
      "list group " + group);
  return names;
}

}  // namespace percuss::hdf5
