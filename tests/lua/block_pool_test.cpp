#include "lua/block_pool.h"

#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace lapidary::lua {
namespace {

TEST(BlockPool, BlocksNeverOverlap) {
  struct Block {
    unsigned char* data;
    std::size_t size;
    unsigned char mark;
  };
  BlockPool pool;
  std::vector<Block> blocks;
  std::mt19937 random(3);
  for (int i = 0; i < 50000; ++i) {
    if (!blocks.empty() && random() % 3 == 0) {
      std::swap(blocks[random() % blocks.size()], blocks.back());
      const Block b = blocks.back();
      for (std::size_t k = 0; k < b.size; ++k) ASSERT_EQ(b.data[k], b.mark);
      pool.give_back(b.data, b.size);
      blocks.pop_back();
    } else {
      const std::size_t size = 1 + random() % BlockPool::largest;
      auto* data = static_cast<unsigned char*>(pool.take(size));
      ASSERT_EQ(reinterpret_cast<std::uintptr_t>(data) % alignof(std::max_align_t), 0u);
      const auto mark = static_cast<unsigned char>(random());
      std::memset(data, mark, size);
      blocks.push_back({data, size, mark});
    }
  }
}

TEST(BlockPool, ReusesWhatComesBack) {
  BlockPool pool;
  void* block = pool.take(20);
  pool.give_back(block, 20);
  EXPECT_EQ(pool.take(32), block);
  EXPECT_TRUE(BlockPool::same_class(17, 32));
  EXPECT_FALSE(BlockPool::same_class(16, 17));
}

}  // namespace
}  // namespace lapidary::lua
