#pragma once
// What a text file has that is no mesh, in a note.

#include <set>
#include <string>
#include <string_view>

namespace percuss {

/// "*MATERIAL, *STEP and 3 more of the file are not read (the mesh alone is)"; mark: what stands before each word.
std::string describe_unread(const std::set<std::string>& words, std::string_view mark);

}  // namespace percuss
