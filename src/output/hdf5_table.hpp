#pragma once
// Datasets and attributes of fields.vtkhdf: the one place where numbers go into HDF5.
//
// Errors are hdf5::Error. Every write goes through write_rows(), so that a parallel run needs to change only that
// function: each rank will select its own rows and the transfer will be collective.

#include <cstdint>
#include <span>
#include <string>

#include "src/output/hdf5_handle.hpp"

namespace percuss::hdf5 {

/// The HDF5 type of a C++ number in memory.
template <class T>
hid_t memory_type();
template <>
inline hid_t memory_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t memory_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
inline hid_t memory_type<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

/// Numbers laid out as rows of `components`; a single component makes a one-dimensional dataset, as VTK wants it.
struct RowShape {
  hsize_t rows = 0;
  int components = 1;
};

/// A group below `parent`.
Handle create_group(hid_t parent, const std::string& name);

/// A dataset that is written once. values: shape.rows * shape.components numbers.
void write_dataset(hid_t parent, const std::string& name, hid_t file_type, RowShape shape, hid_t memory_type,
                   const void* values);

template <class T>
void write_dataset(hid_t parent, const std::string& name, hid_t file_type, int components, std::span<const T> values) {
  const auto rows = values.size() / static_cast<std::size_t>(components);
  write_dataset(parent, name, file_type, {rows, components}, memory_type<T>(), values.data());
}

/// Attributes: whole numbers (one or several) and text of fixed length.
void write_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values);
void write_attribute(hid_t object, const std::string& name, const std::string& text);

/// Texts of one fixed length (that of the longest), padded with zeros.
void write_texts(hid_t parent, const std::string& name, std::span<const std::string> texts);

/// A dataset that grows at its end.
class Table {
 public:
  /// Creates it empty below `parent`; `rows_at_once` is how many rows an append brings (decides the chunks).
  Table(hid_t parent, const std::string& name, hid_t file_type, int components, hsize_t rows_at_once);

  /// Adds rows at the end. values: a whole number of rows.
  template <class T>
  void append(std::span<const T> values) {
    append(values.data(), memory_type<T>(), values.size() / static_cast<std::size_t>(components_));
  }

  hsize_t rows() const { return rows_; }

  /// Most bytes that the next append of so many rows makes the file grow by.
  hsize_t growth_bytes(hsize_t rows) const;

 private:
  void append(const void* values, hid_t memory_type, hsize_t rows);

  Handle dataset_;
  std::string name_;
  int components_;
  hsize_t chunk_rows_ = 1, row_bytes_ = 1;
  hsize_t rows_ = 0;
};

}  // namespace percuss::hdf5
