// The order of keys is that of coordinates, then ids.

#include "comm/rcb/coordinate_key.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace percuss::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

}  // namespace

TEST(CoordinateKey, OrdersLikeTheCoordinatesFromMinusToPlusInfinity) {
  const std::vector<double> ascending{-infinity, -largest, -1.5,   -1, -1e-300, -smallest,
                                      0,         smallest, 1e-300, 1,  largest, infinity};
  for (std::size_t i = 0; i + 1 < ascending.size(); ++i) {
    EXPECT_LT(order_coordinate(ascending[i]), order_coordinate(ascending[i + 1])) << ascending[i];
  }
}

TEST(CoordinateKey, RestoresEveryCoordinate) {
  for (const double x : {-infinity, -largest, -1.5, -smallest, 0.0, smallest, 0.1, largest, infinity}) {
    EXPECT_EQ(restore_coordinate(order_coordinate(x)), x);
  }
}

TEST(CoordinateKey, TakesBothZerosForOne) { EXPECT_EQ(order_coordinate(-0.0), order_coordinate(0.0)); }

// Beyond which one is open: arithmetic may turn the sign of a NaN.
TEST(CoordinateKey, PutsNaNBeyondTheInfinities) {
  for (const double nan : {std::nan(""), -std::nan("")}) {
    const std::uint64_t ordered = order_coordinate(nan);
    EXPECT_TRUE(ordered > order_coordinate(infinity) || ordered < order_coordinate(-infinity));
  }
}

TEST(CoordinateKey, TellsCoincidentPointsApartById) {
  const std::uint64_t here = order_coordinate(2.0);
  EXPECT_TRUE((CoordinateKey{here, -1} < CoordinateKey{here, 0}));
  EXPECT_FALSE((CoordinateKey{here, 3} < CoordinateKey{here, 3}));
  EXPECT_TRUE((CoordinateKey{here, 7} < CoordinateKey{order_coordinate(2.5), 0}));
}

}  // namespace percuss::test
