#pragma once
// Where the nodes of round solids lie: a square (cylinder section) or cube (ball) lattice, its core slightly rounded,
// its outer layers blended into the circle or sphere.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>

namespace percuss {

/// Cells on a diameter: core cells between two runs of rings.
struct RoundSplit {
  int core = 0;
  int rings = 0;
};

/// across cells on a diameter (at least 3), see CylinderShape.
inline RoundSplit split_round(int across) {
  const int rings = std::max(1, across / 4);
  return {across - 2 * rings, rings};
}

/// Form of the core as shares of the radius.
struct CoreForm {
  double half_width = 0;  // from the centre to the middle of a side (of a face)
  double roundness = 0;   // 0: a square (cube), 1: a circle (ball) of radius half_width
};

/// In the disk (N = 2) for a rim that stays round where the solid flows, in the ball (N = 3) for the largest stable
/// step of the worst element, each on 3 to 64 cells across at a worst scaled Jacobian above 0.7 in the disk and above
/// 0.57 (cosine of the cube's diagonal, the best that a core of one cell can have) in the ball. docs/mesh.md has the
/// table.
template <std::size_t N>
CoreForm choose_core_form(RoundSplit split) {
  static_assert(N == 2 || N == 3);
  const double core_share = double(split.core) / (split.core + 2 * split.rings);
  return N == 2 ? CoreForm{0.05 + 0.8 * core_share, 0.4} : CoreForm{0.1 + 0.8 * core_share, 0.55};
}

/// Maps lattice points to places in the disk (N = 2) or ball (N = 3) of the given radius. Points that a symmetry of the
/// square (cube) maps onto each other get coordinates that agree to the last bit.
template <std::size_t N>
class RoundedLattice {
 public:
  using Point = std::array<double, N>;
  using Index = std::array<int, N>;  // 0..core in each direction

  RoundedLattice(double radius, RoundSplit split, CoreForm form) : radius_(radius), split_(split), form_(form) {}
  RoundedLattice(double radius, RoundSplit split) : RoundedLattice(radius, split, choose_core_form<N>(split)) {}

  /// Place of a point of the core (ring 0), or of the ring-th copy outwards of a point on the core's boundary.
  Point operator()(const Index& index, int ring) const {
    Index doubled{};                    // distance from the centre in half cells, signed
    std::array<std::size_t, N> rank{};  // directions by falling distance
    for (std::size_t d = 0; d < N; ++d) {
      doubled[d] = 2 * index[d] - split_.core;
      rank[d] = d;
    }
    std::sort(rank.begin(), rank.end(), [&](auto a, auto b) { return std::abs(doubled[a]) > std::abs(doubled[b]); });
    Index sorted{};
    for (std::size_t d = 0; d < N; ++d) sorted[d] = std::abs(doubled[rank[d]]);
    const Point placed = place_sorted(sorted, ring);
    Point result{};
    for (std::size_t d = 0; d < N; ++d) result[rank[d]] = doubled[rank[d]] < 0 ? -placed[d] : placed[d];
    return result;
  }

 private:
  /// The place in the wedge of points with falling, positive distances: by symmetry the only one to define.
  Point place_sorted(const Index& distance, int ring) const {
    if (distance[0] == 0) return {};
    const double level = double(distance[0]) / split_.core;  // 1 on the boundary of the core
    Point square{}, round{};
    double length_squared = 0;
    for (std::size_t d = 0; d < N; ++d) {
      square[d] = double(distance[d]) / distance[0];
      // Equal angles between neighbours; tan(pi / 4) is not 1 in floating point.
      round[d] = distance[d] == distance[0] ? 1 : std::tan(std::numbers::pi / 4 * square[d]);
      length_squared += round[d] * round[d];
    }
    const double length = std::sqrt(length_squared), roundness = form_.roundness * level;
    const double outwards = double(ring) / split_.rings;
    Point place{};
    for (std::size_t d = 0; d < N; ++d) {
      const double direction = round[d] / length;
      const double core = level * form_.half_width * radius_ * (square[d] + roundness * (direction - square[d]));
      place[d] = ring == split_.rings ? radius_ * direction : core + outwards * (radius_ * direction - core);
    }
    return place;
  }

  double radius_;
  RoundSplit split_;
  CoreForm form_;
};

}  // namespace percuss
