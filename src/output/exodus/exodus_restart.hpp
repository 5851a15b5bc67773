#pragma once
// A fields.exo of an earlier run, before a restart continues it.

#include <span>
#include <string>

#include "src/output/fields/fields_restart.hpp"

namespace percuss {

/// As check_fields_file(), find_later_frames() and cut_fields_file().
void check_exodus_results(const std::string& path, const EarlierFrames& kept, std::span<const std::string> fields);
LaterStates find_later_exodus_frames(const std::string& path, std::int64_t frames);
void cut_exodus_results(const std::string& path, const EarlierFrames& kept);

/// Frames that a file shows to readers. Throws hdf5::Error.
std::int64_t count_exodus_frames(hid_t file);

}  // namespace percuss
