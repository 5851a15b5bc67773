#include "src/step/audit/hourglass_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Places of the corners in the element's own coordinates, from -1 to 1.
constexpr int hex_places[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                  {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

/// Values of the modes at the corners: products of two or three coordinates.
struct Modes {
  std::vector<std::array<double, most_corners>> of_corners;
  int axes = 0;
};

const Modes& find_modes(const Topology& topology) {
  static const auto make = [](bool is_solid) {
    Modes modes;
    modes.axes = is_solid ? 3 : 2;
    const std::vector<std::vector<int>> products =
        is_solid ? std::vector<std::vector<int>>{{0, 1}, {1, 2}, {2, 0}, {0, 1, 2}}
                 : std::vector<std::vector<int>>{{0, 1}};
    for (const auto& product : products) {
      auto& values = modes.of_corners.emplace_back();
      for (std::size_t i = 0; i < most_corners; ++i) {
        values[i] = 1;
        for (const int axis : product) values[i] *= hex_places[i][axis];
      }
    }
    return modes;
  };
  static const Modes solid = make(true), surface = make(false);
  return topology.is_solid() ? solid : surface;
}

void add_to(Vec3& sum, double factor, const Vec3& value) {
  for (std::size_t k = 0; k < 3; ++k) sum[k] += factor * value[k];
}

/// Covectors g with g_i . x_j = 1 if i = j, else 0, of the axes x; those of a surface lie in it.
std::array<Vec3, 3> find_dual(std::array<Vec3, 3> axes, bool is_solid) {
  if (!is_solid) axes[2] = cross(axes[0], axes[1]);
  const double volume = dot(axes[0], cross(axes[1], axes[2]));
  std::array<Vec3, 3> dual{};
  for (std::size_t k = 0; k < 3 && volume != 0; ++k)
    add_to(dual[k], 1 / volume, cross(axes[(k + 1) % 3], axes[(k + 2) % 3]));
  return dual;
}

/// Mean derivatives of places by the own coordinates.
std::array<Vec3, 3> find_axes(const Modes& modes, std::span<const Vec3> places) {
  std::array<Vec3, 3> axes{};
  for (std::size_t i = 0; i < places.size(); ++i)
    for (int k = 0; k < modes.axes; ++k)
      add_to(axes[static_cast<std::size_t>(k)], hex_places[i][k] / static_cast<double>(places.size()), places[i]);
  return axes;
}

Vec3 sum_mode(const std::array<double, most_corners>& mode, std::span<const Vec3> places) {
  Vec3 sum{};
  for (std::size_t i = 0; i < places.size(); ++i) add_to(sum, mode[i], places[i]);
  return sum;
}

/// A face of a solid, or an edge of a surface, between two elements: corners by their nodes.
struct Side {
  int element = -1;                        // among the elements looked at
  std::array<int, 4> corners{}, across{};  // of the element: on the side, and behind it along an edge
  std::size_t count = 0;
};

using SideKey = std::array<int, 4>;

/// The corner that an edge joins to a corner of a side, and that does not lie in it.
int find_corner_across(const Topology& topology, int corner, std::span<const int> side) {
  for (const auto& [a, b] : topology.edges()) {
    const int other = a == corner ? b : b == corner ? a : -1;
    if (other >= 0 && std::find(side.begin(), side.end(), other) == side.end()) return other;
  }
  return corner;
}

template <class Use>
void for_each_side(const Mesh& mesh, int element, const Use& use) {
  const auto e = static_cast<std::size_t>(element);
  const Topology& topology = mesh.topology_of(e);
  const std::span<const int> nodes = mesh.corners(e);
  const auto visit = [&](std::span<const int> corners) {
    Side side;
    for (const int corner : corners) {
      side.corners[side.count] = corner;
      side.across[side.count++] = find_corner_across(topology, corner, corners);
    }
    const std::span<int> sorted = std::span(side.corners).first(std::min(side.count, side.corners.size()));
    std::ranges::sort(sorted, {}, [&](int corner) { return nodes[static_cast<std::size_t>(corner)]; });
    for (std::size_t i = 0; i < side.count; ++i)
      side.across[i] = find_corner_across(topology, side.corners[i], corners);
    SideKey key{-1, -1, -1, -1};
    for (std::size_t i = 0; i < side.count; ++i) key[i] = nodes[static_cast<std::size_t>(side.corners[i])];
    use(key, side);
  };
  if (topology.is_solid())
    for (const FaceCorners& face : topology.faces()) visit(face.corners());
  else
    for (const auto& edge : topology.edges()) visit(edge);
}

/// Part of the motion that changes sign across an element, at a corner of its side.
Vec3 find_odd_part(const HourglassDisplacement& motion, const Side& side, std::size_t i) {
  Vec3 odd{};
  add_to(odd, 0.5, motion.of_corners[static_cast<std::size_t>(side.corners[i])]);
  add_to(odd, -0.5, motion.of_corners[static_cast<std::size_t>(side.across[i])]);
  return odd;
}

/// Sums of two neighbours over the corners where they meet: mean square, and its part that alternates.
struct PairSums {
  double square = 0, alternating = 0;
};

PairSums compare(const HourglassDisplacement& a, const Side& of_a, const HourglassDisplacement& b, const Side& of_b) {
  PairSums sums;
  for (std::size_t i = 0; i < of_a.count; ++i) {
    const Vec3 one = find_odd_part(a, of_a, i), other = find_odd_part(b, of_b, i);
    const double square = 0.5 * (dot(one, one) + dot(other, other));
    sums.square += square;
    sums.alternating += 0.5 * (square + dot(one, other));
  }
  return sums;
}

}  // namespace

HourglassDisplacement find_hourglass_displacement(const Topology& topology, std::span<const Vec3> start,
                                                  std::span<const Vec3> now) {
  HourglassDisplacement motion;
  const bool is_quadrilateral = topology.is_surface() && topology.corner_count == 4;
  if (topology.family != ElementFamily::hexahedra && !is_quadrilateral) return motion;
  const Modes& modes = find_modes(topology);
  const auto corners = static_cast<double>(start.size());
  const std::array<Vec3, 3> before = find_axes(modes, start), after = find_axes(modes, now);
  const std::array<Vec3, 3> dual = find_dual(before, topology.is_solid());
  std::array<Vec3, 3> moved = after;
  if (!topology.is_solid()) moved[2] = cross(after[0], after[1]);
  for (const auto& mode : modes.of_corners) {
    Vec3 part = sum_mode(mode, now);
    const Vec3 of_start = sum_mode(mode, start);
    for (std::size_t k = 0; k < 3; ++k) add_to(part, -dot(of_start, dual[k]), moved[k]);  // where the axes take it
    for (std::size_t i = 0; i < start.size(); ++i) add_to(motion.of_corners[i], mode[i] / corners, part);
  }
  for (const Vec3& corner : motion.of_corners) motion.square += dot(corner, corner);
  return motion;
}

std::vector<double> find_alternating_shares(const Mesh& mesh, int first_element,
                                            const std::vector<HourglassDisplacement>& motions) {
  std::vector<PairSums> sums(motions.size());
  std::map<SideKey, Side> open;
  for (std::size_t e = 0; e < motions.size(); ++e) {
    for_each_side(mesh, first_element + static_cast<int>(e), [&](const SideKey& key, Side side) {
      side.element = static_cast<int>(e);
      const auto [met, is_new] = open.emplace(key, side);
      if (is_new) return;
      const auto other = static_cast<std::size_t>(met->second.element);
      const PairSums pair = compare(motions[e], side, motions[other], met->second);
      for (const std::size_t of : {e, other}) {
        sums[of].square += pair.square;
        sums[of].alternating += pair.alternating;
      }
    });
  }
  std::vector<double> shares;
  for (const PairSums& sum : sums) shares.push_back(sum.square > 0 ? sum.alternating / sum.square : 1);
  return shares;
}

}  // namespace percuss
