#pragma once
// How the formats of result files keep their frames, for who continues a file.

#include <cstdint>
#include <set>
#include <span>
#include <string>

#include "src/hdf5/hdf5_handle.hpp"

namespace percuss {

/// Counts that a file has, or must have.
struct FramesInFile {
  hsize_t frames = 0;
  hsize_t nodes = 0, elements = 0;  // of the mesh
};

/// Begin of the names of the files of an output of fields: "fields", of one with a name "fields_NAME".
inline std::string name_fields(const std::string& output) { return output.empty() ? "fields" : "fields_" + output; }

/// file: an open HDF5 file. All functions throw hdf5::Error.
struct FrameLayout {
  const char* ending;  // of the file's name

  /// The file of an output of fields in the folder of a run.
  std::string name_file(const std::string& output) const { return name_fields(output) + ending; }

  /// Paths of datasets with a number a frame.
  const char *times, *steps;

  /// Frames that a reader finds.
  std::int64_t (*count_frames)(hid_t file);
  /// The mesh; frames are not counted.
  FramesInFile (*find_mesh)(hid_t file);

  /// The fields in the file, and "?" for what belongs to none of `fields`.
  std::set<std::string> (*list_fields)(hid_t file, std::span<const std::string> fields);

  /// Cuts off all frames behind the first. The file is flushed in between: a kill must leave no frame that a reader
  /// counts but finds cut, and filled with zeros.
  void (*cut)(hid_t file, const FramesInFile& kept);
};

extern const FrameLayout vtkhdf_frames, exodus_frames;

}  // namespace percuss
