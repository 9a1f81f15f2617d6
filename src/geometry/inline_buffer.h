#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace lapidary::geometry {

/// A list that allocates only when it holds more than ever before, and than `inline_capacity`
/// elements. Not initialised: T is trivial.
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
  void clear() { count_ = 0; }
  void drop_last() { --count_; }
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  T& operator[](std::size_t i) { return elements_[i]; }
  T& back() { return elements_[count_ - 1]; }
  T* begin() { return elements_; }
  T* end() { return elements_ + count_; }
  const T* begin() const { return elements_; }
  const T* end() const { return elements_ + count_; }

 private:
  [[gnu::noinline]] void grow() {  // so that `push` is short enough to inline
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
