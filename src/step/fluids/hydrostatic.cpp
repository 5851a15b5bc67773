#include "src/step/fluids/hydrostatic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comm/all_reduce.hpp"
#include "kernels/element/hex8/centroid.hpp"
#include "src/deck/laws/fluid_at_rest.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// Mean of the volume of the trilinear hexahedron: exact with 2x2x2 points.
Vec3 find_centroid(const ElementCorners& x) {
  double modes[3][8];
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 8; ++i) modes[k][i] = x[i][k];
    to_modes(modes[k]);
  }
  VectorModes<double> a;
  for (int m = 1; m < 8; ++m) a[m] = {modes[0][m], modes[1][m], modes[2][m]};
  Vec3 moment{};
  double volume = 0;
  for (int p = 0; p < 8; ++p) {
    const auto [xi, eta, zeta] = find_gauss_point(p);
    const double phi[8] = {1, xi, eta, zeta, eta * zeta, zeta * xi, xi * eta, xi * eta * zeta};
    const double share = find_point_geometry(a, find_gauss_point(p)).volume;
    for (std::size_t k = 0; k < 3; ++k)
      for (int m = 1; m < 8; ++m) moment[k] += share * phi[m] * modes[k][m];
    volume += share;
  }
  Vec3 centroid;
  for (std::size_t k = 0; k < 3; ++k) centroid[k] = (modes[k][0] + moment[k] / volume) / 8;
  return centroid;
}

/// Wedges and pyramids are hexahedra of which corners coincide; of a tetrahedron it is the mean of the corners.
Vec3 find_centroid(const Mesh& mesh, std::size_t element) {
  const auto nodes = mesh.corners(element);
  Vec3 mean{};
  for (const int n : nodes)
    for (std::size_t k = 0; k < 3; ++k) mean[k] += mesh.nodes[at(n)][k] / static_cast<double>(nodes.size());
  const ElementFamily family = mesh.topology_of(element).family;
  if (family == ElementFamily::tetrahedra) return mean;
  const Collapsed shape = find_collapsed(family);
  ElementCorners corners;
  for (std::size_t i = 0; i < 8; ++i) corners[i] = mesh.nodes[at(nodes[at(shape.corner[i])])];
  return find_centroid(corners);
}

/// Depth below the surface of a fluid.
class Depth {
 public:
  Depth(const Deck& deck, const HydrostaticDeck& fluid) : surface_(fluid.surface), along_(deck.gravity.at(0)) {
    gravity_ = std::sqrt(dot(along_, along_));
    for (double& along : along_) along /= gravity_;
  }

  double operator()(const Vec3& x) const { return dot(along_, subtract(x, surface_)); }
  double gravity() const { return gravity_; }

 private:
  Vec3 surface_, along_;
  double gravity_;
};

const MaterialDeck& find_material(const Deck& deck, const Mesh& mesh, const std::string& part) {
  const std::vector<ElementBlock>& blocks = mesh.elements.blocks;  // all ranks know them all
  const auto block =
      std::find_if(blocks.begin(), blocks.end(), [&](const auto& of) { return deck.parts[at(of.part)].name == part; });
  return deck.materials[at(block->material)];
}

}  // namespace

std::optional<PressedFluid> find_hydrostatic_state(const Deck& deck, const Mesh& mesh, std::size_t element) {
  if (deck.start.hydrostatic.empty()) return std::nullopt;
  const ElementBlock& block = mesh.block_of(element);
  const HydrostaticDeck* const fluid = deck.start.find_hydrostatic(deck.parts[at(block.part)].name);
  if (fluid == nullptr) return std::nullopt;
  const Depth depth(deck, *fluid);
  const MaterialDeck& material = deck.materials[at(block.material)];
  return find_fluid_at_rest(material, fluid->pressure,
                            material.density * depth.gravity() * depth(find_centroid(mesh, element)));
}

void check_surfaces(const Deck& deck, const Mesh& mesh) {
  constexpr double tolerance = 1e-6;  // of the depth of a part
  for (const HydrostaticDeck& fluid : deck.start.hydrostatic) {
    const Depth depth(deck, fluid);
    for (const std::string& part : fluid.parts) {
      std::array<double, 2> ends{-HUGE_VAL, -HUGE_VAL};  // height of the highest node over the surface, depth
      for (const int n : mesh.node_sets.at(part)) {
        const double here = depth(mesh.nodes[at(n)]);
        ends = {std::max(ends[0], -here), std::max(ends[1], here)};
      }
      all_reduce(find_ranks(mesh), Reduce::largest, ends);
      if (ends[0] > tolerance * (ends[0] + ends[1]))
        throw InputError(
            fmt::format("{}: error: part '{}' rises {:.6g} above the surface of its fluid (which has no pressure "
                        "there): give the point of start.hydrostatic.surface at the top of the part or above",
                        deck.where(fluid.place), part, ends[0]));
      const MaterialDeck& material = find_material(deck, mesh, part);
      if (!can_rest(material, fluid.pressure, material.density * depth.gravity() * ends[1]))
        throw InputError(fmt::format(
            "{}: error: part '{}' cannot rest at {:.6g} below the surface of its fluid (the equation of state of "
            "material '{}' does not carry the weight above without heat, or only below a fifth of its volume): check "
            "its constants, the density and gravity",
            deck.where(fluid.place), part, ends[1], material.name));
    }
  }
}

}  // namespace percuss
