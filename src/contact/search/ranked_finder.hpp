#pragma once
// Search and check in the contact decomposition: Figure 5 of the paper, by search() and check().
//
// A rank knows the nodes that it owns there, the faces that reach it, and the faces around the nodes of both, for
// normals: its part of the surface, which it is told once and uses for many searches, until faces reach other ranks or
// erosion makes another surface. A search lists the candidate pairs; then the rank tells the FE owners of nodes which
// places and velocities, and which remembered contacts, the check of these pairs reads. Until it tells them otherwise a
// step costs no more than these, and the touches that go back: nodes and faces far from any contact are not sent at
// all. Where near pairs are listed, only theirs are.

#include "src/contact/check/check_space.hpp"
#include "src/contact/decomposition/contact_decomposition.hpp"
#include "src/contact/exchange/motion_copy.hpp"
#include "src/contact/search/ranked_edges.hpp"
#include "src/contact/surface/number_map.hpp"

namespace percuss {

class RankedFinder : public ContactFinder {
 public:
  RankedFinder(const ContactRanks& ranks, const SurfaceShare& share, const ContactDeck& deck);

  std::int64_t search(const SurfaceMotion& motion, double margin) override;
  void narrow(const NearWay& way) override;
  int check(const SurfaceMotion& motion, const ContactHistory& history, Array<RowTouch>& touches) override;
  bool has_found_nothing_new() const override {
    return check_.has_found_nothing_new() && edges_.has_found_nothing_new();
  }
  std::vector<Penetration> find_penetrations(const SurfaceMotion& motion) override;
  std::vector<EdgePenetration> find_edge_penetrations(const SurfaceMotion& motion) override {
    return edges_.find_penetrations(motion);
  }
  std::vector<PartGap> find_gaps(const SurfaceMotion& motion) override;
  std::vector<int> node_ranks() const override { return decomposition_.node_owners(); }
  DecompositionReport report() const override { return decomposition_.report(); }
  SearchLoad load() const override;
  PairCounts pair_counts() const override { return check_.counts; }
  void take_over(const ContactFinder& before) override;
  PhaseClock decomposition_clock() const override { return decomposition_clock_; }
  Traffic traffic() const override;

 private:
  /// A touch on its way to the FE owner of its node.
  struct TouchRecord;

  /// What the check of a list of pairs reads.
  struct CheckPart {
    MotionPart motion;
    ItemPart history;                                 // of searched nodes
    Array<int> history_rows;                          // in messages: nodes of the surface
    Array<int> own_history_rows, own_history_places;  // of this rank itself: nodes, and contact nodes of the share
    Array<int> published_history;                     // contact nodes of the share
  };

  void redefine_surface();
  std::vector<std::int64_t> list_nodes_of_unknown_faces() const;
  std::vector<FaceTopology> ask_for_faces_around(const std::vector<std::int64_t>& nodes);
  void number_surface(std::vector<FaceTopology> more);
  std::int64_t search_faces(double margin);
  std::int64_t find_points_in_boxes_here(std::int64_t limit);
  CheckPart select(const CandidateList& pairs);
  void select_near();
  std::vector<RowTouch> check_faces(const SurfaceMotion& motion, const ContactHistory& history);
  SurfaceMotion receive(const SurfaceMotion& motion, const ContactHistory& history);
  template <class Record>
  std::vector<Record> send_results_to_fe_owners(const CheckPart& part, std::vector<Record> records);
  std::vector<RowTouch> make_row_touches(std::vector<TouchRecord> records) const;
  int find_contact_node(std::int64_t number) const { return contact_nodes_.find(number); }

  ContactRanks ranks_;
  const SurfaceShare& share_;
  const NumberMap contact_nodes_;  // those that this rank owns in the FE decomposition
  UnstructuredExchange exchange_;
  DataExchange data_, history_data_;
  ContactDecomposition decomposition_;
  PhaseClock decomposition_clock_;
  Traffic traffic_before_;  // of finders whose place this one took

  // The surface that this rank knows, in numbers of its own: searched nodes and faces are those of the decomposition.
  CheckSpace check_;
  std::vector<std::int64_t> nodes_;  // [nodes] numbers, ascending
  std::vector<FaceTopology> faces_;  // [faces] ascending
  std::vector<int> searched_nodes_;  // [searched] places in nodes_
  MotionCopy motion_;
  RemoteItems history_;  // of searched nodes, from their FE owners

  // The search on this rank.
  SearchScratch scratch_;
  Rows3<double> places_ = Rows3<double>("contact::searched_places", 0);  // [nodes], of searched nodes
  std::int64_t total_pairs_ = 0;                                         // of all ranks

  // What is asked for of others: for all pairs, for those that can come near before the next search, for the near ones.
  CheckPart of_all_, of_reachable_, of_near_;
  const CheckPart *base_ = &of_all_, *read_ = &of_all_;  // where no near pairs are listed, and in the next check
  NearWay asked_;                                        // of lists that the next check makes
  Array<int> wanted_ = Array<int>("contact::wanted_nodes", 0);

  RankedEdges edges_;
};

}  // namespace percuss
