#pragma once
// Whether candidate pairs may be used again: a bound on the motion since the search that found them.

#include <optional>

#include "comm/merge_reduction.hpp"
#include "src/contact/check/check_space.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {

class ReuseBound {
 public:
  /// enabled: whether pairs may be used again at all. The share outlives this. Collective, as are all calls.
  ReuseBound(const Communicator& ranks, const SurfaceShare& share, bool enabled);

  /// The share is another now: the next step searches.
  void redefine();

  /// Measures all that this step may request, in one reduction over many ranks; on one rank what is requested is
  /// measured when it is. Until leave_step(), all questions are about this motion. Collective.
  void enter_step(const SurfaceMotion& motion);
  void leave_step() { ways_.reset(); }

  /// Whether the pairs of the last search still hold all that the check could accept in this step.
  bool covers(const SurfaceMotion& motion);

  /// Whether no contact node, and none behind a face, is farther from its place at the last restart_near(), in this
  /// step, than that allowed. Then covers() holds as well.
  bool covers_near(const SurfaceMotion& motion) const;

  /// Largest way of a contact node in this step, and of one behind a face [length].
  double find_way(const SurfaceMotion& motion) const;
  /// No way is longer where covers_near() holds.
  double near_way() const { return 2 * near_travel_; }

  /// Starts the travel of the near pairs at this step's positions, where covers() holds or restart() was called.
  NearWay restart_near(const SurfaceMotion& motion);

  /// Starts again at this step's positions; returns the margin by which capture boxes must be widened [length]. wide:
  /// also where pairs are not reused, for other users of the margin.
  double restart(const SurfaceMotion& motion, bool wide = false);

  /// The last search, so that it can be done again: its margin, positions and velocities. Collective.
  void archive(CheckpointArchive& archive, const ChunkRows& contact_nodes);

  /// Whether there was a search; its margin [length], step, and rows of this rank's contact nodes.
  bool is_valid() const { return valid_; }
  double margin() const { return margin_; }
  double dt() const { return dt_; }
  const Rows3<double>& origin() const { return origin_; }
  const Rows3<double>& velocity() const { return velocity_; }

  /// Mean of the shortest edges of the searched faces, of beams where these alone touch [length].
  double find_mean_edge(const SurfaceMotion& motion) const;

 private:
  double find_mean(const ExactSum& edges) const;
  /// Largest ways of nodes in this step, on all ranks: from the places of the last restart_near(), of the last search
  /// and of the pairs that can come near; in the step alone.
  struct Ways {
    double near = 0, travel = 0, first = 0, step = 0;
  };
  /// Sums at the begin of a search.
  struct SearchSums {
    double move = 0;  // largest of a contact node in the step
    ExactSum edges;

    void merge(const SearchSums& other) {
      move = other.move > move ? other.move : move;
      edges.merge(other.edges);
    }
  };

  /// The largest of all ranks.
  double find_largest(double value) const;
  double find_travel_here(const SurfaceMotion& motion) const;
  double find_step_here(const SurfaceMotion& motion) const;
  ExactSum sum_edges_here(const SurfaceMotion& motion) const;
  double find_distance_here(const SurfaceMotion& motion, const Rows3<double>& origin) const;
  void store_watched(const SurfaceMotion& motion, const Rows3<double>& origin) const;

  Communicator ranks_;
  const SurfaceShare& share_;
  bool enabled_;
  MergeReduction<SearchSums> sum_;
  std::optional<Ways> ways_;  // of the step that was entered
  bool valid_ = false;
  double margin_ = 0;
  double dt_ = 0;
  Rows3<double> origin_, velocity_;  // at the last search
  double travel_ = 0;                // since then, as covers() found it last
  // Places of the nodes of SurfaceShare::watched_list: at the last restart_near(), and when the pairs that can come
  // near before the next search were requested. Also the travel allowed from there; 0: no list is valid.
  double near_travel_ = 0, first_travel_ = 0;
  Rows3<double> near_origin_, first_origin_;
};

/// Lists of near pairs between two searches a given number of steps apart, where displacements are equal from step to
/// step.
struct PlannedLists {
  NearWay way;       // none: none are made
  double steps = 1;  // for which a list serves
};
PlannedLists plan_near_lists(double margin, double steps_per_search);

}  // namespace percuss
