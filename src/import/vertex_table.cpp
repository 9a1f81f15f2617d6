#include "import/vertex_table.h"

#include <utility>

namespace lapidary::import {
namespace {

// Every bit of the key moves about half the bits of the result (constants: Steele, Lea & Flood,
// "Fast splittable pseudorandom number generators", 2014, variant 13 of Stafford).
std::uint64_t hash(const VertexTable::Key& key) {
  const auto mix = [](std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
  };
  return mix(mix((std::uint64_t{key[0]} << 32) + key[1]) + key[2]);
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
