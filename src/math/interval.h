#pragma once

#include "math/constants.h"
#include "math/vec.h"

namespace lapidary {

/// A closed interval of the real line; empty when min > max.
struct Interval {
  double min = infinity;
  double max = -infinity;

  static constexpr Interval all() { return {-infinity, infinity}; }

  constexpr bool empty() const { return !(min <= max); }
  constexpr bool contains(double t) const { return min <= t && t <= max; }
  constexpr double length() const { return empty() ? 0.0 : max - min; }
  constexpr Interval intersect(Interval b) const {
    return {std::max(min, b.min), std::min(max, b.max)};
  }
  constexpr bool operator==(const Interval&) const = default;
};

/// An axis-aligned box, possibly unbounded; empty when min > max along any axis.
struct Box3d {
  Vec3d min{infinity, infinity, infinity};
  Vec3d max{-infinity, -infinity, -infinity};

  static constexpr Box3d all() {
    return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  }

  constexpr bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  bool bounded() const { return !empty() && is_finite(min) && is_finite(max); }
  constexpr void extend(Vec3d p) {
    min = lapidary::min(min, p);
    max = lapidary::max(max, p);
  }
  constexpr void extend(const Box3d& b) {
    min = lapidary::min(min, b.min);
    max = lapidary::max(max, b.max);
  }
  constexpr Vec3d center() const { return (min + max) * 0.5; }
  constexpr Vec3d extent() const { return max - min; }
  constexpr bool contains(Vec3d p) const {
    return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y && min.z <= p.z &&
           p.z <= max.z;
  }
  constexpr Box3d intersect(const Box3d& b) const {
    return {lapidary::max(min, b.min), lapidary::min(max, b.max)};
  }
  /// Corner `i` in 0..7: bit 0 picks x, bit 1 y, bit 2 z.
  constexpr Vec3d corner(unsigned i) const {
    return {i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z};
  }
  constexpr bool operator==(const Box3d&) const = default;
};

}  // namespace lapidary
