#pragma once
// Groups and growing tables of fields.vtkhdf, as VTKHDF 2.0 names them; what VTK does not know is in /percuss.

#include <optional>
#include <span>
#include <vector>

#include "src/hdf5/hdf5_handle.hpp"
#include "src/output/hdf5/frame_table.hpp"
#include "src/output/hdf5/hdf5_table.hpp"
#include "src/output/vtkhdf/fields_file.hpp"

namespace percuss {

/// Everything below the file that is open while frames are written. Calls are collective and throw hdf5::Error.
struct VtkhdfTables {
  /// One field of every frame, and the row at which each frame of it starts.
  struct Field {
    FieldPlace place;
    hdf5::Table values;
    hdf5::Table offsets;
  };
  /// A table of Steps to which every frame adds the same number.
  struct Constant {
    hdf5::Table table;
    std::int64_t value;
  };

  hdf5::Handle root, point_data, cell_data, steps, point_data_offsets, cell_data_offsets, own;
  std::optional<hdf5::Table> points, times, point_offsets, step_numbers;  // from create_steps() or open() on
  std::optional<hdf5::FrameTable> wall_displacements;                     // only where walls move
  std::vector<Constant> constants;
  std::vector<Field> fields;  // from the first frame on

  /// Makes the groups in an empty file.
  void create_groups(hid_t file);

  /// Makes the tables of the steps, empty. nodes: of the whole mesh, rows of Points that a frame brings.
  void create_steps(hsize_t nodes, const FieldsOptions& options);

  /// Makes the tables of the fields, empty. nodes, elements: of the whole mesh.
  void create_fields(std::span<const FieldData> described, const FieldsOptions& options, hsize_t nodes,
                     hsize_t elements);

  /// Opens what create_groups() and create_steps() made.
  void open(hid_t file);

  /// Whether create_fields() was called for the file.
  bool has_fields() const;

  /// Opens what create_fields() made for the same fields.
  void open_fields(std::span<const FieldData> described);

  /// Closes everything: HDF5 closes a file only when nothing within it is open.
  void release();

 private:
  template <class Make>
  void add_constants(const Make& make);
};

}  // namespace percuss
