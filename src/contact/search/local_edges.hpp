#pragma once
// Search and check of edge pairs on one rank, which has the whole surface: what RankedEdges is on several.

#include <cstdint>
#include <vector>

#include "kernels/contact/check/edge_cells.hpp"
#include "src/contact/check/cell_list.hpp"
#include "src/contact/check/check_space.hpp"
#include "src/contact/check/edge_space.hpp"

namespace percuss {

class LocalEdges {
 public:
  /// The share outlives this. A scene without edges does nothing in any call.
  LocalEdges(const SurfaceShare& share, const ContactDeck& deck);
  /// Edges for one check of those of the run, or of none.
  LocalEdges(const LocalEdges& of_run, bool looks);

  /// Goes on with the order of the search of other edges, of which most are the same.
  void take_over(const LocalEdges& before);

  /// Finds the pairs for boxes widened by `margin` and returns how many there are. Throws RunError if they are absurdly
  /// many.
  std::int64_t find_candidates(const SurfaceMotion& motion, double margin);

  /// ContactFinder::narrow() for edges.
  void narrow(const NearWay& way) {
    if (!lists_near_) space_.near.ask(way.near);
  }

  /// The detailed check of these pairs; returns the number of touches.
  int check(const SurfaceMotion& motion, const EdgeHistory& history);

  /// Appends the touches of the last check, by (A, B), after the first `count` of `touches`.
  void append_touches(int count, Array<RowTouch>& touches) const { append_edge_touches(space_, count, touches); }

  bool has_found_nothing_new() const { return space_.has_found_nothing_new(); }

  std::vector<EdgePenetration> find_penetrations(const SurfaceMotion& motion) {
    space_.pairs = all_;
    return measure_edge_pairs(motion, space_);
  }

  // Results of the last search and check.
  const EdgeSpace& space() const { return space_; }
  const std::vector<EdgeTopology>& divided_edges() const { return divided_edges_; }
  const Boxes& boxes() const { return boxes_; }                  // [edges]
  int piece_count() const { return points_.points.num_points; }  // of all edges
  const Rows3<double>& places() const { return places_; }        // [pieces]

 private:
  void use(const EdgeSurface& surface);
  void identify_edges();

  const SurfaceShare& share_;
  EdgeSpace space_;
  bool lists_near_ = false;  // with shells: of the pairs of a search cells say which are near enough to be checked
  EdgePairs all_;            // of the last search
  CellList<EdgeCells, EdgePairs> cells_;
  std::vector<EdgeTopology> divided_edges_;  // SurfaceShare::edges, in pieces of now
  EdgePointLists points_;
  Rows3<double> places_ = Rows3<double>("contact::edge_places", 0);
  Boxes boxes_ = Boxes("contact::edge_boxes", 0);
  EdgeSearchScratch scratch_;
};

}  // namespace percuss
