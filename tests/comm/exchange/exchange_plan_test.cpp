// The order of items in a send buffer.

#include "comm/exchange/exchange_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::test {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SendOrder, SortsByDestinationAndKeepsTheOrderWithinOne) {
  const SendOrder order = order_by_destination({5, 2, 5, 2, 9, 2});
  EXPECT_THAT(order.items, ElementsAre(1, 3, 5, 0, 2, 4));
  EXPECT_THAT(order.to, ElementsAre(PeerRun{2, 0, 3}, PeerRun{5, 3, 2}, PeerRun{9, 5, 1}));
}

TEST(SendOrder, OfNothingIsEmpty) {
  const SendOrder order = order_by_destination({});
  EXPECT_THAT(order.items, IsEmpty());
  EXPECT_THAT(order.to, IsEmpty());
}

TEST(ExchangePlan, CountsTheItemsOfAllRuns) {
  const ExchangePlan plan{{{1, 0, 4}, {7, 4, 2}}, {{0, 0, 3}}};
  EXPECT_EQ(plan.send_count(), 6);
  EXPECT_EQ(plan.receive_count(), 3);
  EXPECT_EQ(ExchangePlan{}.send_count(), 0);
}

TEST(ExchangePlan, ReversedTwiceIsItself) {
  const ExchangePlan plan{{{1, 0, 4}}, {{0, 0, 3}, {2, 3, 1}}};
  EXPECT_EQ(reverse(plan).to, plan.from);
  EXPECT_EQ(reverse(reverse(plan)).to, plan.to);
}

}  // namespace percuss::test
