#pragma once

#include "geometry/interval_events.h"
#include "geometry/surface_point.h"
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

/// The stretch of a line between two parallel faces, with error bounds of both ends.
struct Slab {
  double near = -infinity, far = infinity;
  double near_error = 0, far_error = 0;
};

/// The error bounds of where a line enters and leaves the common part of three slabs, to within a
/// rounding of `enter` and `leave`. The exact entry is the greatest exact near end: at least
/// max(near - error) and at most max(near + error), where an axis matters whose end may reach past
/// the one found. The exit likewise.
struct SlabErrors {
  double enter, leave;
};
SlabErrors slab_errors(const Slab (&slabs)[3], double enter, double leave);

/// Error analysis: t = (face - origin) * (1 / direction) has three roundings and no sum, so it is
/// exact to 3 u |t|; these errors grow with t, and so the greatest near end and the least far end
/// keep the bound of their own axis (the fourth u is slab_errors' rounding). A displacement delta
/// of the line adds delta / |exact direction|, where the exact direction is at least half the
/// computed one, or else the line counts as parallel.
///
/// A line parallel to a pair of faces is between them from `min` inclusive to `max` exclusive,
/// as tie_shift has it.
inline void intervals(const Box& box, const Line& line, EventBuffer& events) {
  events.clear();
  constexpr double u = rounding_unit;
  // Below this the reciprocal overflows, and 0 * infinity would follow.
  constexpr double smallest_direction = 0x1p-1000;
  const double parallel = smallest_direction + 2 * line.direction_error;
  const bool is_exact = line.origin_error == 0.0 && line.direction_error == 0.0;
  Slab slabs[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const double o = line.origin[i], d = line.direction[i];
    if (std::abs(d) <= parallel) {
      if (!(o + line.origin_error >= box.min[i] && o + line.origin_error < box.max[i])) return;
      continue;
    }
    const double inverse = 1.0 / d;
    const double t0 = (box.min[i] - o) * inverse, t1 = (box.max[i] - o) * inverse;
    slabs[i].near = d > 0.0 ? t0 : t1;
    slabs[i].far = d > 0.0 ? t1 : t0;
    if (is_exact) continue;
    const double scale = std::abs(inverse) * (1 + 2 * line.direction_error * std::abs(inverse));
    slabs[i].near_error = line.error_at(slabs[i].near) * scale;
    slabs[i].far_error = line.error_at(slabs[i].far) * scale;
  }
  const double enter = std::max(std::max(slabs[0].near, slabs[1].near), slabs[2].near);
  const double leave = std::min(std::min(slabs[0].far, slabs[1].far), slabs[2].far);
  if (!(enter < leave)) return;
  const int enter_axis = enter == slabs[0].near ? 0 : enter == slabs[1].near ? 1 : 2;
  const int leave_axis = leave == slabs[0].far ? 0 : leave == slabs[1].far ? 1 : 2;
  const int enter_high = line.direction[static_cast<std::size_t>(enter_axis)] < 0.0;
  const int leave_high = line.direction[static_cast<std::size_t>(leave_axis)] > 0.0;
  const SlabErrors displaced = is_exact ? SlabErrors{0, 0} : slab_errors(slabs, enter, leave);
  events.push({enter, 4 * u * std::abs(enter) + displaced.enter,
               static_cast<Patch>(2 * enter_axis + enter_high), Crossing::enter});
  events.push({leave, 4 * u * std::abs(leave) + displaced.leave,
               static_cast<Patch>(2 * leave_axis + leave_high), Crossing::leave});
}

inline SlabErrors slab_errors(const Slab (&slabs)[3], double enter, double leave) {
  SlabErrors errors{0, 0};
  for (const Slab& slab : slabs) {
    errors.enter = std::max(errors.enter, slab.near + slab.near_error - enter);
    errors.leave = std::max(errors.leave, leave - (slab.far - slab.far_error));
  }
  return errors;
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

}  // namespace lapidary::geometry
