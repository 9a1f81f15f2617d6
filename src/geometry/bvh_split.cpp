#include "geometry/bvh_split.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lapidary::geometry {
namespace {

using FloatBox = BoxSplitter::FloatBox;
using Range = BoxSplitter::Range;

constexpr std::size_t bins = 16;
// Deeper than this, halves by count replace the heuristic, so that the walk's stack suffices for
// any input: 7 entries a level, 24 levels here and 11 below for 2^32 items.
constexpr int heuristic_depth = 24;
constexpr float infinite = std::numeric_limits<float>::infinity();

/// A float that is at most x, within the farthest.
float rounded_down(double x) {
  constexpr double far = BoxSplitter::farthest;
  if (!(x > -far)) return -BoxSplitter::farthest;
  const float f = static_cast<float>(std::min(x, far));
  if (static_cast<double>(f) <= x) return f;
  // One step down. Past zero is the least of all negative floats.
  const auto bits = std::bit_cast<std::uint32_t>(f);
  return std::bit_cast<float>(f > 0.0f ? bits - 1 : f < 0.0f ? bits + 1 : 0x80000001u);
}

FloatBox empty_box() {
  return _mm256_set1_ps(BoxSplitter::farthest);
}

FloatBox joined(FloatBox a, FloatBox b) {
  return _mm256_min_ps(a, b);
}

/// Twice the centre.
__m128 centre(FloatBox box) {
  return _mm256_castps256_ps128(box) - _mm256_extractf128_ps(box, 1);
}

__m128 extent(FloatBox box) {
  return -(_mm256_castps256_ps128(box) + _mm256_extractf128_ps(box, 1));
}

/// Half of the surface, in units of which the box's own measure is 1 / `scale`.
float half_area(FloatBox box, float scale) {
  const __m128 e = extent(box) * _mm_set1_ps(scale);
  const __m128 products = e * _mm_permute_ps(e, _MM_SHUFFLE(3, 0, 2, 1));
  return products[0] + products[1] + products[2];
}

/// A unit in which no area overflows.
float scale_of(FloatBox box) {
  const __m128 e = extent(box);
  return 1.0f / std::max({e[0], e[1], e[2], 1e-37f});
}

struct Bin {
  FloatBox box = empty_box();
  std::size_t count = 0;
};
using Bins = std::array<std::array<Bin, bins>, 3>;

float cost(FloatBox box, std::size_t count, float scale) {
  return count == 0 ? 0.0f : half_area(box, scale) * static_cast<float>(count);
}

}  // namespace

struct BoxSplitter::Plane {
  std::size_t axis = 0;
  int bin = 0;  ///< the first of the right side
  float cost = infinite;

  void improve(const std::array<Bin, bins>& along, std::size_t along_axis, float scale) {
    std::array<float, bins> left_cost;
    FloatBox box = empty_box();
    std::size_t count = 0, total = 0;
    for (std::size_t b = 0; b + 1 < bins; ++b) {
      box = joined(box, along[b].box), total += along[b].count;
      left_cost[b + 1] = geometry::cost(box, total, scale);
    }
    total += along[bins - 1].count;
    box = empty_box();
    for (std::size_t b = bins - 1; b > 0; --b) {
      box = joined(box, along[b].box), count += along[b].count;
      if (count == 0 || count == total) continue;
      const float both = left_cost[b] + geometry::cost(box, count, scale);
      if (both < cost) *this = {along_axis, static_cast<int>(b), both};
    }
  }
};

/// In which bin centres are, along all axes.
struct BoxSplitter::Binning {
  explicit Binning(const Range& r) : least(r.least) {
    const __m128 reach = r.greatest - r.least;
    const __m128 some = _mm_cmp_ps(reach, _mm_set1_ps(1e-36f), _CMP_GT_OQ);
    // A hair less, so that the greatest is in the last bin.
    per_unit = _mm_and_ps(some, _mm_set1_ps(bins * (1.0f - 0x1p-20f)) / reach);
  }
  __m128i operator()(FloatBox box) const {
    return _mm_cvttps_epi32((centre(box) - least) * per_unit);
  }
  __m128 least, per_unit;
};

BoxSplitter::BoxSplitter(std::span<const Box3d> boxes, ThreadPool* pool) : items_(boxes.size()) {
  constexpr std::size_t grain = std::size_t{1} << 14;
  parallel_for(pool, boxes.size(), grain, [&](IndexRange piece) {
    for (std::size_t i = piece.begin; i < piece.end; ++i) {
      const Vec3d low = boxes[i].min, high = boxes[i].max;
      const auto number = std::bit_cast<float>(static_cast<std::uint32_t>(i));
      items_[i].box =
          _mm256_setr_ps(rounded_down(low.x), rounded_down(low.y), rounded_down(low.z), number,
                         rounded_down(-high.x), rounded_down(-high.y), rounded_down(-high.z), 0);
    }
  });
}

Range BoxSplitter::range(std::size_t begin, std::size_t end) const {
  Range r{begin, end, empty_box(), _mm_set1_ps(infinite), _mm_set1_ps(-infinite)};
  for (std::size_t i = begin; i < end; ++i) {
    const FloatBox box = items_[i].box;
    const __m128 at = centre(box);
    r.box = joined(r.box, box);
    r.least = _mm_min_ps(r.least, at);
    r.greatest = _mm_max_ps(r.greatest, at);
  }
  return r;
}

/// The index that parts `r`'s items after reordering them.
std::size_t BoxSplitter::split(const Range& r, int depth) {
  Plane best;
  const Binning binning(r);
  if (depth < heuristic_depth) {
    Bins filled;
    for (std::size_t i = r.begin; i < r.end; ++i) {
      const FloatBox box = items_[i].box;
      const __m128i at = binning(box);
      const auto add = [box](Bin& bin) { bin.box = joined(bin.box, box), ++bin.count; };
      add(filled[0][static_cast<std::size_t>(_mm_extract_epi32(at, 0))]);
      add(filled[1][static_cast<std::size_t>(_mm_extract_epi32(at, 1))]);
      add(filled[2][static_cast<std::size_t>(_mm_extract_epi32(at, 2))]);
    }
    const float scale = scale_of(r.box);
    for (std::size_t axis = 0; axis < 3; ++axis) best.improve(filled[axis], axis, scale);
  }
  if (std::isinf(best.cost)) return r.begin + r.size() / 2;
  // Without a branch, which would be guessed wrong half of the time.
  std::size_t middle = r.begin;
  for (std::size_t i = r.begin; i < r.end; ++i) {
    const Item item = items_[i];
    const auto at = std::bit_cast<std::array<int, 4>>(binning(item.box));
    items_[i] = items_[middle];
    items_[middle] = item;
    middle += at[best.axis] < best.bin ? 1 : 0;
  }
  return middle;
}

/// In two, the widest first, until there are eight.
BoxSplitter::Parts BoxSplitter::parts_of(const Range& range, int depth) {
  Parts parts;
  if (range.size() <= width) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      parts.list[parts.count++] = this->range(i, i + 1);
    }
    return parts;
  }
  const float scale = scale_of(range.box);
  parts.list[parts.count++] = range;
  while (parts.count < width) {
    const auto all = std::span(parts.list).first(parts.count);
    const auto size = [scale](const Range& r) {
      return r.size() > 1 ? half_area(r.box, scale) : -1.0f;
    };
    const auto widest = std::ranges::max_element(all, {}, size);
    const Range whole = *widest;
    const std::size_t middle = split(whole, depth);
    *widest = this->range(whole.begin, middle);
    parts.list[parts.count++] = this->range(middle, whole.end);
  }
  return parts;
}

}  // namespace lapidary::geometry
