#include "src/step/elements/thick_corners.hpp"

#include <fmt/format.h>

#include "src/error.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

using Nodes = std::array<int, kernel_corner_count>;

/// Corners of a hexahedron turned about its diagonal from corner 1 to 7: its first, second or third direction becomes
/// the third.
constexpr std::array<std::array<std::size_t, kernel_corner_count>, 3> turned{
    {{0, 3, 7, 4, 1, 2, 6, 5}, {0, 4, 5, 1, 3, 7, 6, 2}, {0, 1, 2, 3, 4, 5, 6, 7}}};

Nodes turn(const Nodes& nodes, std::size_t direction) {
  Nodes out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = nodes[turned[direction][i]];
  return out;
}

/// Square of the sum of the four edges along the third direction.
double find_square_across(const Mesh& mesh, const Nodes& nodes) {
  Vec3 sum{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t d = 0; d < 3; ++d) sum[d] += mesh.nodes[at(nodes[i + 4])][d] - mesh.nodes[at(nodes[i])][d];
  return sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2];
}

/// The shortest direction; of equally short ones the last.
std::size_t find_shortest(const Mesh& mesh, const Nodes& nodes) {
  std::size_t shortest = 2;
  double least = find_square_across(mesh, nodes);
  for (const std::size_t direction : {std::size_t{1}, std::size_t{0}}) {
    const double square = find_square_across(mesh, turn(nodes, direction));
    if (square >= least) continue;
    shortest = direction;
    least = square;
  }
  return shortest;
}

}  // namespace

bool is_thick_shell(const Deck& deck, const ElementBlock& block) {
  return block.topology == TopologyKind::hex8 &&
         deck.find_elements(at(block.part)).integration == ElementDeck::Integration::thick_shell;
}

Nodes find_kernel_nodes(const Deck& deck, const Mesh& mesh, std::size_t element) {
  using Across = ElementDeck::Across;
  const Nodes nodes = mesh.elements.kernel_nodes(element);
  const ElementBlock& block = mesh.elements.block_of(element);
  if (!is_thick_shell(deck, block)) return nodes;
  const Across across = deck.find_elements(at(block.part)).across;
  return turn(nodes, across == Across::shortest ? find_shortest(mesh, nodes) : static_cast<std::size_t>(across));
}

void refuse_other_solids(const Deck& deck, const Mesh& mesh) {
  for (const ElementBlock& block : mesh.elements.blocks) {
    const Topology& topology = find_topology(block.topology);
    const PartDeck& part = deck.parts[at(block.part)];
    if (part.is_membrane() && !topology.is_surface())
      throw InputError(
          fmt::format("{}: error: part '{}' has {} and integration membrane (membranes are shells): make the others a "
                      "part of their own",
                      deck.where(part.place), part.name, topology.name));
    if (topology.dimension != 3 || block.topology == TopologyKind::hex8) continue;
    if (part.own_elements.integration != ElementDeck::Integration::thick_shell) continue;
    throw InputError(
        fmt::format("{}: error: part '{}' has {} and integration thick_shell (thick shells are hexahedra): "
                    "mesh it with hexahedra alone, or make the others a part of their own",
                    deck.where(part.place), part.name, topology.name));
  }
}

}  // namespace percuss
