#include "inspect/crofton.h"

#include <array>
#include <cassert>
#include <cmath>

#include "geometry/sweep.h"
#include "math/frame.h"
#include "sampling/sobol.h"
#include "sampling/warp.h"

namespace lapidary::inspect {
namespace {

constexpr std::uint64_t seed = 1868;
/// Independent sets of lines: enough that the scatter of their means is known to about a fifth.
constexpr std::size_t sets = 16;

/// Lines that meet a box, uniformly: through points uniform on its surface, inward by the cosine.
class BoxLines {
 public:
  explicit BoxLines(const Box3d& box) : box_(box), diagonal_(length(box.extent())) {
    const Vec3d e = box.extent();
    const Vec3d areas{e.y * e.z, e.z * e.x, e.x * e.y};
    for (std::size_t face = 0; face < 6; ++face) area_to_[face] = area_ += areas[face / 2];
  }

  double area() const { return area_; }  ///< of the surface

  /// Starts well before the box.
  geometry::Ray ray(const Block8& u) const {
    const double place = u[0] * area_;
    std::size_t face = 0;
    while (face < 5 && place >= area_to_[face]) ++face;
    const double before = face == 0 ? 0.0 : area_to_[face - 1];
    const double u0 = (place - before) / (area_to_[face] - before);
    const std::size_t axis = face / 2, a = (axis + 1) % 3, b = (axis + 2) % 3;
    const bool at_max = face % 2 != 0;
    const Vec3d extent = box_.extent();
    Vec3d p = box_.min, inward;
    if (at_max) p[axis] = box_.max[axis];
    p[a] += u0 * extent[a];
    p[b] += u[1] * extent[b];
    inward[axis] = at_max ? -1.0 : 1.0;
    const Vec3d d = Frame::from_normal(inward).to_world(sample_cosine_hemisphere({u[2], u[3]}));
    return {p - d * diagonal_, d};
  }

 private:
  Box3d box_;
  double diagonal_, area_ = 0;
  std::array<double, 6> area_to_{};  ///< of all faces up to this one: -x, x, -y, y, -z, z
};

/// Of the lines of one set.
struct Sums {
  double inside = 0;  ///< length
  std::size_t crossings = 0;
};

void add_line(const geometry::SolidScene& body, const geometry::Ray& ray, Sums& sums) {
  geometry::Sweep sweep(body, ray);
  geometry::Transition found;
  while (sweep.next(found)) {
    sums.inside += found.after == geometry::SolidScene::no_region ? found.t : -found.t;
    ++sums.crossings;
  }
}

/// Mean of the values that sets gave, and its standard error.
Estimate estimate_of(const std::array<double, sets>& values) {
  double sum = 0, squares = 0;
  for (const double v : values) sum += v;
  const double mean = sum / sets;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, std::sqrt(squares / (sets * (sets - 1.0)))};
}

}  // namespace

BodySize measure_by_lines(const geometry::SolidScene& body, const LineBudget& budget,
                          ThreadPool& pool) {
  assert(body.region_count() == 1);
  const Box3d bounds = body.bounds(0);
  if (bounds.empty()) return {};
  assert(bounds.bounded());
  const BoxLines box(bounds);
  if (!(box.area() > 0.0)) return {};
  std::array<Sums, sets> sums;
  std::size_t lines = 0, crossings = 0;  // of each set; of all
  // Powers of four spread best.
  for (std::size_t next = 64;; next *= 4) {
    pool.parallel_for(sets, 1, [&](IndexRange range) {
      for (std::size_t set = range.begin; set < range.end; ++set) {
        for (std::size_t i = lines; i < next; ++i) {
          const PixelSampler numbers(seed, static_cast<std::uint32_t>(set), 0,
                                     static_cast<std::uint32_t>(i));
          add_line(body, box.ray(numbers.block(0)), sums[set]);
        }
      }
    });
    lines = next;
    crossings = 0;
    for (const Sums& s : sums) crossings += s.crossings;
    const bool affordable = 4 * (sets * lines + crossings) <= budget.crossings;
    if (!affordable || 4 * sets * lines > budget.most_lines) break;
  }
  const double per_line = box.area() / static_cast<double>(lines);
  std::array<double, sets> volumes{}, areas{};
  for (std::size_t i = 0; i < sets; ++i) {
    volumes[i] = per_line * sums[i].inside / 4;
    areas[i] = per_line * static_cast<double>(sums[i].crossings) / 2;
  }
  return {estimate_of(volumes), estimate_of(areas), sets * lines};
}

}  // namespace lapidary::inspect
