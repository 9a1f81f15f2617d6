#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "body_checks.h"
#include "geometry/triangle_mesh.h"

namespace lapidary::geometry::exact {

/// Triangles in long double: textbook formulas, no code of the library.
struct Soup {
  using Real = long double;
  using Point = Vec3<Real>;
  std::vector<std::array<Point, 3>> triangles;

  Soup() = default;
  explicit Soup(const TriangleMesh& mesh) {
    for (const auto& t : mesh.triangles) {
      auto& c = triangles.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        c[i] = Point(Vec3d(mesh.positions[t[i]])) + Point(mesh.origin);
      }
    }
  }

  /// Where the line may touch a triangle, ends and edges included.
  std::vector<Real> touches(Point o, Point d) const {
    std::vector<Real> found;
    for (const auto& [a, b, c] : triangles) {
      const Point n = cross(b - a, c - a);
      const Real slope = dot(n, d);
      if (slope == 0) continue;
      const Real t = dot(a - o, n) / slope;
      const Point p = o + d * t;
      const Real area = dot(n, n), slack = -area / 1024;
      if (dot(cross(b - a, p - a), n) >= slack && dot(cross(c - b, p - b), n) >= slack &&
          dot(cross(a - c, p - c), n) >= slack) {
        found.push_back(t);
      }
    }
    return found;
  }

  /// The winding number by solid angles (Van Oosterom & Strackee 1983).
  bool inside(Point p) const {
    Real turns = 0;
    for (const auto& t : triangles) {
      const Point a = t[0] - p, b = t[1] - p, c = t[2] - p;
      const Real la = length(a), lb = length(b), lc = length(c);
      turns += std::atan2(dot(a, cross(b, c)),
                          la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return turns > static_cast<Real>(pi);
  }

  Real distance(Point p) const {
    Real least = infinity;
    for (const auto& t : triangles) least = std::min(least, length(p - nearest(t, p)));
    return least;
  }

  static Point nearest(const std::array<Point, 3>& t, Point p) {
    const Point n = cross(t[1] - t[0], t[2] - t[0]);
    if (dot(n, n) > 0) {
      const Point foot = p - n * (dot(p - t[0], n) / dot(n, n));
      bool within = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const Point &a = t[i], &b = t[(i + 1) % 3];
        within = within && dot(cross(b - a, foot - a), n) >= 0;
      }
      if (within) return foot;
    }
    Point best = t[0];
    for (std::size_t i = 0; i < 3; ++i) {
      const Point a = t[i], along = t[(i + 1) % 3] - a;
      const Real size = dot(along, along);
      const Real s = size > 0 ? std::clamp<Real>(dot(p - a, along) / size, 0, 1) : 0;
      const Point q = a + along * s;
      if (dot(p - q, p - q) < dot(p - best, p - best)) best = q;
    }
    return best;
  }
};

inline Oracle oracle_of(const Soup& soup, Soup::Point o, Soup::Point d, double rounding) {
  return {soup.touches(o, d), [&soup, o, d](long double t) { return soup.inside(o + d * t); },
          [&soup, o, d](long double t) { return soup.distance(o + d * t); }, rounding};
}

}  // namespace lapidary::geometry::exact
