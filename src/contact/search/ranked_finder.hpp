#pragma once
// Search and check in the contact decomposition: what the steps of ContactFinder::search() and check() do on many
// ranks.
//
// A rank knows its part of the surface: the nodes that it owns there, the faces that reach it, and the faces around the
// nodes of both, for normals. This topology is sent once and cached for many searches, until faces reach other ranks or
// erosion rebuilds the surface. A search lists the candidate pairs; ranked_check.hpp checks them.

#include "src/contact/check/ranked_check.hpp"
#include "src/contact/ranks/contact_decomposition.hpp"
#include "src/contact/search/contact_finder.hpp"
#include "src/contact/search/ranked_edges.hpp"

namespace percuss {

class RankedFinder : public ContactFinder {
 public:
  RankedFinder(const ContactRanks& ranks, const SurfaceShare& share, const ContactDeck& deck);

  void narrow(const NearWay& way) override {
    check_.narrow(way);
    edges_.narrow(way);
  }
  bool has_found_nothing_new() const override {
    return check_.space().has_found_nothing_new() && edges_.has_found_nothing_new();
  }
  std::vector<Penetration> find_penetrations(const SurfaceMotion& motion) override {
    return check_.find_penetrations(motion);
  }
  std::vector<EdgePenetration> find_edge_penetrations(const SurfaceMotion& motion) override {
    return edges_.find_penetrations(motion);
  }
  std::vector<PartGap> find_gaps(const SurfaceMotion& motion) override { return check_.find_gaps(motion); }
  std::vector<int> node_ranks() const override { return decomposition_.node_owners(); }
  DecompositionReport report() const override { return decomposition_.report(); }
  SearchLoad load() const override;
  PairCounts pair_counts() const override { return check_.space().counts; }
  void take_over(const ContactFinder& before) override;
  PhaseClock decomposition_clock() const override { return decomposition_clock_; }
  Traffic traffic() const override;

  // Kernels of its own: nvcc takes none in a private function.
  std::int64_t find_candidate_pairs_here(std::int64_t limit);

 private:
  void send_contact_data_to_previous_owners(const SurfaceMotion& motion) override;
  void rebalance() override;
  void share_cuts() override;
  void send_points_to_owners(const SurfaceMotion& motion) override;
  void find_reached_ranks(const SurfaceMotion& motion, double margin) override;
  void send_overlapping_faces(const SurfaceMotion& motion) override;
  std::int64_t find_candidates(const SurfaceMotion& motion, double margin) override;
  void check_pairs(const SurfaceMotion& motion, const ContactHistory& history) override;
  int send_results_to_fe_owners(const ContactHistory& history, Array<RowTouch>& touches) override;
  void request_near_pairs() override {
    check_.request_near_pairs();
    edges_.request_near_pairs();
  }

  Phase decompose() { return {"percuss::contact_rcb", decomposition_clock_}; }
  void redefine_surface();
  std::vector<std::int64_t> list_nodes_of_unknown_faces() const;
  std::vector<FaceTopology> ask_for_faces_around(const std::vector<std::int64_t>& nodes);
  void number_surface(std::vector<FaceTopology> more);
  std::int64_t search_faces(double margin);

  ContactRanks ranks_;
  const SurfaceShare& share_;
  UnstructuredExchange exchange_;
  DataExchange data_;
  ContactDecomposition decomposition_;
  PhaseClock decomposition_clock_;
  Traffic traffic_before_;  // of finders whose place this one took

  // The surface that this rank knows, in numbers of its own: searched nodes and faces are those of the decomposition.
  RankedCheck check_;
  RankedEdges edges_;

  // The search on this rank.
  SearchScratch scratch_;
  Rows3<double> places_ = Rows3<double>("contact::searched_places", 0);  // [nodes], of searched nodes
};

}  // namespace percuss
