#pragma once
// Stiffness of contact faces for penalty enforcement, from the element behind each.

#include <vector>

#include "src/mesh/mesh.hpp"

namespace percuss {

/// K A^2 / V of each face [force/length]: K bulk modulus, A area of the face, V volume of its element, all at time 0.
/// Zeros unless contact.enforcement is penalty. faces: of this rank's elements.
std::vector<double> find_face_springs(const Mesh& mesh, const Deck& deck, const std::vector<ElementFace>& faces);

}  // namespace percuss
