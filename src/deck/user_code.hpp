#pragma once
// Code of users: shared libraries with the VUMAT interface. A library runs with all rights of the program, so none is
// loaded that the command line has not named.

#include <string>
#include <vector>

#include "kernels/material/material_key.hpp"

namespace percuss {

/// From now on load_user_code() loads these files, and no others.
void permit_user_code(const std::vector<std::string>& files);

/// Whether the file is one of those that are permitted, by whatever path.
bool is_user_code_permitted(const std::string& file);

/// The entry of the library, which is loaded once and stays. Throws InputError if it is not permitted, cannot be loaded
/// or has no VUMAT.
UserCode load_user_code(const std::string& file);

/// Whether a law of this library was found to write outside its arrays.
bool has_written_outside(const std::string& file);

}  // namespace percuss
