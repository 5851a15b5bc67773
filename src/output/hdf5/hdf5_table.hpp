#pragma once
// Datasets and attributes of fields.vtkhdf: the one place where numbers go into HDF5.
//
// Errors are hdf5::Error. In a file that several ranks write together every call is collective: each rank writes its
// block of the rows, in one collective transfer.

#include <cstdint>
#include <span>
#include <string>

#include "src/hdf5/hdf5_handle.hpp"
#include "src/output/hdf5/growing_dataset.hpp"
#include "src/output/hdf5/write_record.hpp"

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

/// Rows that the ranks write together, and the block of them that this rank brings. Rows are numbers, or `components`
/// of them side by side.
struct RowBlock {
  hsize_t all = 0;
  hsize_t first = 0;
  hsize_t count = 0;
  hid_t transfer = H5P_DEFAULT;   // collective where several ranks write
  WriteRecord* record = nullptr;  // notes what was written, to be compared with what is read back
};

/// A group below `parent`.
Handle create_group(hid_t parent, const std::string& name);

/// A dataset that is written once. values: [block.count] numbers; or [block.count][components], row by row.
void write_dataset(hid_t parent, const std::string& name, hid_t file_type, const RowBlock& block, hid_t memory_type,
                   const void* values);
void write_rows_once(hid_t parent, const std::string& name, const RowBlock& block, int components,
                     std::span<const double> values);
void write_rows_once(hid_t parent, const std::string& name, const RowBlock& block, int components,
                     std::span<const std::int64_t> values);

/// Attributes: whole numbers (one or several) and text of fixed length.
void write_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values);
void write_attribute(hid_t object, const std::string& name, const std::string& text);

/// Texts of one fixed length (that of the longest), padded with zeros. texts: [block.all], the same on every rank, of
/// which this one writes its block.
void write_texts(hid_t parent, const std::string& name, std::span<const std::string> texts, const RowBlock& block);

/// A dataset that grows at its end; a single component makes it one-dimensional, as VTK wants it.
class Table {
 public:
  /// Creates it empty below `parent`; `rows_at_once` is how many rows an append brings (decides the chunks).
  Table(hid_t parent, const std::string& name, hid_t file_type, int components, hsize_t rows_at_once);

  /// Opens one that is there.
  Table(hid_t parent, const std::string& name);

  int components() const { return static_cast<int>(dataset_.row_length()); }

  /// Says what its numbers are in, as the attribute `unit`; nothing if that is empty.
  void note_unit(const std::string& unit);

  /// Cuts off all rows from row `rows` on. In a file that this process alone has open.
  void cut(hsize_t rows) { dataset_.cut(rows); }

  /// Adds block.all rows at the end. values: [block.count][components].
  template <class T>
  void append(std::span<const T> values, const RowBlock& block) {
    append(values.data(), memory_type<T>(), block);
  }

  hsize_t rows() const { return dataset_.rows(); }

  /// Most bytes that the next append of so many rows makes the file grow by.
  hsize_t growth_bytes(hsize_t rows) const { return dataset_.growth_bytes(rows); }

 private:
  void append(const void* values, hid_t memory_type, const RowBlock& block);

  GrowingDataset dataset_;
};

}  // namespace percuss::hdf5
