#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace lapidary::import {

/// Numbers distinct corners - position, uv and normal index - in the order they come.
///
/// Most positions have one kind of corner, found directly through the position, which keeps memory
/// access as coherent as the file; further kinds go through a hash table (linear probing).
class VertexTable {
 public:
  using Key = std::array<std::uint32_t, 3>;  ///< position, uv, normal

  /// Position indices are below `positions`.
  explicit VertexTable(std::size_t positions);

  /// The number of `key`, a new one if it has not come before.
  std::uint32_t number_of(const Key& key) {
    std::uint32_t& first = first_[key[0]];
    if (first == empty) return first = add(key);
    return keys_[first] == key ? first : further(key);
  }

  /// By number.
  const std::vector<Key>& keys() const { return keys_; }

 private:
  static constexpr std::uint32_t empty = 0xffffffff;

  std::uint32_t add(const Key& key);
  std::uint32_t further(const Key& key);
  std::size_t slot_of(const Key& key) const;
  void grow();

  std::vector<Key> keys_;
  std::vector<std::uint32_t> first_;  // by position
  std::vector<std::uint32_t> slots_;  // a power of two of them, at most half are taken
  std::size_t taken_ = 0;
};

}  // namespace lapidary::import
