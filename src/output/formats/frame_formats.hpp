#pragma once
// The formats in which frames of fields are written. A new format is a FrameWriter, a FrameLayout, its word in
// fields_formats (src/deck/output_deck.hpp) and a row of the list here; names of files, restarts, `info` and what
// --force removes follow.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "src/deck/output_deck.hpp"
#include "src/output/frame/earlier_results.hpp"
#include "src/output/frame/frame_writer.hpp"

namespace percuss {

struct FrameFormat {
  FieldsFormat format;                  // in the deck
  const FrameLayout& layout;            // of the file that holds the frames
  std::vector<const char*> index_ends;  // endings of the names of files beside it, which hold none
  bool wants_sets;                      // FieldsOptions::node_sets and side_sets; otherwise they are not gathered

  /// Creates the files with the mesh: cells, ids, parts. Old ones are replaced. Throws SystemError.
  std::unique_ptr<FrameWriter> (*create)(const FrameTarget& target);
  /// Continues with the files of an earlier run behind their first `frames`; what lies there is cut off. Throws what
  /// check_earlier_frames() throws, which is asked first, and SystemError.
  std::unique_ptr<FrameWriter> (*resume)(const FrameTarget& target, std::int64_t frames,
                                         std::span<const std::string> fields);

  /// Endings of all its files, that which holds the frames first.
  std::vector<std::string> list_endings() const;
};

/// Formats in the order of FieldsFormat.
const std::vector<FrameFormat>& frame_formats();

/// Formats of an output.
std::vector<const FrameFormat*> list_formats(const FieldsDeck& fields);

/// Throws InputError, on all ranks, if a file of the folder has not this mesh, so many frames and the fields of these
/// names; changes nothing. Collective.
void check_earlier_frames(const FrameFormat& format, const EarlierFrames& earlier, const ChunkedMesh& chunked,
                          const Communicator& ranks);

}  // namespace percuss
