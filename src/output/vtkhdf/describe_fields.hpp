#pragma once
// What a fields.vtkhdf holds, in words, for `percuss info`.

#include <string>

namespace percuss {

/// Several lines: sizes of mesh and file, parts, frames with their times, and every field with its range in the last
/// frame. Throws InputError if the file is not a fields file of percuss (anything else, cut short, damaged),
/// SystemError if it cannot be read.
std::string describe_fields_file(const std::string& path);

}  // namespace percuss
