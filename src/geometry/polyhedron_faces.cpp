#include <algorithm>

#include "geometry/polyhedron_data.h"
#include "geometry/rounded_bounds.h"

/// The faces of an intersection of half-spaces: each plane starts as a huge square that all the
/// others cut (Sutherland & Hodgman 1974). In 113 bits: corners are then exact to double in all
/// but the worst cases, and what is nearer than 2^-70 can be told from what coincides.
namespace lapidary::geometry {
namespace {

__extension__ typedef __float128 Quad;

struct Point {
  Quad x = 0, y = 0, z = 0;

  Point() = default;
  Point(Quad x_, Quad y_, Quad z_) : x(x_), y(y_), z(z_) {}
  explicit Point(Vec3d p) : x(p.x), y(p.y), z(p.z) {}
  explicit operator Vec3d() const {
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }
};
Point operator+(const Point& a, const Point& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Point operator*(const Point& a, Quad s) {
  return {a.x * s, a.y * s, a.z * s};
}
Quad dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Where everything is, in one length.
struct Extent {
  Vec3d middle;
  double size;  ///< of the distances of the half-spaces' points from the middle; 1 if that is 0
};

constexpr double far_away = 0x1p20;     // in sizes: the half side of the starting squares
constexpr double coincident = 0x1p-70;  // in sizes

Extent extent_of(std::span<const HalfSpace> half_spaces) {
  Extent e{{}, 0};
  for (const HalfSpace& h : half_spaces) {
    e.middle += h.point * (1.0 / static_cast<double>(half_spaces.size()));
  }
  for (const HalfSpace& h : half_spaces) e.size = std::max(e.size, length(h.point - e.middle));
  if (e.size == 0.0) e.size = 1.0;
  return e;
}

using Polygon = std::vector<Point>;

/// Spans the plane near the middle, counter-clockwise seen from where the normal points.
Polygon huge_square(const HalfSpace& h, const Extent& extent) {
  const Point n(h.normal), to_middle = Point(extent.middle) - Point(h.point);
  const Point center = Point(extent.middle) - n * (dot(to_middle, n) / dot(n, n));
  // Any two directions in the plane do, about as long as each other.
  const Vec3d a = abs(h.normal);
  const Vec3d least = a.x <= a.y && a.x <= a.z ? Vec3d{1, 0, 0}
                      : a.y <= a.z             ? Vec3d{0, 1, 0}
                                               : Vec3d{0, 0, 1};
  const Vec3d unit = normalize(h.normal), side = normalize(cross(unit, least));
  const auto in_plane = [&](Vec3d v) {
    const Point p(v);
    return (p - n * (dot(p, n) / dot(n, n))) * (extent.size * far_away);
  };
  const Point u = in_plane(side), v = in_plane(cross(unit, side));
  return {center + u + v, center - u + v, center - u - v, center + u - v};
}

/// Keeps what is below the plane of `h`, or in it as well as can be told.
void cut(Polygon& polygon, const HalfSpace& h, double tolerance) {
  const Point n(h.normal), p(h.point);
  const Quad most = Quad(tolerance) * length(h.normal);
  std::vector<Quad> height;
  for (const Point& q : polygon) height.push_back(dot(q - p, n));
  if (std::ranges::all_of(height, [&](Quad x) { return x <= most; })) return;
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    if (height[i] <= most) kept.push_back(polygon[i]);
    if ((height[i] <= most) == (height[next] <= most)) continue;
    const Quad share = height[i] / (height[i] - height[next]);
    // Within the tolerance the end itself is as good as the crossing.
    if (share >= 0 && share <= 1) {
      kept.push_back(polygon[i] + (polygon[next] - polygon[i]) * share);
    }
  }
  polygon = std::move(kept);
  if (polygon.size() < 3) polygon.clear();
}

/// In double, to save most of the cuts: whether all corners are far below the plane.
bool is_clear_of(const std::vector<Vec3d>& corners, const HalfSpace& h, const Extent& extent) {
  const double margin = 1e-9 * extent.size * length(h.normal);
  return std::ranges::all_of(corners, [&](Vec3d q) {
    return length(q - extent.middle) < 64 * extent.size && dot(q - h.point, h.normal) < -margin;
  });
}

Polygon face(std::span<const HalfSpace> half_spaces, std::size_t own, const Extent& extent) {
  Polygon polygon = huge_square(half_spaces[own], extent);
  std::vector<Vec3d> corners;
  for (std::size_t i = 0; i < half_spaces.size() && !polygon.empty(); ++i) {
    if (i == own) continue;
    const HalfSpace& h = half_spaces[i];
    // Of two half-spaces with the same plane the first has the face.
    const bool repeats = h.point == half_spaces[own].point && h.normal == half_spaces[own].normal;
    if (repeats && i < own) return {};
    if (!corners.empty() && is_clear_of(corners, h, extent)) continue;
    cut(polygon, h, coincident * extent.size);
    corners.clear();
    for (const Point& p : polygon) corners.emplace_back(Vec3d(p));
  }
  return polygon;
}

Box3d box_of_half_spaces(std::span<const HalfSpace> half_spaces) {
  Box3d box = Box3d::all();
  for (const HalfSpace& h : half_spaces) {
    const Box3d b = bounds(h);
    box = {max(box.min, b.min), min(box.max, b.max)};
  }
  return box;
}

/// Whether some point is truly inside of all planes: the mean of all corners; of a single face,
/// which that lies on, a point behind.
bool has_interior(std::span<const HalfSpace> half_spaces, const std::vector<Polygon>& faces,
                  const Extent& extent) {
  Point sum, behind;
  int corners = 0, used = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const Point& p : faces[i]) sum = sum + (p - Point(extent.middle)), ++corners;
    if (faces[i].empty()) continue;
    ++used;
    behind = Point(normalize(half_spaces[i].normal) * -extent.size);
  }
  if (corners == 0) return false;
  Point mean = Point(extent.middle) + sum * (Quad(1) / corners);
  if (used == 1) mean = mean + behind;
  return std::ranges::all_of(half_spaces, [&](const HalfSpace& h) {
    return dot(mean - Point(h.point), Point(h.normal)) <
           -Quad(coincident) * extent.size * length(h.normal);
  });
}

}  // namespace

PolyhedronFaces faces_of_intersection(std::span<const HalfSpace> half_spaces) {
  const Extent extent = extent_of(half_spaces);
  std::vector<Polygon> faces;
  for (std::size_t i = 0; i < half_spaces.size(); ++i) {
    faces.push_back(face(half_spaces, i, extent));
  }
  PolyhedronFaces found;
  found.has_volume = has_interior(half_spaces, faces, extent);
  if (!found.has_volume) return found;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    std::vector<Vec3d> p;
    for (const Point& corner : faces[i]) p.emplace_back(Vec3d(corner));
    for (std::size_t k = 2; k < p.size(); ++k) {
      found.pieces.push_back({{p[0], p[k - 1], p[k]}, static_cast<Patch>(i)});
    }
    for (const Vec3d& corner : p) found.box.extend(corner);
  }
  const Vec3d reach = max(abs(found.box.min - extent.middle), abs(found.box.max - extent.middle));
  if (max_component(reach) > 0.5 * far_away * extent.size) {
    found.pieces.clear();
    found.box = box_of_half_spaces(half_spaces);
  } else {
    found.box = rounded_outward(found.box);
  }
  return found;
}

}  // namespace lapidary::geometry
