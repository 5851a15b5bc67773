#pragma once
// Step (4.2) of the paper: position the cut so that it divides the points in the required numbers exactly.
//
// The cut is the key of one point: the first whose predecessors, with itself, weigh more than the lower side's share.
// It is found by rounds of one reduction each. A round counts the points between 15 probes and keeps the bin that the
// cut is in; the probes of the first round lie around the previous step's cut. Once few points are left, their keys are
// gathered and the cut is picked. Every choice follows from reduced numbers, so all ranks of the group make the same.

#include <vector>

#include "comm/communicator.hpp"
#include "comm/merge_reduction.hpp"
#include "comm/rcb/cut_tree.hpp"
#include "comm/rcb/probe_counts.hpp"
#include "comm/rcb/probing.hpp"

namespace percuss {

/// Keys of several ranks in ascending order, with their weights.
struct KeyList {
  int count = 0;
  int weights[gathered_keys];
  CoordinateKey keys[gathered_keys];
  void merge(const KeyList& other);
};

/// Points of the group before a cut is sought.
struct GroupSurvey {
  Survey survey;            // over all ranks; counts along `axis`
  Cut previous;             // if it was made, points were counted around it
  Probes probes;            // what was counted against
  int axis = 0;             // along which was counted
  std::int64_t points = 0;  // of the group
  std::int64_t weight = 0;
};

struct FoundCut {
  Cut cut;
  std::int64_t lower_weight = 0;  // of the points before the cut
  int rounds = 0;                 // reductions over the group, the survey's included
};

class MedianSearch {
 public:
  /// The first round: extents and weights of the group's points and, if there is a previous cut, the counts at probes
  /// around it, in one reduction. previous: may be one that was never made. Collective over the group. Throws MpiError.
  GroupSurvey survey(const ExecSpace& space, const Communicator& group, const RcbPoints& points, const Cut& previous);

  /// Finds the cut along `axis` that gives the lower side floor(total weight * lower_ranks / ranks), or the most below
  /// that which whole points can. Collective over the group. Throws MpiError.
  FoundCut find_cut(const ExecSpace& space, const Communicator& group, const RcbPoints& points,
                    const GroupSurvey& survey, int axis, int lower_ranks);

 private:
  struct Progress;
  Probes choose_probes(Progress& progress);
  std::vector<KeySample> gather_samples(Progress& progress);
  void count_round(Progress& progress, const Probes& probes);
  void narrow_to_bin(Progress& progress, const ProbeCounts& counts);
  void take_all(Progress& progress);
  void pick_gathered(Progress& progress);

  PointCounter counter_;
  MergeReduction<Survey> reduce_survey_;
  MergeReduction<ProbeCounts> reduce_counts_;
  MergeReduction<KeyList> gather_keys_;
};

}  // namespace percuss
