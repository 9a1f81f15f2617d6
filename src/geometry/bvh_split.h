#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include <immintrin.h>

#include "base/parallel.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// Sorts boxes into the parts that the nodes of a hierarchy are made of. Private to bvh_*.cpp.
class BoxSplitter {
 public:
  static constexpr std::size_t width = 8;

  /// Rounded outward. Lanes 0, 1, 2: minima; 4, 5, 6: negated maxima, so that one instruction
  /// extends it; lanes 3 and 7 are no coordinates.
  using FloatBox = __m256;
  /// What reaches farther than this counts as reaching to infinity: so that neither sums nor
  /// extents overflow.
  static constexpr float farthest = 8e37f;

  /// A box with its number in lane 3.
  struct alignas(32) Item {
    FloatBox box;
    std::uint32_t number() const { return std::bit_cast<std::array<std::uint32_t, 8>>(box)[3]; }
  };

  /// Of items.
  struct Range {
    std::size_t begin, end;
    FloatBox box;
    __m128 least, greatest;  ///< of twice the centres
    std::size_t size() const { return end - begin; }
  };

  struct Parts {
    std::array<Range, width> list;
    std::size_t count = 0;
  };

  /// Every box must be bounded and not empty. Without a pool this thread does it alone.
  BoxSplitter(std::span<const Box3d> boxes, ThreadPool* pool);

  const Item& item(std::size_t index) const { return items_[index]; }
  Range range(std::size_t begin, std::size_t end) const;
  /// Reorders the items of a range of at least 2 and parts it in up to 8, by a heuristic up to a
  /// depth that is enough for all but hostile input, then by count. May be called for ranges that
  /// have no items in common by several threads at a time. Binned surface-area heuristic (Wald
  /// 2007), collapsed to width 8 (Wald, Benthin & Boulos 2008).
  Parts parts_of(const Range& range, int depth);

 private:
  struct Plane;
  struct Binning;

  std::size_t split(const Range& range, int depth);

  std::vector<Item> items_;
};

}  // namespace lapidary::geometry
