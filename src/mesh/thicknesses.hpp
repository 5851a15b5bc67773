#pragma once
// Thickness of each shell, where a part says that they differ: an expression of the place, or what its file has.

#include "comm/communicator.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// Turns what files give (Elements::own_thickness, 0: nothing) into the thickness of every shell, if some part of the
/// deck varies in thickness; otherwise forgets it. An expression is taken at the mean of the corners at time 0, before
/// imperfections. Blocks get the largest of theirs. Adds a line for each such part to Mesh::notes. Collective. Throws
/// InputError, the same on all ranks, where a thickness is missing, not positive or not finite.
void set_thicknesses(const Deck& deck, const Communicator& ranks, Mesh& mesh);

}  // namespace percuss
