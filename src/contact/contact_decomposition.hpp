#pragma once
// The contact decomposition: recursive coordinate bisection of contact nodes and faces, dynamic, beside the static one
// of the elements. Steps (5.1) to (5.5) of the paper's Figure 5, each a function.
//
// Two things differ from the paper. A face goes straight from its FE owner to every rank that its capture box reaches,
// one message instead of two. And the cuts are kept until copies of faces on several ranks have grown by a share: the
// owners of points stay, so the balance stays, and nothing moves in between. Nothing physical depends on the cuts.

#include <cstdint>
#include <vector>

#include "comm/data_exchange.hpp"
#include "comm/rcb.hpp"
#include "src/contact/contact_finder.hpp"
#include "src/contact/reached_ranks.hpp"

namespace percuss {

/// A contact node as the search needs it.
struct NodeRecord {
  std::int64_t number = -1;
  double x[3] = {0, 0, 0};
  int surface_class = 0;
};

/// A contact face and its capture box: lowest x, y, z, highest x, y, z.
struct FaceRecord {
  FaceTopology face;
  double box[6] = {0, 0, 0, 0, 0, 0};
};

class ContactDecomposition {
 public:
  /// Collective. The share outlives this.
  ContactDecomposition(const Communicator& ranks, const SurfaceShare& share, ContactDeck::Rebalance rebalance);

  /// Goes on with the cuts and the counts of the decomposition of another surface of the same scene. Collective.
  void take_over(const ContactDecomposition& before);

  /// Brings searched contact nodes to their owners and searched faces to the ranks that their boxes, widened by
  /// `margin`, reach; rebalances before if that is due. Collective. Throws MpiError.
  void update(const SurfaceMotion& motion, double margin);

  /// What this rank has after update(), ascending in number.
  const std::vector<NodeRecord>& nodes() const { return nodes_; }
  const std::vector<FaceRecord>& faces() const { return faces_; }

  /// The cuts, and whether the last update() made them anew.
  const Rcb& cuts() const { return rcb_; }
  bool was_rebalanced() const { return just_rebalanced_; }

  /// Tells how many copies of faces there are on all ranks beyond one each; decides whether the next update rebalances.
  void note_ghost_faces(std::int64_t ghosts);

  /// The owner of each searched contact node of this rank's FE share, ascending; -1 before the first update().
  std::vector<int> node_owners() const;
  const DecompositionReport& report() const { return report_; }
  const Traffic& traffic() const { return data_.traffic(); }

 private:
  /// Points of the FE share: searched nodes, then centres of searched faces.
  struct SharePoints {
    Rows3<double> positions;
    Array<std::int64_t> ids;
  };

  void locate_points(const SurfaceMotion& motion);
  RcbPoints send_contact_data_to_previous_owners();
  void rebalance_points(const RcbPoints& points);
  void find_new_owners();
  void send_nodes_to_owners();
  void list_reached_ranks(const SurfaceMotion& motion, double margin);
  void send_overlapping_faces();

  const SurfaceShare& share_;
  ContactDeck::Rebalance rebalance_;
  UnstructuredExchange exchange_;
  DataExchange data_;
  Rcb rcb_;
  SharePoints points_;
  std::vector<int> searched_nodes_;  // places in OwnedContactNodes
  std::vector<int> owners_;          // [points] in the contact decomposition; empty before the first rebalance
  bool knows_owners_ = false;        // the same on all ranks, unlike whether a rank has points
  SendOrder node_order_;
  ExchangePlan node_plan_;
  std::vector<int> received_order_;  // places of received nodes, ascending in number
  std::vector<NodeRecord> nodes_;
  std::vector<FaceRecord> faces_;
  Boxes boxes_;           // [searched faces]
  ReachedRanks reached_;  // of the searched faces
  Array<int> reach_count_ = Array<int>("contact::reach_count", 0);
  long searches_ = 0;
  std::int64_t ghosts_after_rebalance_ = 0;
  std::int64_t points_at_rebalance_ = 0;  // of this rank's FE share
  bool is_due_ = true, just_rebalanced_ = false;
  double warm_rounds_ = 0;
  DecompositionReport report_;
};

}  // namespace percuss
