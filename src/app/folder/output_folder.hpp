#pragma once
// Where the files of a run go; nothing that a user has computed is lost unasked.

#include <string>

namespace percuss {

/// The folder of a run without --out: out/SCENE, where SCENE is the deck's name without extension, or the name of its
/// folder if the deck is called deck.yaml.
std::string default_output_folder(const std::string& deck_file);

/// The checkpoint that --restart names: a file, or a folder of results with the newest one in it.
std::string find_checkpoint(const std::string& file_or_folder);

/// The folder that a checkpoint lies in.
std::string find_restart_folder(const std::string& checkpoint);

/// Whether a checkpoint lies in a folder that is there: itself or, where it is a symbolic link, the file behind that.
bool lies_in_folder(const std::string& checkpoint, const std::string& folder);

/// Throws SystemError if it is not.
void check_folder_is_writable(const std::string& folder);

/// Makes the folder if it is not there. Throws InputError if its name is that of a file, SystemError if it cannot be
/// made or written to.
void make_output_folder(const std::string& folder);

/// Throws InputError if anything but the lock of a run is in the folder, SystemError if it cannot be read.
void check_folder_is_empty(const std::string& folder);

/// Throws InputError if remove_results() would remove a file that the run needs, by whatever name. what: it is.
void refuse_to_remove(const std::string& path, const std::string& what, const std::string& folder);

/// Removes the files that an earlier run wrote, with those that it was about to replace when it was killed. Others
/// stay. Throws SystemError.
void remove_results(const std::string& folder);

}  // namespace percuss
