#pragma once
// fields.exo: the fields of a run over time as Exodus II, in netCDF-4. docs/output.md describes it.
//
// Positions are those of time 0; the displacement is always among the variables. A field is a variable a component. All
// ranks write the file together; it is the same whatever their number.
//
// The number of time steps of netCDF is the largest number of rows that a variable over the dimension time_step has.
// The values of nodes and elements therefore stand over another dimension, frame_rows, and time_whole alone over
// time_step: it grows last, when all values of a frame are in the file.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "src/output/frame/frame_writer.hpp"

namespace percuss {

class ExodusResults final : public FrameWriter {
 public:
  /// Creates DIR/fields.exo, or fields_NAME.exo.
  ExodusResults(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
                const Communicator& ranks);
  /// Continues with the file of an earlier run behind its first `frames`.
  ExodusResults(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
                const Communicator& ranks, std::int64_t frames, std::span<const std::string> fields);
  ~ExodusResults() override;

  /// The displacements of walls have no place in the format.
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
