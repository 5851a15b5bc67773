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

#include "src/output/fields/fields_file.hpp"
#include "src/output/later_states.hpp"

namespace percuss {

/// All calls are collective and throw as those of FieldsFile.
class ExodusResults {
 public:
  /// Creates DIR/fields.exo, or fields_NAME.exo, with the mesh; an old one is replaced.
  ExodusResults(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
                const Communicator& ranks);
  /// Continues with the file of an earlier run behind its first `frames`; what lies there is cut off.
  ExodusResults(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
                const Communicator& ranks, std::int64_t frames, std::span<const std::string> fields);
  static void check(const EarlierFrames& earlier, const ChunkedMesh& chunked, const Communicator& ranks);
  ~ExodusResults();
  ExodusResults(ExodusResults&&) noexcept;
  ExodusResults& operator=(ExodusResults&&) noexcept;

  /// Appends a frame, as FieldsFile::write_frame().
  void write_frame(double time, long step, std::span<const double> positions, std::span<const FieldData> fields);
  void sync();
  void close();
  bool is_in_place() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace percuss
