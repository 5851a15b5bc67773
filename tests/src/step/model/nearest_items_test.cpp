// The nearest of many places, against a look at all of them.

#include "src/step/model/nearest_items.hpp"

#include <gtest/gtest.h>

#include "tests/random.hpp"

namespace percuss::test {
namespace {

Nearest look_at_all(const std::vector<Item>& items, const Vec3& place) {
  Nearest nearest;
  for (const Item& item : items) {
    double score = 0;
    for (std::size_t k = 0; k < 3; ++k) score += (place[k] - item.place[k]) * (place[k] - item.place[k]);
    nearest.merge({score, item.number});
  }
  return nearest;
}

}  // namespace

TEST(NearestItems, AreThoseOfAllAndTheLowestAmongEquals) {
  RandomIndex random;
  const auto pick = [&] { return static_cast<double>(random.below(9)); };  // on a lattice: many are equally near
  for (const std::size_t count : {1U, 2U, 3U, 50U, 700U}) {
    std::vector<Item> items;
    for (std::size_t i = 0; i < count; ++i)
      items.push_back({{pick(), pick(), 0.1 * pick()}, static_cast<std::int64_t>((i * 7919) % 1009)});
    const NearestItems tree(items);
    for (int i = 0; i < 200; ++i) {
      const Vec3 place{0.5 * pick(), pick() - 2, 0.1 * pick()};
      const Nearest expected = look_at_all(items, place), found = tree.find(place);
      EXPECT_EQ(found.score, expected.score);
      EXPECT_EQ(found.number, expected.number);
    }
  }
}

TEST(NearestItems, OfNoneIsNone) { EXPECT_EQ(NearestItems({}).find({0, 0, 0}).score, Nearest{}.score); }

}  // namespace percuss::test
