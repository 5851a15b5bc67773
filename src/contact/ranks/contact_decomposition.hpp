#pragma once
// The contact decomposition: recursive coordinate bisection of contact nodes and faces, dynamic, beside the static one
// of the elements. Steps (5.1) to (5.5) of the paper, each a function, called in this order (ContactFinder).
//
// Four things differ from the paper. A face goes straight from its FE owner to every rank that its capture box reaches,
// one message instead of two; a node likewise to its contact owner. A part goes to the rank that has most of its points
// in the FE decomposition; these need no messages. The cuts are kept until copies of faces on several ranks have grown
// by a share: the owners of points stay, so the balance stays and nothing moves. The topology of nodes and faces is
// sent once and cached: each search sends only positions and boxes, until a face reaches a rank that does not know it.
// No physical result depends on the cuts, nor on extra faces that ranks know.

#include <cstdint>
#include <memory>
#include <vector>

#include "comm/exchange/data_exchange.hpp"
#include "comm/partition/assign_parts.hpp"
#include "src/contact/ranks/reached_parts.hpp"
#include "src/contact/surface/surface_share.hpp"

namespace percuss {

/// Extra width of a box, in margins of a search, for the choice of the ranks that receive its face: faces can then move
/// for some searches before more ranks need them. Not the first time: where erosion rebuilds the surface in every other
/// step, there is no second one.
inline constexpr double sent_margins = 2;

/// A contact node as the search needs it.
struct NodeRecord {
  std::int64_t number = -1;
  int surface_class = 0;
  int faces = 0;  // around it, searched or not
};

/// Report of the contact decomposition so far; the same on every rank.
struct DecompositionReport {
  long rebalances = 0;
  double imbalance = 1;          // of nodes and faces after the last rebalance: max over mean
  double worst_imbalance = 1;    // after any rebalance
  double rounds_per_cut = 0;     // of reduction, mean over the cuts of all rebalances but the first
  std::int64_t ghost_faces = 0;  // copies of faces on ranks that do not own them, at the last search, all ranks
};

class ContactDecomposition {
 public:
  /// Collective. The share outlives this.
  ContactDecomposition(const Communicator& ranks, const SurfaceShare& share, ContactDeck::Rebalance rebalance);

  /// Continues with the cuts and the counts of the decomposition of another surface of the same scene. Collective.
  void take_over(const ContactDecomposition& before);

  /// Together, in this order, these bring searched contact nodes to their owners and searched faces to the ranks that
  /// their boxes, widened by `margin`, reach, and maybe to more. (5.1) to (5.3) rebalance, where that is due. Each is
  /// collective. Throw MpiError.
  void send_contact_data_to_previous_owners(const SurfaceMotion& motion);
  void rebalance();
  void share_cuts();
  void send_points_to_owners();
  void find_reached_ranks(const SurfaceMotion& motion, double margin);
  void send_overlapping_faces();

  /// Nodes and faces of this rank after a search, ascending in number, and whether they have changed on any rank.
  const std::vector<NodeRecord>& nodes() const { return nodes_; }
  const std::vector<FaceTopology>& faces() const { return faces_; }
  /// [nodes] OwnedContactNodes::radii; empty: no beams touch.
  const std::vector<double>& radii() const { return radii_; }
  bool has_changed() const { return has_changed_; }

  /// Where they are: [nodes][3], and capture boxes [faces], lowest x, y, z, highest x, y, z.
  const Rows3<double>& places() const { return places_; }
  const Boxes& boxes() const { return received_boxes_; }

  /// Faces of this rank's FE share, one for each rank that its box reached.
  std::int64_t reaching_faces() const { return reaching_faces_; }

  /// How many of faces() have boxes that reached this rank.
  std::int64_t count_reaching_here() const;

  /// The cuts, and whether the last search renewed them.
  const AssignedParts& parts() const { return *parts_; }
  bool was_rebalanced() const { return just_rebalanced_; }

  /// Takes the number of ghost faces on all ranks; decides whether the next search rebalances.
  void decide_rebalance(std::int64_t ghosts);

  /// The owner of each searched contact node of this rank's FE share, ascending; -1 before the first search.
  std::vector<int> node_owners() const;
  const DecompositionReport& report() const { return report_; }
  const Traffic& traffic() const { return data_.traffic(); }

  // Kernels of its own: nvcc takes none in a private function.
  void locate_points(const SurfaceMotion& motion);

 private:
  /// Points of the FE share: searched nodes, then centres of searched faces.
  struct SharePoints {
    Rows3<double> positions;
    Array<std::int64_t> ids;
  };

  void begin_search(const SurfaceMotion& motion);
  bool adopt_cuts();
  RcbPoints send_points_to_previous_owners();
  void take_report(const RcbReport& done);
  void assign_parts_once(const std::vector<int>& parts);
  bool find_new_owners();
  void send_nodes_to_owners();
  void send_places_to_owners();
  bool are_reached_parts_known(const SurfaceMotion& motion, double margin);
  void send_faces();
  void send_boxes();

  const SurfaceShare& share_;
  ContactDeck::Rebalance rebalance_;
  UnstructuredExchange exchange_;
  DataExchange data_;
  std::shared_ptr<AssignedParts> parts_;  // kept from one surface of the scene to the next
  SharePoints points_;
  std::vector<int> searched_nodes_;  // places in OwnedContactNodes
  std::vector<int> owners_;          // [points] ranks in the contact decomposition; empty before the first rebalance
  bool knows_owners_ = false;        // the same on all ranks, unlike whether a rank has points
  long searches_ = 0;
  std::int64_t ghosts_after_rebalance_ = 0;
  std::int64_t points_at_rebalance_ = 0;  // of this rank's FE share
  bool is_due_ = true, just_rebalanced_ = false;
  RcbPoints arrived_;                                          // from (5.1) to (5.3)
  RcbReport divided_;                                          // likewise
  bool are_nodes_others_ = false, are_reached_known_ = false;  // in the search that has begun
  double warm_rounds_ = 0;
  DecompositionReport report_;

  // Nodes on their way to their owners, and those that this rank owns. Order: of the messages.
  ExchangePlan node_plan_;
  Array<const int> sent_nodes_;      // points
  Array<const int> received_nodes_;  // places in nodes_
  std::vector<NodeRecord> nodes_;
  std::vector<double> radii_;
  Rows3<double> places_;  // [nodes]

  // Faces likewise.
  Boxes boxes_;         // [searched faces]
  ReachedParts known_;  // of the searched faces: the parts whose ranks have each
  ExchangePlan face_plan_;
  Array<const int> sent_faces_, received_faces_;
  std::vector<FaceTopology> faces_;
  Boxes received_boxes_;  // [faces]
  std::int64_t reaching_faces_ = 0;
  bool are_faces_sent_ = false, has_changed_ = false;
};

}  // namespace percuss
