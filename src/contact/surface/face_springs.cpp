#include "src/contact/surface/face_springs.hpp"

#include <array>
#include <cmath>

#include "src/deck/contact_springs.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// M, or K of a shell.
double find_modulus(const MaterialDeck& material, bool is_of_shell) {
  const LameConstants moduli = find_moduli(material);
  return moduli.lambda + (is_of_shell ? 2.0 / 3.0 : 2.0) * moduli.mu;
}

/// Area of a quadrilateral from its diagonals; of a warped one, of its projection along their normal.
double find_area(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 normal = cross(subtract(c, a), subtract(d, b));
  return 0.5 * std::sqrt(dot(normal, normal));
}

}  // namespace

std::vector<double> find_face_springs(const Mesh& mesh, const Deck& deck, const std::vector<ElementFace>& faces) {
  std::vector<double> springs(faces.size(), 0);
  if (!may_have_contact_springs(deck)) return springs;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto element = static_cast<std::size_t>(faces[f].element);
    const std::array<int, 4> nodes = mesh.elements.face_nodes(faces[f]);
    const auto corner = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(nodes[i])]; };
    const double area = find_area(corner(0), corner(1), corner(2), corner(3));
    const ElementBlock& block = mesh.block_of(element);
    const bool of_shell = mesh.topology_of(element).is_surface();
    const bool is_rigid = deck.parts[static_cast<std::size_t>(block.part)].rigid.has_value();
    // A rigid sheet gives way as a cube of its face would, however thin it is.
    const double length = !of_shell  ? area * area / find_element_volume(mesh, element)
                          : is_rigid ? std::sqrt(area)
                                     : mesh.thickness_of(element);
    springs[f] = find_modulus(deck.materials[static_cast<std::size_t>(block.material)], of_shell) * length;
  }
  return springs;
}

}  // namespace percuss
