#include "lua/block_pool.h"

#include <new>

namespace lapidary::lua {

void* BlockPool::take(std::size_t size) noexcept {
  const std::size_t c = size_class(size);
  if (Free* block = free_[c]) {
    free_[c] = block->next;
    return block;
  }
  const std::size_t bytes = (c + 1) * grain;
  if (static_cast<std::size_t>(end_ - at_) < bytes) {
    try {
      auto piece = std::make_unique_for_overwrite<std::byte[]>(piece_bytes);
      at_ = piece.get();
      end_ = at_ + piece_bytes;
      pieces_.push_back(std::move(piece));
    } catch (const std::bad_alloc&) {
      at_ = end_ = nullptr;
      return nullptr;
    }
  }
  std::byte* block = at_;
  at_ += bytes;
  return block;
}

}  // namespace lapidary::lua
