#include "geometry/polygon.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include <fmt/format.h>

#include "base/error.h"
#include "geometry/exact_sign.h"

namespace lapidary::geometry {
namespace {

std::string name_of(std::size_t loop, std::size_t point) {
  if (loop == 0) return fmt::format("points[{}]", point + 1);
  return fmt::format("holes[{}][{}]", loop, point + 1);
}

/// One edge, and where it stands.
struct Edge {
  Vec2d from, to;
  std::size_t loop, index, count;  ///< count: of the loop's edges

  std::string name() const {
    return fmt::format("{} to {}", name_of(loop, index), name_of(loop, (index + 1) % count));
  }
  bool precedes(const Edge& e) const { return loop == e.loop && (index + 1) % count == e.index; }
};

bool overlap(double a, double b, double c, double d) {
  return std::max(std::min(a, b), std::min(c, d)) <= std::min(std::max(a, b), std::max(c, d));
}

/// Whether two closed segments have a point in common.
bool touch(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  return overlap(a.x, b.x, c.x, d.x) && overlap(a.y, b.y, c.y, d.y) &&
         orientation(a, b, c) * orientation(a, b, d) <= 0 &&
         orientation(c, d, a) * orientation(c, d, b) <= 0;
}

/// Whether b to c goes straight back over a to b.
bool turns_back(const Edge& first, const Edge& second) {
  const Vec2d along = first.to - first.from, next = second.to - second.from;
  return orientation(first.from, first.to, second.to) == 0 &&
         along.x * next.x + along.y * next.y < 0.0;
}

std::vector<std::span<const Vec2d>> loops_of(const Polygon& polygon) {
  std::vector<std::span<const Vec2d>> loops{polygon.outline};
  loops.insert(loops.end(), polygon.holes.begin(), polygon.holes.end());
  return loops;
}

std::vector<Edge> edges_of(const std::vector<std::span<const Vec2d>>& loops) {
  std::vector<Edge> edges;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const std::size_t count = loops[l].size();
    if (count < 3) {
      throw Error({}, fmt::format("{} has {} {}; a polygon needs three",
                                  l == 0 ? "points" : fmt::format("holes[{}]", l), count,
                                  count == 1 ? "point" : "points"));
    }
    for (std::size_t i = 0; i < count; ++i) {
      edges.push_back({loops[l][i], loops[l][(i + 1) % count], l, i, count});
      if (edges.back().from != edges.back().to) continue;
      throw Error(
          {},
          fmt::format("{} and {} are the same point", name_of(l, i), name_of(l, (i + 1) % count)),
          "leave out the second; a polygon closes by itself");
    }
  }
  return edges;
}

bool is_bad_pair(const Edge& a, const Edge& b) {
  const bool a_first = a.precedes(b), b_first = b.precedes(a);
  if (a_first && turns_back(a, b)) return true;
  if (b_first && turns_back(b, a)) return true;
  return !a_first && !b_first && touch(a.from, a.to, b.from, b.to);
}

/// Whether p, which no edge touches, is in the loop: crossings of the ray to +x.
bool is_in(std::span<const Vec2d> loop, Vec2d p) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2d a = loop[i], b = loop[(i + 1) % loop.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const bool is_left = orientation(a, b, p) > 0;
    if (is_left == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

void check_nesting(const std::vector<std::span<const Vec2d>>& loops) {
  for (std::size_t i = 1; i < loops.size(); ++i) {
    if (!is_in(loops[0], loops[i][0])) {
      throw Error({}, fmt::format("holes[{}] lies outside of the outline", i));
    }
    for (std::size_t j = 1; j < loops.size(); ++j) {
      if (i == j || !is_in(loops[j], loops[i][0])) continue;
      throw Error({}, fmt::format("holes[{}] lies in holes[{}]", i, j),
                  "make an island a prism of its own");
    }
  }
}

/// Of a simple loop: the first point by x, then y, is a corner that turns as the loop does.
bool is_clockwise(std::span<const Vec2d> loop) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const Vec2d p = loop[i], q = loop[first];
    if (p.x < q.x || (p.x == q.x && p.y < q.y)) first = i;
  }
  const std::size_t n = loop.size();
  return orientation(loop[(first + n - 1) % n], loop[first], loop[(first + 1) % n]) < 0;
}

}  // namespace

void check_simple(const Polygon& polygon) {
  const auto loops = loops_of(polygon);
  const std::vector<Edge> edges = edges_of(loops);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!is_bad_pair(edges[j], edges[i])) continue;
      throw Error(
          {},
          fmt::format("the edge from {} touches that from {}", edges[i].name(), edges[j].name()),
          "outlines must not cross or touch themselves or each other");
    }
  }
  check_nesting(loops);
}

OrientedLoops oriented_loops(const Polygon& polygon) {
  OrientedLoops oriented;
  const auto loops = loops_of(polygon);
  for (std::size_t l = 0; l < loops.size(); ++l) {
    oriented.begins.push_back(static_cast<std::uint32_t>(oriented.points.size()));
    std::vector<Vec2d> points(loops[l].begin(), loops[l].end());
    // The first point stays the first.
    if (is_clockwise(points) != (l > 0)) std::reverse(points.begin() + 1, points.end());
    oriented.points.insert(oriented.points.end(), points.begin(), points.end());
  }
  oriented.begins.push_back(static_cast<std::uint32_t>(oriented.points.size()));
  return oriented;
}

namespace {

/// Ties holes to the outline one by one.
class Joiner {
 public:
  explicit Joiner(const OrientedLoops& loops) : loops_(loops) {
    all_ = std::vector<std::uint32_t>(loops.begins[1]);
    std::iota(all_.begin(), all_.end(), 0u);
  }

  /// Holes with the rightmost points first: to the right of such a point there is only what is
  /// joined already, so one of the joined points is in its sight.
  std::vector<std::uint32_t> join() {
    std::vector<std::uint32_t> tips;
    for (std::size_t l = 1; l + 1 < loops_.begins.size(); ++l) {
      std::uint32_t tip = loops_.begins[l];
      for (std::uint32_t i = tip; i < loops_.begins[l + 1]; ++i) {
        if (point(i).x > point(tip).x) tip = i;
      }
      tips.push_back(tip);
    }
    std::ranges::sort(tips, [&](auto a, auto b) { return point(a).x > point(b).x; });
    for (const std::uint32_t tip : tips) tie(tip);
    return std::move(all_);
  }

 private:
  Vec2d point(std::uint32_t i) const { return loops_.points[i]; }

  /// The hole from its point `tip` round to `tip` again, put behind the nearest joined point that
  /// sees it: ..., base, tip, ..., tip, base, ...
  void tie(std::uint32_t tip) {
    const auto loop = std::ranges::upper_bound(loops_.begins, tip);
    const std::uint32_t begin = *(loop - 1), end = *loop;
    std::vector<std::size_t> places(all_.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    const auto distance = [&](std::size_t place) {
      const Vec2d d = point(all_[place]) - point(tip);
      return d.x * d.x + d.y * d.y;
    };
    std::ranges::stable_sort(places, {}, distance);
    const auto found =
        std::ranges::find_if(places, [&](std::size_t place) { return sees(place, tip); });
    assert(found != places.end());
    std::vector<std::uint32_t> tied;
    for (std::uint32_t i = 0; i <= end - begin; ++i) {
      tied.push_back(begin + (tip - begin + i) % (end - begin));
    }
    tied.push_back(all_[*found]);
    all_.insert(all_.begin() + static_cast<std::ptrdiff_t>(*found) + 1, tied.begin(), tied.end());
  }

  /// Whether the way from the joined point at `place` to the tip leaves into the inside there and
  /// meets no edge but at its ends. Where points are joined twice, only one place looks that way.
  bool sees(std::size_t place, std::uint32_t tip) const {
    const std::uint32_t base = all_[place];
    const std::size_t n = all_.size();
    const Vec2d from = point(base), to = point(tip);
    const Vec2d before = point(all_[(place + n - 1) % n]), after = point(all_[(place + 1) % n]);
    const bool is_convex = orientation(before, from, after) > 0;
    const bool left_of_before = orientation(before, from, to) > 0;
    const bool left_of_after = orientation(from, after, to) > 0;
    const bool is_inward =
        is_convex ? left_of_before && left_of_after : left_of_before || left_of_after;
    if (!is_inward) return false;
    for (std::size_t l = 0; l + 1 < loops_.begins.size(); ++l) {
      const std::uint32_t begin = loops_.begins[l], end = loops_.begins[l + 1];
      for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t j = i + 1 < end ? i + 1 : begin;
        if (i == base || j == base || i == tip || j == tip) continue;
        if (touch(from, to, point(i), point(j))) return false;
      }
    }
    return !crosses_tie(from, to, base);
  }

  /// The ties that are there already are edges, too.
  bool crosses_tie(Vec2d from, Vec2d to, std::uint32_t base) const {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const std::uint32_t a = all_[i], b = all_[(i + 1) % all_.size()];
      if (a != base && b != base && touch(from, to, point(a), point(b))) return true;
    }
    return false;
  }

  const OrientedLoops& loops_;
  std::vector<std::uint32_t> all_;
};

}  // namespace

std::vector<std::uint32_t> joined(const OrientedLoops& loops) {
  return Joiner(loops).join();
}

}  // namespace lapidary::geometry
