// Messages of which the receivers know only how many ranks send them.

#include "comm/exchange/counted_exchange.hpp"

#include <gtest/gtest.h>

#include "comm/all_reduce.hpp"
#include "tests/comm/random_numbers.hpp"

namespace percuss::test {

namespace {

/// What a rank sends to another: some numbers, or nothing; never to itself.
std::vector<std::int64_t> write_numbers(int from, int to, std::uint64_t seed) {
  Random random(seed * 10000 + static_cast<std::uint64_t>(from * 100 + to));
  const int count = from == to || random.below(2) == 0 ? 0 : 1 + random.below(40);
  std::vector<std::int64_t> numbers(static_cast<std::size_t>(count));
  for (std::int64_t& number : numbers) number = random.below(1 << 30);
  return numbers;
}

struct Outgoing {
  std::vector<PeerRun> to;
  std::vector<std::int64_t> items;
  int senders = 0;
};

Outgoing prepare(const Communicator& world, std::uint64_t seed) {
  Outgoing out;
  std::vector<int> fold(static_cast<std::size_t>(world.size()), 0);
  for (int to = 0; to < world.size(); ++to) {
    const std::vector<std::int64_t> numbers = write_numbers(world.rank(), to, seed);
    if (numbers.empty()) continue;
    out.to.push_back({to, static_cast<std::int64_t>(out.items.size()), static_cast<std::int64_t>(numbers.size())});
    out.items.insert(out.items.end(), numbers.begin(), numbers.end());
    fold[static_cast<std::size_t>(to)] = 1;
  }
  all_reduce(world, Reduce::sum, fold);
  out.senders = fold[static_cast<std::size_t>(world.rank())];
  return out;
}

void expect_numbers(const Communicator& world, std::uint64_t seed, const std::vector<std::int64_t>& received,
                    const std::vector<PeerRun>& from) {
  std::vector<std::int64_t> expected;
  std::vector<PeerRun> runs;
  for (int source = 0; source < world.size(); ++source) {
    const std::vector<std::int64_t> numbers = write_numbers(source, world.rank(), seed);
    if (numbers.empty()) continue;
    runs.push_back({source, static_cast<std::int64_t>(expected.size()), static_cast<std::int64_t>(numbers.size())});
    expected.insert(expected.end(), numbers.begin(), numbers.end());
  }
  EXPECT_EQ(received, expected);
  EXPECT_EQ(from, runs);
}

}  // namespace

TEST(CountedExchange, DeliversBySourceInOneMessageToEach) {
  const Communicator world = Communicator::world();
  CountedExchange exchange(world);
  std::int64_t messages = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Outgoing out = prepare(world, seed);
    std::vector<PeerRun> from;
    expect_numbers(world, seed, exchange.exchange(out.to, out.items, out.senders, from), from);
    messages += static_cast<std::int64_t>(out.to.size());
  }
  EXPECT_EQ(exchange.traffic().messages, messages);
}

TEST(CountedExchange, CutsLongRunsInSeveralMessages) {
  const Communicator world = Communicator::world();
  for (const std::int64_t limit : {7, 8, 16}) {  // bytes: also those of an item, and of two
    CountedExchange exchange(world, limit);
    const Outgoing out = prepare(world, 5);
    std::vector<PeerRun> from;
    expect_numbers(world, 5, exchange.exchange(out.to, out.items, out.senders, from), from);
  }
}

}  // namespace percuss::test
