#pragma once
// Text files that are either the old or the new one, never half of one: written beside the target, then renamed.

#include <string>
#include <string_view>

#include "src/error.hpp"

namespace percuss {

/// Whether a write waits until the disk holds it (survives a power cut) or only until the system has it (survives the
/// end of this process).
enum class Durability { system, disk };

/// Replaces the file at `path` by `text` in one step: a reader, and whoever looks after a crash, finds the old text or
/// the new one whole. Throws SystemError with path and reason; the old file then stays as it was.
void write_file_atomically(const std::string& path, std::string_view text, Durability durability);

/// Waits until the disk holds the names in the folder of a file: a rename is there only then. Throws SystemError.
void sync_folder_of(const std::string& path);

/// "cannot ACTION 'PATH' (REASON): SUGGESTION" for an errno of the system.
SystemError make_io_error(std::string_view action, const std::string& path, int error_number);

/// Remedy for an errno (": free some space, ..."); empty if nothing is known.
std::string suggest_for_errno(int error_number);

}  // namespace percuss
