#pragma once
// Search and check in the contact decomposition: steps (5.6) and (5.7) of the paper's Figure 5.
//
// A search lists the candidate pairs among the nodes that a rank owns there and the faces that reached it. Then the
// rank learns what the check of these pairs reads (the faces around their nodes, for normals) and subscribes to the
// places and velocities of all nodes concerned. Until the next search a step costs no more than these, and the touches
// that go back: nodes and faces far from any contact are not sent at all.

#include "comm/merge_reduction.hpp"
#include "src/contact/check_space.hpp"
#include "src/contact/contact_decomposition.hpp"
#include "src/contact/motion_copy.hpp"
#include "src/contact/ranked_edges.hpp"

namespace percuss {

class RankedFinder : public ContactFinder {
 public:
  RankedFinder(const ContactRanks& ranks, const SurfaceShare& share, ContactDeck::Rebalance rebalance,
               SearchMethod method);

  std::int64_t search(const SurfaceMotion& motion, double margin) override;
  void narrow(const NearWay& way) override { check_.near.ask(way); }
  int check(const SurfaceMotion& motion, const ContactHistory& history, Array<RowTouch>& touches) override;
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

  std::int64_t search_faces(double margin);
  std::vector<RowTouch> check_faces(const SurfaceMotion& motion, const ContactHistory& history);
  std::int64_t find_points_in_boxes_here(std::int64_t limit);
  void list_pairs();
  std::vector<FaceTopology> ask_for_faces_around(const std::vector<std::int64_t>& nodes);
  void build_check_space(std::vector<FaceTopology> faces);
  Subscription subscribe_to_contact_nodes(const std::vector<std::int64_t>& numbers);
  void receive_history(const ContactHistory& history);
  template <class Record>
  std::vector<Record> send_results_to_fe_owners(const std::vector<Record>& records, const std::vector<int>& counts);
  std::vector<RowTouch> make_row_touches(std::vector<TouchRecord> records) const;
  int find_mesh_node(std::int64_t number) const;
  int find_contact_node(std::int64_t number) const;

  ContactRanks ranks_;
  const SurfaceShare& share_;
  UnstructuredExchange exchange_;
  DataExchange data_;
  ContactDecomposition decomposition_;
  PhaseClock decomposition_clock_;
  Traffic traffic_before_;  // of finders whose place this one took

  // The search on this rank.
  SearchScratch scratch_;
  CandidateList found_;                      // in places of decomposition_.nodes() and faces()
  std::vector<int> first_pair_, pair_face_;  // the same on the host: [nodes + 1], [pairs]
  std::vector<int> checked_;                 // places of nodes with candidates
  std::vector<int> candidate_faces_;         // places of faces that are some node's candidate, ascending
  std::int64_t total_pairs_ = 0;             // of all ranks

  // The check on this rank, in numbers of its own.
  CheckSpace check_;
  std::vector<std::int64_t> check_nodes_;  // [nodes] numbers, ascending
  std::vector<FaceTopology> check_faces_;  // [faces] ascending
  std::vector<int> checked_nodes_;         // [checked] places in check_nodes_
  MotionCopy motion_;
  Subscription history_;

  RankedEdges edges_;
};

}  // namespace percuss
