#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace lapidary::geometry {

/// A priority queue, least `key` first, for what a sweep has before it: most of the time a few
/// entries, and most of those pushed come next or never.
///
/// The nearest entries stand in an array in order; when that is full, its farther half moves to a
/// binary heap, to which whatever comes behind the array goes directly.
template <typename Entry>
class SweepQueue {
 public:
  bool empty() const { return near_count_ == 0 && far_.empty(); }
  void clear() { near_count_ = 0, far_.clear(); }

  /// Not of an empty queue; moves entries, hence not const.
  const Entry& top() {
    if (near_count_ == 0) refill();
    return near_[near_count_ - 1];
  }
  void pop() { --near_count_; }  ///< after `top`

  void push(const Entry& e) {
    if (!far_.empty() && !(e.key < far_.front().key)) return push_far(e);
    if (near_count_ == capacity) spill();
    std::size_t i = near_count_++;
    for (; i > 0 && near_[i - 1].key < e.key; --i) near_[i] = near_[i - 1];
    near_[i] = e;
  }

 private:
  static constexpr std::size_t capacity = 48;

  static bool later(const Entry& a, const Entry& b) { return a.key > b.key; }

  void push_far(const Entry& e) {
    far_.push_back(e);
    std::push_heap(far_.begin(), far_.end(), later);
  }
  void spill() {
    constexpr std::size_t half = capacity / 2;
    for (std::size_t i = 0; i < half; ++i) push_far(near_[i]);
    std::copy(near_.begin() + half, near_.begin() + capacity, near_.begin());
    near_count_ -= half;
  }
  void refill() {
    while (!far_.empty() && near_count_ < capacity / 2) {
      std::pop_heap(far_.begin(), far_.end(), later);
      near_[near_count_++] = far_.back();
      far_.pop_back();
    }
    std::reverse(near_.begin(), near_.begin() + static_cast<std::ptrdiff_t>(near_count_));
  }

  std::array<Entry, capacity> near_;  ///< the nearest last
  std::size_t near_count_ = 0;
  std::vector<Entry> far_;  ///< a heap; nothing in it comes before anything in `near_`
};

}  // namespace lapidary::geometry
