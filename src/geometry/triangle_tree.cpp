#include "geometry/triangle_tree.h"

#include <cmath>

#include <immintrin.h>

/// How lines find the triangles near them. Coordinates are those of the tree, within -1 .. 1.
namespace lapidary::geometry {
namespace {

__m256 widened(const std::array<std::uint8_t, 8>& bytes) {
  const auto* eight = reinterpret_cast<const __m128i*>(bytes.data());
  return _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(_mm_loadl_epi64(eight)));
}

template <typename T>
void prefetch(const T& object) {
  const auto* bytes = reinterpret_cast<const char*>(&object);
  for (std::size_t i = 0; i < sizeof(T); i += 64) _mm_prefetch(bytes + i, _MM_HINT_T0);
}

}  // namespace

/// The line, as thick as all errors make it, for slab tests in float. It is a ray that starts
/// before everything: by 2 and more before its point nearest to the centre, where everything is
/// within sqrt(3) of the centre. The direction is scaled so that its largest component is 1.
///
/// Error analysis. Distances of planes are (plane - start) / d; with w half the width, lines not
/// farther than sqrt(3) + w from the centre have |start| <= 5.3 + 4.5 w. Planes are displaced by
///   - 16 u far at most where they are far away: by roundings of the nearest point, of start and
///     direction; far is the greatest magnitude of the line's origin,
///   - 2^-24 (4 |start| + 3), by start, its difference to the grid's origin, the product and the
///     way across, in float,
///   - 2^-25, by boxes in float,
///   - 2^-37, where components of d below 2^-40 count as 2^-40;
/// but for the first these are less than (1 + w) 2^-19. What remains is relative: the inverse in
/// float and the last sum are off by 2 * 2^-24 of the distance, enter and leave together by less
/// than 2^-21. A line that may be as far off as `vague` meets everything, like one through the
/// centre that is as thick.
class TriangleTree::Corridor {
 public:
  Corridor(const LineView& view, double scale) {
    Vec3d d;
    d[view.z] = view.inverse < 0.0 ? -1.0 : 1.0;
    d[view.x] = d[view.z] * view.shear_x;
    d[view.y] = d[view.z] * view.shear_y;
    const Vec3d origin = view.origin * scale;
    const double far = max_component(abs(origin));
    // Sixteen times what is needed to meet the boxes of all triangles that could be touched: also
    // those that only come near the line count, alike in whatever boxes they are.
    const double error = 16 * std::max(view.x_error, view.y_error) * scale;
    const double half_width = error + 16 * rounding_unit * far + 0x1p-19;
    if (!(half_width < vague)) {
      set(d * (-2 - 2 * vague), d, vague);
      return;
    }
    const double t_nearest = -dot(origin, d) / dot(d, d);
    const Vec3d nearest = origin + d * t_nearest;
    const double reach = 1.7321 + half_width;
    passes_by_ = dot(nearest, nearest) > reach * reach;
    set(origin + d * (t_nearest - 2 - 2 * half_width), d, half_width * 1.001);
  }

  bool passes_by() const { return passes_by_; }

  /// The children whose boxes are met, a bit each.
  unsigned test(const Node& node) const {
    __m256 enter = _mm256_setzero_ps(), leave = _mm256_set1_ps(1e30f);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const __m256 step = _mm256_set1_ps(node.grid.quantum[axis] * inverse_[axis]);
      const float to_near = (node.grid.origin[axis] - start_[axis]) * inverse_[axis];
      const float to_far = to_near + across_[axis];
      const __m256 near = widened(node.bounds[near_row_[axis]]);
      const __m256 far = widened(node.bounds[far_row_[axis]]);
      enter = _mm256_max_ps(enter, _mm256_fmadd_ps(near, step, _mm256_set1_ps(to_near)));
      leave = _mm256_min_ps(leave, _mm256_fmadd_ps(far, step, _mm256_set1_ps(to_far)));
    }
    const __m256 met = _mm256_cmp_ps(enter, leave * (1.0f + 0x1p-21f), _CMP_LE_OQ);
    return static_cast<unsigned>(_mm256_movemask_ps(met)) & node.used;
  }

 private:
  static constexpr double vague = 64;

  void set(Vec3d start, Vec3d d, double half_width) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool forward = !std::signbit(d[axis]);
      const double inverse = 1.0 / std::max(std::abs(d[axis]), 0x1p-40);
      start_[axis] = static_cast<float>(start[axis] + (forward ? half_width : -half_width));
      across_[axis] = static_cast<float>(2 * half_width * inverse);
      inverse_[axis] = static_cast<float>(forward ? inverse : -inverse);
      near_row_[axis] = 2 * axis + (forward ? 0 : 1);
      far_row_[axis] = near_row_[axis] ^ 1u;
    }
  }

  std::array<float, 3> start_;  ///< half a width nearer to what the ray comes to along each axis
  std::array<float, 3> across_, inverse_;
  std::array<std::size_t, 3> near_row_, far_row_;
  bool passes_by_ = false;
};

/// Holds back triangles that the line surely does not cross, eight at a time.
///
/// Error analysis. A corner's x is off the one that the view gives by at most
///   - (quantum.x + |shear| quantum.z) / 2, by being on the grid,
///   - x_error, by the roundings of the view,
///   - x_error, by those of `base` in double,
///   - 5 * 2^-24 (|base| + 255 (quantum.x + |shear| quantum.z)), by base, shear and four operations
///     in float;
/// and by x_error once more where the view still counts it as near. With e the sum, turns
/// x y' - y x' of two corners are off by 2 (|x| e.y + |y| e.x + e.x e.y) and three roundings.
class TriangleTree::Sieve {
 public:
  Sieve(const LineView& view, double scale)
      : x_(side(view.x, view.shear_x, view.x_error, view.origin, scale)),
        y_(side(view.y, view.shear_y, view.y_error, view.origin, scale)),
        z_(view.z),
        origin_z_(view.origin[view.z] * scale) {}

  /// The triangles left, a bit each.
  unsigned test(const Leaf& leaf) const {
    const Sheared x = sheared(leaf, x_), y = sheared(leaf, y_);
    const auto turn = [&](std::size_t i, std::size_t j) {
      return _mm256_fmsub_ps(x.corner[i], y.corner[j], y.corner[i] * x.corner[j]);
    };
    const __m256 u = turn(1, 2), v = turn(2, 0), w = turn(0, 1);
    const __m256 mx = magnitude(x.corner), my = magnitude(y.corner);
    const __m256 margin =
        mx * my * 0x1p-22f + (mx * y.error + my * x.error + x.error * y.error) * 2.0f;
    const __m256 least = _mm256_min_ps(_mm256_min_ps(u, v), w);
    const __m256 greatest = _mm256_max_ps(_mm256_max_ps(u, v), w);
    const __m256 missed = _mm256_and_ps(_mm256_cmp_ps(least, -margin, _CMP_LT_OQ),
                                        _mm256_cmp_ps(greatest, margin, _CMP_GT_OQ));
    return static_cast<unsigned>(_mm256_movemask_ps(missed)) ^ 255u;
  }

 private:
  /// One of the two coordinates across the line.
  struct Side {
    std::size_t axis;
    double origin, shear;
    float float_shear, error;
  };

  static Side side(std::size_t axis, double shear, double error, Vec3d origin, double scale) {
    return {axis, origin[axis] * scale, shear, static_cast<float>(shear),
            static_cast<float>(4 * scale * error)};
  }

  struct Sheared {
    __m256 corner[3];  // NOLINT: an argument of a template would lose its alignment
    float error;
  };

  Sheared sheared(const Leaf& leaf, const Side& side) const {
    const double z = static_cast<double>(leaf.grid.origin[z_]) - origin_z_;
    const double from_line = static_cast<double>(leaf.grid.origin[side.axis]) - side.origin;
    const auto base = static_cast<float>(from_line - side.shear * z);
    const float step = leaf.grid.quantum[side.axis];
    const float step_z = side.float_shear * leaf.grid.quantum[z_];
    Sheared s;
    for (std::size_t i = 0; i < 3; ++i) {
      const __m256 across = widened(leaf.corners[3 * i + side.axis]);
      const __m256 along = widened(leaf.corners[3 * i + z_]);
      s.corner[i] =
          _mm256_fmadd_ps(across, _mm256_set1_ps(step),
                          _mm256_fnmadd_ps(along, _mm256_set1_ps(step_z), _mm256_set1_ps(base)));
    }
    s.error = side.error + 0.501f * (step + std::abs(step_z)) + 0x1p-21f * std::abs(base);
    return s;
  }

  static __m256 magnitude(const __m256 (&a)[3]) {
    const __m256 sign_bit = _mm256_set1_ps(-0.0f);
    return _mm256_max_ps(
        _mm256_max_ps(_mm256_andnot_ps(sign_bit, a[0]), _mm256_andnot_ps(sign_bit, a[1])),
        _mm256_andnot_ps(sign_bit, a[2]));
  }

  Side x_, y_;
  std::size_t z_;
  double origin_z_;
};

void TriangleTree::find(const LineView& view, Found& found) const {
  const Corridor corridor(view, scale_);
  if (corridor.passes_by()) return;
  // Breadth first, and leaves after all nodes: so what is next has had time to come from memory.
  InlineBuffer<std::uint32_t, 256> nodes, leaves;
  nodes.push(0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes_[nodes[i]];
    for (unsigned met = corridor.test(node); met != 0; met &= met - 1) {
      const std::uint32_t child = node.child[static_cast<std::size_t>(__builtin_ctz(met))];
      if (child & leaf_bit) {
        leaves.push(child & ~leaf_bit);
        prefetch(leaves_[child & ~leaf_bit]);
      } else {
        nodes.push(child);
        prefetch(nodes_[child]);
      }
    }
  }
  const Sieve sieve(view, scale_);
  for (const std::uint32_t i : leaves) {
    const Leaf& leaf = leaves_[i];
    for (unsigned left = sieve.test(leaf); left != 0; left &= left - 1) {
      const Patch triangle = leaf.triangles[static_cast<std::size_t>(__builtin_ctz(left))];
      if (triangle != no_triangle) found.push(triangle);
    }
  }
}

}  // namespace lapidary::geometry
