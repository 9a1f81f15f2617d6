#include "distributed/dealer.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace lapidary::test {
namespace {

using distributed::Dealer;
using film::PassRange;
using film::PassSet;
using Bounds = Dealer::Bounds;
using Clock = Dealer::Clock;

constexpr Clock::time_point start{};

Clock::time_point after(double seconds) {
  return start +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

TEST(Dealer, DealsLowestFirstAndFillsGaps) {
  PassSet done;
  done.add(PassRange{4, 8});
  done.add(PassRange{16, 20});
  Dealer dealer(2, 4, done);
  const Bounds bounds{.end = 28, .end_of_work = 28, .most_blocks = 100};
  EXPECT_EQ(dealer.deal(0, bounds, start), PassRange(0, 4));
  EXPECT_EQ(dealer.deal(1, bounds, start), PassRange(8, 12)) << "a quarter of what is left";
  EXPECT_EQ(dealer.deal(1, bounds, start), PassRange(12, 16));
  EXPECT_EQ(dealer.deal(0, bounds, start), PassRange(20, 24));
  EXPECT_EQ(dealer.deal(0, bounds, start), PassRange(24, 28));
  EXPECT_EQ(dealer.deal(1, bounds, start), std::nullopt);
  EXPECT_EQ(dealer.load(0), 3);
  EXPECT_EQ(dealer.load(1), 2);
}

TEST(Dealer, MakesRunsSmallTowardsTheEnd) {
  Dealer dealer(2, 4, {});
  const Bounds bounds{.end = 400, .end_of_work = 400, .most_blocks = 10};
  std::uint32_t before = 0, largest = 100;
  while (const auto run = dealer.deal(0, bounds, start)) {
    ASSERT_EQ(run->begin, before);
    ASSERT_LE(run->size(), largest) << "never larger than the one before";
    largest = run->size();
    before = run->end;
  }
  EXPECT_EQ(before, 400u);
  EXPECT_EQ(largest, 4u);

  Dealer coarse(2, 4, {});
  const Bounds no_less{.end = 400, .end_of_work = 400, .least_blocks = 3, .most_blocks = 10};
  std::uint32_t least = 400;
  for (auto run = coarse.deal(0, no_less, start); run; run = coarse.deal(0, no_less, start)) {
    if (run->end < 400) least = std::min(least, run->size());
  }
  EXPECT_EQ(least, 12u) << "rank 0 can take no more films than so many";
}

TEST(Dealer, EndsRunsWithTheEpoch) {
  Dealer dealer(1, 4, {});
  const Bounds bounds{
      .end = 64, .end_of_work = 1 << 20, .most_blocks = 1000, .epochs = Bounds::Epochs::are_ends};
  for (const PassRange expected : {PassRange{0, 8}, {8, 16}, {16, 32}, {32, 64}}) {
    EXPECT_EQ(dealer.deal(0, bounds, start), expected);
  }
  EXPECT_EQ(dealer.deal(0, bounds, start), std::nullopt);
}

TEST(Dealer, GivesAwayWhatASlowRankHasNotBegun) {
  Dealer dealer(2, 4, {});
  const Bounds bounds{.end = 12, .end_of_work = 12};
  dealer.deal(0, bounds, start);
  dealer.deal(0, bounds, start);
  dealer.deal(1, bounds, start);
  EXPECT_EQ(dealer.done(1, {8, 12}, PassRange{8, 12}), std::vector<int>());
  const auto shared = dealer.share(1, 1.0, after(0.5));
  ASSERT_TRUE(shared);
  EXPECT_EQ(shared->run, PassRange(4, 8));
  EXPECT_EQ(shared->from, 0);
  EXPECT_EQ(shared->means, Dealer::Shared::Means::instead_of_it);
  EXPECT_EQ(dealer.load(0), 1);
  EXPECT_EQ(dealer.load(1), 1);
  // The running one is left to its rank for a while.
  dealer.done(1, {4, 8}, PassRange{4, 8});
  EXPECT_FALSE(dealer.share(1, 1.0, after(3)));
  const auto doubled = dealer.share(1, 1.0, after(10));
  ASSERT_TRUE(doubled);
  EXPECT_EQ(doubled->run, PassRange(0, 4));
  EXPECT_EQ(doubled->means, Dealer::Shared::Means::beside_it);
  EXPECT_FALSE(dealer.share(1, 1.0, after(1000))) << "it has all";
  EXPECT_EQ(dealer.done(1, {0, 4}, PassRange{0, 4}), std::vector<int>{0});
  EXPECT_EQ(dealer.load(0), 0);
  EXPECT_EQ(dealer.done(0, {0, 4}, PassRange{0, 4}), std::nullopt) << "known already";
}

TEST(Dealer, DealsAgainWhatIsCalledBack) {
  Dealer dealer(1, 4, {});
  const Bounds bounds{.end = 100, .end_of_work = 1000, .most_blocks = 4};
  EXPECT_EQ(dealer.deal(0, bounds, start), PassRange(0, 16));
  EXPECT_EQ(dealer.deal(0, bounds, start), PassRange(16, 32));
  EXPECT_EQ(dealer.done(0, {0, 16}, PassRange{0, 8}), std::vector<int>()) << "not to its end";
  dealer.recall();
  EXPECT_EQ(dealer.load(0), 0);
  EXPECT_EQ(dealer.deal(0, bounds, start), PassRange(8, 24));
  // One that was asked before comes late, and has some of it.
  EXPECT_EQ(dealer.done(0, {16, 32}, PassRange{16, 32}), std::vector<int>());
  EXPECT_EQ(dealer.done(0, {8, 24}, PassRange{8, 24}), std::nullopt);
  EXPECT_EQ(dealer.deal(0, bounds, start), PassRange(8, 16));
}

// Ranks of very different speed, some of which die: all passes come, each counted once.
TEST(Dealer, ComesToTheEndWhateverRanksDo) {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    const int ranks = 2 + static_cast<int>(random.index(5));
    Dealer dealer(ranks, 4, {});
    const auto end = static_cast<std::uint32_t>(4 * (1 + random.index(60)));
    const Bounds bounds{.end = end,
                        .end_of_work = end,
                        .most_blocks = static_cast<std::uint32_t>(1 + random.index(9))};
    std::vector<std::vector<PassRange>> queues(static_cast<std::size_t>(ranks));
    std::uint64_t counted = 0;
    double time = 0;
    for (int step = 0; dealer.done().first_missing() < end; ++step) {
      ASSERT_LT(step, 100000);
      time += 1;
      for (int rank = 0; rank < ranks; ++rank) {
        auto& queue = queues[static_cast<std::size_t>(rank)];
        if (dealer.load(rank) == 0) {
          if (const auto run = dealer.deal(rank, bounds, after(time))) {
            queue.push_back(*run);
          } else if (const auto shared = dealer.share(rank, 1.0, after(time))) {
            queue.push_back(shared->run);
          }
        }
        const bool is_dead = rank > 0 && rank % 2 == round % 2;
        if (is_dead || queue.empty() || random.index(3) != 0) continue;
        const PassRange run = queue.front();
        queue.erase(queue.begin());
        if (dealer.done(rank, run, run)) counted += run.size();
      }
    }
    EXPECT_EQ(counted, end);
  }
}

}  // namespace
}  // namespace lapidary::test
