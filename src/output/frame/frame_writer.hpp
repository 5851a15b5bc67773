#pragma once
// What writes the frames of one output in one format. frame_formats.hpp lists the formats.

#include <span>

#include "comm/communicator.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/frame/frame_fields.hpp"

namespace percuss {

/// All calls, the destructor included, are collective over the ranks that the writer was made with. An error is a
/// SystemError with the path and the reason, on all ranks alike.
class FrameWriter {
 public:
  FrameWriter() = default;
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;
  /// Closes the file if close() was not called; an error is lost then.
  virtual ~FrameWriter() = default;

  /// Appends a frame and flushes it: it survives the end of the process, even kill -9, from then on.
  /// positions: [local nodes][3] [length] at `time`. Every frame must give the same fields in the same order
  /// (std::logic_error otherwise); names are unique and have neither '/' nor quotes. "displacement" (positions less
  /// those of the mesh) is added unless it is given. After an error (disk full) the frames before stay readable, and
  /// the file takes no more. With several ranks a write that fails although there was room ends the program at once
  /// (exit code 4).
  /// wall_displacements: of FieldsOptions::moving_walls along their normals, then of moving_round_walls along their
  /// directions.
  virtual void write_frame(double time, long step, std::span<const double> positions, std::span<const FieldData> fields,
                           std::span<const double> wall_displacements = {}) = 0;

  /// Waits until the disk has the frames written so far.
  virtual void sync() = 0;

  /// Waits until the disk has all, closes the file and looks whether all frames are in it.
  virtual void close() = 0;

  /// Whether the file still has its name, as rank 0 sees it: not if somebody removed or replaced it.
  virtual bool is_in_place() const = 0;
};

/// Where a writer writes and what of: this rank's share of the mesh.
struct FrameTarget {
  const std::string& directory;
  const ChunkedMesh& chunked;
  const FieldsOptions& options;
  const Communicator& ranks;
};

}  // namespace percuss
