#pragma once
// Files that a mesh file includes: in its folder or below, since a mesh could read any file of the user's otherwise.

#include <cstddef>
#include <string>
#include <string_view>

#include "src/mesh/files/text_source.hpp"

namespace percuss {

/// Files that may be open at once, and that may be included at all.
inline constexpr std::size_t most_open_files = 20, most_included_files = 10000;

/// The folder of a file, which limits what it may include.
std::string find_folder(const std::string& path);

/// Path of the file of this name. Throws InputError at the place if it lies elsewhere or does not exist.
std::string find_included_file(const std::string& folder, std::string_view name, const TextNames& names,
                               TextPlace place);

}  // namespace percuss
