#pragma once
// A file of results of an earlier run, before a restart continues it: it is checked, what lies behind the checkpoint is
// listed, and cut off. What the formats have in common; earlier_formats.hpp has what differs.
//
// By one process, while no other has the file open for writing.

#include <span>
#include <string>
#include <vector>

#include "src/mesh/ordering.hpp"
#include "src/output/frame/frame_layout.hpp"
#include "src/output/later_states.hpp"

namespace percuss {

/// Counts that a file of this mesh must have so that a run continues behind its first `frames`.
FramesInFile find_kept(const ChunkedMesh& chunked, std::int64_t frames);

/// Looks at the file and changes nothing. fields: names of the fields that every frame will have. Returns the times of
/// the frames that are kept. Throws InputError if the file is not there or does not fit, SystemError if it cannot be
/// read.
std::vector<double> check_earlier_results(const FrameLayout& format, const std::string& path, const FramesInFile& kept,
                                          std::span<const std::string> fields);

/// The complete frames behind the first `frames`. None of a file that is not there or that cannot be read.
LaterStates find_later_frames(const FrameLayout& format, const std::string& path, std::int64_t frames);

/// Cuts off the frames that are not kept; does nothing if there are none. Throws SystemError.
void cut_earlier_results(const FrameLayout& format, const std::string& path, const FramesInFile& kept);

}  // namespace percuss
