#pragma once
// Stiffness of contact faces for the springs of contact, from the element behind each.

#include <vector>

#include "src/mesh/mesh.hpp"

namespace percuss {

/// M A^2 / V of each face [force/length]: M = lambda + 2 mu resists a push on one face of an element whose sides are
/// held, as those of its neighbours hold it; A area of the face, V volume of its element, all at time 0. Of a shell K t
/// (bulk modulus, thickness), in proportion to its mass: about as stiff as its membrane and no stiffer, so that a
/// bounce takes some steps. Only penalty has springs at solids that deform; 0: no spring. faces: of this rank's
/// elements.
std::vector<double> find_face_springs(const Mesh& mesh, const Deck& deck, const std::vector<ElementFace>& faces);

}  // namespace percuss
