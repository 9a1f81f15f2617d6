#include "light/light_tree_build.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/constants.h"
#include "math/frame.h"

namespace lapidary::light {
namespace {

/// The unit vector `v` turned by `angle` towards the unit vector `to`; they are not parallel.
Vec3d turned(Vec3d v, Vec3d to, double angle) {
  const Vec3d across = normalize(to - dot(to, v) * v);
  return normalize(std::cos(angle) * v + std::sin(angle) * across);
}

/// Into how large a part of the sphere of directions a group shines, its edges by their cosine.
/// Source: Conty Estevez & Kulla 2018, equation 1.
double directions(const EmissionCone& cone) {
  const double o = cone.angle, w = std::min(o + cone.spread, pi);
  const double sine = std::sin(o), cosine = std::cos(o);
  const double core = 2.0 * pi * (1.0 - cosine);
  const double rim = 2.0 * w * sine - std::cos(o - 2.0 * w) - 2.0 * o * sine + cosine;
  return core + 0.5 * pi * std::max(rim, 0.0);
}

/// The surface of a box; to that comes the square of its longest edge, so that the lights of
/// a straight row are near or far, too.
double size(const Box3d& box) {
  const Vec3d e = box.extent();
  const double longest = max_component(e);
  return 2.0 * (e.x * e.y + e.y * e.z + e.z * e.x) + longest * longest;
}

double cost(const LightGroup& group) {
  return group.is_empty() ? 0.0 : group.strength * directions(group.cone) * size(group.box);
}

Box3d box_of_centers(std::span<const LightGroup> lights) {
  Box3d box;
  for (const LightGroup& light : lights) box.extend(light.box.center());
  return box;
}

constexpr std::size_t most_bins = 12;

/// Slices of equal width along one axis.
struct Slices {
  std::size_t axis;
  double low, per_width;
  std::size_t count;

  std::size_t of(const LightGroup& light) const {
    const double place = (light.box.center()[axis] - low) * per_width;
    return std::min(static_cast<std::size_t>(std::max(place, 0.0)), count - 1);
  }
};

struct Cut {
  double cost = infinity;
  Slices slices{};
  std::size_t first_right = 0;  ///< the slice that the right group begins with
};

/// The best place between two slices.
Cut best_cut(std::span<const LightGroup> lights, const Slices& slices, double stretch) {
  std::array<LightGroup, most_bins> bins, from_right;
  for (const LightGroup& light : lights) bins[slices.of(light)].add(light);
  LightGroup right;
  for (std::size_t i = slices.count; i-- > 1;) {
    right.add(bins[i]);
    from_right[i] = right;
  }
  Cut best;
  LightGroup left;
  for (std::size_t i = 1; i < slices.count; ++i) {
    left.add(bins[i - 1]);
    if (left.is_empty() || from_right[i].is_empty()) continue;
    const double both = stretch * (cost(left) + cost(from_right[i]));
    if (both < best.cost) best = {both, slices, i};
  }
  return best;
}

}  // namespace

EmissionCone united(const EmissionCone& a, const EmissionCone& b) {
  if (b.angle > a.angle) return united(b, a);
  const double spread = std::max(a.spread, b.spread);
  if (a.angle >= pi) return {a.axis, pi, spread};
  const double between = std::acos(std::clamp(dot(a.axis, b.axis), -1.0, 1.0));
  if (std::min(between + b.angle, pi) <= a.angle) return {a.axis, a.angle, spread};
  const double angle = 0.5 * (a.angle + between + b.angle);
  const bool is_all = angle >= pi || length(cross(a.axis, b.axis)) < 1e-9;
  if (is_all && between > 1.0) return {a.axis, pi, spread};
  if (is_all) return {a.axis, std::min(pi, between + b.angle), spread};
  // Within the rounding of `between` the union must not lose a direction.
  return {turned(a.axis, b.axis, angle - a.angle), std::min(pi, angle + 1e-7), spread};
}

void LightGroup::add(const LightGroup& b) {
  if (b.is_empty()) return;
  cone = is_empty() ? b.cone : united(cone, b.cone);
  box.extend(b.box);
  radius = infinity;
  strength += b.strength;
}

LightGroup group_of(const Influence& light, std::uint32_t index) {
  LightGroup group;
  group.box = light.box;
  group.radius = std::sqrt(light.radius_squared) + length(light.center - light.box.center());
  group.cone.angle = std::acos(std::clamp(light.normal_cosine, -1.0, 1.0));
  group.cone.spread = std::acos(std::clamp(light.spread_cosine, -1.0, 1.0));
  if (group.cone.angle < pi) group.cone.axis = light.front;
  group.strength = light.strength;
  group.light = index;
  return group;
}

std::size_t cut(std::span<LightGroup> lights, const LightGroup& all) {
  if (lights.size() == 2) return 1;
  const Vec3d whole = all.box.extent();
  const Box3d centers = box_of_centers(lights);
  Cut best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double width = centers.extent()[axis];
    if (!(width > 0.0)) continue;
    const std::size_t count = std::min(most_bins, lights.size());
    const Slices slices{axis, centers.min[axis], static_cast<double>(count) / width, count};
    // Thin boxes stay thin unless there is something to gain.
    const Cut found = best_cut(lights, slices, max_component(whole) / std::max(whole[axis], width));
    if (found.cost < best.cost) best = found;
  }
  if (best.first_right == 0) return halve(lights);
  const auto middle = std::stable_partition(
      lights.begin(), lights.end(),
      [&](const LightGroup& light) { return best.slices.of(light) < best.first_right; });
  return static_cast<std::size_t>(middle - lights.begin());
}

std::size_t halve(std::span<LightGroup> lights) {
  const Vec3d e = box_of_centers(lights).extent();
  const std::size_t axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
  std::stable_sort(lights.begin(), lights.end(), [axis](const LightGroup& a, const LightGroup& b) {
    return a.box.center()[axis] < b.box.center()[axis];
  });
  return lights.size() / 2;
}

}  // namespace lapidary::light
