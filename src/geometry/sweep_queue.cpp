#include "geometry/sweep_queue.h"

namespace lapidary::geometry {

void SweepQueue::spill() {
  constexpr std::size_t half = capacity / 2;
  for (std::size_t i = 0; i < half; ++i) push_far(near_keys_[i], near_values_[i]);
  for (std::size_t i = half; i < capacity; ++i) {
    near_keys_[i - half] = near_keys_[i];
    near_values_[i - half] = near_values_[i];
  }
  near_count_ -= half;
}

void SweepQueue::refill() {
  while (!far_.empty() && near_count_ < capacity / 2) {
    std::pop_heap(far_.begin(), far_.end());
    near_keys_[near_count_] = far_.back().key;
    near_values_[near_count_++] = far_.back().value;
    far_.pop_back();
  }
  std::reverse(near_keys_.begin(), near_keys_.begin() + static_cast<std::ptrdiff_t>(near_count_));
  std::reverse(near_values_.begin(),
               near_values_.begin() + static_cast<std::ptrdiff_t>(near_count_));
}

}  // namespace lapidary::geometry
