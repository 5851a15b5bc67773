#pragma once
// Reads HDF5 files that may be damaged or untrusted: all claims of a file are checked before use.

#include <cstdint>
#include <string>
#include <vector>

#include "src/hdf5/hdf5_handle.hpp"
#include "src/output/hdf5/hdf5_table.hpp"

namespace percuss::hdf5 {

/// Opens a file (H5F_ACC_RDONLY, H5F_ACC_RDWR) without a lock: others may have it open. This and all below throw Error
/// if the thing is missing or is not what it should be.
Handle open_unlocked(const std::string& path, unsigned mode);

/// Opens a group below `parent`.
Handle open_group(hid_t parent, const std::string& name);

/// The shape of a dataset of one or two dimensions; components is 1 for one dimension.
struct Shape {
  hsize_t rows = 0, components = 1;
};
Shape read_shape(hid_t parent, const std::string& name);

/// Rows [first, first + rows) of a dataset, row by row. file_bytes: size of the file, which bounds what is believed.
template <class T>
std::vector<T> read_rows(hid_t parent, const std::string& name, hsize_t first, hsize_t rows, hsize_t file_bytes);

/// Attributes: one whole number; one text of fixed length.
std::int64_t read_whole_number(hid_t object, const std::string& name);
std::string read_text(hid_t object, const std::string& name);

/// A dataset of texts of fixed length.
std::vector<std::string> read_texts(hid_t parent, const std::string& name);

/// Texts as rows of characters, as netCDF has them, up to their first zero.
std::vector<std::string> read_character_rows(hid_t parent, const std::string& name);

/// Names of what is in a group, ascending.
std::vector<std::string> list_names(hid_t parent, const std::string& group);

}  // namespace percuss::hdf5
