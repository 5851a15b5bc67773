#pragma once
// Recursive coordinate bisection (section 4.1.4 of the paper): the dynamic decomposition for contact.
//
// Points = contact nodes and face centres. Each cut divides the points of a group of ranks exactly in proportion to the
// ranks on its two sides, whatever their number. Cuts follow from the points, their weights and, through the choice of
// axes, from the previous cuts; neither the holders of the points nor the start of the search matter: a warm start and
// a cold one with the same axes give the same owners. Cuts depend on history, so they belong in a checkpoint.

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/rcb/cut_tree.hpp"
#include "comm/rcb/far_side.hpp"
#include "comm/rcb/median_search.hpp"
#include "comm/rcb/rcb_points.hpp"

namespace percuss {

/// Points cannot be divided; what() says why. Thrown on all ranks.
class RcbError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Result of a bisection; the same on every rank.
struct RcbReport {
  std::int64_t points = 0;
  std::int64_t weight = 0;
  std::int64_t moved = 0;     // points sent across cuts (4.3)
  double rounds_per_cut = 0;  // rounds of reduction, mean over the cuts
  int most_rounds = 0;        // of one cut
  double imbalance = 1;       // weight of the heaviest rank over the mean
};

/// Another axis is taken only if the points extend so much farther along it than along the previous axis: without
/// that, two nearly equal extents would swap half of all points back and forth.
inline constexpr double axis_change = 1.15;

class Rcb {
 public:
  /// Collective over `ranks`. Throws MpiError.
  explicit Rcb(const Communicator& ranks);

  /// Bisects the points again, starting from the previous cuts if there are any. It costs least when the points are
  /// where the previous cuts put them (step (5.1)). Collective. Throws RcbError on all ranks if a coordinate is not
  /// finite or a weight not positive; MpiError.
  RcbReport decompose(const ExecSpace& space, const RcbPoints& points);

  /// The two steps of decompose(): (5.2) divides the points; (5.3) tells all ranks all cuts and completes the report.
  RcbReport divide(const ExecSpace& space, const RcbPoints& points);
  void share_cuts(RcbReport& report);

  /// The cuts, on every rank: who owns a point, which ranks a box reaches.
  const CutTree& tree() const { return tree_; }

  /// The cuts on the host, entry m the cut whose upper ranks begin at m: for a checkpoint.
  const std::vector<Cut>& cuts() const { return cuts_; }

  /// Takes cuts as the previous ones; those made for another number of ranks are of no use and leave a cold start.
  void restore(const std::vector<Cut>& cuts);

  /// Adapts the reach of boxes to the current points, with the same owners: until the next bisection points leave the
  /// side of the cut that they were on. positions: [n][3] of the points that this rank owns. Collective. Throws
  /// MpiError.
  void refit(const ExecSpace& space, const Rows3<const double>& positions);

 private:
  /// Ranks that are divided together: [first, last).
  struct Group {
    int first, last;
    OwnedCommunicator ranks;
  };

  void bisect(const ExecSpace& space, std::size_t level, RcbReport& report);
  void publish();

  OwnedCommunicator ranks_;
  std::vector<Group> groups_;  // groups that this rank is in, the largest first
  std::vector<Cut> cuts_;      // [ranks]
  CutTree tree_;
  MedianSearch search_;
  TravellingPoints travelling_;
  std::int64_t own_weight_ = 0;  // of the points that this rank ends up with
  int own_rounds_ = 0;           // for the cut that this rank stores
};

}  // namespace percuss
