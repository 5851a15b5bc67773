#pragma once
// Dimensions, variables and attributes of netCDF-4, written as HDF5: a dimension is a dimension scale, a variable a
// dataset whose attribute DIMENSION_LIST refers to its scales (netCDF-4 file format specification, "NetCDF-4 Format").

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "src/output/hdf5/hdf5_table.hpp"

namespace percuss {

/// The dimensions of a file, in the order of their creation. Errors are hdf5::Error; calls are collective.
class NetcdfDimensions {
 public:
  /// A dimension without a variable; length 0: it grows.
  void create(hid_t file, const std::string& name, std::size_t length);
  /// One that is there.
  void open(hid_t file, const std::string& name);

  /// Says which dimensions a dataset has.
  void attach(hid_t dataset, std::span<const std::string> names) const;
  /// Attaches dimensions to a dataset below the file.
  void attach(hid_t file, const std::string& dataset, std::span<const std::string> names) const;

  std::size_t length(const std::string& name) const { return lengths_.at(name); }

 private:
  std::map<std::string, hobj_ref_t> scales_;
  std::map<std::string, std::size_t> lengths_;
};

/// Variables that are written once, with their dimensions. Rows of a block are those of the first dimension.
struct NetcdfFile {
  hid_t file;
  NetcdfDimensions& dimensions;

  void write_integers(const std::string& name, const std::string& dimension, const hdf5::RowBlock& block,
                      std::span<const std::int64_t> values) const;
  /// values: [block.count][length of the second dimension]
  void write_integer_rows(const std::string& name, std::span<const std::string> names, const hdf5::RowBlock& block,
                          std::span<const std::int64_t> values) const;
  void write_numbers(const std::string& name, const std::string& dimension, const hdf5::RowBlock& block,
                     std::span<const double> values) const;
  /// Texts as rows of characters, padded with zeros or cut to the length of the last dimension; all ranks have all of
  /// them. The first dimensions have as many entries together as there are texts.
  void write_texts(const std::string& name, std::span<const std::string> names, hid_t transfer, bool is_writer,
                   std::span<const std::string> texts) const;
};

/// Attributes of a type that netCDF expects.
void write_int_attribute(hid_t object, const std::string& name, int value);
void write_float_attribute(hid_t object, const std::string& name, float value);

}  // namespace percuss
