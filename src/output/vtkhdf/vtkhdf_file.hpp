#pragma once
// The datasets of fields.vtkhdf: VTK's layout of an unstructured grid over time, version 2.0 of VTKHDF.
//
// One partition, whose cells are stored once: Steps/*Offsets refer every step to them. Points and fields are stored
// frame after frame in one dataset each. Data without a place in VTK (title, units, part names, step numbers) are in
// /percuss.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "src/output/hdf5/durable_file.hpp"
#include "src/output/vtkhdf/fields_file.hpp"
#include "src/output/vtkhdf/vtkhdf_tables.hpp"

namespace percuss {

class VtkhdfFile {
 public:
  /// Creates the file with the mesh and no frame. Collective, as all below. Throws SystemError; no file is left then.
  VtkhdfFile(const std::string& path, const ChunkedMesh& chunked, const FieldsOptions& options,
             const Communicator& ranks);
  /// Continues with a file that has so many frames and nothing else (cut_earlier_results()).
  VtkhdfFile(const std::string& path, const ChunkedMesh& chunked, const FieldsOptions& options,
             const Communicator& ranks, std::int64_t frames);
  VtkhdfFile(const VtkhdfFile&) = delete;
  VtkhdfFile& operator=(const VtkhdfFile&) = delete;

  /// Appends a frame (local rows): room is reserved, data are written, flushed, read back and compared, then the number
  /// of steps is written, which is what shows the frame to readers. The first frame creates the fields. Throws
  /// SystemError; the file then keeps the frames before and takes no more.
  void append_frame(double time, std::int64_t step, std::span<const double> positions,
                    std::span<const FieldData> fields, std::span<const double> wall_displacements);

  /// Waits until the disk has the frames written so far, and looks whether all are there. Throws SystemError.
  void sync() { file_.sync(); }

  /// Waits for the disk, closes and looks whether all frames are there. Throws SystemError.
  void close() { file_.close(); }

  /// Whether the path still leads to this file, as rank 0 sees it.
  bool is_in_place() const { return file_.is_in_place(); }

 private:
  struct Unopened {};
  VtkhdfFile(Unopened, const std::string& path, const ChunkedMesh& chunked, const FieldsOptions& options,
             const Communicator& ranks);

  void write_cells(const Mesh& mesh);
  void write_mesh(const Mesh& mesh);
  void write_scene(const Mesh& mesh);
  void write_walls();
  hdf5::RowBlock make_block(FieldPlace place, int rows = 1);
  void write_numbers(const hdf5::Handle& group, const std::string& name, const hdf5::RowBlock& block,
                     std::span<const std::int64_t> values);
  void write_items(const std::string& name, FieldPlace place, std::span<const std::int64_t> values);
  void append_items(hdf5::Table& table, FieldPlace place, std::span<const double> values, int components,
                    FieldNumber number = FieldNumber::real);
  template <class T>
  void append_one(hdf5::Table& table, T value);
  void append_rows(double time, std::int64_t step, std::span<const double> positions,
                   std::span<const FieldData> fields);
  hsize_t frame_bytes() const;

  Communicator ranks_;
  FieldsOptions options_;
  hsize_t nodes_, elements_;  // of the whole mesh
  RowBlocks node_rows_, element_rows_;
  hdf5::DurableFile file_;
  VtkhdfTables tables_;
};

}  // namespace percuss
