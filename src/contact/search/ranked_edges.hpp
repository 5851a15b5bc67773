#pragma once
// Search and check of edge pairs in the contact decomposition.
//
// The cuts of contact nodes and faces divide the edges too. An edge belongs to the rank in whose part its middle was
// when the cuts were made, with the points of its search. It is sent to the ranks whose points its capture box may
// hold. As for nodes and faces, a rank that has the points of an edge has every edge whose box holds one of them,
// wherever the cuts are.

#include <optional>

#include "src/contact/check/ranked_edge_check.hpp"
#include "src/contact/ranks/contact_decomposition.hpp"

namespace percuss {

class RankedEdges {
 public:
  /// Size of an edge on its way to a rank that its box reaches.
  static constexpr int record_bytes = sizeof(EdgeTopology) + 104;

  /// Collective, as are all calls; a scene without edges sends nothing. The share outlives this.
  RankedEdges(const ContactRanks& ranks, const SurfaceShare& share, const ContactDeck& deck);

  /// Together, in this order, these find the pairs for boxes widened by `margin`: what the steps of
  /// ContactFinder::search() from (5.3) on do for nodes and faces, by the same cuts.
  void send_points_to_owners(const SurfaceMotion& motion, const ContactDecomposition& decomposition);
  void find_reached_ranks(const SurfaceMotion& motion, double margin);
  void send_overlapping_edges(const SurfaceMotion& motion);
  /// Returns how many pairs there are on all ranks. Throws RunError, on all ranks, if they are absurdly many.
  std::int64_t find_candidates(double margin);

  /// ContactFinder::narrow() for edges. Not collective.
  void narrow(const NearWay& way) { check_.narrow(way); }
  /// ContactFinder::request_near_pairs() for edges.
  void request_near_pairs() {
    if (data_) check_.request_near_pairs(*data_);
  }

  void check(const SurfaceMotion& motion, const EdgeHistory& history) {
    if (data_) check_.check(motion, history, *data_);
  }

  /// Appends the touches of edges A whose home this rank is, by (A, B), to those of faces.
  void append_touches(const EdgeHistory& history, std::vector<RowTouch>& touches) {
    if (data_) check_.append_touches(history, *data_, touches);
  }

  /// EdgeSpace::has_found_nothing_new() of this rank's pairs.
  bool has_found_nothing_new() const { return check_.space().has_found_nothing_new(); }

  std::vector<EdgePenetration> find_penetrations(const SurfaceMotion& motion) {
    return data_ ? check_.find_penetrations(motion, *data_) : std::vector<EdgePenetration>{};
  }

  Traffic traffic() const { return data_ ? data_->traffic() : Traffic{}; }

  // Kernels of its own: nvcc takes none in a private function.
  void find_owners(const SurfaceMotion& motion);

 private:
  Point3 find_half_piece_of_all(const SurfaceMotion& motion) const;
  std::int64_t find_pairs_here(const Point3& slack, std::int64_t limit);

  const ContactRanks ranks_;
  const SurfaceShare& share_;
  std::optional<UnstructuredExchange> exchange_;
  std::optional<DataExchange> data_;
  std::optional<AssignedParts> parts_;  // parts of the decomposition, with the reach of edges' points

  // Edges whose home this rank is.
  std::vector<EdgeTopology> divided_edges_;   // SurfaceShare::edges, in pieces of now
  EdgePoints points_;                         // ends as mesh nodes
  std::vector<int> owners_;                   // [edges] ranks in the contact decomposition
  bool knows_owners_ = false;                 // the same on all ranks, unlike whether a rank has edges
  Boxes boxes_ = Boxes("contact::boxes", 0);  // [edges]
  Point3 half_piece_{};                       // of all ranks' edges, in this search
  ReachedParts reached_;                      // likewise, by the boxes

  // Edges that reached this rank, ascending in number.
  struct EdgeRecord;
  std::vector<EdgeTopology> edges_;
  std::vector<char> is_owned_;                 // [edges]
  std::vector<std::array<double, 6>> places_;  // [edges] of the ends
  Boxes edge_boxes_ = Boxes("contact::received_boxes", 0);
  EdgeSearchScratch scratch_;
  RankedEdgeCheck check_;
};

}  // namespace percuss
