#pragma once
// Results that a mesh file has of its elements and nodes, of the formats that have some: Exodus II and VTK.

#include <string>

#include "src/mesh/files/file_results.hpp"

namespace percuss {

/// Whether the first bytes of a file, or its extension, are those of such a format. Throws SystemError, and InputError
/// for what is no regular file.
bool has_results_format(const std::string& path);

/// Exodus II is read in a process of its own first. Throws InputError, with the file's name, if the file is damaged,
/// has no such time, or names a time without having any; SystemError.
FileResults read_file_results(const std::string& path, const ResultsWish& wish);

/// Results in a mesh file; none of other formats. Exodus II is read at once: call in a process of its own first. Throws
/// InputError if the results are damaged; SystemError.
ResultsContents read_results_contents(const std::string& path);

}  // namespace percuss
