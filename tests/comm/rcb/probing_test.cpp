// Where the median search looks next.

#include "comm/rcb/probing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace percuss::test {

namespace {

CoordinateKey key_at(double coordinate, std::int64_t id = 0) { return {order_coordinate(coordinate), id}; }

bool are_ascending(const Probes& probes) { return std::is_sorted(std::begin(probes.keys), std::end(probes.keys)); }

Bracket bracket_of(CoordinateKey lowest, CoordinateKey highest, std::int64_t points, std::int64_t target) {
  Bracket bracket;
  bracket.lowest = lowest;
  bracket.highest = highest;
  bracket.points = bracket.weight = points;
  bracket.target = target;
  return bracket;
}

}  // namespace

TEST(Probes, AroundACutHoldTheCutItselfAndReachFarOnBothSides) {
  Cut cut;
  cut.key = key_at(10, 77);
  cut.axis = 0;
  cut.spacing = 1e-3;
  const Probes probes = probe_around(cut);
  EXPECT_TRUE(are_ascending(probes));
  EXPECT_TRUE(probes.keys[probe_count / 2] == cut.key);
  const double nearest = restore_coordinate(probes.keys[probe_count / 2 + 1].coordinate) - 10;
  const double farthest = restore_coordinate(probes.keys[probe_count - 1].coordinate) - 10;
  EXPECT_LT(nearest / cut.spacing, 256 / 3.0);  // a cut that moved by less than 4 nearest leaves at most 256 points
  EXPECT_NEAR(farthest / nearest, 4096, 1e-6);  // 4^6; the probes are rounded to doubles near 10
}

TEST(Probes, AroundACutThatTravelsReachBeyondItsNextPlace) {
  Cut cut;
  cut.key = key_at(10, 77);
  cut.axis = 0;
  cut.spacing = 1e-12;
  cut.travel = 0.5;
  const Probes probes = probe_around(cut);
  EXPECT_NEAR(restore_coordinate(probes.keys[probe_count - 1].coordinate) - 10, 4 * 0.5, 1e-6);
  EXPECT_NEAR(10 - restore_coordinate(probes.keys[0].coordinate), 4 * 0.5, 1e-6);
}

TEST(Probes, AroundACutWithoutSpacingAreStillDifferentKeys) {
  Cut cut;
  cut.key = key_at(3, 1);
  const Probes probes = probe_around(cut);
  for (int k = 0; k + 1 < probe_count; ++k) EXPECT_TRUE(probes.keys[k] < probes.keys[k + 1]);
}

TEST(Probes, EvenOnesDivideTheCoordinatesEvenBeyondHalfTheRangeOfDoubles) {
  const Probes probes = probe_evenly(bracket_of(key_at(-1.6e308), key_at(1.6e308), 1000, 500));
  EXPECT_TRUE(are_ascending(probes));
  EXPECT_EQ(restore_coordinate(probes.keys[probe_count / 2].coordinate), 0.0);
  EXPECT_EQ(restore_coordinate(probes.keys[0].coordinate), -1.4e308);
}

TEST(Probes, EvenOnesDivideTheIdsOfCoincidentPoints) {
  const Probes probes = probe_evenly(bracket_of(key_at(1, 100), key_at(1, 1699), 1600, 500));
  for (int k = 0; k < probe_count; ++k) {
    EXPECT_EQ(probes.keys[k].coordinate, order_coordinate(1));
    EXPECT_NEAR(static_cast<double>(probes.keys[k].id), 100 * (k + 2), 1);
  }
}

TEST(Probes, QuantilesFollowTheWeightsOfTheSamples) {
  // Nine tenths of the weight between 0 and 1, the rest up to 1000.
  std::vector<KeySample> samples;
  for (int i = 0; i < 90; ++i) samples.push_back({key_at(i / 90.0, i), 1.0});
  for (int i = 0; i < 10; ++i) samples.push_back({key_at(100.0 * (i + 1), i), 1.0});
  std::reverse(samples.begin(), samples.end());
  const Probes probes = probe_quantiles(samples, bracket_of(key_at(0), key_at(1000, 9), 1000, 500));
  EXPECT_TRUE(are_ascending(probes));
  const auto below_one = std::count_if(std::begin(probes.keys), std::end(probes.keys),
                                       [](const CoordinateKey& key) { return key < key_at(1.0); });
  EXPECT_EQ(below_one, 13);
  EXPECT_TRUE(probes.keys[probe_count - 1] == key_at(1000, 9));
}

TEST(Spacing, IsTheMeanDistanceWhereEnoughPointsAreNotCoincident) {
  // Bins of 1000 points over a length of 1 each; in bin 5 all points coincide.
  ProbeCounts counts;
  for (int k = 0; k < bin_count; ++k) {
    counts.bins[k].points = 1000;
    counts.bins[k].lowest = key_at(k);
    counts.bins[k].highest = key_at(k == 5 ? k : k + 1, 1);
  }
  EXPECT_DOUBLE_EQ(measure_spacing(counts, 3), 1e-3);
  EXPECT_DOUBLE_EQ(measure_spacing(counts, 5), 3.0 / 3000);  // with both neighbours
}

TEST(Spacing, IsZeroIfAllPointsCoincide) {
  ProbeCounts counts;
  counts.bins[4].points = 10'000;
  counts.bins[4].lowest = key_at(2, 0);
  counts.bins[4].highest = key_at(2, 9'999);
  EXPECT_EQ(measure_spacing(counts, 4), 0);
}

TEST(Bracket, NarrowsToTheBinThatHoldsTheTarget) {
  ProbeCounts counts;
  for (int k = 0; k < bin_count; ++k) {
    counts.bins[k].points = 10;
    counts.bins[k].weight = 20;
    counts.bins[k].lowest = key_at(k);
    counts.bins[k].highest = key_at(k + 0.5);
  }
  int bin = -1;
  const Bracket narrower = narrow(bracket_of(key_at(0), key_at(20), 160, 70), counts, bin);
  EXPECT_EQ(bin, 3);
  EXPECT_EQ(narrower.target, 10);
  EXPECT_EQ(narrower.points, 10);
  EXPECT_EQ(narrower.weight, 20);
  EXPECT_TRUE(narrower.lowest == key_at(3));
}

TEST(Bracket, FindsTheCutAtItsEndsOnly) {
  Bracket at_lowest = bracket_of(key_at(1), key_at(2), 500, 0);
  EXPECT_TRUE(find_at_ends(at_lowest));
  EXPECT_TRUE(at_lowest.lowest == key_at(1));
  Bracket at_highest = bracket_of(key_at(1), key_at(2), 500, 499);
  EXPECT_TRUE(find_at_ends(at_highest));
  EXPECT_TRUE(at_highest.lowest == key_at(2));
  Bracket between = bracket_of(key_at(1), key_at(2), 500, 498);
  EXPECT_FALSE(find_at_ends(between));
}

TEST(Bracket, DoesNotTrustKeysThatAreNotThoseOfPoints) {
  Bracket bracket = bracket_of(key_at(1), key_at(2), 500, 0);
  bracket.keys_are_exact = false;
  EXPECT_FALSE(find_at_ends(bracket));
}

TEST(Bracket, DoesNotTakeAHeavyHighestPointForTheCut) {
  Bracket bracket = bracket_of(key_at(1), key_at(2), 2, 4);  // weights 2 and 3: passing 4 cuts at the heavy one, but so
  bracket.weight = 5;                                        // it does for weights 4 and 1, with another weight passed
  EXPECT_FALSE(find_at_ends(bracket));
}

}  // namespace percuss::test
