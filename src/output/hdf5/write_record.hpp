#pragma once
// What was handed to HDF5 for writing, kept as hashes, so that it can be compared with what a reader finds in the file.

#include <cstdint>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/hdf5/hdf5_handle.hpp"

namespace percuss::hdf5 {

/// The blocks of datasets that this rank has written. The hash of a block is a sum over its numbers that depends on
/// their places in the dataset: those of the blocks of all ranks add up to that of the whole, however it is cut.
class WriteRecord {
 public:
  /// Notes rows [first, first + rows) of a dataset of one or two dimensions. values: as they are in memory, [rows] of
  /// as many components as the dataset has. Throws Error.
  void add(hid_t dataset, hsize_t first, hsize_t rows, hid_t memory_type, const void* values);

  /// Notes numbers [first, first + count) of one row of a dataset of one or two dimensions.
  struct PartOfRow {
    hsize_t row, first, count;
  };
  void add_part(hid_t dataset, const PartOfRow& part, hid_t memory_type, const void* values);

  /// Reads the blocks of this rank in a file that was opened for nothing else (open_to_compare()). Throws Error for the
  /// first dataset whose numbers are not those that were written.
  void compare(hid_t file) const;

  /// One hash of names, lengths and numbers of all datasets, whose blocks lie in any order; find_content() of the file
  /// gives the same. Collective. Throws MpiError.
  std::uint64_t find_content(const Communicator& ranks) const;

  void clear() { blocks_.clear(); }

 private:
  struct Block {
    std::string path;  // of the dataset
    hsize_t first, rows, all;
    std::uint64_t hash;
    bool is_part = false;  // of one row:
    hsize_t first_number = 0, numbers = 0;
  };
  std::vector<Block> blocks_;
};

/// The hash of names, lengths and numbers of all datasets below a group, of a file that may be damaged. file_bytes:
/// its size, which bounds what is believed. Throws Error.
std::uint64_t find_content(hid_t group, std::uint64_t file_bytes);

/// Opens a file that this process may have open for writing so that it is seen as other programs see it: through the
/// system, not through what HDF5 holds in memory. Throws Error.
Handle open_to_compare(const std::string& path);

}  // namespace percuss::hdf5
