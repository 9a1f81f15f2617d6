#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lapidary::geometry {

/// A priority queue, least key first, for what a sweep has before it: most of the time a few
/// entries, and most of those pushed come next or never.
///
/// The nearest entries stand in an array in order; when that is full, its farther half moves to a
/// binary heap, to which whatever comes behind the array goes directly. Keys and values lie apart:
/// an entry that is read as a whole just after its parts were written stalls the processor. An
/// entry carries a value and a number, which the queue does not look at.
class SweepQueue {
 public:
  bool empty() const { return near_count_ == 0 && far_.empty(); }
  void clear() { near_count_ = 0, far_.clear(); }

  /// Not of an empty queue; moves entries, hence not const.
  double top_key() {
    if (near_count_ == 0) refill();
    return near_keys_[near_count_ - 1];
  }
  /// After `top_key`.
  std::uint64_t top_value() const { return near_values_[near_count_ - 1]; }
  float top_exit() const { return near_exits_[near_count_ - 1]; }
  void pop() { --near_count_; }

  void push(double key, std::uint64_t value, float exit) {
    if (near_count_ == capacity) spill();
    // After that: what was moved may come before the new one.
    if (!far_.empty() && !(key < far_.front().key)) return push_far(key, value, exit);
    std::size_t i = near_count_++;
    for (; i > 0 && near_keys_[i - 1] < key; --i) {
      near_keys_[i] = near_keys_[i - 1];
      near_values_[i] = near_values_[i - 1];
      near_exits_[i] = near_exits_[i - 1];
    }
    near_keys_[i] = key;
    near_values_[i] = value;
    near_exits_[i] = exit;
  }

 private:
  static constexpr std::size_t capacity = 48;

  struct Entry {
    double key;
    std::uint64_t value;
    float exit;
    friend bool operator<(const Entry& a, const Entry& b) { return a.key > b.key; }
  };

  void push_far(double key, std::uint64_t value, float exit) {
    far_.push_back({key, value, exit});
    std::push_heap(far_.begin(), far_.end());
  }
  void spill();
  void refill();

  std::array<double, capacity> near_keys_;  ///< the nearest last
  std::array<std::uint64_t, capacity> near_values_;
  std::array<float, capacity> near_exits_;
  std::size_t near_count_ = 0;
  std::vector<Entry> far_;  ///< a heap; nothing in it comes before anything near
};

}  // namespace lapidary::geometry
