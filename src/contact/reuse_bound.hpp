#pragma once
// Whether candidate pairs may be used again: a bound on the motion since the search that found them.

#include "comm/merge_reduction.hpp"
#include "src/contact/surface_share.hpp"
#include "src/output/checkpoint_archive.hpp"

namespace percuss {

class ReuseBound {
 public:
  /// enabled: whether pairs may be used again at all. The share outlives this. Collective, as are all calls.
  ReuseBound(const Communicator& ranks, const SurfaceShare& share, bool enabled);

  /// The share is another now: the next step searches.
  void redefine();

  /// Whether the pairs of the last search still hold all that the check could accept in this step.
  bool covers(const SurfaceMotion& motion) const;

  /// Starts anew at this step's places; returns the margin by which capture boxes must be widened [length]. wide: also
  /// where pairs are not used again, for what else asks for them.
  double restart(const SurfaceMotion& motion, bool wide = false);

  /// The last search, so that it can be done again: its margin, places and velocities. Collective.
  void archive(CheckpointArchive& archive, const ChunkRows& contact_nodes);

  /// Whether there was a search; its margin [length], step, and rows of this rank's contact nodes.
  bool is_valid() const { return valid_; }
  double margin() const { return margin_; }
  double dt() const { return dt_; }
  const Rows3<double>& origin() const { return origin_; }
  const Rows3<double>& velocity() const { return velocity_; }

  /// Mean of the shortest edges of the searched faces [length].
  double find_mean_edge(const SurfaceMotion& motion) const;

 private:
  double find_largest(double value) const;

  Communicator ranks_;
  const SurfaceShare& share_;
  bool enabled_;
  MergeReduction<ExactSum> sum_;
  bool valid_ = false;
  double margin_ = 0;
  double dt_ = 0;
  Rows3<double> origin_, velocity_;  // at the last search
};

}  // namespace percuss
