#include "geometry/sweep_queue.h"

namespace lapidary::geometry {

void SweepQueue::spill() {
  constexpr std::size_t half = capacity / 2;
  for (std::size_t i = 0; i < half; ++i) push_far(near_keys_[i], near_values_[i], near_exits_[i]);
  for (std::size_t i = half; i < capacity; ++i) {
    near_keys_[i - half] = near_keys_[i];
    near_values_[i - half] = near_values_[i];
    near_exits_[i - half] = near_exits_[i];
  }
  near_count_ -= half;
}

void SweepQueue::refill() {
  while (!far_.empty() && near_count_ < capacity / 2) {
    std::pop_heap(far_.begin(), far_.end());
    near_keys_[near_count_] = far_.back().key;
    near_exits_[near_count_] = far_.back().exit;
    near_values_[near_count_++] = far_.back().value;
    far_.pop_back();
  }
  const auto reverse = [this](auto& part) {
    std::reverse(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(near_count_));
  };
  reverse(near_keys_);
  reverse(near_values_);
  reverse(near_exits_);
}

}  // namespace lapidary::geometry
