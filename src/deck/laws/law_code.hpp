#pragma once
// Laws of libraries that `percuss build-law` has made (kernels/material/user/law_library.hpp).

#include "kernels/material/material_key.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// Name by which a LawDeck has the constant of a library, in the map of its kind.
inline std::string name_library_constant(const std::string& constant) { return "constants." + constant; }

/// The law of a material's library with its constants; one that was made before for the same constants. Throws
/// InputError as load_library() does, and if the library is of another program, or the constants are not those that its
/// law takes.
MadeLaw make_law_of_library(const LawDeck& law, const std::string& file);

}  // namespace percuss
