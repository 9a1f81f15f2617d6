#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>
#include <utility>

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

struct Corner {
  explicit Corner(const Point& p) : exact(p), rounded(p) {}
  Point exact;
  Vec3d rounded;
};
using Polygon = std::vector<Corner>;

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
  return {Corner(center + u + v), Corner(center - u + v), Corner(center - u - v),
          Corner(center + u - v)};
}

/// A plane of the intersection, which cuts the faces of the others.
class CuttingPlane {
 public:
  CuttingPlane(const HalfSpace& h, const Extent& extent)
      : stated_(h),
        exact_normal_(h.normal),
        exact_point_(h.point),
        unit_(normalize(h.normal)),
        distance_(dot(h.point - extent.middle, unit_)),
        tolerance_(coincident * extent.size * length(h.normal)) {}

  const HalfSpace& stated() const { return stated_; }
  /// How far the line that it has in common with another passes from the foot of the middle there.
  double distance_in(const CuttingPlane& other) const {
    const double cosine = dot(unit_, other.unit_);
    const double d = (distance_ - other.distance_ * cosine) / std::sqrt(1 - cosine * cosine);
    return std::isnan(d) ? infinity : d;
  }

  /// What is above it by less than can be told counts as below. Double is enough where the corner
  /// is further away than it errs: 5 roundings of each term.
  bool takes(const Corner& corner) const {
    const Vec3d q = corner.rounded, p = stated_.point;
    const double height = dot(q - p, stated_.normal);
    const double error = 8 * rounding_unit * dot(abs(q) + abs(p), abs(stated_.normal));
    if (std::abs(height) > error + tolerance_) return height > 0;
    return exact_height(corner.exact) > tolerance_;
  }

  bool has_clearly_below(const Point& p) const { return exact_height(p) < -Quad(tolerance_); }

  /// Where it cuts an edge; nothing where an end does as well, within the tolerance.
  std::optional<Corner> crossing(const Corner& a, const Corner& b) const {
    const Quad from = exact_height(a.exact), share = from / (from - exact_height(b.exact));
    if (!(share >= 0 && share <= 1)) return std::nullopt;
    return Corner(a.exact + (b.exact - a.exact) * share);
  }

 private:
  Quad exact_height(const Point& p) const { return dot(p - exact_point_, exact_normal_); }

  HalfSpace stated_;
  Point exact_normal_, exact_point_;
  Vec3d unit_;
  double distance_;  ///< from the middle
  double tolerance_;
};

void cut(Polygon& polygon, const CuttingPlane& plane) {
  std::vector<bool> taken;
  taken.reserve(polygon.size());
  for (const Corner& corner : polygon) taken.push_back(plane.takes(corner));
  if (std::ranges::find(taken, true) == taken.end()) return;
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    if (!taken[i]) kept.push_back(polygon[i]);
    if (taken[i] == taken[next]) continue;
    if (const auto corner = plane.crossing(polygon[i], polygon[next])) kept.push_back(*corner);
  }
  polygon = std::move(kept);
  if (polygon.size() < 3) polygon.clear();
}

/// All but one, those first that pass nearest to the middle there: they make most of the edges and
/// leave little for the others to cut. The face is the same in any order, but takes longer.
std::vector<std::size_t> nearest_first(std::span<const CuttingPlane> planes, std::size_t own) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (i != own) order.emplace_back(planes[i].distance_in(planes[own]), i);
  }
  std::ranges::sort(order);
  const auto numbers = order | std::views::values;
  return {numbers.begin(), numbers.end()};
}

Polygon face(std::span<const CuttingPlane> planes, std::size_t own, const Extent& extent) {
  const HalfSpace& h = planes[own].stated();
  Polygon polygon = huge_square(h, extent);
  for (const std::size_t i : nearest_first(planes, own)) {
    if (polygon.empty()) break;
    // Of two half-spaces with the same plane the first has the face.
    const HalfSpace& other = planes[i].stated();
    if (i < own && other.point == h.point && other.normal == h.normal) return {};
    cut(polygon, planes[i]);
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
bool has_interior(std::span<const CuttingPlane> planes, const std::vector<Polygon>& faces,
                  const Extent& extent) {
  Point sum, behind;
  int corners = 0, used = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const Corner& corner : faces[i]) {
      sum = sum + (corner.exact - Point(extent.middle));
      ++corners;
    }
    if (faces[i].empty()) continue;
    ++used;
    behind = Point(normalize(planes[i].stated().normal) * -extent.size);
  }
  if (corners == 0) return false;
  Point mean = Point(extent.middle) + sum * (Quad(1) / corners);
  if (used == 1) mean = mean + behind;
  return std::ranges::all_of(planes,
                             [&](const CuttingPlane& p) { return p.has_clearly_below(mean); });
}

}  // namespace

PolyhedronFaces faces_of_intersection(std::span<const HalfSpace> half_spaces) {
  const Extent extent = extent_of(half_spaces);
  std::vector<CuttingPlane> planes;
  for (const HalfSpace& h : half_spaces) planes.emplace_back(h, extent);
  std::vector<Polygon> faces;
  for (std::size_t i = 0; i < planes.size(); ++i) faces.push_back(face(planes, i, extent));
  PolyhedronFaces found;
  found.has_volume = has_interior(planes, faces, extent);
  if (!found.has_volume) return found;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Polygon& p = faces[i];
    for (std::size_t k = 2; k < p.size(); ++k) {
      found.pieces.push_back(
          {{p[0].rounded, p[k - 1].rounded, p[k].rounded}, static_cast<Patch>(i)});
    }
    for (const Corner& corner : p) found.box.extend(corner.rounded);
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
