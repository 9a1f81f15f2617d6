#include "geometry/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lapidary::geometry {
namespace {

constexpr std::size_t bins = 16;
// Deeper than this, halves by count replace the heuristic, so that the walk's stack suffices for
// any input: 7 entries a level, 24 levels here and 11 below for 2^32 items.
constexpr int heuristic_depth = 24;

double half_area(const Box3d& b) {
  if (b.empty()) return 0.0;
  const Vec3d e = b.extent();
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

float rounded_down(double x) {
  const float f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafter(f, -std::numeric_limits<float>::infinity())
                                    : f;
}

float rounded_up(double x) {
  return -rounded_down(-x);
}

}  // namespace

/// Splits ranges of items in two, widest first, until a node has eight.
struct Bvh::Builder {
  struct Range {
    std::size_t begin = 0, end = 0;
    Box3d box;
    std::size_t size() const { return end - begin; }
  };

  std::span<const Box3d> boxes;
  std::vector<std::uint32_t> items;
  std::vector<Node>& nodes;

  Builder(std::span<const Box3d> all, std::vector<Node>& out)
      : boxes(all), items(all.size()), nodes(out) {
    std::iota(items.begin(), items.end(), 0u);
  }

  Range range(std::size_t begin, std::size_t end) const {
    Range r{begin, end, {}};
    for (std::size_t i = begin; i < end; ++i) r.box.extend(boxes[items[i]]);
    return r;
  }

  double center(std::uint32_t item, std::size_t axis) const {
    return boxes[item].min[axis] + boxes[item].max[axis];
  }

  struct Plane {
    std::size_t axis = 0;
    std::size_t bin = 0;  ///< first bin of the right side
    double cost = infinity;
    double min = 0, scale = 0;
    std::size_t bin_of(double c) const {
      return std::min(bins - 1, static_cast<std::size_t>(std::max(0.0, (c - min) * scale)));
    }
  };

  Plane best_plane(const Range& r, std::size_t axis, Interval centers) const {
    Plane best{axis, 0, infinity, centers.min, static_cast<double>(bins) / centers.length()};
    std::array<Box3d, bins> box;
    std::array<std::size_t, bins> count{};
    for (std::size_t i = r.begin; i < r.end; ++i) {
      const std::size_t b = best.bin_of(center(items[i], axis));
      box[b].extend(boxes[items[i]]);
      ++count[b];
    }
    std::array<double, bins> left_cost{};
    Box3d left, right;
    std::size_t n = 0;
    for (std::size_t b = 0; b + 1 < bins; ++b) {
      left.extend(box[b]);
      n += count[b];
      left_cost[b + 1] = half_area(left) * static_cast<double>(n);
    }
    n = 0;
    for (std::size_t b = bins - 1; b > 0; --b) {
      right.extend(box[b]);
      n += count[b];
      const double cost = left_cost[b] + half_area(right) * static_cast<double>(n);
      if (n > 0 && n < r.size() && cost < best.cost) best.cost = cost, best.bin = b;
    }
    return best;
  }

  /// The index that parts `r`'s items after reordering them.
  std::size_t split(const Range& r, int depth) {
    Plane best;
    for (std::size_t axis = 0; axis < 3 && depth < heuristic_depth; ++axis) {
      Interval centers;
      for (std::size_t i = r.begin; i < r.end; ++i) {
        const double c = center(items[i], axis);
        centers = {std::min(centers.min, c), std::max(centers.max, c)};
      }
      if (!(centers.length() > 0.0)) continue;
      const Plane plane = best_plane(r, axis, centers);
      if (plane.cost < best.cost) best = plane;
    }
    if (best.cost == infinity) return r.begin + r.size() / 2;
    const auto first = items.begin() + static_cast<std::ptrdiff_t>(r.begin);
    const auto last = items.begin() + static_cast<std::ptrdiff_t>(r.end);
    const auto middle = std::stable_partition(first, last, [&](std::uint32_t item) {
      return best.bin_of(center(item, best.axis)) < best.bin;
    });
    return static_cast<std::size_t>(middle - items.begin());
  }

  std::uint32_t build(const Range& all, int depth) {
    std::vector<Range> parts{all};
    while (parts.size() < width) {
      const auto widest =
          std::max_element(parts.begin(), parts.end(), [](const Range& a, const Range& b) {
            return (a.size() > 1 ? half_area(a.box) : -1.0) <
                   (b.size() > 1 ? half_area(b.box) : -1.0);
          });
      if (widest->size() < 2) break;
      const Range whole = *widest;
      const std::size_t middle = split(whole, depth);
      *widest = range(whole.begin, middle);
      parts.push_back(range(middle, whole.end));
    }
    const auto index = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back(empty_node());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::uint32_t child =
          parts[i].size() == 1 ? items[parts[i].begin] | leaf_bit : build(parts[i], depth + 1);
      set_child(nodes[index], i, parts[i].box, child);
    }
    return index;
  }

  static Node empty_node() {
    Node node;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.bounds[2 * axis].fill(std::numeric_limits<float>::infinity());
      node.bounds[2 * axis + 1].fill(-std::numeric_limits<float>::infinity());
    }
    node.child.fill(leaf_bit);
    return node;
  }

  static void set_child(Node& node, std::size_t i, const Box3d& box, std::uint32_t child) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.bounds[2 * axis][i] = rounded_down(box.min[axis]);
      node.bounds[2 * axis + 1][i] = rounded_up(box.max[axis]);
    }
    node.child[i] = child;
  }
};

Bvh::Bvh(std::span<const Box3d> boxes) {
  constexpr std::uint32_t all_of_them[]{0};
  if (!boxes.empty()) *this = Bvh(boxes, all_of_them);
}

Bvh::Bvh(std::span<const Box3d> boxes, std::span<const std::uint32_t> first) {
  Builder builder(boxes, nodes_);
  for (std::size_t k = 0; k < first.size(); ++k) {
    const std::size_t end = k + 1 < first.size() ? first[k + 1] : boxes.size();
    const Builder::Range all = builder.range(first[k], end);
    bounds_.extend(all.box);
    roots_.push_back(builder.build(all, 0));
  }
}

/// The start is the point nearest to the middle of everything, put back by a little more than the
/// half diagonal. It is off the line by the rounding of origin + t direction: t is a quotient, and
/// whatever t came out, product and sum round by u (|t d| + |start|) each. Scaled so that its
/// largest component is 1, the direction fits into floats; components that do not fit move the line
/// by less than 1e-30 of the way.
Bvh::Slabs Bvh::whole_line(const Line& line) const {
  const Vec3d middle = bounds_.center(), half = bounds_.extent() * 0.5;
  const double largest = max_component(abs(line.direction));
  const Vec3d d = line.direction / largest;
  const Vec3d to_middle = middle - line.origin;
  const double t_middle = dot(to_middle, d) / dot(d, d);
  const double reach = 1.01 * (half.x + half.y + half.z);
  const double far = max_component(abs(line.origin)) + max_component(abs(middle)) + reach;
  const double displacement =
      line.origin_error + (std::abs(t_middle) + reach) / largest * line.direction_error;
  const double before = reach + 32 * rounding_unit * far + 2 * displacement;
  const Line ray{line.origin + d * (t_middle - before), d};
  return Slabs(ray, displacement + 16 * rounding_unit * far + 1e-30 * before);
}

}  // namespace lapidary::geometry
