#include "src/step/turned_corners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/communicator.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {

namespace {

/// Of the product of the edges at a corner: what the checks of a mesh call zero.
constexpr double zero_jacobian = 1e-10;

bool has_turned_corner(const HexCorners& x) {
  for (int corner = 0; corner < 8; ++corner) {
    const CornerJacobian jacobian = find_corner_jacobian(x, corner);
    if (jacobian.value < -zero_jacobian * jacobian.edge_product) return true;
  }
  return false;
}

}  // namespace

std::vector<std::int64_t> count_turned_corners(const ChunkedMesh& chunked, const Model& model, const State& state) {
  const Mesh& mesh = chunked.mesh;
  const auto places = to_host(state.x);
  std::vector<std::int64_t> counts(mesh.parts.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (is_shell(mesh.elements[e]) || (e < mesh.eroded.dead.size() && mesh.eroded.dead[e] != 0)) continue;
    HexCorners x{};
    for (std::size_t c = 0; c < 8; ++c) {
      const auto n = static_cast<std::size_t>(mesh.elements[e][c]);
      for (std::size_t k = 0; k < 3; ++k) x[c][k] = places(n, k);
    }
    if (has_turned_corner(x)) ++counts[static_cast<std::size_t>(mesh.element_part[e])];
  }
  all_reduce(model.ranks, Reduce::sum, counts);
  return counts;
}

void TurnedCorners::note(double time, std::vector<std::int64_t> now) {
  counts = std::move(now);
  const bool any = std::any_of(counts.begin(), counts.end(), [](std::int64_t n) { return n > 0; });
  if (any && first_time < 0) first_time = time;
}

std::string TurnedCorners::describe(const std::vector<MeshPart>& parts) const {
  if (first_time < 0) return "";
  const std::int64_t total = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  std::string where;
  for (std::size_t p = 0; p < counts.size(); ++p) {
    if (counts[p] > 0) where += fmt::format("{}'{}' {}", where.empty() ? " (" : ", ", parts[p].name, counts[p]);
  }
  return fmt::format(
      "warning: elements with a corner turned inside out at the end: {}{}{}; the first were seen at t = {:g} "
      "(one point does not see it: the results there are doubtful) use smaller elements, failure or a material that "
      "resists it",
      total, where, where.empty() ? "" : ")", first_time);
}

}  // namespace percuss
