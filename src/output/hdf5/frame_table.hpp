#pragma once
// A dataset with a row a frame, [frames][items]: the layout of netCDF and so of Exodus II.

#include <span>
#include <string>

#include "src/output/hdf5/hdf5_table.hpp"

namespace percuss::hdf5 {

/// Errors are Error. In a file that several ranks write together every call is collective.
class FrameTable {
 public:
  /// Creates it without frames below `parent`. items: numbers of a frame, at least 1; one alone with is_list gives a
  /// dataset of one dimension. is_alone: one of a few in the file, whatever the number of blocks.
  struct Shape {
    hsize_t items = 1;
    bool is_list = false, is_alone = false;
  };
  FrameTable(hid_t parent, const std::string& name, const Shape& shape);

  /// Opens one that is there.
  FrameTable(hid_t parent, const std::string& name);

  hid_t id() const { return dataset_.id(); }
  hsize_t frames() const { return dataset_.rows(); }

  /// Adds a frame. block: of its items; values: [block.count].
  void append(std::span<const double> values, const RowBlock& block);

  /// Cuts off all frames from `frames` on. In a file that this process alone has open.
  void cut(hsize_t frames) { dataset_.cut(frames); }

  /// Most bytes that the next append makes the file grow by.
  hsize_t growth_bytes() const { return dataset_.growth_bytes(1); }

 private:
  GrowingDataset dataset_;
};

}  // namespace percuss::hdf5
