#include "geometry/lathe.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "base/error.h"
#include "geometry/affine_area.h"
#include "geometry/lathe_data.h"
#include "geometry/rounded_bounds.h"
#include "geometry/triangulate.h"
#include "math/quadrature.h"

namespace lapidary::geometry {
namespace {

using Data = Lathe::Data;
using Corner = Data::Corner;

void check_radii(const Polygon& profile) {
  const auto check = [](const std::vector<Vec2d>& loop, const std::string& name) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i].x >= 0.0) continue;
      throw Error({}, fmt::format("{}[{}] has the radius {}", name, i + 1, loop[i].x),
                  "points are {r, z} with r at least 0");
    }
  };
  check(profile.outline, "points");
  for (std::size_t l = 0; l < profile.holes.size(); ++l) {
    check(profile.holes[l], fmt::format("holes[{}]", l + 1));
  }
}

/// A height from which the differences of all others are exact and as small as the profile: one of
/// its own if no other is more than twice as far from 0 (Sterbenz 1974), and 0 if it reaches to
/// where it is about as large as far away.
double base_of(const std::vector<Vec2d>& points) {
  const auto [lowest, highest] = std::ranges::minmax(points, {}, &Vec2d::y);
  if (lowest.y > 0.0 && highest.y <= 2 * lowest.y) return lowest.y;
  if (highest.y < 0.0 && lowest.y >= 2 * highest.y) return highest.y;
  return 0.0;
}

/// Exact for multiples of 90 degrees.
Vec2d direction_of(double degrees) {
  if (degrees == 90.0) return {0, 1};
  if (degrees == 180.0) return {-1, 0};
  if (degrees == 270.0) return {0, -1};
  if (degrees == 360.0) return {1, 0};
  return {std::cos(radians(degrees)), std::sin(radians(degrees))};
}

void add_edges(const OrientedLoops& loops, Data& data) {
  for (std::size_t l = 0; l + 1 < loops.begins.size(); ++l) {
    const std::uint32_t begin = loops.begins[l], end = loops.begins[l + 1];
    double way = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t to = i + 1 < end ? i + 1 : begin, previous = i > begin ? i - 1 : end - 1;
      const Corner a = data.corners[i], b = data.corners[to];
      const double dr = b.r - a.r, dz = b.height - a.height, size = std::hypot(dr, dz);
      const double side = dz < 0.0 ? -1.0 : 1.0;
      const double outward = std::abs(dz) / size, upward = dz == 0.0 ? 1.0 : -side * dr / size;
      data.edges.push_back({to, previous, outward, upward, way, way + size});
      way += size;
    }
    for (std::uint32_t i = begin; i < end; ++i) {
      data.edges[i].texture_from /= way, data.edges[i].texture_to /= way;
    }
  }
}

/// The node of the edges begin to end, and all below it.
void add_nodes(Data& data, std::uint32_t begin, std::uint32_t end) {
  constexpr std::uint32_t leaf_size = 4;
  const std::size_t own = data.nodes.size();
  Data::Node node{infinity, 0.0, infinity, -infinity, begin, end, 0};
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const Corner c : {data.corners[i], data.corners[data.edges[i].to]}) {
      node.r_min = std::min(node.r_min, c.r), node.r_max = std::max(node.r_max, c.r);
      node.height_min = std::min(node.height_min, c.height);
      node.height_max = std::max(node.height_max, c.height);
    }
  }
  data.nodes.push_back(node);
  if (end - begin > leaf_size) {
    const std::uint32_t middle = begin + (end - begin) / 2;
    data.nodes[own].end = begin;
    add_nodes(data, begin, middle);
    add_nodes(data, middle, end);
  }
  data.nodes[own].skip = static_cast<std::uint32_t>(data.nodes.size());
}

void add_cap(const OrientedLoops& loops, Data& data) {
  const std::vector<std::uint32_t> loop = joined(loops);
  std::vector<Vec3d> points;
  for (const std::uint32_t i : loop) points.push_back({loops.points[i].x, loops.points[i].y, 0});
  PolygonTriangulator().triangulate(points, data.cap);
  for (auto& triangle : data.cap) {
    for (std::uint32_t& corner : triangle) corner = loop[corner];
  }
}

double cap_area(const Data& data, const std::array<std::uint32_t, 3>& triangle) {
  const Corner a = data.corners[triangle[0]], b = data.corners[triangle[1]],
               c = data.corners[triangle[2]];
  return 0.5 * std::abs((b.r - a.r) * (c.height - a.height) - (c.r - a.r) * (b.height - a.height));
}

/// Of the edges by Pappus.
void add_shares(Data& data) {
  double sum = 0;
  const auto add = [&](double area) { data.shares.push_back(sum += area); };
  for (std::size_t i = 0; i < data.edges.size(); ++i) {
    const Corner along = data.along(i);
    const double from_axis = 0.5 * (data.corners[i].r + data.corners[data.edges[i].to].r);
    add(data.turn * from_axis * std::hypot(along.r, along.height));
  }
  for (int side = 0; side < 2; ++side) {
    for (const auto& triangle : data.cap) add(cap_area(data, triangle));
  }
}

/// The greatest of x cos + y sin over the angles of the turn.
double greatest_over_turn(const Data& data, double x, double y) {
  const double at = std::atan2(y, x), angle = at < 0.0 ? at + 2 * pi : at;
  if (data.is_whole() || angle <= data.turn) return std::hypot(x, y);
  return std::max(x, x * data.end.x + y * data.end.y);
}

}  // namespace

Lathe make_lathe(const Polygon& profile, double degrees) {
  check_radii(profile);
  check_simple(profile);
  const OrientedLoops loops = oriented_loops(profile);
  Data data{};
  data.degrees = degrees, data.turn = radians(degrees), data.end = direction_of(degrees);
  data.base = base_of(loops.points);
  for (const Vec2d& p : loops.points) {
    data.corners.push_back({p.x, p.y - data.base});
    data.radius = std::max(data.radius, std::hypot(p.x, p.y - data.base));
  }
  add_edges(loops, data);
  add_nodes(data, 0, static_cast<std::uint32_t>(data.edges.size()));
  if (!data.is_whole()) add_cap(loops, data);
  add_shares(data);
  return Lathe(std::make_shared<const Data>(std::move(data)));
}

std::size_t Lathe::edge_count() const {
  return data_->edges.size();
}

/// By Pappus: the profile's area times the way of its centroid.
double Lathe::volume() const {
  double moment = 0;
  for (std::size_t i = 0; i < data_->edges.size(); ++i) {
    const Corner a = data_->corners[i], b = data_->corners[data_->edges[i].to];
    moment += (a.r + b.r) * (a.r * b.height - b.r * a.height);
  }
  return data_->turn * moment / 6.0;
}

double area(const Lathe& lathe) {
  return lathe.data_->shares.back();
}

/// Corners sweep the circles, or arcs, that reach furthest.
Box3d affine_bounds(const Lathe& lathe, const Transform& map) {
  const Data& data = *lathe.data_;
  Box3d box;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d row = map.linear().row[i];
    const double most = greatest_over_turn(data, row.x, row.y);
    const double least = -greatest_over_turn(data, -row.x, -row.y);
    for (const Corner& c : data.corners) {
      const double middle = map.offset()[i] + row.z * (data.base + c.height);
      box.max[i] = std::max(box.max[i], middle + most * c.r);
      box.min[i] = std::min(box.min[i], middle + least * c.r);
    }
  }
  return box;
}

Box3d bounds(const Lathe& lathe) {
  const Box3d box = affine_bounds(lathe, Transform());
  return padded(box, 8 * rounding_unit * max_component(max(abs(box.min), abs(box.max))));
}

double affine_area(const Lathe& lathe, const Mat3& linear) {
  const Data& data = *lathe.data_;
  const Mat3 c = cofactors(linear);
  const Vec3d east = c.column(0), north = c.column(1), up = c.column(2);
  double sum = 0;
  for (std::size_t i = 0; i < data.edges.size(); ++i) {
    const double radii = data.corners[i].r + data.corners[data.edges[i].to].r;
    if (radii == 0.0) continue;
    const auto [dr, dz] = data.along(i);
    const auto stretched = [&, dr = dr, dz = dz](double phi) {
      return length((east * std::cos(phi) + north * std::sin(phi)) * dz - up * dr);
    };
    sum += 0.5 * radii *
           (data.is_whole() ? ellipse_distance_integral(east * dz, north * dz, up * -dr)
                            : integrate(stretched, 0.0, data.turn));
  }
  double profile = 0;
  for (const auto& triangle : data.cap) profile += cap_area(data, triangle);
  if (profile == 0.0) return sum;
  return sum + profile * (length(c * data.start_normal()) + length(c * data.end_normal()));
}

int compare_content(const Lathe& a, const Lathe& b) {
  const Data &p = *a.data_, &q = *b.data_;
  if (&p == &q) return 0;
  if (p.corners.size() != q.corners.size()) return p.corners.size() < q.corners.size() ? -1 : 1;
  const std::array<double, 2> own{p.degrees, p.base}, other{q.degrees, q.base};
  const int order = std::memcmp(&own, &other, sizeof(own));
  if (order != 0) return order;
  const std::size_t count = p.corners.size();
  const int corners = std::memcmp(p.corners.data(), q.corners.data(), count * sizeof(Corner));
  if (corners != 0) return corners;
  // The same points may make different loops.
  for (std::size_t i = 0; i < count; ++i) {
    if (p.edges[i].to != q.edges[i].to) return p.edges[i].to < q.edges[i].to ? -1 : 1;
  }
  return 0;
}

}  // namespace lapidary::geometry
