#include "src/contact/check/near_list.hpp"

#include <gtest/gtest.h>

namespace percuss {
namespace {

struct Pairs {
  int num_pairs = 0;
};

/// Fills a list with so many pairs, if there are not too many.
struct Fill {
  int found = 0;
  bool operator()(double most_pairs, Pairs& list) const {
    list.num_pairs = found;
    return found <= most_pairs;
  }
};

TEST(NearList, StandsForAllPairsWhereItLeavesOutEnough) {
  const Pairs all{100};
  NearList<Pairs> near(3);
  EXPECT_EQ(near.choose(all).num_pairs, 100);
  near.ask(true, false);
  EXPECT_TRUE(near.is_due());
  near.make(all, Fill{70});
  EXPECT_FALSE(near.is_due());
  EXPECT_EQ(near.choose(all).num_pairs, 70);
  near.ask(false, true);
  EXPECT_EQ(near.choose(all).num_pairs, 70);
  near.ask(false, false);
  EXPECT_EQ(near.choose(all).num_pairs, 100);
}

TEST(NearList, PausesWhereItLeftOutTooLittle) {
  const Pairs all{100};
  NearList<Pairs> near(3);
  near.ask(true, false);
  near.make(all, Fill{71});
  EXPECT_EQ(near.choose(all).num_pairs, 100);
  for (int turn = 0; turn < 3; ++turn) {
    near.ask(true, false);
    EXPECT_FALSE(near.is_due());
    near.make(all, Fill{1});
    EXPECT_EQ(near.choose(all).num_pairs, 100);
  }
  near.ask(false, false);  // a turn in which nobody wants it does not count
  near.ask(true, false);
  EXPECT_TRUE(near.is_due());
  near.make(all, Fill{1});
  EXPECT_EQ(near.choose(all).num_pairs, 1);
  near.forget();
  EXPECT_EQ(near.choose(all).num_pairs, 100);
}

}  // namespace
}  // namespace percuss
