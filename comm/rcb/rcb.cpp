#include "comm/rcb/rcb.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "comm/all_reduce.hpp"
#include "comm/exchange/exchange_buffers.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

namespace {

/// (4.1) Choose a coordinate axis (xyz): the longest extent makes the sub-domains most cubic.
int choose_axis(const Survey& survey, const Cut& previous) {
  double extents[3];
  for (int k = 0; k < 3; ++k) {
    const bool is_empty = survey.highest[k] < survey.lowest[k];
    extents[k] = is_empty ? 0 : restore_coordinate(survey.highest[k]) - restore_coordinate(survey.lowest[k]);
  }
  const auto longest = static_cast<int>(std::max_element(extents, extents + 3) - extents);
  const bool keep = is_made(previous) && extents[longest] <= axis_change * extents[previous.axis];
  return keep ? previous.axis : longest;
}

/// Throws on all ranks if a point cannot be divided.
void check_points(const Survey& survey) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::uint64_t least = order_coordinate(-infinity), most = order_coordinate(infinity);
  for (int k = 0; k < 3; ++k) {
    if (survey.highest[k] < survey.lowest[k]) continue;
    if (survey.lowest[k] <= least || survey.highest[k] >= most) {
      throw RcbError(std::string("a contact point has no finite ") + "xyz"[k] + " coordinate (its motion diverged)");
    }
  }
  if (survey.lowest_weight < 1) {
    throw RcbError("a contact point has the weight " + std::to_string(survey.lowest_weight) + " (must be positive)");
  }
}

void check_and_report(const GroupSurvey& survey, RcbReport& report) {
  check_points(survey.survey);
  report.points = survey.points;
  report.weight = survey.weight;
}

/// Data that a rank sends to all others at the end.
struct CutNotice {
  Cut cut;  // of the group whose upper ranks begin with this rank
  std::int64_t weight = 0;
  std::int64_t moved = 0;
  int rounds = 0;
};

}  // namespace

Rcb::Rcb(const Communicator& ranks)
    : ranks_(OwnedCommunicator::duplicate(ranks)), cuts_(static_cast<std::size_t>(ranks.size())) {
  int first = 0, last = ranks.size();
  while (last - first > 1) {
    groups_.push_back({first, last, OwnedCommunicator::of_range(*ranks_, first, last)});
    const int middle = find_middle_rank(first, last);
    (ranks.rank() < middle ? last : first) = middle;
  }
  publish();
}

// Figure 4 of the paper. Extents and first counts come in one reduction, so (4.1) has no round of its own.
void Rcb::bisect(const ExecSpace& space, std::size_t level, RcbReport& report) {
  if (level == groups_.size()) return;
  const Communicator& group = *groups_[level].ranks;
  const int middle = find_middle_rank(groups_[level].first, groups_[level].last);
  const int lower_ranks = middle - groups_[level].first;
  Cut& cut = cuts_[static_cast<std::size_t>(middle)];

  const GroupSurvey survey = search_.survey(space, group, travelling_.points(), cut);
  if (level == 0) check_and_report(survey, report);
  const int axis = choose_axis(survey.survey, cut);                                                        // (4.1)
  const FoundCut found = search_.find_cut(space, group, travelling_.points(), survey, axis, lower_ranks);  // (4.2)
  cut = found.cut;
  report.moved += travelling_.send_far_points(space, group, cut, lower_ranks);  // (4.3)
  travelling_.receive_near_points(space, group, lower_ranks);                   // (4.4)

  if (ranks_->rank() == middle) own_rounds_ = found.rounds;
  own_weight_ = ranks_->rank() < middle ? found.lower_weight : survey.weight - found.lower_weight;
  bisect(space, level + 1, report);  // (4.5) Recurse
}

// Step (5.3): share RCB cut info with all processors. "One of which is stored by each processor".
void Rcb::share_cuts(RcbReport& report) {
  const CutNotice mine{cuts_[static_cast<std::size_t>(ranks_->rank())], own_weight_, report.moved, own_rounds_};
  std::vector<CutNotice> notices(cuts_.size());
  constexpr auto size = static_cast<int>(sizeof(CutNotice));
  wait_mpi([&] { return MPI_Allgather(&mine, size, MPI_BYTE, notices.data(), size, MPI_BYTE, ranks_->handle()); },
           "MPI_Allgather");
  std::int64_t heaviest = 0, rounds = 0;
  report.moved = 0;
  for (std::size_t m = 0; m < notices.size(); ++m) {
    cuts_[m] = notices[m].cut;
    heaviest = std::max(heaviest, notices[m].weight);
    report.moved += notices[m].moved;
    rounds += notices[m].rounds;
    report.most_rounds = std::max(report.most_rounds, notices[m].rounds);
  }
  const auto rank_count = static_cast<double>(notices.size());
  if (rank_count > 1) report.rounds_per_cut = static_cast<double>(rounds) / (rank_count - 1);
  if (report.weight > 0) {
    report.imbalance = static_cast<double>(heaviest) * rank_count / static_cast<double>(report.weight);
  }
  publish();
}

RcbReport Rcb::divide(const ExecSpace& space, const RcbPoints& points) {
  RcbReport report;
  travelling_.begin(points);
  if (groups_.empty()) {
    check_and_report(search_.survey(space, *ranks_, points, Cut{}), report);
    own_weight_ = report.weight;
  }
  bisect(space, 0, report);
  return report;
}

RcbReport Rcb::decompose(const ExecSpace& space, const RcbPoints& points) {
  RcbReport report = divide(space, points);
  share_cuts(report);
  return report;
}

void Rcb::restore(const std::vector<Cut>& cuts) {
  if (cuts.size() == cuts_.size()) {
    cuts_ = cuts;
  } else {
    std::fill(cuts_.begin(), cuts_.end(), Cut{});
  }
  publish();
}

void Rcb::publish() { tree_ = {ranks_->size(), copy_to_view("percuss::rcb_cuts", cuts_)}; }

namespace {

struct Extents {
  double low[3], high[3];
};

Extents find_extents(const ExecSpace& space, const Rows3<const double>& positions) {
  Extents extents{};
  for (int k = 0; k < 3; ++k) {
    parallel_reduce(
        "percuss::rcb_extents", RangeOf(space, 0, static_cast<int>(positions.extent(0))),
        KOKKOS_LAMBDA(const int i, double& low, double& high) {
          if (positions(i, k) < low) low = positions(i, k);
          if (positions(i, k) > high) high = positions(i, k);
        },
        Kokkos::Min<double>(extents.low[k]), Kokkos::Max<double>(extents.high[k]));
  }
  return extents;
}

}  // namespace

// One reduction: each rank speaks for the sides that it is on. Maxima, with the sign of minima turned.
void Rcb::refit(const ExecSpace& space, const Rows3<const double>& positions) {
  const Extents extents = find_extents(space, positions);
  std::vector<double> ends(2 * cuts_.size(), -std::numeric_limits<double>::infinity());
  for (const Group& group : groups_) {
    const auto middle = static_cast<std::size_t>(find_middle_rank(group.first, group.last));
    const int axis = cuts_[middle].axis;
    if (ranks_->rank() < static_cast<int>(middle)) {
      ends[2 * middle] = extents.high[axis];
    } else {
      ends[2 * middle + 1] = -extents.low[axis];
    }
  }
  all_reduce(*ranks_, Reduce::largest, ends);
  for (std::size_t m = 1; m < cuts_.size(); ++m) {
    cuts_[m].lower_end = ends[2 * m];
    cuts_[m].upper_begin = -ends[2 * m + 1];
  }
  publish();
}

}  // namespace percuss
