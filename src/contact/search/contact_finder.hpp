#pragma once
// Location phase and detailed check (the paper's (1.7), (1.8)) for the contact nodes that a rank owns, by steps
// (5.1) to (5.7). On one rank those that only send do nothing.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "comm/exchange/data_exchange.hpp"
#include "comm/phase.hpp"
#include "src/contact/check/check_space.hpp"
#include "src/contact/check/edge_space.hpp"
#include "src/contact/ranks/contact_decomposition.hpp"
#include "src/contact/surface/contact_ranks.hpp"
#include "src/contact/surface/surface_share.hpp"

namespace percuss {

/// Load of a rank in its last search.
struct SearchLoad {
  std::int64_t nodes = 0;  // contact nodes that it owns for contact
  std::int64_t faces = 0;  // contact faces that reached it, copies included
};

/// All calls are collective.
class ContactFinder {
 public:
  virtual ~ContactFinder() = default;

  /// Steps (5.1) to (5.6), points in boxes: finds candidate pairs for capture boxes widened by `margin` and returns how
  /// many there are on all ranks. Throws RunError, on all ranks, if they are absurdly many.
  std::int64_t search(const SurfaceMotion& motion, double margin);

  /// Leaves out, from the next check on, the pairs that it cannot accept before some node has used up its travel.
  virtual void narrow(const NearWay& way) = 0;

  /// Steps (5.6), the detailed check, and (5.7), of the candidate pairs of the last search. history: of the last step.
  /// touches: those of this rank's contact nodes, by (node, face), then those of edges whose home this rank is, by
  /// (edge A, edge B); in: the same array with those of the last check as they were, where they stay if it finds the
  /// same. Returns how many these are.
  int check(const SurfaceMotion& motion, const ContactHistory& history, Array<RowTouch>& touches);

  /// Whether all that the last check found on this rank was found by the one before it as well, and is at rest: as many
  /// touches on all ranks are then the same ones.
  virtual bool has_found_nothing_new() const = 0;

  /// The contact nodes of this rank that are inside another body, among the candidate pairs, at the positions of a
  /// motion with dt = 0; ascending.
  virtual std::vector<Penetration> find_penetrations(const SurfaceMotion& motion) = 0;

  /// The edges whose home is this rank and that are inside another edge of a higher number; as above.
  virtual std::vector<EdgePenetration> find_edge_penetrations(const SurfaceMotion& motion) = 0;

  /// The smallest gap between parts among the candidate pairs of this rank, at the positions of a motion with dt = 0.
  virtual std::vector<PartGap> find_gaps(const SurfaceMotion& motion) = 0;

  /// Rank that owns each searched contact node (ascending) in the contact decomposition; -1 before it is first made.
  virtual std::vector<int> node_ranks() const = 0;
  virtual DecompositionReport report() const = 0;
  virtual SearchLoad load() const = 0;
  virtual PairCounts pair_counts() const = 0;  // of this rank

  /// Continues where a finder of the surface before left off: cuts, orders, counts and clocks.
  virtual void take_over(const ContactFinder& before) = 0;

  /// Time that searches spent on the decomposition: steps (5.1) to (5.5) of nodes and faces; those of edges count as
  /// search.
  virtual PhaseClock decomposition_clock() const = 0;
  virtual Traffic traffic() const = 0;

 private:
  virtual void send_contact_data_to_previous_owners(const SurfaceMotion& /*motion*/) {}
  virtual void rebalance() {}
  virtual void share_cuts() {}
  virtual void send_points_to_owners(const SurfaceMotion& /*motion*/) {}
  virtual void find_reached_ranks(const SurfaceMotion& /*motion*/, double /*margin*/) {}
  virtual void send_overlapping_faces(const SurfaceMotion& /*motion*/) {}
  /// Points in boxes; returns how many pairs there are on all ranks.
  virtual std::int64_t find_candidates(const SurfaceMotion& motion, double margin) = 0;
  virtual void check_pairs(const SurfaceMotion& motion, const ContactHistory& history) = 0;
  /// Returns the number of touches of this rank's contact nodes and edges.
  virtual int send_results_to_fe_owners(const ContactHistory& history, Array<RowTouch>& touches) = 0;
  /// Requests from other ranks, after narrow(), what the pairs that are left read.
  virtual void request_near_pairs() {}
};

/// Part of the surface that a check between steps covers.
struct LookedAt {
  std::optional<std::vector<char>> nodes;  // [contact nodes] those whose penetrations are requested; none: all
  bool has_nodes = true;                   // whether some of any rank are
  bool has_edges = true;                   // whether penetrations of edges are requested
};

/// A finder for one look at the surface of the run's, which stays as it is. What is not looked at, it may find or not.
std::unique_ptr<ContactFinder> make_look_finder(const ContactFinder& of_run, const ContactRanks& ranks,
                                                const SurfaceShare& share, const ContactDeck& deck, const LookedAt& at);

/// The finder that suits the number of ranks.
std::unique_ptr<ContactFinder> make_contact_finder(const ContactRanks& ranks, const SurfaceShare& share,
                                                   const ContactDeck& deck);

/// The kernels' name of the deck's choice.
constexpr SearchMethod find_method(ContactDeck::Search search) {
  return search == ContactDeck::Search::blocks ? SearchMethod::blocks : SearchMethod::points_in_box;
}

}  // namespace percuss
