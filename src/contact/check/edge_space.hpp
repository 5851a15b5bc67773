#pragma once
// Where feature edges are searched and checked: their surface in local numbers, their pairs and the memory of both.

#include <cstdint>
#include <functional>
#include <vector>

#include "kernels/contact/check/edge_touches.hpp"
#include "kernels/contact/check/near_edges.hpp"
#include "kernels/contact/rows/row_system.hpp"
#include "kernels/contact/search/edge_search.hpp"
#include "src/contact/check/near_list.hpp"
#include "src/contact/surface/surface_share.hpp"

namespace percuss {

/// Two edges inside one another.
struct EdgePenetration {
  std::int64_t a = -1, b = -1;  // numbers of the edges
  Point3 normal{};              // push direction of a
  double depth = 0;             // [length]
  double size = 0;              // h
  double limit = 0;             // depth up to which contact can hold it [length]
};

/// Edges with the points by which points-in-box knows them.
struct EdgePointLists {
  EdgePoints points;  // in rows of some motion
  EdgePointNames names;
};

/// find_row(number): row of a node in the motion, -1 if it is not there (then only what needs no such row may be used).
using FindRow = std::function<int(std::int64_t)>;

EdgeSurface make_edge_surface(const std::vector<EdgeTopology>& edges, const FindRow& find_row,
                              const SurfaceShare& share);

/// Divides edges by their lengths of now, since a stretched one would widen the boxes of all others. ends: [edges] rows
/// of x; piece: SurfaceShare::edge_piece. Returns whether some edge has another number of pieces.
bool divide_again(const Rows2<const int>& ends, const Rows3<const double>& x, double piece,
                  std::vector<EdgeTopology>& edges);

/// ends: [edges] rows of some motion. points_of: [edges] whether the points of an edge are searched here; empty: all.
EdgePointLists list_edge_points(const std::vector<EdgeTopology>& edges, const Rows2<const int>& ends,
                                const std::vector<char>& points_of);

/// The pairs of edges that are near enough to be checked, where there are many others.
class NearEdges {
 public:
  /// The pairs are others now, and all of them are checked.
  void forget() { near_.forget(); }

  /// Requests a list, at the next check, of the pairs near enough for this travel of any node; 0: all are checked.
  void ask(double travel) {
    travel_ = travel;
    near_.ask(travel > 0, false);
  }
  bool is_asked() const { return near_.is_due(); }

  /// Lists them; motion: of the edges of all pairs.
  void make(const EdgeSurface& surface, const SurfaceMotion& motion, const EdgePairs& all);

  const EdgePairs& checked_pairs(const EdgePairs& all) const { return near_.choose(all); }

 private:
  static constexpr int pause = 31;

  NearList<EdgePairs> near_{pause};
  NearEdgeScratch scratch_;
  double travel_ = 0;
};

/// Edges with their pairs and the memory of checking them.
struct EdgeSpace {
  EdgeSurface surface;
  EdgePairs pairs;  // of the last search
  NearEdges near;
  EdgeState state;
  StillEdges still;
  bool keeps_still = true;  // what the last check found of pairs that are at rest
  EdgeTouchTable touches;

  const EdgePairs& checked_pairs() const { return near.checked_pairs(pairs); }

  /// Whether all that the last check found was found by the one before it as well, and is at rest.
  bool has_found_nothing_new() const { return touches.num_new == 0; }
};

/// Takes a surface into use: memory for its edges.
void set_edge_surface(const EdgeSurface& surface, EdgeSpace& space);

/// No pair was checked in this step: nothing is found, and the next check has none before it to compare with.
inline void forget_touches(EdgeSpace& space) {
  space.touches.count = space.touches.num_new = 0;
  space.still.forget();
}

/// The detailed check of the pairs that are near; returns the number of touches.
int check_edge_pairs(const SurfaceMotion& motion, const EdgeHistory& history, EdgeSpace& space);

/// The touches of the last check as rows need them, after the first `count` of `touches`. The rows of the motion are
/// mesh nodes.
void append_edge_touches(const EdgeSpace& space, int count, Array<RowTouch>& touches);

/// Pairs inside one another at the positions of a motion with dt = 0, in the order of the pairs.
std::vector<EdgePenetration> measure_edge_pairs(const SurfaceMotion& motion, EdgeSpace& space);

}  // namespace percuss
