#include "src/step/elements/element_mass.hpp"

#include "kernels/element/hex8/modes.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/fluids/hydrostatic.hpp"

namespace percuss {
namespace {

/// Volume by the modes of the element's kernel.
double find_kernel_volume(const Mesh& mesh, std::size_t element) {
  if (mesh.topology_of(element).family != ElementFamily::hexahedra) return find_element_volume(mesh, element);
  const ElementCorners corners = gather_corners(mesh.elements, element, mesh.nodes);
  double x[8], y[8], z[8];
  for (std::size_t i = 0; i < 8; ++i) {
    x[i] = corners[i][0];
    y[i] = corners[i][1];
    z[i] = corners[i][2];
  }
  to_modes(x);
  to_modes(y);
  to_modes(z);
  VectorModes<double> a{};
  for (int m = 1; m < 8; ++m) a[m] = {x[m], y[m], z[m]};
  return find_volume_gradient(a).volume;
}

}  // namespace

double find_element_mass(const Deck& deck, const Mesh& mesh, std::size_t element) {
  const auto material = static_cast<std::size_t>(mesh.block_of(element).material);
  const double mass = deck.materials[material].density * find_kernel_volume(mesh, element);
  const auto pressed = find_hydrostatic_state(deck, mesh, element);
  return pressed ? mass / pressed->j : mass;
}

}  // namespace percuss
