#include "geometry/convex_hull.h"

#include <algorithm>
#include <map>
#include <optional>

#include "geometry/exact_sign.h"

namespace lapidary::geometry {
namespace {

using Triangle = ConvexHull::Triangle;

/// Points are added one by one: the triangles that see a point are replaced by those from the
/// rim of what it sees. A point in the plane of a triangle does not see it, so a new triangle is
/// never flat: its rim edge is of one that strictly sees the point.
class HullBuilder {
 public:
  explicit HullBuilder(std::span<const Vec3d> points) : points_(points) {}

  ConvexHull build() {
    const auto start = first_tetrahedron();
    if (!start) return {};
    const auto& [a, b, c, d] = *start;
    triangles_ = {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
    for (std::uint32_t i = 0; i < points_.size(); ++i) add(i);
    ConvexHull hull{triangles_, {}, 0};
    number_faces(hull);
    return hull;
  }

 private:
  int side(const Triangle& t, std::uint32_t i) const {
    return orientation(points_[t[0]], points_[t[1]], points_[t[2]], points_[i]);
  }

  bool on_one_line(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    // In one plane with any three points that span space.
    const Vec3d o = points_[a];
    const double size = 1.0 + max_component(abs(o));
    return orientation(o, points_[b], points_[c], o + Vec3d{size, 0, 0}) == 0 &&
           orientation(o, points_[b], points_[c], o + Vec3d{0, size, 0}) == 0 &&
           orientation(o, points_[b], points_[c], o + Vec3d{0, 0, size}) == 0;
  }

  /// Four points that are not in one plane, the first three counter-clockwise from outside.
  std::optional<std::array<std::uint32_t, 4>> first_tetrahedron() const {
    const auto count = static_cast<std::uint32_t>(points_.size());
    std::uint32_t b = 1;
    while (b < count && points_[b] == points_[0]) ++b;
    std::uint32_t c = b + 1;
    while (c < count && on_one_line(0, b, c)) ++c;
    for (std::uint32_t d = c + 1; d < count; ++d) {
      const int where = side({0, b, c}, d);
      if (where > 0) return {{0, b, c, d}};
      if (where < 0) return {{0, c, b, d}};
    }
    return std::nullopt;
  }

  void add(std::uint32_t i) {
    std::vector<Triangle> kept;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> rim;  // directed edges seen
    for (const Triangle& t : triangles_) {
      if (side(t, i) >= 0) {
        kept.push_back(t);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) ++rim[{t[k], t[(k + 1) % 3]}];
    }
    if (rim.empty()) return;
    for (const auto& [edge, uses] : rim) {
      const auto& [from, to] = edge;
      if (!rim.contains({to, from})) kept.push_back({from, to, i});
    }
    triangles_ = std::move(kept);
  }

  /// Neighbours in one plane are of one face.
  void number_faces(ConvexHull& hull) const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> triangle_at;
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      const Triangle& t = triangles_[i];
      for (std::size_t k = 0; k < 3; ++k) triangle_at[{t[k], t[(k + 1) % 3]}] = i;
    }
    constexpr std::uint32_t none = ~0u;
    hull.faces.assign(triangles_.size(), none);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      if (hull.faces[i] != none) continue;
      std::vector<std::uint32_t> open{i};
      hull.faces[i] = hull.face_count;
      while (!open.empty()) {
        const Triangle t = triangles_[open.back()];
        open.pop_back();
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t next = triangle_at.at({t[(k + 1) % 3], t[k]});
          const Triangle& n = triangles_[next];
          const bool flat = side(t, n[0]) == 0 && side(t, n[1]) == 0 && side(t, n[2]) == 0;
          if (hull.faces[next] != none || !flat) continue;
          hull.faces[next] = hull.face_count;
          open.push_back(next);
        }
      }
      ++hull.face_count;
    }
  }

  std::span<const Vec3d> points_;
  std::vector<Triangle> triangles_;
};

}  // namespace

ConvexHull convex_hull(std::span<const Vec3d> points) {
  return HullBuilder(points).build();
}

}  // namespace lapidary::geometry
