// Packs do in every lane what the scalar functions do: the contract that lets physics be written once.

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/simd.hpp"

namespace percuss::test::simd_test {
namespace {

template <class Scalar>
class Packs : public testing::Test {
 protected:
  static constexpr int width = pack_size<Scalar>;

  /// Lanes that differ, in memory that is aligned to a pack.
  struct Lanes {
    alignas(64) Scalar value[width];
    Pack<Scalar> pack() const { return load_pack(value); }
  };

  static Lanes make_rising() {
    Lanes lanes;
    for (int i = 0; i < width; ++i) lanes.value[i] = Scalar(0.75) + Scalar(i);
    return lanes;
  }
  static Lanes make_falling() {
    Lanes lanes;
    for (int i = 0; i < width; ++i) lanes.value[i] = Scalar(width) - Scalar(i);
    return lanes;
  }
  static Lanes store(const Pack<Scalar>& pack) {
    Lanes lanes;
    store_pack(lanes.value, pack);
    return lanes;
  }
};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(Packs, Scalars);

TYPED_TEST(Packs, LoadAndStoreKeepTheOrderOfLanes) {
  const auto a = this->make_rising();
  const auto stored = this->store(a.pack());
  for (int i = 0; i < this->width; ++i) EXPECT_EQ(stored.value[i], a.value[i]);
}

TYPED_TEST(Packs, SelectChoosesLaneByLane) {
  // Every pattern of "the first n lanes, or all but them": n = 0 and n = width are none and all.
  const auto a = this->make_rising();
  const auto b = this->make_falling();
  for (int n = 0; n <= this->width; ++n) {
    const auto limit = Pack<TypeParam>(TypeParam(n) + TypeParam(0.5));
    const auto first = this->store(select(a.pack() < limit, a.pack(), b.pack()));
    const auto others = this->store(select(limit < a.pack(), a.pack(), b.pack()));
    for (int i = 0; i < this->width; ++i) {
      EXPECT_EQ(first.value[i], i < n ? a.value[i] : b.value[i]) << "lane " << i << ", first " << n;
      EXPECT_EQ(others.value[i], i < n ? b.value[i] : a.value[i]) << "lane " << i << ", all but the first " << n;
    }
  }
}

TYPED_TEST(Packs, LargerAndSmallerAreThoseOfTheScalar) {
  const auto a = this->make_rising();
  const auto b = this->make_falling();
  const auto most = this->store(larger(a.pack(), b.pack()));
  const auto least = this->store(smaller(a.pack(), b.pack()));
  for (int i = 0; i < this->width; ++i) {
    EXPECT_EQ(most.value[i], larger(a.value[i], b.value[i]));
    EXPECT_EQ(least.value[i], smaller(a.value[i], b.value[i]));
  }
}

TYPED_TEST(Packs, AnyIsTrueFromTheFirstLaneOn) {
  const auto a = this->make_rising();
  for (int n = 0; n <= this->width; ++n) {
    EXPECT_EQ(any(a.pack() < Pack<TypeParam>(TypeParam(n) + TypeParam(0.5))), n > 0);
  }
}

TYPED_TEST(Packs, SquareRootsAreRoundedAsTheScalarOnes) {
  const auto a = this->make_rising();
  const auto root = this->store(square_root(a.pack()));
  for (int i = 0; i < this->width; ++i) EXPECT_EQ(root.value[i], std::sqrt(a.value[i]));
}

}  // namespace
}  // namespace percuss::test::simd_test
