#include "distributed/packed_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <vector>

namespace lapidary::distributed {
namespace {

constexpr std::size_t group_rows = 64;
constexpr std::size_t widest = sizeof(std::uint64_t);

/// The bytes of a group, and room for whole words that begin with its last one.
using Group = std::array<std::byte, (group_rows + 1) * widest>;

/// Small numbers for small differences of either sign.
std::uint64_t folded(std::uint64_t difference) {
  return (difference << 1) ^ (0 - (difference >> 63));
}
std::uint64_t unfolded(std::uint64_t number) {
  return (number >> 1) ^ (0 - (number & 1));
}

std::size_t bytes_of(std::uint64_t number) {
  return (static_cast<std::size_t>(std::bit_width(number)) + 7) / 8;
}

template <typename Number>
void pack_table(std::span<const Number> table, std::size_t columns, ByteWriter& to) {
  assert(table.size() % columns == 0);
  const std::size_t rows = table.size() / columns;
  std::vector<std::uint64_t> before(columns, 0);
  std::array<std::uint64_t, group_rows> differences;
  Group group;
  for (std::size_t first = 0; first < rows; first += group_rows) {
    const std::size_t size = std::min(group_rows, rows - first);
    for (std::size_t c = 0; c < columns; ++c) {
      std::uint64_t all = 0, last = before[c];
      for (std::size_t i = 0; i < size; ++i) {
        const auto number = static_cast<std::uint64_t>(table[(first + i) * columns + c]);
        differences[i] = folded(number - last);
        all |= differences[i];
        last = number;
      }
      before[c] = last;
      const std::size_t width = bytes_of(all);
      to.add(static_cast<std::uint8_t>(width));
      for (std::size_t i = 0; i < size; ++i) {
        std::memcpy(&group[i * width], &differences[i], widest);
      }
      to.append(std::span(group).first(size * width));
    }
  }
}

template <typename Number>
void unpack_table(std::span<Number> table, std::size_t columns, ByteReader& from) {
  assert(table.size() % columns == 0);
  const std::size_t rows = table.size() / columns;
  std::vector<std::uint64_t> before(columns, 0);
  Group group{};
  for (std::size_t first = 0; first < rows; first += group_rows) {
    const std::size_t size = std::min(group_rows, rows - first);
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t width = from.take<std::uint8_t>();
      if (width > widest) ByteReader::fail();
      std::ranges::copy(from.take(size * width), group.begin());
      const std::uint64_t mask = width == 0 ? 0 : ~std::uint64_t{0} >> (64 - 8 * width);
      std::uint64_t last = before[c];
      for (std::size_t i = 0; i < size; ++i) {
        std::uint64_t word = 0;
        std::memcpy(&word, &group[i * width], widest);
        last += unfolded(word & mask);
        table[(first + i) * columns + c] = static_cast<Number>(last);
      }
      before[c] = last;
    }
  }
}

}  // namespace

void pack(std::span<const std::int64_t> table, std::size_t columns, ByteWriter& to) {
  pack_table(table, columns, to);
}
void pack(std::span<const std::uint32_t> table, std::size_t columns, ByteWriter& to) {
  pack_table(table, columns, to);
}
void unpack(std::span<std::int64_t> table, std::size_t columns, ByteReader& from) {
  unpack_table(table, columns, from);
}
void unpack(std::span<std::uint32_t> table, std::size_t columns, ByteReader& from) {
  unpack_table(table, columns, from);
}

}  // namespace lapidary::distributed
