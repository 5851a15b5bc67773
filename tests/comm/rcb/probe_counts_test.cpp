// The parallel counting against a plain loop, over more points than a block has, not a multiple of anything.

#include "comm/rcb/probe_counts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "tests/comm/random_numbers.hpp"

namespace percuss::test {

namespace {

constexpr int n = 10'007;

/// Points on few coordinates, so that many lie exactly on a probe; random ids and weights.
struct PointsOnPlanes {
  PointsOnPlanes() {
    Random random(1);
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < 3; ++k) positions(i, k) = random.below(40) - 20 + 100 * k;
      ids(i) = random.below(1'000'000);
      weights(i) = 1 + random.below(9);
    }
  }
  AxisPoints along(int axis) const { return {{positions, ids, weights}, axis}; }
  Rows3<double> positions{"positions", n};
  Array<std::int64_t> ids{"ids", n};
  Array<int> weights{"weights", n};
};

/// Some between planes, some on them with an id, and two unused.
Probes make_probes(int axis) {
  Probes probes;
  for (int k = 0; k + 2 < probe_count; ++k) {
    const double coordinate = 3 * k - 20 + 100 * axis;
    probes.keys[k] = k % 3 == 0 ? CoordinateKey{order_coordinate(coordinate), 500'000}
                                : CoordinateKey{order_coordinate(coordinate + 0.5 * (k % 2)), first_key.id};
  }
  return probes;
}

ProbeCounts count_plainly(const AxisPoints& points, const Probes& probes) {
  ProbeCounts counts;
  for (int i = 0; i < n; ++i) {
    const CoordinateKey key = points.key(i);
    const auto bin = std::upper_bound(std::begin(probes.keys), std::end(probes.keys), key) - std::begin(probes.keys);
    BinCount& count = counts.bins[bin];
    ++count.points;
    count.weight += points.weight(i);
    count.lowest = std::min(count.lowest, key);
    count.highest = std::max(count.highest, key);
  }
  return counts;
}

void expect_equal(const ProbeCounts& found, const ProbeCounts& expected) {
  for (int k = 0; k < bin_count; ++k) {
    EXPECT_EQ(found.bins[k].points, expected.bins[k].points) << k;
    EXPECT_EQ(found.bins[k].weight, expected.bins[k].weight) << k;
    EXPECT_TRUE(found.bins[k].lowest == expected.bins[k].lowest) << k;
    EXPECT_TRUE(found.bins[k].highest == expected.bins[k].highest) << k;
  }
}

}  // namespace

TEST(PointCounter, CountsPointsBetweenProbesAndOnThem) {
  const PointsOnPlanes points;
  PointCounter counter;
  for (int axis = 0; axis < 3; ++axis) {
    const Probes probes = make_probes(axis);
    const ProbeCounts expected = count_plainly(points.along(axis), probes);
    expect_equal(counter.count(ExecSpace(), points.along(axis), n, probes), expected);
    const Survey survey = counter.survey(ExecSpace(), points.along(axis), n, probes);
    expect_equal(survey.counts, expected);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(restore_coordinate(survey.lowest[k]), -20 + 100 * k);
      EXPECT_EQ(restore_coordinate(survey.highest[k]), 19 + 100 * k);
    }
    EXPECT_EQ(survey.lowest_weight, 1);
  }
}

TEST(PointCounter, TakesThePointsOfABinInTheirOrder) {
  const PointsOnPlanes points;
  PointCounter counter;
  const Probes probes = make_probes(1);
  const ProbeCounts counts = counter.count(ExecSpace(), points.along(1), n, probes);
  for (const int bin : {0, 4, 9, bin_count - 1}) {
    const CandidateKeys taken = counter.take_bin(ExecSpace(), points.along(1), n, bin);
    const CoordinateKey begin = bin == 0 ? first_key : probes.keys[bin - 1];
    const CoordinateKey end = bin == bin_count - 1 ? last_key : probes.keys[bin];
    int place = 0;
    for (int i = 0; i < n; ++i) {
      const CoordinateKey key = points.along(1).key(i);
      if (key < begin || !(key < end)) continue;
      ASSERT_LT(place, counts.bins[bin].points);
      EXPECT_TRUE(taken.key(place) == key);
      EXPECT_EQ(taken.weight(place++), points.weights(i));
    }
    EXPECT_EQ(place, counts.bins[bin].points);
    EXPECT_EQ(counter.count_of(bin), place);
  }
}

TEST(PointCounter, TakesCandidatesOutOfCandidates) {
  const PointsOnPlanes points;
  PointCounter counter;
  const ProbeCounts wide = counter.count(ExecSpace(), points.along(0), n, make_probes(0));
  const int bin = 6;
  const CandidateKeys candidates = counter.take_bin(ExecSpace(), points.along(0), n, bin);
  const auto candidate_count = static_cast<int>(wide.bins[bin].points);
  Probes probes;
  probes.keys[0] = {wide.bins[bin].lowest.coordinate, 500'000};
  const ProbeCounts narrow = counter.count(ExecSpace(), candidates, candidate_count, probes);
  EXPECT_EQ(narrow.bins[0].points + narrow.bins[1].points, candidate_count);
  EXPECT_TRUE(narrow.bins[0].lowest == wide.bins[bin].lowest);
  const CandidateKeys lower = counter.take_bin(ExecSpace(), candidates, candidate_count, 0);
  for (int i = 0; i < counter.count_of(0); ++i) EXPECT_TRUE(lower.key(i) < probes.keys[0]);
}

TEST(PointCounter, CountsNothingWhereThereIsNothing) {
  PointCounter counter;
  const Survey survey = counter.survey(ExecSpace(), AxisPoints{}, 0, Probes{});
  EXPECT_EQ(survey.counts.bins[0].points, 0);
  EXPECT_GT(survey.lowest[0], survey.highest[0]);
}

}  // namespace percuss::test
