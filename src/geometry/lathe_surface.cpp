#include <algorithm>

#include "geometry/exact_sign.h"
#include "geometry/lathe.h"
#include "geometry/lathe_data.h"
#include "sampling/warp.h"

namespace lapidary::geometry {
namespace {

using Data = Lathe::Data;
using Corner = Data::Corner;

/// Directions at a point: away from the axis, and about it. For points on the axis some.
struct Around {
  Vec3d radial, along;
  double from_axis;
};

Around around(Vec3d p) {
  const double rho = std::hypot(p.x, p.y);
  const Vec3d radial = rho > 0.0 ? Vec3d{p.x / rho, p.y / rho, 0} : Vec3d{1, 0, 0};
  return {radial, {-radial.y, radial.x, 0}, rho};
}

/// Of a point of the solid, as a share of the turn.
double share_of_turn(const Data& data, Vec3d p) {
  const double at = std::atan2(p.y, p.x), angle = at < 0.0 ? at + 2 * pi : at;
  const double share = angle / data.turn;
  if (share < 1.0) return share;
  // Rounding took it out of the turn.
  return data.is_whole() || angle - data.turn > 2 * pi - angle ? 0.0 : 1.0;
}

SurfaceUv edge_uv(const Data& data, std::size_t index, Vec3d p) {
  const Data::Edge& edge = data.edges[index];
  const Corner from = data.corners[index], along = data.along(index);
  const Around at = around(p);
  const double dr = at.from_axis - from.r, dz = p.z - data.base - from.height;
  const double share =
      (dr * along.r + dz * along.height) / (along.r * along.r + along.height * along.height);
  const double per_texture = 1.0 / (edge.texture_to - edge.texture_from);
  return {{share_of_turn(data, p), edge.texture_from + share / per_texture},
          at.along * (data.turn * at.from_axis),
          (at.radial * along.r + Vec3d{0, 0, along.height}) * per_texture};
}

BoundaryPoint sample_cap(const Data& data, std::size_t triangle, Patch patch, Vec2d u) {
  const auto [i, j, k] = data.cap[triangle];
  const Corner a = data.corners[i], b = data.corners[j], c = data.corners[k];
  const Vec2d weight = sample_triangle(u);
  const double r = a.r + (b.r - a.r) * weight.x + (c.r - a.r) * weight.y;
  const double height =
      a.height + (b.height - a.height) * weight.x + (c.height - a.height) * weight.y;
  const Vec2d out = patch == Data::start_cap ? Vec2d{1, 0} : data.end;
  return {{r * out.x, r * out.y, data.base + height},
          patch == Data::start_cap ? data.start_normal() : data.end_normal(),
          patch};
}

/// Rings have areas in proportion to their radius, so the square of the radius is uniform.
Vec3d sample_edge(const Data& data, std::size_t index, Vec2d u) {
  const Corner from = data.corners[index], to = data.corners[data.edges[index].to];
  const double r = std::sqrt(from.r * from.r * (1.0 - u.y) + to.r * to.r * u.y);
  const double share = r + from.r > 0.0 ? u.y * (from.r + to.r) / (r + from.r) : 0.0;
  const double height = from.height + (to.height - from.height) * share, phi = data.turn * u.x;
  return {r * std::cos(phi), r * std::sin(phi), data.base + height};
}

bool is_in_turn(const Data& data, Vec3d p) {
  const bool is_past_start = dot(p, data.start_normal()) <= 0.0;
  const bool is_before_end = dot(p, data.end_normal()) <= 0.0;
  if (data.is_whole()) return true;
  return data.is_reflex() ? is_past_start || is_before_end : is_past_start && is_before_end;
}

}  // namespace

Vec3d outward_normal(const Lathe& lathe, Patch patch, Vec3d p) {
  const Data& data = *lathe.data_;
  if (patch == Data::start_cap) return data.start_normal();
  if (patch == Data::end_cap) return data.end_normal();
  const Corner along = data.along(patch - Data::first_edge);
  const Around at = around(p);
  if (at.from_axis == 0.0) return {0, 0, along.r < 0.0 ? 1.0 : -1.0};
  return normalize(at.radial * along.height - Vec3d{0, 0, along.r});
}

SurfaceUv surface_uv(const Lathe& lathe, Patch patch, Vec3d p) {
  const Data& data = *lathe.data_;
  if (patch == Data::start_cap) return {{p.x, p.z}, {1, 0, 0}, {0, 0, 1}};
  if (patch == Data::end_cap) {
    const Vec3d inward{-data.end.x, -data.end.y, 0};
    return {{dot(p, inward), p.z}, inward, {0, 0, 1}};
  }
  return edge_uv(data, patch - Data::first_edge, p);
}

/// By the edges further from the axis, of which there are an odd number inside; on an edge is
/// inside, too. Exact for the distance from the axis as computed.
bool contains(const Lathe& lathe, Vec3d p) {
  const Data& data = *lathe.data_;
  if (!is_in_turn(data, p)) return false;
  const Vec2d q{std::hypot(p.x, p.y), p.z - data.base};
  bool inside = false;
  for (std::uint32_t n = 0; n < data.nodes.size();) {
    const Data::Node& node = data.nodes[n];
    if (q.y < node.height_min || q.y > node.height_max || q.x > node.r_max) {
      n = node.skip;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const Corner a = data.corners[i], b = data.corners[data.edges[i].to];
      const int side = orientation({a.r, a.height}, {b.r, b.height}, q);
      const bool is_within = std::min(a.r, b.r) <= q.x && q.x <= std::max(a.r, b.r) &&
                             std::min(a.height, b.height) <= q.y &&
                             q.y <= std::max(a.height, b.height);
      if (side == 0 && is_within) return true;
      if ((a.height > q.y) != (b.height > q.y) && (side > 0) == (b.height > a.height)) {
        inside = !inside;
      }
    }
    ++n;
  }
  return inside;
}

BoundaryPoint sample_boundary(const Lathe& lathe, Vec2d u, double u_patch) {
  const Data& data = *lathe.data_;
  const double total = data.shares.back();
  const double chosen = std::min(u_patch * total, std::nextafter(total, 0.0));
  // The first that the sum exceeds at has an area.
  const auto found = std::ranges::upper_bound(data.shares, chosen);
  const auto index = static_cast<std::size_t>(found - data.shares.begin());
  BoundaryPoint b;
  if (index < data.edges.size()) {
    b.patch = Data::first_edge + static_cast<Patch>(index);
    b.p = sample_edge(data, index, u);
    b.normal = outward_normal(lathe, b.patch, b.p);
  } else {
    const std::size_t triangle = index - data.edges.size(), count = data.cap.size();
    b = sample_cap(data, triangle % count, triangle < count ? Data::start_cap : Data::end_cap, u);
  }
  b.pdf_area = 1.0 / total;
  return b;
}

namespace {

bool is_on_axis(const Data& data, std::size_t edge) {
  return data.corners[edge].r == 0.0 && data.corners[data.edges[edge].to].r == 0.0;
}

/// Of a run: whether it ends at a corner on the axis that is no tip.
ChartEnd end_on_axis(const Data& data, std::size_t edge, std::uint32_t corner) {
  const Corner along = data.along(edge);
  const bool is_flat = std::abs(along.height) < std::abs(along.r);
  const bool is_pole = data.corners[corner].r == 0.0 && is_flat && data.is_whole();
  return is_pole ? ChartEnd::pole : ChartEnd::border;
}

UvChart chart_of_run(const Data& data, const SmoothRun& run) {
  UvChart chart;
  chart.first = Data::first_edge + static_cast<Patch>(run.first);
  chart.last = Data::first_edge + static_cast<Patch>(run.last);
  chart.min.y = data.edges[run.first].texture_from;
  chart.max.y = data.edges[run.last].texture_to;
  if (data.is_whole()) chart.u = ChartEnd::seam;
  if (run.is_closed) {
    chart.v_low = chart.v_high = ChartEnd::seam;
  } else {
    chart.v_low = end_on_axis(data, run.first, static_cast<std::uint32_t>(run.first));
    chart.v_high = end_on_axis(data, run.last, data.edges[run.last].to);
  }
  return chart;
}

}  // namespace

std::vector<UvChart> uv_charts(const Lathe& lathe) {
  const Data& data = *lathe.data_;
  const auto joins = [&](std::size_t i, std::size_t j) {
    const Corner a = data.along(i), b = data.along(j);
    const double sizes = std::hypot(a.r, a.height) * std::hypot(b.r, b.height);
    return a.r * b.r + a.height * b.height > cos_smooth_turn * sizes;
  };
  const auto exists = [&](std::size_t i) { return !is_on_axis(data, i); };
  std::vector<SmoothRun> runs;
  for (std::size_t begin = 0, end = 1; begin < data.edges.size(); begin = end++) {
    while (end < data.edges.size() && data.edges[end].texture_from > 0.0) ++end;
    cut_into_runs(begin, end, joins, exists, runs);
  }
  std::vector<UvChart> charts;
  if (!data.is_whole()) {
    charts = {planar_chart(Data::start_cap), planar_chart(Data::end_cap)};
  }
  for (const SmoothRun& run : runs) charts.push_back(chart_of_run(data, run));
  return charts;
}

std::optional<PatchPoint> point_at(const Lathe& lathe, const UvChart& chart, Vec2d uv) {
  const Data& data = *lathe.data_;
  if (chart.first == Data::start_cap) return PatchPoint{chart.first, {uv.x, 0.0, uv.y}};
  if (chart.first == Data::end_cap) {
    return PatchPoint{chart.first, {-data.end.x * uv.x, -data.end.y * uv.x, uv.y}};
  }
  const auto first = data.edges.begin() + (chart.first - Data::first_edge);
  const auto last = data.edges.begin() + (chart.last - Data::first_edge);
  const auto edge =
      std::partition_point(first, last, [&](const Data::Edge& e) { return e.texture_to < uv.y; });
  const auto index = static_cast<std::size_t>(edge - data.edges.begin());
  const double share = (uv.y - edge->texture_from) / (edge->texture_to - edge->texture_from);
  const Corner from = data.corners[index], along = data.along(index);
  const double phi = data.turn * uv.x, r = from.r + along.r * share;
  return PatchPoint{
      Data::first_edge + static_cast<Patch>(index),
      {r * std::cos(phi), r * std::sin(phi), data.base + from.height + along.height * share}};
}

}  // namespace lapidary::geometry
