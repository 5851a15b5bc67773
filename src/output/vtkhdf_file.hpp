#pragma once
// The datasets of fields.vtkhdf: VTK's layout of an unstructured grid over time, version 2.0 of VTKHDF.
//
// One partition, whose cells are stored once: Steps/*Offsets send every step back to them. Points and fields lie frame
// after frame in one dataset each. What VTK does not know (title, units, part names, step numbers) is in /percuss.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/output/disk_reservation.hpp"
#include "src/output/fields_file.hpp"
#include "src/output/hdf5_table.hpp"

namespace percuss {

class VtkhdfFile {
 public:
  /// Creates the file with the mesh and no frame. Throws SystemError; no file is left then.
  VtkhdfFile(const std::string& path, const Mesh& mesh, const FieldsOptions& options);
  /// Closes the file; errors are lost.
  ~VtkhdfFile();
  VtkhdfFile(const VtkhdfFile&) = delete;
  VtkhdfFile& operator=(const VtkhdfFile&) = delete;

  /// Appends a frame: room is reserved, data are written and flushed, then the number of steps, which is what shows the
  /// frame to readers. The first frame creates the fields. Throws SystemError; the file then keeps the frames before
  /// and takes no more.
  void append_frame(double time, std::int64_t step, std::span<const double> positions,
                    std::span<const FieldData> fields);

  /// Waits for the disk and closes. Throws SystemError.
  void close();

 private:
  // One field of every frame, and the row at which each frame of it starts.
  struct FieldTables {
    FieldPlace place;
    hdf5::Table values;
    hdf5::Table offsets;
  };
  // A table of Steps to which every frame adds the same number.
  struct StepConstant {
    hdf5::Table table;
    std::int64_t value;
  };

  template <class Work>
  void run_or_abandon(const char* action, Work&& work);
  void create(const Mesh& mesh, const FieldsOptions& options);
  void write_mesh(const Mesh& mesh, const FieldsOptions& options);
  void create_steps(hsize_t nodes);
  void create_fields(std::span<const FieldData> fields);
  void add_constant(const hdf5::Handle& group, const std::string& name, std::int64_t value);
  void append_rows(double time, std::int64_t step, std::span<const double> positions,
                   std::span<const FieldData> fields);
  hsize_t frame_bytes(std::span<const FieldData> fields) const;
  hsize_t file_bytes() const;
  void flush();
  void release_objects();
  void abandon();

  std::string path_;
  FieldPrecision precision_;
  hsize_t nodes_, elements_;
  std::int64_t frames_ = 0;
  bool flushing_ = false;  // stays true if that failed
  DiskReservation disk_;
  hdf5::Handle file_, root_, point_data_, cell_data_, steps_, point_data_offsets_, cell_data_offsets_, own_;
  std::optional<hdf5::Table> points_, times_, point_offsets_, step_numbers_;
  std::vector<StepConstant> constants_;
  std::vector<FieldTables> fields_;
};

}  // namespace percuss
