#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <immintrin.h>

#include "geometry/triangle_tree.h"

/// How triangles become a hierarchy. Boxes are eight floats, the minima and the negated maxima, so
/// that one instruction extends them.
namespace lapidary::geometry {
namespace {

constexpr std::size_t bins = 16;
/// What testing a leaf costs, when testing a node costs 1.
constexpr float leaf_cost = 1.5f;
// Deeper than this, halves by count replace the heuristic: no input makes the recursion deep.
constexpr int heuristic_depth = 40;

/// Lanes 0, 1, 2: minima; 4, 5, 6: negated maxima; lane 3 is not a coordinate, lane 7 is 0.
using FloatBox = __m256;

FloatBox empty_box() {
  return _mm256_set1_ps(1e30f);
}

FloatBox joined(FloatBox a, FloatBox b) {
  return _mm256_min_ps(a, b);
}

/// Twice the centre.
__m128 centre(FloatBox box) {
  return _mm256_castps256_ps128(box) - _mm256_extractf128_ps(box, 1);
}

float half_area(FloatBox box) {
  const __m128 e = -(_mm256_castps256_ps128(box) + _mm256_extractf128_ps(box, 1));
  const __m128 products = e * _mm_permute_ps(e, _MM_SHUFFLE(3, 0, 2, 1));
  return products[0] + products[1] + products[2];
}

/// Leaves of up to eight cost as much as full ones.
float cost(FloatBox box, std::size_t count) {
  return count == 0 ? 0.0f : half_area(box) * static_cast<float>((count + 7) / 8);
}

/// A power of two, at least 2^-60, that covers `extent` in 255 steps.
float quantum_of(double extent) {
  int exponent;
  std::frexp(std::max(extent, 0x1p-53) / 255, &exponent);
  return static_cast<float>(std::ldexp(1.0, exponent));
}

}  // namespace

/// Splits ranges of triangles in two until they fit into leaves, then joins splits into nodes.
struct TriangleTree::Builder {
  /// A triangle's box with its number in lane 3.
  struct alignas(32) Item {
    FloatBox box;
    Patch triangle() const { return std::bit_cast<std::array<Patch, 8>>(box)[3]; }
  };

  struct Range {
    std::size_t begin, end;
    FloatBox box;
    __m128 least, greatest;  ///< of the centres
    std::size_t size() const { return end - begin; }
  };

  /// A range that was split until leaves were left.
  struct Part {
    FloatBox box;
    std::size_t begin, size;
    std::array<std::uint32_t, 2> halves;  ///< parts, unless it is a leaf
    std::array<float, width + 1> cost;    ///< at least, when it may be up to n children of a node
    std::array<std::uint8_t, width + 1> for_left;  ///< so many of the n; 0: it is one child
    bool is_leaf() const { return size <= width; }
  };

  struct Plane {
    std::size_t axis = 0;
    int bin = 0;  ///< the first of the right side
    float cost = std::numeric_limits<float>::infinity();
  };

  /// In which bin centres are, along all axes.
  struct Binning {
    explicit Binning(const Range& r) : least(r.least) {
      const __m128 extent = r.greatest - r.least;
      const __m128 some = _mm_cmp_ps(extent, _mm_setzero_ps(), _CMP_GT_OQ);
      // A hair less, so that the greatest is in the last bin.
      per_unit = _mm_and_ps(some, _mm_set1_ps(bins * (1.0f - 0x1p-20f)) / extent);
    }
    __m128i operator()(FloatBox box) const {
      return _mm_cvttps_epi32((centre(box) - least) * per_unit);
    }
    __m128 least, per_unit;
  };

  std::span<const Vec3d> vertices;
  std::span<const Triangle> triangles;
  TriangleTree& tree;
  std::vector<Item> items;
  std::vector<Part> parts;

  std::array<Vec3d, 3> corners(Patch triangle) const {
    const auto& [i, j, k] = triangles[triangle];
    return {vertices[i] * tree.scale_, vertices[j] * tree.scale_, vertices[k] * tree.scale_};
  }

  void make_items() {
    items.resize(triangles.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      const auto c = corners(static_cast<Patch>(i));
      const Vec3f low(min(min(c[0], c[1]), c[2])), high(max(max(c[0], c[1]), c[2]));
      const float number = std::bit_cast<float>(static_cast<Patch>(i));
      items[i].box = _mm256_setr_ps(low.x, low.y, low.z, number, -high.x, -high.y, -high.z, 0);
    }
  }

  Range range(std::size_t begin, std::size_t end) const {
    Range r{begin, end, empty_box(), _mm_set1_ps(1e30f), _mm_set1_ps(-1e30f)};
    for (std::size_t i = begin; i < end; ++i) {
      const __m128 at = centre(items[i].box);
      r.box = joined(r.box, items[i].box);
      r.least = _mm_min_ps(r.least, at);
      r.greatest = _mm_max_ps(r.greatest, at);
    }
    return r;
  }

  struct Bin {
    FloatBox box = empty_box();
    std::size_t count = 0;
  };
  using Bins = std::array<std::array<Bin, bins>, 3>;

  void fill(Bins& filled, const Range& r, const Binning& binning) const {
    for (std::size_t i = r.begin; i < r.end; ++i) {
      const FloatBox box = items[i].box;
      const __m128i at = binning(box);
      const auto add = [box](Bin& bin) { bin.box = joined(bin.box, box), ++bin.count; };
      add(filled[0][static_cast<std::size_t>(_mm_extract_epi32(at, 0))]);
      add(filled[1][static_cast<std::size_t>(_mm_extract_epi32(at, 1))]);
      add(filled[2][static_cast<std::size_t>(_mm_extract_epi32(at, 2))]);
    }
  }

  static void improve(Plane& best, const std::array<Bin, bins>& along, std::size_t axis) {
    std::array<float, bins> left_cost;
    FloatBox box = empty_box();
    std::size_t count = 0, total = 0;
    for (std::size_t b = 0; b + 1 < bins; ++b) {
      box = joined(box, along[b].box), total += along[b].count;
      left_cost[b + 1] = cost(box, total);
    }
    total += along[bins - 1].count;
    box = empty_box();
    for (std::size_t b = bins - 1; b > 0; --b) {
      box = joined(box, along[b].box), count += along[b].count;
      if (count == 0 || count == total) continue;
      const float both = left_cost[b] + cost(box, count);
      if (both < best.cost) best = {axis, static_cast<int>(b), both};
    }
  }

  /// The index that parts `r`'s items after reordering them.
  std::size_t split(const Range& r, int depth) {
    Plane best;
    const Binning binning(r);
    if (depth < heuristic_depth) {
      Bins filled;
      fill(filled, r, binning);
      for (std::size_t axis = 0; axis < 3; ++axis) improve(best, filled[axis], axis);
    }
    if (std::isinf(best.cost)) return r.begin + r.size() / 2;
    const auto first = items.begin() + static_cast<std::ptrdiff_t>(r.begin);
    const auto last = items.begin() + static_cast<std::ptrdiff_t>(r.end);
    const auto middle = std::partition(first, last, [&](const Item& item) {
      const auto at = std::bit_cast<std::array<int, 4>>(binning(item.box));
      return at[best.axis] < best.bin;
    });
    return static_cast<std::size_t>(middle - items.begin());
  }

  /// Splits `r` in two and two down to leaves; returns the number of the part that it becomes.
  std::uint32_t add_part(const Range& r, int depth) {
    const auto number = static_cast<std::uint32_t>(parts.size());
    parts.push_back({r.box, r.begin, r.size(), {}, {}, {}});
    if (r.size() <= width) {
      parts[number].cost.fill(leaf_cost * half_area(r.box));
      return number;
    }
    const std::size_t middle = split(r, depth);
    const std::uint32_t left = add_part(range(r.begin, middle), depth + 1);
    const std::uint32_t right = add_part(range(middle, r.end), depth + 1);
    parts[number].halves = {left, right};
    weigh(parts[number]);
    return number;
  }

  /// How to spend the children of a node on the halves of a part, and whether to spend only one on
  /// a node for all of it. Source: Ylitie, Karras & Laine 2017, section 3.1.
  void weigh(Part& part) const {
    const Part &left = parts[part.halves[0]], &right = parts[part.halves[1]];
    for (std::size_t children = 2; children <= width; ++children) {
      part.cost[children] = std::numeric_limits<float>::infinity();
      for (std::size_t k = 1; k < children; ++k) {
        const float both = left.cost[k] + right.cost[children - k];
        if (!(both < part.cost[children])) continue;
        part.cost[children] = both;
        part.for_left[children] = static_cast<std::uint8_t>(k);
      }
    }
    part.cost[1] = half_area(part.box) + part.cost[width];
    for (std::size_t children = 2; children < width; ++children) {
      if (part.cost[1] > part.cost[children]) continue;
      part.cost[children] = part.cost[1];
      part.for_left[children] = 0;
    }
  }

  struct Children {
    std::array<const Part*, width> parts;
    std::size_t count = 0;
  };

  /// Adds the parts that this one comes to as up to `children` of a node.
  void collect(const Part& part, std::size_t children, Children& out) const {
    const std::size_t for_left = part.for_left[children];
    if (for_left == 0) {
      out.parts[out.count++] = &part;
      return;
    }
    collect(parts[part.halves[0]], for_left, out);
    collect(parts[part.halves[1]], children - for_left, out);
  }

  std::uint32_t add_node(const Part& part) {
    Children children;
    collect(part, width, children);
    const auto index = static_cast<std::uint32_t>(tree.nodes_.size());
    tree.nodes_.push_back(node_of(part.box, children));
    for (std::size_t i = 0; i < children.count; ++i) {
      const Part& child = *children.parts[i];
      const std::uint32_t bits = child.is_leaf() ? add_leaf(child) | leaf_bit : add_node(child);
      tree.nodes_[index].child[i] = bits;
    }
    return index;
  }

  static Node node_of(FloatBox box, const Children& children) {
    Node node{};
    node.used = (1u << children.count) - 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float origin = box[axis];
      const double extent = -static_cast<double>(box[axis + 4]) - static_cast<double>(origin);
      node.grid.origin[axis] = origin;
      node.grid.quantum[axis] = quantum_of(extent);
      const auto steps = [&](float x) {
        const double from_origin = static_cast<double>(x) - static_cast<double>(origin);
        return from_origin / static_cast<double>(node.grid.quantum[axis]);
      };
      for (std::size_t i = 0; i < children.count; ++i) {
        const FloatBox& part = children.parts[i]->box;
        node.bounds[2 * axis][i] = static_cast<std::uint8_t>(steps(part[axis]));
        node.bounds[2 * axis + 1][i] = static_cast<std::uint8_t>(std::ceil(steps(-part[axis + 4])));
      }
    }
    return node;
  }

  std::uint32_t add_leaf(const Part& r) {
    Leaf& leaf = tree.leaves_.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // Before the least coordinate, which the box has rounded to the nearest float.
      leaf.grid.origin[axis] = r.box[axis] - 0x1p-24f;
      const double high = -static_cast<double>(r.box[axis + 4]) + 0x1p-24;
      leaf.grid.quantum[axis] = quantum_of(high - static_cast<double>(leaf.grid.origin[axis]));
    }
    leaf.triangles.fill(no_triangle);
    for (std::size_t i = 0; i < width; ++i) {
      const Patch triangle = items[r.begin + (i < r.size ? i : 0)].triangle();
      if (i < r.size) leaf.triangles[i] = triangle;
      const auto c = corners(triangle);
      for (std::size_t row = 0; row < 9; ++row) {
        const std::size_t axis = row % 3;
        const double steps = (c[row / 3][axis] - static_cast<double>(leaf.grid.origin[axis])) /
                             static_cast<double>(leaf.grid.quantum[axis]);
        leaf.corners[row][i] = static_cast<std::uint8_t>(steps + 0.5);
      }
    }
    return static_cast<std::uint32_t>(tree.leaves_.size() - 1);
  }
};

TriangleTree::TriangleTree(std::span<const Vec3d> vertices, std::span<const Triangle> triangles) {
  double reach = 0;
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) reach = std::max(reach, max_component(abs(vertices[v])));
  }
  int exponent;
  std::frexp(reach, &exponent);
  scale_ = std::ldexp(1.0, -exponent);
  Builder builder{vertices, triangles, *this, {}, {}};
  builder.make_items();
  builder.add_part(builder.range(0, triangles.size()), 0);
  builder.add_node(builder.parts.front());
}

}  // namespace lapidary::geometry
