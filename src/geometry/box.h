#pragma once

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
#include "geometry/uv_chart.h"
#include "math/interval.h"

namespace lapidary::geometry {

/// The axis-aligned box from corner `min` to corner `max`, min < max in every axis. Patches: 0 and
/// 1 the faces at min.x and max.x, 2 and 3 those of y, 4 and 5 those of z.
///
/// Texture coordinates run from 0 to 1 over each face, u to the right as seen from outside; v goes
/// up (+z) on the four sides, and along +y on the faces of z.
struct Box {
  Vec3d min{-0.5, -0.5, -0.5};
  Vec3d max{0.5, 0.5, 0.5};
};

/// The stretches of a line between the three pairs of opposite faces.
struct Slabs {
  double near[3]{-infinity, -infinity, -infinity};
  double far[3]{infinity, infinity, infinity};
  double inverse[3]{0, 0, 0};  ///< of the direction; 0 where the line is parallel
};

/// What displacement of the line adds to the error bounds of an entry and an exit.
///
/// At each axis it is the displacement over the exact direction, which is at least half the
/// computed one: 1/(1 - x) <= 1 + 2x for x <= 1/2. The exact entry is the greatest exact near end,
/// at least max(near - error) and at most max(near + error): other axes than the one found matter
/// when they may reach past it. The exit likewise.
struct SlabErrors {
  double enter = 0, leave = 0;
};
inline SlabErrors displacement_errors(const Slabs& slabs, const Line& line, double enter,
                                      double leave) {
  SlabErrors errors;
  for (std::size_t i = 0; i < 3; ++i) {
    if (slabs.inverse[i] == 0.0) continue;
    const double inverse = std::abs(slabs.inverse[i]);
    const double scale = inverse + 2 * line.direction_error * inverse * inverse;
    errors.enter =
        std::max(errors.enter, slabs.near[i] + line.error_at(slabs.near[i]) * scale - enter);
    errors.leave =
        std::max(errors.leave, leave - (slabs.far[i] - line.error_at(slabs.far[i]) * scale));
  }
  return errors;
}

/// Error analysis: t = (face - origin) * (1 / direction) has three roundings and no sum, so it is
/// exact to 3 u |t|; these errors grow with t, and so the greatest near end and the least far end
/// keep the bound of their own axis. Displacement comes on top, with a rounding of its own.
///
/// A line parallel to a pair of faces is between them from `min` inclusive to `max` exclusive,
/// as tie_shift has it.
inline void intervals(const Box& box, const Line& line, EventBuffer& events) {
  events.clear();
  constexpr double u = rounding_unit;
  // Below this the reciprocal overflows, and 0 * infinity would follow.
  constexpr double smallest_direction = 0x1p-1000;
  const double parallel = smallest_direction + 2 * line.direction_error;
  Slabs slabs;
  for (std::size_t i = 0; i < 3; ++i) {
    const double o = line.origin[i], d = line.direction[i];
    if (std::abs(d) <= parallel) {
      if (!(o + line.origin_error >= box.min[i] && o + line.origin_error < box.max[i])) return;
      continue;
    }
    slabs.inverse[i] = 1.0 / d;
    const double t0 = (box.min[i] - o) * slabs.inverse[i];
    const double t1 = (box.max[i] - o) * slabs.inverse[i];
    slabs.near[i] = d > 0.0 ? t0 : t1;
    slabs.far[i] = d > 0.0 ? t1 : t0;
  }
  const double enter = std::max(std::max(slabs.near[0], slabs.near[1]), slabs.near[2]);
  const double leave = std::min(std::min(slabs.far[0], slabs.far[1]), slabs.far[2]);
  if (!(enter < leave)) return;
  const std::size_t enter_axis = enter == slabs.near[0] ? 0 : enter == slabs.near[1] ? 1 : 2;
  const std::size_t leave_axis = leave == slabs.far[0] ? 0 : leave == slabs.far[1] ? 1 : 2;
  const std::size_t enter_high = slabs.inverse[enter_axis] < 0.0;
  const std::size_t leave_high = slabs.inverse[leave_axis] > 0.0;
  double enter_error = 3 * u * std::abs(enter), leave_error = 3 * u * std::abs(leave);
  if (!line.is_exact()) {
    const SlabErrors displaced = displacement_errors(slabs, line, enter, leave);
    enter_error += displaced.enter + u * std::abs(enter);
    leave_error += displaced.leave + u * std::abs(leave);
  }
  events.push(
      {enter, enter_error, static_cast<Patch>(2 * enter_axis + enter_high), Crossing::enter});
  events.push(
      {leave, leave_error, static_cast<Patch>(2 * leave_axis + leave_high), Crossing::leave});
}

inline Vec3d outward_normal(const Box&, Patch patch, Vec3d) {
  Vec3d n;
  n[patch / 2u] = patch % 2u == 0 ? -1.0 : 1.0;
  return n;
}

inline bool contains(const Box& box, Vec3d p) {
  return Box3d{box.min, box.max}.contains(p);
}

SurfaceUv surface_uv(const Box& box, Patch patch, Vec3d p);
Box3d bounds(const Box& box);
double area(const Box& box);
BoundaryPoint sample_boundary(const Box& box, Vec2d u, double u_patch);
/// The pieces that make up the surface, and the point of a piece that has these coordinates:
/// the inverse of surface_uv, to a few roundings. Nothing where there is none.
std::vector<UvChart> uv_charts(const Box& box);
std::optional<PatchPoint> point_at(const Box& box, const UvChart& chart, Vec2d uv);

}  // namespace lapidary::geometry
