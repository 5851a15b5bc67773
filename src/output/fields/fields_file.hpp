#pragma once
// fields.vtkhdf: the fields of a run over time, one HDF5 file in VTK's UnstructuredGrid layout (version 2, temporal),
// and two indexes in XDMF beside it over the same datasets. docs/output.md lists every dataset.
//
// The cells are stored once, the positions of the nodes at every frame. Displacement is always among the fields. All
// ranks write the file together; it is the same whatever their number, nodes and elements in ascending global number.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/frame/frame_fields.hpp"

namespace percuss {

class FieldsFile {
 public:
  /// Creates DIR/fields.vtkhdf, DIR/fields.xdmf and DIR/fields.xdmf2 (old ones are replaced) with the mesh: cells, ids,
  /// part numbers. With a name in the options they are fields_NAME.vtkhdf and so on.
  /// `chunked` is this rank's share of the mesh. Collective over `ranks`, as everything below, the destructor included.
  /// Throws SystemError with the path and the reason, on all ranks alike.
  FieldsFile(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
             const Communicator& ranks);
  /// Continues with the files of an earlier run behind their first `frames`; what lies there is cut off. Throws what
  /// check() throws, which is asked first.
  FieldsFile(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
             const Communicator& ranks, std::int64_t frames, std::span<const std::string> fields);

  /// Throws InputError, on all ranks, if the folder's fields file has not this mesh, so many frames and the fields of
  /// these names; changes nothing.
  static void check(const EarlierFrames& earlier, const ChunkedMesh& chunked, const Communicator& ranks);

  /// Closes the file if close() was not called; an error is lost then.
  ~FieldsFile();
  FieldsFile(FieldsFile&&) noexcept;
  FieldsFile& operator=(FieldsFile&&) noexcept;

  /// Appends a frame and flushes it: it survives the end of the process, even kill -9, from then on.
  /// positions: [local nodes][3] [length] at `time`. Every frame must give the same fields in the same order
  /// (std::logic_error otherwise); names are unique and have neither '/' nor quotes. "displacement" (positions less
  /// those of the mesh) is added unless it is given. Throws SystemError (disk full) on all ranks alike; the frames
  /// before then stay readable, and the file takes no more. With several ranks a write that fails although there was
  /// room ends the program at once (exit code 4).
  /// wall_displacements: of FieldsOptions::moving_walls along their normals, then of moving_round_walls along their
  /// directions.
  void write_frame(double time, long step, std::span<const double> positions, std::span<const FieldData> fields,
                   std::span<const double> wall_displacements = {});

  /// Waits until the disk has the frames written so far. Throws SystemError.
  void sync();

  /// Waits until the disk has all, closes the file and looks whether all frames are in it; errors are thrown here
  /// rather than lost in the destructor.
  void close();

  /// Whether the file still has its name, as rank 0 sees it: not if somebody removed or replaced it.
  bool is_in_place() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace percuss
