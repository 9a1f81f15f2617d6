#include "distributed/packed_numbers.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.h"

namespace lapidary::test {
namespace {

using distributed::ByteReader;
using distributed::Bytes;
using distributed::ByteWriter;

template <typename Number>
std::vector<Number> there_and_back(const std::vector<Number>& table, std::size_t columns,
                                   std::size_t& bytes) {
  ByteWriter writer;
  distributed::pack(std::span<const Number>(table), columns, writer);
  bytes = writer.bytes().size();
  std::vector<Number> back(table.size(), 99);
  ByteReader reader(writer.bytes());
  distributed::unpack(std::span<Number>(back), columns, reader);
  EXPECT_TRUE(reader.rest().empty());
  return back;
}

TEST(PackedNumbers, ComeBackWhateverTheyAre) {
  Random random(1);
  for (int round = 0; round < 300; ++round) {
    const std::size_t columns = 1 + random.index(11), rows = random.index(200);
    const std::uint64_t bits = random.index(65);
    const std::uint64_t mask = bits == 0 ? 0 : ~std::uint64_t{0} >> (64 - bits);
    std::vector<std::int64_t> wide(rows * columns);
    for (auto& x : wide) x = static_cast<std::int64_t>(random.bits() & mask);
    if (!wide.empty() && round % 3 == 0) {
      wide.front() = std::numeric_limits<std::int64_t>::min();
      wide.back() = std::numeric_limits<std::int64_t>::max();
    }
    std::vector<std::uint32_t> narrow(rows * columns);
    for (auto& x : narrow) x = static_cast<std::uint32_t>(random.bits() & mask);
    std::size_t bytes = 0;
    ASSERT_EQ(there_and_back(wide, columns, bytes), wide);
    ASSERT_EQ(there_and_back(narrow, columns, bytes), narrow);
  }
}

TEST(PackedNumbers, TakeTheRoomTheyNeed) {
  std::size_t bytes = 0;
  // A byte for each 64 numbers, and the first one.
  there_and_back(std::vector<std::uint32_t>(6400, 7), 1, bytes);
  EXPECT_EQ(bytes, 100u + 64u);
  // Differences of up to 2^31 on both sides need five bytes.
  Random random(2);
  std::vector<std::int64_t> noise(6400);
  for (auto& x : noise) x = static_cast<std::int64_t>(random.index(std::uint64_t{1} << 32));
  there_and_back(noise, 10, bytes);
  EXPECT_EQ(bytes, 10u * 10u + 5u * 6400u);
}

TEST(PackedNumbers, RefuseBytesThatAreNone) {
  const std::vector<std::int64_t> table(100, -5);
  ByteWriter writer;
  distributed::pack(std::span(table), 2, writer);
  std::vector<std::int64_t> back(100);
  const Bytes& whole = writer.bytes();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    ByteReader reader{std::span(whole).first(size)};
    EXPECT_THROW(distributed::unpack(std::span(back), 2, reader), Error) << size;
  }
  Bytes wrong = whole;
  wrong.front() = std::byte{9};
  ByteReader reader(wrong);
  EXPECT_THROW(distributed::unpack(std::span(back), 2, reader), Error);
}

}  // namespace
}  // namespace lapidary::test
