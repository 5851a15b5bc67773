#pragma once
// Names of the files of fields in the folder of a run: those of output.fields, and of each entry of
// output.field_outputs.

#include <string>
#include <vector>

namespace percuss {

/// Whether a run may have written a file of this name: fields.vtkhdf, fields_rim.xdmf2 ...
bool is_fields_file(const std::string& name);

/// Names of those in a folder, those of output.fields first, then ascending. None of one that cannot be read.
/// behind: what stands behind each in the folder, as ".tmp" of those that a run had not finished.
std::vector<std::string> list_fields_files(const std::string& folder, const std::string& behind = "");

/// Whether the file holds frames itself: no index of them.
bool holds_frames(const std::string& name);

/// Names of all files of an output, whatever its formats.
std::vector<std::string> name_fields_files(const std::string& output);

}  // namespace percuss
