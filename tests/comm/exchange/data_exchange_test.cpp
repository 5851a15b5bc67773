// Data along a plan: every item arrives once, in the order of source ranks, whatever its size and the message limit.

#include "comm/exchange/data_exchange.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "comm/exchange/unstructured_exchange.hpp"
#include "tests/comm/random_numbers.hpp"
#include "tests/expect_error.hpp"

namespace percuss::test {

namespace {

/// An item that says where it comes from.
struct Letter {
  int from, to;
  std::int64_t number;
  std::array<char, 13> text;
  friend bool operator==(const Letter&, const Letter&) = default;
};

/// Letters of one rank to random destinations, numbered; the same on every rank that asks.
std::vector<Letter> write_letters(int from, int rank_count, std::uint64_t seed) {
  Random random(seed * 1000 + static_cast<std::uint64_t>(from));
  std::vector<Letter> letters(static_cast<std::size_t>(random.below(3) == 0 ? 0 : random.below(500)));
  for (std::size_t i = 0; i < letters.size(); ++i) {
    letters[i] = {from, random.below(rank_count), static_cast<std::int64_t>(i), {}};
    letters[i].text.fill(static_cast<char>('a' + random.below(26)));
  }
  return letters;
}

/// Letters that a rank should receive: by source, then as written.
std::vector<Letter> find_mail(int me, int rank_count, std::uint64_t seed) {
  std::vector<Letter> mail;
  for (int from = 0; from < rank_count; ++from) {
    for (const Letter& letter : write_letters(from, rank_count, seed)) {
      if (letter.to == me) mail.push_back(letter);
    }
  }
  return mail;
}

struct Post {
  std::vector<Letter> sent;  // in the order of the send buffer
  ExchangePlan plan;
};

Post prepare(UnstructuredExchange& exchange, std::uint64_t seed) {
  const Communicator& ranks = exchange.ranks();
  const std::vector<Letter> letters = write_letters(ranks.rank(), ranks.size(), seed);
  std::vector<int> destinations;
  for (const Letter& letter : letters) destinations.push_back(letter.to);
  const SendOrder order = order_by_destination(destinations);
  Post post;
  for (const int i : order.items) post.sent.push_back(letters[static_cast<std::size_t>(i)]);
  post.plan = exchange.plan(order.to);
  return post;
}

}  // namespace

TEST(DataExchange, DeliversRandomMailInTheOrderOfItsSources) {
  const Communicator world = Communicator::world();
  UnstructuredExchange exchange(world);
  DataExchange data(world);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Post post = prepare(exchange, seed);
    EXPECT_EQ(data.exchange(post.plan, post.sent), find_mail(world.rank(), world.size(), seed));
  }
}

TEST(DataExchange, CutsLongRunsInSeveralMessages) {
  const Communicator world = Communicator::world();
  UnstructuredExchange exchange(world);
  DataExchange in_pieces(world, 7);  // bytes: shorter than a letter, and not a divisor of one
  DataExchange in_one(world);
  const Post post = prepare(exchange, 4);
  EXPECT_EQ(in_pieces.exchange(post.plan, post.sent), find_mail(world.rank(), world.size(), 4));
  EXPECT_EQ(in_one.exchange(post.plan, post.sent), find_mail(world.rank(), world.size(), 4));
  EXPECT_EQ(in_pieces.traffic().bytes, in_one.traffic().bytes);
  std::int64_t pieces = 0;
  for (const PeerRun& run : post.plan.to) {
    const auto bytes = run.count * static_cast<std::int64_t>(sizeof(Letter));
    if (run.rank != world.rank()) pieces += (bytes + 6) / 7;
  }
  EXPECT_EQ(in_pieces.traffic().messages, pieces);
}

TEST(DataExchange, AnswersFindTheirWayBack) {
  const Communicator world = Communicator::world();
  UnstructuredExchange exchange(world);
  DataExchange data(world);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Post post = prepare(exchange, seed);
    const std::vector<Letter> mail = data.exchange(post.plan, post.sent);
    EXPECT_EQ(data.exchange(reverse(post.plan), mail), post.sent);
  }
}

TEST(DataExchange, APlanServesItemsOfAnySizeAndAnyNumberOfTimes) {
  const Communicator world = Communicator::world();
  UnstructuredExchange exchange(world);
  DataExchange data(world);
  const Post post = prepare(exchange, 7);
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::vector<short> numbers(post.sent.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<short>(post.sent[i].number + repeat);
    const std::vector<short> received = data.exchange(post.plan, numbers);
    const std::vector<Letter> mail = find_mail(world.rank(), world.size(), 7);
    ASSERT_EQ(received.size(), mail.size());
    for (std::size_t i = 0; i < mail.size(); ++i) EXPECT_EQ(received[i], static_cast<short>(mail[i].number + repeat));
  }
}

TEST(DataExchange, PartnersOfAPlanSendAsMuchAsTheyLike) {
  const Communicator world = Communicator::world();
  UnstructuredExchange exchange(world);
  DataExchange data(world), in_pieces(world, static_cast<std::int64_t>(sizeof(Letter)));
  const Post post = prepare(exchange, 5);
  for (const int factor : {0, 1, 3}) {  // of what the plan says
    std::vector<int> counts;
    std::vector<Letter> sent;
    for (const PeerRun& run : post.plan.to) {
      counts.push_back(factor * static_cast<int>(run.count));
      for (int i = 0; i < counts.back(); ++i) sent.push_back({world.rank(), run.rank, i, {}});
    }
    std::vector<Letter> expected;
    for (const PeerRun& run : post.plan.from)
      for (int i = 0; i < factor * static_cast<int>(run.count); ++i)
        expected.push_back({run.rank, world.rank(), i, {}});
    EXPECT_EQ(data.exchange_sized(post.plan, counts, sent), expected);
    EXPECT_EQ(in_pieces.exchange_sized(post.plan, counts, sent), expected);
    EXPECT_EQ(data.exchange_sized(post.plan, counts, sent), expected);  // one right after the other
  }
}

TEST(DataExchange, ToOneselfSendsNoMessage) {
  const Communicator world = Communicator::world();
  DataExchange data(world);
  const std::vector<PeerRun> own{{world.rank(), 0, 5}};
  const std::vector<double> values{1, 2, 3, 4, 5};
  EXPECT_EQ(data.exchange(ExchangePlan{own, own}, values), values);
  EXPECT_EQ(data.traffic().messages, 0);
}

TEST(DataExchange, OfNothingIsNothing) {
  DataExchange data(Communicator::world());
  EXPECT_TRUE(data.exchange(ExchangePlan{}, std::vector<int>{}).empty());
}

TEST(DataExchange, RefusesBuffersThatAreTooShortAndASecondBegin) {
  const Communicator world = Communicator::world();
  DataExchange data(world);
  const int next = (world.rank() + 1) % world.size();
  const int previous = (world.rank() + world.size() - 1) % world.size();
  const ExchangePlan ring{{{next, 0, 3}}, {{previous, 0, 3}}};
  std::vector<int> send{1, 2, 3}, receive(3);
  EXPECT_ERROR(data.exchange(ring, std::vector<int>{1, 2}), std::logic_error, "buffers of 2 and 3 items");
  data.begin<int>(ring, send, receive);
  if (world.size() > 1) {  // messages to oneself are over at once
    EXPECT_ERROR(data.begin<int>(ring, send, receive), std::logic_error, "was begun");
  }
  data.end();
  EXPECT_EQ(receive, send);
}

TEST(DataExchange, WorkGoesOnBetweenBeginAndEnd) {
  const Communicator world = Communicator::world();
  DataExchange data(world);
  const int next = (world.rank() + 1) % world.size();
  const int previous = (world.rank() + world.size() - 1) % world.size();
  const ExchangePlan ring{{{next, 0, 100'000}}, {{previous, 0, 100'000}}};
  std::vector<double> send(100'000, world.rank()), receive(100'000, -1);
  data.begin<double>(ring, send, receive);
  world.barrier();  // every rank gets here before any message need have arrived
  data.end();
  EXPECT_EQ(receive, std::vector<double>(100'000, previous));
}

}  // namespace percuss::test
