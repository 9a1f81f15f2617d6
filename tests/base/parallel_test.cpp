#include "base/parallel.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace lapidary {
namespace {

TEST(ThreadPool, VisitsEveryIndexOnce) {
  for (const int threads : {1, 2, 5}) {
    ThreadPool pool(threads);
    EXPECT_EQ(pool.threads(), threads);
    std::vector<std::atomic<int>> visits(1009);
    pool.parallel_for(visits.size(), 7, [&](IndexRange range) {
      EXPECT_LE(range.end - range.begin, 7u);
      for (std::size_t i = range.begin; i < range.end; ++i) ++visits[i];
    });
    for (const auto& v : visits) EXPECT_EQ(v, 1);
  }
}

TEST(ThreadPool, DoesNothingForNoWork) {
  ThreadPool pool(2);
  pool.parallel_for(0, 1, [](IndexRange) { FAIL(); });
}

TEST(ThreadPool, LoopsNest) {
  ThreadPool pool(2);
  std::atomic<int> sum = 0;
  pool.parallel_for(10, 1,
                    [&](IndexRange) { pool.parallel_for(10, 1, [&](IndexRange) { ++sum; }); });
  EXPECT_EQ(sum, 100);
}

TEST(ThreadPool, RethrowsWhatABodyThrows) {
  ThreadPool pool(2);
  const auto fail_at_three = [](IndexRange range) {
    if (range.begin == 3) throw std::runtime_error("three");
  };
  EXPECT_THROW(pool.parallel_for(8, 1, fail_at_three), std::runtime_error);
}

}  // namespace
}  // namespace lapidary
