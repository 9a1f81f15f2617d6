#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace lapidary::geometry {

/// A list that allocates only when it holds more than `inline_capacity` elements. Not initialised:
/// T is trivial.
template <typename T, std::size_t inline_capacity>
class InlineBuffer {
 public:
  InlineBuffer() {}  // NOLINT: not defaulted, so that braces do not clear the array either
  InlineBuffer(const InlineBuffer&) = delete;
  InlineBuffer& operator=(const InlineBuffer&) = delete;

  void push(const T& element) {
    if (count_ == capacity_) grow();
    elements_[count_++] = element;
  }
  std::size_t size() const { return count_; }
  T& operator[](std::size_t i) { return elements_[i]; }
  T* begin() { return elements_; }
  T* end() { return elements_ + count_; }

 private:
  void grow() {
    if (many_.empty()) many_.assign(few_.begin(), few_.end());
    many_.resize(2 * capacity_);
    elements_ = many_.data();
    capacity_ = many_.size();
  }

  std::size_t count_ = 0;
  std::size_t capacity_ = inline_capacity;
  T* elements_ = few_.data();
  std::array<T, inline_capacity> few_;
  std::vector<T> many_;  ///< takes over from `few_` when that is full
};

}  // namespace lapidary::geometry
