#pragma once

#include <optional>
#include <variant>

#include "geometry/interval_events.h"
#include "geometry/plane_crossing.h"
#include "geometry/surface_point.h"
#include "math/interval.h"
#include "math/transform.h"

namespace lapidary::geometry {

/// Seen from the front, the second edge of a parallelogram lies counter-clockwise of the first
/// (right-handed), or clockwise, as a mirror makes it.
enum class Handedness : std::uint8_t { right, left };

/// The flat parallelogram corner + a edge_u + b edge_v, a and b in [0, 1]; the edges are not
/// parallel. Its front is the side of cross(edge_u, edge_v), the other for left-handed ones. An
/// open surface, not a solid. Texture coordinates are (a, b).
struct Rectangle {
  Vec3d corner{-0.5, -0.5, 0};
  Vec3d edge_u{1, 0, 0};
  Vec3d edge_v{0, 1, 0};
  Handedness handedness = Handedness::right;
};

/// The flat disk of `radius` > 0 about `center`; `normal` (not zero) points to its front. An open
/// surface, not a solid. Texture coordinates are planar along the tangents of Frame::from_normal,
/// (1/2, 1/2) at the centre, the diameter 1.
struct Disk {
  Vec3d center;
  Vec3d normal{0, 0, 1};
  double radius = 1.0;
};

/// A flat open surface. Unlike a solid it bounds nothing: media are the same on both sides.
using Sheet = std::variant<Rectangle, Disk>;

/// A rectangle with what intersection needs computed beforehand: what an accelerator stores.
struct PreparedRectangle {
  explicit PreparedRectangle(const Rectangle& rectangle);

  Vec3d corner;
  Vec3d normal;  ///< of the front, unit length
  Vec3d dual_u;  ///< dual_u . edge_u = 1, dual_u . edge_v = 0
  Vec3d dual_v;
};

struct PreparedDisk {
  explicit PreparedDisk(const Disk& disk);

  Vec3d center;
  Vec3d normal;  ///< unit length
  double radius_squared;
};

using PreparedSheet = std::variant<PreparedRectangle, PreparedDisk>;
PreparedSheet prepared(const Sheet& sheet);

/// Where `line` crosses the sheet, nothing if it misses or runs parallel; `crossing` is `enter`
/// when the line comes from the front. The bound tau of t is for the sheet as stated in doubles.
/// A rectangle includes what lies outside by no more than rounding, so that neighbours that share
/// an edge leave no gap.
std::optional<Event> intersect(const PreparedRectangle& rectangle, const Line& line);
std::optional<Event> intersect(const PreparedDisk& disk, const Line& line);
std::optional<Event> intersect(const PreparedSheet& sheet, const Line& line);
std::optional<Event> intersect(const Sheet& sheet, const Line& line);  ///< prepares each time

Vec3d front_normal(const Sheet& sheet);  ///< unit length
SurfaceUv surface_uv(const Sheet& sheet, Vec3d p);
/// The same for a sheet that was prepared before.
SurfaceUv surface_uv(const Sheet& sheet, const PreparedSheet& prepared, Vec3d p);
Box3d bounds(const Sheet& sheet);
double area(const Sheet& sheet);                         ///< one side
BoundaryPoint sample_area(const Sheet& sheet, Vec2d u);  ///< uniform by area, with the front normal

/// The image of the sheet; the image of the front is the front, and texture coordinates stay with
/// their points (on a disk up to a turn about its normal). Failure: throws Error for a disk unless
/// the map is a similarity.
Sheet transformed(const Sheet& sheet, const Transform& world_from_object);

/// Error analysis: the prepared normal has 4 roundings (difference of products 1.5 ulp = 3 u,
/// scaling 1), but for a common factor, which cancels in t. Of a = dual_u . p, p = q + t d: |p_i
/// error| <= u |q_i| + tau |d_i| + u |p_i|
/// (+ line displacement), and the product has 3 roundings and about 8 of dual_u.
inline std::optional<Event> intersect(const PreparedRectangle& rectangle, const Line& line) {
  const Plane plane{rectangle.corner, rectangle.normal, 4};
  const Bounded slope = slope_over(plane, line);
  if (is_parallel(slope)) return std::nullopt;
  const PlaneCrossing c = cross_plane(height_over(plane, line), slope, 1.0 / slope.value);
  const Vec3d d = line.direction, q = line.origin - rectangle.corner;
  const Vec3d p{std::fma(c.t, d.x, q.x), std::fma(c.t, d.y, q.y), std::fma(c.t, d.z, q.z)};
  const double from_center_u = std::abs(dot(rectangle.dual_u, p) - 0.5);
  const double from_center_v = std::abs(dot(rectangle.dual_v, p) - 0.5);
  if (!(from_center_u <= 0.5 && from_center_v <= 0.5)) {
    const double displacement = line.error_at(c.t);
    const Vec3d e = (abs(q) + abs(p) * 12.0) * rounding_unit + abs(d) * c.tau +
                    Vec3d{displacement, displacement, displacement};
    if (!(from_center_u <= 0.5 + dot(abs(rectangle.dual_u), e) &&
          from_center_v <= 0.5 + dot(abs(rectangle.dual_v), e))) {
      return std::nullopt;
    }
  }
  return Event{c.t, c.tau, 0, slope.value < 0.0 ? Crossing::enter : Crossing::leave};
}

/// The scaling of the normal to unit length is one rounding.
inline std::optional<Event> intersect(const PreparedDisk& disk, const Line& line) {
  const Plane plane{disk.center, disk.normal, 1};
  const Bounded slope = slope_over(plane, line);
  if (is_parallel(slope)) return std::nullopt;
  const PlaneCrossing c = cross_plane(height_over(plane, line), slope, 1.0 / slope.value);
  const Vec3d d = line.direction, q = line.origin - disk.center;
  const Vec3d p{std::fma(c.t, d.x, q.x), std::fma(c.t, d.y, q.y), std::fma(c.t, d.z, q.z)};
  if (!(length_squared(p) <= disk.radius_squared)) return std::nullopt;
  return Event{c.t, c.tau, 0, slope.value < 0.0 ? Crossing::enter : Crossing::leave};
}

inline std::optional<Event> intersect(const PreparedSheet& sheet, const Line& line) {
  return std::visit([&](const auto& kind) { return intersect(kind, line); }, sheet);
}

}  // namespace lapidary::geometry
