#include "src/step/assembly/check_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comm/all_reduce.hpp"
#include "comm/communicator.hpp"
#include "src/error.hpp"
#include "src/step/elements/block_builder.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// A number of an element that floats hold squared, with what the element multiplies it by.
struct Held {
  const char* name;
  double low, high;
};
constexpr Held held[] = {{"volumes", 1e-15, 1e15},
                         {"products of mass and volume", 1e-33, 1e33},
                         {"products of lambda + 2 mu and volume", 1e-16, 1e16}};
constexpr std::size_t count = std::size(held);

/// Refuses shells and beams too thin for the precision.
void refuse_thin_elements(const Deck& deck, const Mesh& mesh) {
  for (const ElementBlock& block : mesh.elements.blocks) {
    const Topology& topology = find_topology(block.topology);
    if (topology.is_solid()) continue;
    const auto p = static_cast<std::size_t>(block.part);
    throw InputError(
        fmt::format("{}: error: part '{}' is of {}s (this build is in single precision, but {}s need double): use a "
                    "build with PERCUSS_PRECISION=double",
                    deck.where(deck.parts[p].place), deck.parts[p].name, topology.noun, topology.noun));
  }
}

double find_stiffness(const MaterialDeck& material) {
  return std::visit(
      [](const auto& kernel) {
        const LameConstants c = kernel.moduli();
        return std::max(c.lambda, 0.0) + 2 * c.mu;
      },
      make_kernel_material(material).material);
}

}  // namespace

void check_single_precision(const Deck& deck, const ChunkedMesh& chunked, const std::vector<double>& masses) {
  const Mesh& mesh = chunked.mesh;
  refuse_thin_elements(deck, mesh);
  std::vector<double> stiffness;
  for (const MaterialDeck& material : deck.materials) stiffness.push_back(find_stiffness(material));
  std::array<double, 2 * count> extremes;  // largest of each and of its reciprocal
  extremes.fill(0);
  for (std::size_t e = 0; e < masses.size(); ++e) {
    const auto material = static_cast<std::size_t>(mesh.block_of(e).material);
    const double volume = masses[e] / deck.materials[material].density;
    const double values[count] = {volume, masses[e] * volume,
                                  stiffness[material] > 0 ? stiffness[material] * volume : 1};  // skins have none
    for (std::size_t k = 0; k < count; ++k) {
      extremes[2 * k] = std::max(extremes[2 * k], values[k]);
      extremes[2 * k + 1] = std::max(extremes[2 * k + 1], 1 / values[k]);
    }
  }
  all_reduce(find_ranks(mesh), Reduce::largest, extremes);
  for (std::size_t k = 0; k < count; ++k) {
    if (extremes[2 * k] <= held[k].high && extremes[2 * k + 1] <= 1 / held[k].low) continue;
    throw InputError(
        fmt::format("{}: error: {} of elements range from {:g} to {:g} (single precision allows {:g} to {:g}): choose "
                    "units in which they are nearer to 1, or use a build with PERCUSS_PRECISION=double",
                    deck.file, held[k].name, 1 / extremes[2 * k + 1], extremes[2 * k], held[k].low, held[k].high));
  }
}

}  // namespace percuss
