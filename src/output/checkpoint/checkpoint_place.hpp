#pragma once
// The names under which checkpoints lie in a folder: checkpoint.h5, the one before, and what is being written.

#include <string>

namespace percuss {

/// The checkpoint before the one at `path`: checkpoint_previous.h5.
std::string find_previous_checkpoint(const std::string& path);

/// Removes what a run that was killed while it wrote the checkpoint at `path` may have left beside it. By one process.
void remove_unfinished_checkpoint(const std::string& path);

/// Puts a whole file in the place of the checkpoint at `path`, which becomes the one before, and waits until the disk
/// has the names. known_whole: the checkpoint that the run wrote last or continued from; empty: the one at `path`. If
/// that is another one, the file at `path` becomes the one before only if its seal fits, and never in the place of
/// `known_whole`. By one process. Throws SystemError.
void replace_checkpoint(const std::string& temporary, const std::string& path, const std::string& known_whole);

}  // namespace percuss
