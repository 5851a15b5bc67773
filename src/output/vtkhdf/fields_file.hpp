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

#include "src/output/frame/frame_writer.hpp"

namespace percuss {

class FieldsFile final : public FrameWriter {
 public:
  /// Creates DIR/fields.vtkhdf, DIR/fields.xdmf and DIR/fields.xdmf2. With a name in the options they are
  /// fields_NAME.vtkhdf and so on.
  FieldsFile(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
             const Communicator& ranks);
  /// Continues with the files of an earlier run behind their first `frames`.
  FieldsFile(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
             const Communicator& ranks, std::int64_t frames, std::span<const std::string> fields);
  ~FieldsFile() override;

  void write_frame(double time, long step, std::span<const double> positions, std::span<const FieldData> fields,
                   std::span<const double> wall_displacements = {}) override;
  void sync() override;
  void close() override;
  bool is_in_place() const override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace percuss
