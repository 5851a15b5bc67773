#pragma once
// Code of users: shared libraries with a VUMAT, a VUHARD, a VUSDFLD beside one of these, or a law. A library runs with
// all rights of the program, so none is loaded that the command line has not named.

#include <string>
#include <vector>

#include "kernels/material/material_key.hpp"

namespace percuss {

/// Permits these files, and no others, to be loaded from now on.
void permit_user_code(const std::vector<std::string>& files);

/// Whether the file is one of those that are permitted, by whatever path.
bool is_user_code_permitted(const std::string& file);

/// A library, and the flag of whether its code was found to write outside its arrays.
struct LoadedLibrary {
  void* handle = nullptr;
  int* has_written_outside = nullptr;
  const char* file = "";  // as decks name it
};

/// Loads a library once; it stays. Throws InputError if it is not permitted or cannot be loaded.
LoadedLibrary load_library(const std::string& file);

/// Throws InputError: this library is no law.
[[noreturn]] void refuse_library(const std::string& file, const std::string& why, const std::string& remedy);

/// A subroutine of a library by its name in small letters; null: it has none. Throws InputError as load_library() does.
void* find_user_entry(const std::string& file, const std::string& subroutine);

/// A subroutine of a library, "vumat" or "vuhard". Throws InputError as load_library() does, and if there is none.
UserCode load_user_code(const std::string& file, const std::string& subroutine);

/// Gives the code times at which steps of its analysis begin, which stay. Throws InputError if they do not rise from 0.
void set_step_starts(const std::vector<double>& starts, UserCode& code);

/// Whether a law of this library was found to write outside its arrays.
bool has_written_outside(const std::string& file);

}  // namespace percuss
