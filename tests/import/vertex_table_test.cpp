#include "import/vertex_table.h"

#include <map>

#include <gtest/gtest.h>

#include "support/random.h"

namespace lapidary::import {
namespace {

TEST(VertexTable, NumbersDistinctCornersInOrder) {
  test::Random random(8);
  VertexTable table(50);
  std::map<VertexTable::Key, std::uint32_t> expected;
  for (int i = 0; i < 50000; ++i) {
    const auto below = [&](std::uint64_t n) { return static_cast<std::uint32_t>(random.index(n)); };
    const VertexTable::Key key{below(50), below(40) - 1, below(20) - 1};
    const auto next = static_cast<std::uint32_t>(expected.size());
    EXPECT_EQ(table.number_of(key), expected.try_emplace(key, next).first->second);
  }
  ASSERT_EQ(table.keys().size(), expected.size());
  for (const auto& [key, number] : expected) EXPECT_EQ(table.keys()[number], key);
}

// The tip of a cone with a normal per facet: must not take quadratic time.
TEST(VertexTable, ManyCornersAtOnePositionAreFound) {
  VertexTable table(1);
  for (int round = 0; round < 2; ++round) {
    for (std::uint32_t i = 0; i < 300000; ++i) EXPECT_EQ(table.number_of({0, 0, i}), i);
  }
}

}  // namespace
}  // namespace lapidary::import
