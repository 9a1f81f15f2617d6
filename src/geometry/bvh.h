#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <immintrin.h>

#include "base/parallel.h"
#include "geometry/interval_events.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// A bounding volume hierarchy over boxes, eight to a node, one item to a leaf.
///
/// Boxes are kept as floats rounded outward, and lines are tested so that rounding can only let
/// more boxes through: no item whose box a line touches is ever missed.
class Bvh {
 public:
  Bvh() = default;
  /// Every box must be bounded, and none empty. How it is built: geometry/bvh_split.h.
  explicit Bvh(std::span<const Box3d> boxes);
  /// Several hierarchies in one: number k holds the items from `first[k]` up to `first[k + 1]`, or
  /// to the end. Items keep their numbers. Each has to hold something. Without a pool this thread
  /// does it alone, with the same result.
  Bvh(std::span<const Box3d> boxes, std::span<const std::uint32_t> first,
      ThreadPool* pool = nullptr);

  /// Calls `visit(item, t_max)` for the items whose boxes `line` meets at some t in [0, t_max],
  /// nearer boxes first as far as nodes allow. `visit` may lower `t_max`, and ends the walk by
  /// returning true; then so does `walk`.
  template <typename Visit>
  bool walk(const Line& line, double t_max, Visit&& visit) const {
    return walk(Slabs(line), t_max, std::forward<Visit>(visit));
  }

  /// A node of the hierarchy or one of its items, for those who walk it in an order of their own.
  class Ref {
   public:
    Ref() = default;
    bool is_item() const { return (bits_ & leaf_bit) != 0; }
    std::uint32_t item() const { return bits_ & ~leaf_bit; }
    /// For those who store it among numbers of their own.
    std::uint32_t bits() const { return bits_; }
    static Ref from_bits(std::uint32_t bits) { return Ref(bits); }

   private:
    friend class Bvh;
    explicit Ref(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_ = 0;
  };

  /// A line prepared for slab tests: its origin rounded down and up, inverse direction.
  struct Slabs {
    /// The true line may be off by `displacement` wherever it meets the boxes.
    explicit Slabs(const Line& line, double displacement = 0);
    std::array<float, 3> origin_near, origin_far, inverse;
    std::array<std::uint32_t, 3> near_row, far_row;
  };

  /// The same for a line that was prepared before.
  template <typename Visit>
  bool walk(const Slabs& slabs, double t_max, Visit&& visit) const;

  bool empty() const { return nodes_.empty(); }
  /// Whether the line comes near anything at some t in [0, t_max]; may say so of lines that do not.
  bool may_meet(const Slabs& slabs, double t_max) const {
    std::array<float, width> entry;
    return !nodes_.empty() &&
           test(nodes_[0], slabs, static_cast<float>(t_max) * (1.0f + 0x1p-22f), entry) != 0;
  }
  /// Of one of the hierarchies; not of an empty one.
  Ref root(std::size_t number = 0) const { return Ref(roots_[number]); }
  /// Calls `visit(entry, exit, child)` for the children of a node (not an item) whose boxes the
  /// line meets at some t in [0, t_max], in no order, with bounds of where.
  template <typename Visit>
  void expand(Ref node, const Slabs& slabs, double t_max, Visit&& visit) const;

  /// Calls `visit(item)` for the items whose boxes the whole line meets, t over all reals, each
  /// once, in no particular order. Also for those that it meets only when displaced by as much as
  /// its own errors allow.
  template <typename Visit>
  void walk_line(const Line& line, Visit&& visit) const;

  std::size_t bytes() const {
    return nodes_.size() * sizeof(Node) + roots_.size() * sizeof(std::uint32_t);
  }

 private:
  static constexpr std::uint32_t width = 8;
  static constexpr std::uint32_t leaf_bit = 0x80000000u;
  static constexpr std::size_t stack_size = 512;

  /// bounds[2 * axis] holds the eight minima along an axis, bounds[2 * axis + 1] the maxima. Unused
  /// children have empty boxes.
  struct alignas(32) Node {
    std::array<std::array<float, width>, 6> bounds;
    std::array<std::uint32_t, width> child;  ///< a node, or an item with `leaf_bit`
  };

  struct Entry {
    float t;
    std::uint32_t child;
  };

  /// Children met at t in [0, t_max]: a bit each, with their entry distances.
  static unsigned test(const Node& node, const Slabs& slabs, float t_max,
                       std::array<float, width>& entry, std::array<float, width>& exit);
  static unsigned test(const Node& node, const Slabs& slabs, float t_max,
                       std::array<float, width>& entry) {
    std::array<float, width> exit;
    return test(node, slabs, t_max, entry, exit);
  }

  /// The line as a ray that starts before everything, near enough to lose no digits.
  Slabs whole_line(const Line& line) const;

  struct Builder;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> roots_;  ///< the first is node 0
  Box3d bounds_;
};

inline Bvh::Slabs::Slabs(const Line& line, double displacement) {
  const float slack = static_cast<float>(displacement) * (1.0f + 0x1p-22f);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double o = line.origin[axis];
    const float nearest = static_cast<float>(o);
    // One unit in the last place to either side covers the conversion, and keeps an origin that
    // lies in a face from multiplying zero by the infinite inverse of a zero direction.
    const float margin = std::abs(nearest) * 0x1p-23f + (1e-37f + slack);
    const float d = static_cast<float>(line.direction[axis]);
    const float along = std::copysign(margin, d);
    origin_near[axis] = nearest + along;
    origin_far[axis] = nearest - along;
    inverse[axis] = 1.0f / d;
    near_row[axis] = static_cast<std::uint32_t>(2 * axis + (std::signbit(d) ? 1 : 0));
    far_row[axis] = near_row[axis] ^ 1u;
  }
}

inline unsigned Bvh::test(const Node& node, const Slabs& slabs, float t_max,
                          std::array<float, width>& entry, std::array<float, width>& exit) {
  __m256 t0 = _mm256_setzero_ps();
  __m256 t1 = _mm256_set1_ps(std::numeric_limits<float>::infinity());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const __m256 inverse = _mm256_set1_ps(slabs.inverse[axis]);
    const __m256 lo = _mm256_load_ps(node.bounds[slabs.near_row[axis]].data());
    const __m256 hi = _mm256_load_ps(node.bounds[slabs.far_row[axis]].data());
    const __m256 a =
        _mm256_mul_ps(_mm256_sub_ps(lo, _mm256_set1_ps(slabs.origin_near[axis])), inverse);
    const __m256 b =
        _mm256_mul_ps(_mm256_sub_ps(hi, _mm256_set1_ps(slabs.origin_far[axis])), inverse);
    t0 = _mm256_max_ps(t0, a);
    t1 = _mm256_min_ps(t1, b);
  }
  // Four roundings (difference, product, inverse, direction) of at most 2^-24 each.
  const __m256 shrink = _mm256_set1_ps(1.0f - 0x1p-21f), grow = _mm256_set1_ps(1.0f + 0x1p-21f);
  t0 = _mm256_mul_ps(t0, shrink);
  t1 = _mm256_min_ps(_mm256_set1_ps(t_max), _mm256_mul_ps(t1, grow));
  _mm256_storeu_ps(entry.data(), t0);
  _mm256_storeu_ps(exit.data(), t1);
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(t0, t1, _CMP_LE_OQ)));
}

template <typename Visit>
void Bvh::expand(Ref node, const Slabs& slabs, double t_max, Visit&& visit) const {
  std::array<float, width> entry, exit;
  const Node& n = nodes_[node.bits()];
  const float limit = static_cast<float>(t_max) * (1.0f + 0x1p-22f);
  for (unsigned met = test(n, slabs, limit, entry, exit); met != 0; met &= met - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(met));
    visit(entry[i], exit[i], Ref(n.child[i]));
  }
}

template <typename Visit>
bool Bvh::walk(const Slabs& slabs, double t_max, Visit&& visit) const {
  if (nodes_.empty()) return false;
  const auto limit = [&] { return static_cast<float>(t_max) * (1.0f + 0x1p-22f); };
  std::array<Entry, stack_size> stack;
  std::size_t top = 0;
  stack[top++] = {0.0f, 0};
  std::array<float, width> entry;
  while (top > 0) {
    const Entry next = stack[--top];
    if (next.t > limit()) continue;
    if (next.child & leaf_bit) {
      if (visit(next.child & ~leaf_bit, t_max)) return true;
      continue;
    }
    const Node& node = nodes_[next.child];
    const std::size_t first = top;
    for (unsigned met = test(node, slabs, limit(), entry); met != 0; met &= met - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctz(met));
      std::size_t at = top++;
      for (; at > first && stack[at - 1].t < entry[i]; --at) stack[at] = stack[at - 1];
      stack[at] = {entry[i], node.child[i]};
    }
  }
  return false;
}

template <typename Visit>
void Bvh::walk_line(const Line& line, Visit&& visit) const {
  if (nodes_.empty()) return;
  const Slabs slabs = whole_line(line);
  std::array<std::uint32_t, stack_size> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  std::array<float, width> entry;
  while (top > 0) {
    const Node& node = nodes_[stack[--top]];
    for (unsigned met = test(node, slabs, std::numeric_limits<float>::infinity(), entry); met != 0;
         met &= met - 1) {
      const std::uint32_t child = node.child[static_cast<std::size_t>(__builtin_ctz(met))];
      if (child & leaf_bit) {
        visit(child & ~leaf_bit);
        continue;
      }
      stack[top++] = child;
      const auto* bytes = reinterpret_cast<const char*>(&nodes_[child]);
      for (std::size_t i = 0; i < sizeof(Node); i += 64) _mm_prefetch(bytes + i, _MM_HINT_T0);
    }
  }
}

}  // namespace lapidary::geometry
