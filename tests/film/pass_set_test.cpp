#include "film/pass_set.h"

#include <set>

#include <gtest/gtest.h>

#include "support/random.h"

namespace lapidary::film {
namespace {

using test::Random;

constexpr std::uint32_t most = 40;

std::set<std::uint32_t> numbers(const PassSet& passes) {
  std::set<std::uint32_t> all;
  for (const PassRange& range : passes.ranges()) {
    for (std::uint32_t p = range.begin; p < range.end; ++p) all.insert(p);
  }
  return all;
}

/// Random passes, one by one and in ranges, and the same as plain numbers.
std::pair<PassSet, std::set<std::uint32_t>> random_passes(Random& random) {
  PassSet passes;
  std::set<std::uint32_t> expected;
  for (int i = 0; i < 8; ++i) {
    const auto begin = static_cast<std::uint32_t>(random.index(most));
    const auto end = begin + static_cast<std::uint32_t>(random.index(7));
    const auto at = expected.lower_bound(begin);
    if (at != expected.end() && *at < end) continue;
    passes.add(PassRange{begin, end});
    for (std::uint32_t p = begin; p < end; ++p) expected.insert(p);
  }
  return {passes, expected};
}

TEST(PassSet, IsASetOfNumbers) {
  Random random(1);
  for (int round = 0; round < 2000; ++round) {
    const auto [passes, expected] = random_passes(random);
    ASSERT_EQ(numbers(passes), expected);
    ASSERT_EQ(passes.count(), expected.size());
    for (std::size_t i = 1; i < passes.ranges().size(); ++i) {
      ASSERT_LT(passes.ranges()[i - 1].end, passes.ranges()[i].begin) << "ranges touch";
    }
    for (std::uint32_t from = 0; from < most; from += 5) {
      std::uint32_t missing = from;
      while (expected.contains(missing)) ++missing;
      ASSERT_EQ(passes.first_missing(from), missing);
      std::set<std::uint32_t> gaps;
      for (std::uint32_t p = 0; p < from; ++p) {
        if (!expected.contains(p)) gaps.insert(p);
      }
      ASSERT_EQ(numbers(passes.gaps_before(from)), gaps);
    }
    ASSERT_EQ(parse_pass_set(to_text(passes)), passes) << to_text(passes);
  }
}

TEST(PassSet, KnowsWhatItSharesWithAnother) {
  Random random(2);
  int disjoint = 0;
  for (int round = 0; round < 4000; ++round) {
    auto [a, as] = random_passes(random);
    auto [b, bs] = random_passes(random);
    if (round % 2 == 0) b = a.gaps_before(most), bs = numbers(b);
    std::set<std::uint32_t> both = as;
    both.insert(bs.begin(), bs.end());
    const bool overlap = both.size() < as.size() + bs.size();
    ASSERT_EQ(a.overlaps(b), overlap);
    ASSERT_EQ(b.overlaps(a), overlap);
    if (overlap) continue;
    ++disjoint;
    PassSet sum = a, other = b;
    sum.add(b), other.add(a);
    ASSERT_EQ(numbers(sum), both);
    ASSERT_EQ(sum, other);
  }
  EXPECT_GT(disjoint, 1000);
}

TEST(PassSet, IsReadFromItsOwnTextAlone) {
  EXPECT_EQ(to_text(PassSet(PassRange{0, 16})), "0-16");
  EXPECT_TRUE(parse_pass_set("")->is_empty());
  for (const char* text : {"0", "0-", "-3", "4-4", "5-4", "0-4,4-8", "4-8,0-2", "0-4,", ",0-4",
                           "0-4 ", "0-4;8-9", "0-4294967296", "a-b", "0--4"}) {
    EXPECT_FALSE(parse_pass_set(text)) << text;
  }
}

}  // namespace
}  // namespace lapidary::film
