#pragma once
// Whether the file of a shared library is whole: the loader of the system ends the program where it is cut off.

#include <string>

namespace percuss {

/// Fault of the file; empty: it is whole, or no shared library of this machine, which the loader finds out.
std::string find_library_fault(const std::string& file);

}  // namespace percuss
