#include "import/vertex_table.h"

#include <utility>

#include "base/mix_bits.h"

namespace lapidary::import {
namespace {

std::uint64_t hash(const VertexTable::Key& key) {
  return mix_bits(mix_bits((std::uint64_t{key[0]} << 32) + key[1]) + key[2]);
}

}  // namespace

VertexTable::VertexTable(std::size_t positions) : first_(positions, empty), slots_(64, empty) {
  keys_.reserve(positions);
}

std::uint32_t VertexTable::add(const Key& key) {
  keys_.push_back(key);
  return static_cast<std::uint32_t>(keys_.size() - 1);
}

std::uint32_t VertexTable::further(const Key& key) {
  std::size_t slot = slot_of(key);
  if (slots_[slot] != empty) return slots_[slot];
  if (2 * (taken_ + 1) > slots_.size()) {
    grow();
    slot = slot_of(key);
  }
  ++taken_;
  return slots_[slot] = add(key);
}

// Where `key` is, or the free slot where it belongs.
std::size_t VertexTable::slot_of(const Key& key) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash(key) & mask;
  while (slots_[slot] != empty && keys_[slots_[slot]] != key) slot = (slot + 1) & mask;
  return slot;
}

void VertexTable::grow() {
  const std::vector<std::uint32_t> old =
      std::exchange(slots_, std::vector<std::uint32_t>(2 * slots_.size(), empty));
  for (const std::uint32_t number : old) {
    if (number != empty) slots_[slot_of(keys_[number])] = number;
  }
}

}  // namespace lapidary::import
