// Exchanges that are repeated with the same buffers: every item arrives each time, in one message from each neighbour.

#include "comm/exchange/persistent_exchange.hpp"

#include <gtest/gtest.h>

#include <array>

#include "comm/exchange/unstructured_exchange.hpp"
#include "tests/expect_error.hpp"

namespace percuss::test {

namespace {

using Parcel = std::array<double, 3>;

/// Each rank sends to the two after it, and none to itself: 3 and 4 parcels more than its own number.
ExchangePlan plan_ring(UnstructuredExchange& exchange) {
  const int rank = exchange.ranks().rank(), size = exchange.ranks().size();
  std::vector<int> destinations;
  for (const int way : {1, 2}) {
    const int to = (rank + way) % size;
    if (to != rank && (way == 1 || size > 2))
      destinations.insert(destinations.end(), static_cast<std::size_t>(rank + 2 + way), to);
  }
  return exchange.plan(order_by_destination(destinations).to);
}

double write_value(int from, int to, std::int64_t item, int round, std::size_t k) {
  return 1000.0 * from + 100.0 * to + static_cast<double>(item) + 1e-3 * round + 1e-6 * static_cast<double>(k);
}

void fill(const ExchangePlan& plan, int rank, int round, std::vector<Parcel>& send) {
  for (const PeerRun& run : plan.to)
    for (std::int64_t i = 0; i < run.count; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        send[static_cast<std::size_t>(run.first + i)][k] = write_value(rank, run.rank, i, round, k);
}

void expect_mail(const ExchangePlan& plan, int rank, int round, const std::vector<Parcel>& received) {
  for (const PeerRun& run : plan.from)
    for (std::int64_t i = 0; i < run.count; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(received[static_cast<std::size_t>(run.first + i)][k], write_value(run.rank, rank, i, round, k));
}

std::vector<Parcel> make_parcels(std::int64_t count) { return std::vector<Parcel>(static_cast<std::size_t>(count)); }

struct PersistentExchangeTest : testing::Test {
  const Communicator world = Communicator::world();
  UnstructuredExchange exchange{world};
  const ExchangePlan plan = plan_ring(exchange);
  std::vector<Parcel> send = make_parcels(plan.send_count()), receive = make_parcels(plan.receive_count());

  void run(PersistentExchange& data, int rounds) {
    for (int round = 0; round < rounds; ++round) {
      fill(plan, world.rank(), round, send);
      data.begin();
      data.end();
      expect_mail(plan, world.rank(), round, receive);
    }
  }
};

}  // namespace

TEST_F(PersistentExchangeTest, DeliversEachTimeInOneMessageToEachNeighbour) {
  PersistentExchange data(world);
  data.prepare<Parcel>(plan, send, receive);
  run(data, 20);
  EXPECT_EQ(data.traffic().messages, 20 * static_cast<std::int64_t>(plan.to.size()));
  EXPECT_EQ(data.traffic().bytes, 20 * plan.send_count() * static_cast<std::int64_t>(sizeof(Parcel)));
}

TEST_F(PersistentExchangeTest, PreparesAgainOnlyForAnotherPlanOrOtherBuffers) {
  PersistentExchange data(world);
  for (int i = 0; i < 3; ++i) data.prepare<Parcel>(plan, send, receive);
  run(data, 2);
  EXPECT_EQ(data.preparations(), 1);
  std::vector<Parcel> elsewhere = make_parcels(plan.receive_count() + 1);
  receive.swap(elsewhere);
  data.prepare<Parcel>(plan, send, receive);
  run(data, 2);
  EXPECT_EQ(data.preparations(), 2);
  data.prepare<Parcel>({}, send, receive);
  run(data, 0);
  data.begin();
  data.end();
  EXPECT_EQ(data.preparations(), world.size() == 1 ? 2 : 3);  // alone there never was a plan
  EXPECT_EQ(data.traffic().messages, 4 * static_cast<std::int64_t>(plan.to.size()));
}

TEST_F(PersistentExchangeTest, CutsLongRunsInSeveralMessages) {
  PersistentExchange data(world, 7);  // bytes: shorter than a parcel, and not a divisor of one
  data.prepare<Parcel>(plan, send, receive);
  run(data, 3);
  std::int64_t messages = 0;
  for (const PeerRun& sent : plan.to) messages += (sent.count * static_cast<std::int64_t>(sizeof(Parcel)) + 6) / 7;
  EXPECT_EQ(data.traffic().messages, 3 * messages);
}

TEST_F(PersistentExchangeTest, MayEndWithItsObject) {
  PersistentExchange data(world);
  data.prepare<Parcel>(plan, send, receive);
  data.begin();
}

TEST_F(PersistentExchangeTest, RefusesWhatWouldMixUpMessages) {
  PersistentExchange data(world);
  data.prepare<Parcel>(plan, send, receive);
  data.begin();
  EXPECT_ERROR(data.begin(), std::logic_error, "was begun");
  EXPECT_ERROR(data.prepare<Parcel>(plan, send, receive), std::logic_error, "was prepared");
  data.end();
  const ExchangePlan own{{{world.rank(), 0, 1}}, {{world.rank(), 0, 1}}}, one_more{{{world.rank() + 1, 0, 100}}, {}};
  std::vector<Parcel> one(1), other(1);
  EXPECT_ERROR(data.prepare<Parcel>(own, one, other), std::logic_error, "has a run of the rank itself");
  EXPECT_ERROR(data.prepare<Parcel>(one_more, one, other), std::logic_error, "are too short for an exchange");
}

}  // namespace percuss::test
