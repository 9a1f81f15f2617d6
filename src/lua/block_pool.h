#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace lapidary::lua {

/// Small blocks of memory in sizes of 16 bytes, cut from large pieces and reused by size: a scene
/// makes and drops millions of tables and nodes, between which a general allocator would scatter
/// what stays. The caller remembers sizes, as Lua does. Pieces are freed with the pool.
class BlockPool {
 public:
  static constexpr std::size_t largest = 256;

  BlockPool() = default;
  BlockPool(const BlockPool&) = delete;
  BlockPool& operator=(const BlockPool&) = delete;

  /// `size` from 1 to `largest`; null when there is no memory.
  void* take(std::size_t size) noexcept;
  /// `block` came from `take` with a size of the same class.
  void give_back(void* block, std::size_t size) noexcept {
    const std::size_t c = size_class(size);
    free_[c] = new (block) Free{free_[c]};
  }
  /// Blocks of these sizes are interchangeable.
  static bool same_class(std::size_t a, std::size_t b) { return size_class(a) == size_class(b); }

 private:
  static constexpr std::size_t grain = 16;
  static constexpr std::size_t piece_bytes = std::size_t{1} << 18;

  struct Free {
    Free* next;
  };
  static std::size_t size_class(std::size_t size) { return (size - 1) / grain; }

  std::array<Free*, largest / grain> free_{};
  std::vector<std::unique_ptr<std::byte[]>> pieces_;
  std::byte* at_ = nullptr;
  std::byte* end_ = nullptr;
};

}  // namespace lapidary::lua
