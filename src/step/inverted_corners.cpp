#include "src/step/inverted_corners.hpp"

#include <fmt/format.h>

#include "comm/all_reduce.hpp"
#include "comm/communicator.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {

namespace {

/// Share of the product of the edges at a corner that the checks of a mesh call zero.
constexpr double zero_jacobian = 1e-10;

bool has_inverted_corner(const Topology& topology, const ElementCorners& x) {
  for (int corner = 0; corner < topology.corner_count; ++corner) {
    const CornerJacobian jacobian = find_corner_jacobian(topology, x, corner);
    if (jacobian.value < -zero_jacobian * jacobian.edge_product) return true;
  }
  return false;
}

}  // namespace

std::vector<std::int64_t> count_inverted_corners(const ChunkedMesh& chunked, const Model& model, const State& state) {
  const Mesh& mesh = chunked.mesh;
  const auto places = to_host(state.x);
  std::vector<std::int64_t> counts(mesh.parts.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Topology& topology = mesh.topology_of(e);
    if (!topology.is_solid()) continue;
    if (e < mesh.eroded.dead.size() && mesh.eroded.dead[e] != 0) continue;
    const ElementCorners x = gather_corners(mesh.elements, e, [&](int node) {
      const auto n = static_cast<std::size_t>(node);
      return Vec3{places(n, 0), places(n, 1), places(n, 2)};
    });
    if (has_inverted_corner(topology, x)) ++counts[static_cast<std::size_t>(mesh.part_of(e))];
  }
  all_reduce(model.ranks, Reduce::sum, counts);
  return counts;
}

std::vector<Warning> describe_inverted_corners(const std::vector<std::int64_t>& counts,
                                               const std::vector<MeshPart>& parts, double time) {
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < counts.size(); ++p) {
    if (counts[p] == 0) continue;
    warnings.push_back(
        {"inverted_corners",
         fmt::format("{} element{} an inverted corner (one integration point does not detect it: results there are "
                     "unreliable): use smaller elements, element failure or a stiffer material",
                     counts[p], counts[p] == 1 ? " has" : "s have"),
         fmt::format("part '{}'", parts[p].name), time, 1});
  }
  return warnings;
}

}  // namespace percuss
