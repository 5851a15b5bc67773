#pragma once
// A dataset that grows at its end by rows: how it is made, opened, extended and cut, and what room it takes.

#include <array>
#include <string>

#include "src/hdf5/hdf5_handle.hpp"

namespace percuss::hdf5 {

/// Properties of a dataset, without the time of its creation, so that two runs of one scene leave the same bytes.
Handle create_dataset_properties(const std::string& action);

/// Properties of one whose room is made when it is created or extended: several ranks can only write to such room. It
/// is not filled: every row is written before a reader may look at it.
Handle create_early_properties(const std::string& action);

/// Errors are Error. In a file that several ranks write together every call is collective.
class GrowingDataset {
 public:
  /// Numbers of a row, in one dimension more unless it is a list, and how many rows and numbers a chunk holds.
  struct Layout {
    hsize_t row_length = 1;
    bool is_list = false;
    hsize_t chunk_rows = 1, chunk_length = 1;
  };

  /// Creates it without rows below `parent`.
  GrowingDataset(hid_t parent, const std::string& name, hid_t file_type, const Layout& layout);

  /// Opens one that is there.
  GrowingDataset(hid_t parent, const std::string& name);

  hid_t id() const { return dataset_.get(); }
  const std::string& name() const { return name_; }
  hsize_t rows() const { return rows_; }
  hsize_t row_length() const { return layout_.row_length; }

  void extend(hsize_t rows);

  /// Cuts off all rows from row `rows` on. In a file that this process alone has open.
  void cut(hsize_t rows);

  /// Most bytes that the next `rows` rows make the file grow by: their chunks and the nodes of the chunks' index.
  hsize_t growth_bytes(hsize_t rows) const;

 private:
  void set_rows(hsize_t rows, const std::string& action);
  hsize_t count_chunks(hsize_t rows) const;

  Handle dataset_;
  std::string name_;
  Layout layout_;
  hsize_t rows_ = 0, chunk_bytes_ = 0;
  hsize_t index_entries_ = 0;  // of a node of the index
};

}  // namespace percuss::hdf5
