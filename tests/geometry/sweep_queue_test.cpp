#include "geometry/sweep_queue.h"

#include <set>

#include <gtest/gtest.h>

#include "support/random.h"

namespace lapidary::test {
namespace {

// Against a sorted set, with long queues and keys in any order: the nearest entries, which the
// queue keeps apart, overflow again and again.
TEST(SweepQueue, YieldsTheLeastKeyWhateverWasPushed) {
  Random random(1);
  for (int run = 0; run < 200; ++run) {
    geometry::SweepQueue queue;
    std::multiset<double> expected;
    const std::uint64_t pushes_of_ten = 5 + random.index(4);
    for (int step = 0; step < 1000; ++step) {
      if (expected.empty() || random.index(10) < pushes_of_ten) {
        const double key = static_cast<double>(random.index(500));
        queue.push(key, static_cast<std::uint64_t>(key) + 7, static_cast<float>(key) + 1.0f);
        expected.insert(key);
        continue;
      }
      const double least = *expected.begin();
      ASSERT_EQ(queue.top_key(), least) << "run " << run << " step " << step;
      EXPECT_EQ(queue.top_value(), static_cast<std::uint64_t>(least) + 7);
      EXPECT_EQ(queue.top_exit(), static_cast<float>(least) + 1.0f);
      queue.pop();
      expected.erase(expected.begin());
    }
    EXPECT_EQ(queue.empty(), expected.empty());
  }
}

}  // namespace
}  // namespace lapidary::test
