#include "geometry/prism.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "geometry/triangle_shell.h"
#include "geometry/triangulate.h"

namespace lapidary::geometry {

struct Prism::Data {
  /// A side by its bottom edge.
  struct Side {
    Vec2d from, to;
    double u_from, u_to;  ///< texture coordinates of the ends
  };

  double height, scale;
  std::vector<Side> sides;
  TriangleShell shell;
  std::vector<Patch> face_of;  ///< which patch a triangle of the shell is a part of

  /// How much wider than the bottom the prism is at height z.
  double width(double z) const { return 1.0 + (scale - 1.0) * (z / height); }
};

namespace {

constexpr Patch bottom = 0, top = 1, first_side = 2;

std::vector<Prism::Data::Side> sides_of(const OrientedLoops& loops) {
  std::vector<Prism::Data::Side> sides;
  for (std::size_t l = 0; l + 1 < loops.begins.size(); ++l) {
    const std::size_t begin = loops.begins[l], end = loops.begins[l + 1], first = sides.size();
    double way = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec2d from = loops.points[i], to = loops.points[i + 1 < end ? i + 1 : begin];
      const double before = way;
      way += std::hypot(to.x - from.x, to.y - from.y);
      sides.push_back({from, to, before, way});
    }
    for (std::size_t i = first; i < sides.size(); ++i) sides[i].u_from /= way, sides[i].u_to /= way;
  }
  return sides;
}

/// The triangles of a prism, with the patch of each.
struct Faces {
  std::vector<TriangleShell::Triangle> triangles;
  std::vector<Patch> patches;

  void add(Patch patch, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles.push_back({a, b, c});
    patches.push_back(patch);
  }
};

/// Corners are numbered as the points of the loops at the bottom, and `top_begin` more at the top;
/// all of those at the top are one at the tip of a pyramid.
void add_sides(const OrientedLoops& loops, bool has_tip, Faces& faces) {
  const auto top_begin = static_cast<std::uint32_t>(loops.points.size());
  for (std::size_t l = 0; l + 1 < loops.begins.size(); ++l) {
    const std::uint32_t begin = loops.begins[l], end = loops.begins[l + 1];
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t j = i + 1 < end ? i + 1 : begin;
      const Patch side = first_side + i;
      if (has_tip) {
        faces.add(side, i, j, top_begin);
      } else {
        faces.add(side, i, j, top_begin + j);
        faces.add(side, i, top_begin + j, top_begin + i);
      }
    }
  }
}

void add_ends(const OrientedLoops& loops, bool has_tip, Faces& faces) {
  const std::vector<std::uint32_t> loop = joined(loops);
  std::vector<Vec3d> corners;
  for (const std::uint32_t i : loop) corners.push_back({loops.points[i].x, loops.points[i].y, 0});
  std::vector<std::array<std::uint32_t, 3>> triangles;
  PolygonTriangulator().triangulate(corners, triangles);
  const auto top_begin = static_cast<std::uint32_t>(loops.points.size());
  for (const auto& [i, j, k] : triangles) {
    const std::uint32_t a = loop[i], b = loop[j], c = loop[k];
    faces.add(bottom, a, c, b);
    if (!has_tip) faces.add(top, top_begin + a, top_begin + b, top_begin + c);
  }
}

std::vector<Vec3d> corners_of(const OrientedLoops& loops, double height, double scale) {
  std::vector<Vec3d> corners;
  for (const Vec2d& p : loops.points) corners.push_back({p.x, p.y, 0.0});
  if (scale == 0.0) {
    corners.push_back({0, 0, height});
    return corners;
  }
  for (const Vec2d& p : loops.points) corners.push_back({scale * p.x, scale * p.y, height});
  return corners;
}

double rounding_of_corners(const std::vector<Vec3d>& corners, double scale) {
  if (scale == 0.0 || scale == 1.0) return 0.0;
  double largest = 0;
  for (const Vec3d& p : corners) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return rounding_unit * largest;
}

}  // namespace

Prism make_prism(const Polygon& polygon, double height, double scale) {
  check_simple(polygon);
  const OrientedLoops loops = oriented_loops(polygon);
  const bool has_tip = scale == 0.0;
  Faces faces;
  add_sides(loops, has_tip, faces);
  add_ends(loops, has_tip, faces);
  std::vector<Vec3d> corners = corners_of(loops, height, scale);
  const double vertex_error = rounding_of_corners(corners, scale);
  TriangleShell shell({{}, std::move(corners), std::move(faces.triangles), vertex_error});
  return Prism(std::make_shared<const Prism::Data>(
      Prism::Data{height, scale, sides_of(loops), std::move(shell), std::move(faces.patches)}));
}

double Prism::volume() const {
  return data_->shell.volume();
}

std::size_t Prism::side_count() const {
  return data_->sides.size();
}

void intervals(const Prism& prism, const Line& line, EventBuffer& events) {
  intervals(prism.data_->shell, line, events);
  for (Event& e : events) e.patch = prism.data_->face_of[e.patch];
}

/// Of a side: across its bottom edge and the way up from the edge's first point.
Vec3d outward_normal(const Prism& prism, Patch patch, Vec3d) {
  if (patch == bottom) return {0, 0, -1};
  if (patch == top) return {0, 0, 1};
  const Prism::Data& data = *prism.data_;
  const auto& [from, to, u_from, u_to] = data.sides[patch - first_side];
  const Vec3d along{to.x - from.x, to.y - from.y, 0.0};
  const double shrink = data.scale - 1.0;
  return normalize(cross(along, Vec3d{shrink * from.x, shrink * from.y, data.height}));
}

SurfaceUv surface_uv(const Prism& prism, Patch patch, Vec3d p) {
  if (patch == bottom) return {{p.x, -p.y}, {1, 0, 0}, {0, -1, 0}};
  if (patch == top) return {{p.x, p.y}, {1, 0, 0}, {0, 1, 0}};
  const Prism::Data& data = *prism.data_;
  const auto& [from, to, u_from, u_to] = data.sides[patch - first_side];
  const double width = data.width(p.z), share_of_loop = u_to - u_from;
  const Vec2d along = to - from;
  // At the tip all points of the edge are one.
  double share = 0;
  if (width > 0.0) {
    const Vec2d q{p.x / width - from.x, p.y / width - from.y};
    share = (q.x * along.x + q.y * along.y) / (along.x * along.x + along.y * along.y);
  }
  const Vec2d foot = from + along * share;
  const double shrink = data.scale - 1.0, per_u = width / share_of_loop;
  return {{u_from + share * share_of_loop, p.z / data.height},
          {along.x * per_u, along.y * per_u, 0.0},
          {shrink * foot.x, shrink * foot.y, data.height}};
}

bool contains(const Prism& prism, Vec3d p) {
  return contains(prism.data_->shell, p);
}

Box3d bounds(const Prism& prism) {
  return prism.data_->shell.bounds();
}

double area(const Prism& prism) {
  return prism.data_->shell.area();
}

BoundaryPoint sample_boundary(const Prism& prism, Vec2d u, double u_patch) {
  BoundaryPoint b = prism.data_->shell.sample(u, u_patch);
  b.patch = prism.data_->face_of[b.patch];
  b.normal = outward_normal(prism, b.patch, b.p);
  return b;
}

Box3d affine_bounds(const Prism& prism, const Transform& map) {
  return prism.data_->shell.affine_bounds(map);
}

double affine_area(const Prism& prism, const Mat3& linear) {
  return prism.data_->shell.affine_area(linear);
}

int compare_content(const Prism& a, const Prism& b) {
  const Prism::Data &p = *a.data_, &q = *b.data_;
  const std::array<double, 2> sizes_a{p.height, p.scale}, sizes_b{q.height, q.scale};
  const int sizes = std::memcmp(&sizes_a, &sizes_b, sizeof(sizes_a));
  if (sizes != 0 || a.data_ == b.data_) return sizes;
  if (p.sides.size() != q.sides.size()) return p.sides.size() < q.sides.size() ? -1 : 1;
  return std::memcmp(p.sides.data(), q.sides.data(), p.sides.size() * sizeof(Prism::Data::Side));
}

std::vector<UvChart> uv_charts(const Prism& prism) {
  const auto& sides = prism.data_->sides;
  const auto along = [&](std::size_t i) {
    const Vec2d way = sides[i].to - sides[i].from;
    return way * (1.0 / std::hypot(way.x, way.y));
  };
  const auto joins = [&](std::size_t i, std::size_t j) {
    const Vec2d a = along(i), b = along(j);
    return a.x * b.x + a.y * b.y > cos_smooth_turn;
  };
  std::vector<SmoothRun> runs;
  for (std::size_t begin = 0, end = 1; begin < sides.size(); begin = end++) {
    while (end < sides.size() && sides[end].u_from > 0.0) ++end;
    cut_into_runs(
        begin, end, joins, [](std::size_t) { return true; }, runs);
  }
  std::vector<UvChart> charts{planar_chart(bottom), planar_chart(top)};
  if (prism.data_->scale == 0.0) charts.pop_back();
  for (const SmoothRun& run : runs) {
    UvChart& chart = charts.emplace_back();
    chart.first = first_side + static_cast<Patch>(run.first);
    chart.last = first_side + static_cast<Patch>(run.last);
    chart.min.x = sides[run.first].u_from, chart.max.x = sides[run.last].u_to;
    if (run.is_closed) chart.u = ChartEnd::seam;
  }
  return charts;
}

std::optional<PatchPoint> point_at(const Prism& prism, const UvChart& chart, Vec2d uv) {
  const Prism::Data& data = *prism.data_;
  if (chart.first == bottom) return PatchPoint{bottom, {uv.x, -uv.y, 0.0}};
  if (chart.first == top) return PatchPoint{top, {uv.x, uv.y, data.height}};
  const auto first = data.sides.begin() + (chart.first - first_side);
  const auto last = data.sides.begin() + (chart.last - first_side);
  const auto side =
      std::partition_point(first, last, [&](const Prism::Data::Side& s) { return s.u_to < uv.x; });
  const double share = (uv.x - side->u_from) / (side->u_to - side->u_from);
  const Vec2d foot = side->from + (side->to - side->from) * share;
  const double height = uv.y * data.height, width = data.width(height);
  return PatchPoint{first_side + static_cast<Patch>(side - data.sides.begin()),
                    {foot.x * width, foot.y * width, height}};
}

}  // namespace lapidary::geometry
