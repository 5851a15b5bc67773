#pragma once
// A fields file of an earlier run, before a restart continues it.

#include <span>
#include <string>
#include <vector>

#include "src/hdf5/hdf5_handle.hpp"
#include "src/output/later_states.hpp"

namespace percuss {

/// What a fields file must hold so that a run can continue with it.
struct EarlierFrames {
  hsize_t frames = 0;               // that are kept
  hsize_t nodes = 0, elements = 0;  // of the mesh
};

/// Looks at the file and changes nothing. fields: names of the fields that every frame will have. Returns the times of
/// the frames that are kept. Throws InputError if the file is not there or does not fit, SystemError if it cannot be
/// read. By one process.
std::vector<double> check_fields_file(const std::string& path, const EarlierFrames& kept,
                                      std::span<const std::string> fields);

/// The complete frames of a fields file behind the first `frames`. None of a file that is not there or that cannot be
/// read. By one process.
LaterStates find_later_frames(const std::string& path, std::int64_t frames);

/// Cuts off the frames that are not kept; does nothing if there are none. Throws SystemError. By one process, while
/// no other has the file open for writing.
void cut_fields_file(const std::string& path, const EarlierFrames& kept);

}  // namespace percuss
