#include "geometry/mesh_chart.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <unordered_map>

#include <fmt/format.h>

#include "math/constants.h"
#include "math/frame.h"

namespace lapidary::geometry {
namespace {

using Corners2 = std::array<Vec2d, 3>;

double doubled_area(const Corners2& c) {
  const Vec2d a = c[1] - c[0], b = c[2] - c[0];
  return a.x * b.y - a.y * b.x;
}

/// Which triangle covers which point of a square lattice.
class Occupancy {
 public:
  explicit Occupancy(double spacing) : spacing_(spacing) {}

  void clear() { covered_.clear(); }

  /// Whether no point strictly inside of the triangle is covered; then they are from now on.
  bool take(const Corners2& corners) {
    if (!visit(corners, [&](std::uint64_t key) { return !covered_.contains(key); })) return false;
    visit(corners, [&](std::uint64_t key) { return covered_.emplace(key, true), true; });
    return true;
  }

 private:
  /// Calls `use` for each point until that says no.
  template <typename Use>
  bool visit(const Corners2& corners, Use&& use) const {
    Corners2 c = corners;
    const double area = doubled_area(c);
    if (area < 0.0) std::swap(c[1], c[2]);
    const auto range = [&](std::size_t axis) {
      const auto [low, high] = std::minmax({c[0][axis], c[1][axis], c[2][axis]});
      return std::pair(std::ceil(low / spacing_), std::floor(high / spacing_));
    };
    const auto [y0, y1] = range(1);
    const auto [x0, x1] = range(0);
    // Off the edges by more than rounding: neighbours share them.
    const double margin = 1e-9 * std::abs(area);
    for (double y = y0; y <= y1; ++y) {
      for (double x = x0; x <= x1; ++x) {
        const Vec2d p{x * spacing_, y * spacing_};
        const bool inside = doubled_area({c[0], c[1], p}) > margin &&
                            doubled_area({c[1], c[2], p}) > margin &&
                            doubled_area({c[2], c[0], p}) > margin;
        if (inside && !use(key_of(x, y))) return false;
      }
    }
    return true;
  }
  static std::uint64_t key_of(double x, double y) {
    const auto bits = [](double v) {
      return static_cast<std::uint64_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(v)));
    };
    return bits(x) << 32 | bits(y);
  }

  double spacing_;
  std::unordered_map<std::uint64_t, bool> covered_;
};

std::array<Vec3d, 3> corners_of(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return {Vec3d(mesh.positions[t[0]]), Vec3d(mesh.positions[t[1]]), Vec3d(mesh.positions[t[2]])};
}

/// Twice the area, along the normal.
Vec3d area_vector(const std::array<Vec3d, 3>& c) {
  return cross(c[1] - c[0], c[2] - c[0]);
}

/// The triangle beyond each edge; none where there is none, or more than one.
std::vector<std::array<std::uint32_t, 3>> neighbours_of(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> order(mesh.positions.size()), place(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    const Vec3f p = mesh.positions[i];
    return std::tuple(p.x, p.y, p.z);
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? place[order[i - 1]] : order[i];
  }
  struct Edge {
    std::uint32_t low, high, face, side;
  };
  std::vector<Edge> edges;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t a = place[mesh.triangles[f][side]];
      const std::uint32_t b = place[mesh.triangles[f][(side + 1) % 3]];
      edges.push_back({std::min(a, b), std::max(a, b), f, side});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.face, a.side) < std::tie(b.low, b.high, b.face, b.side);
  });
  constexpr std::uint32_t none = ~0u;
  std::vector<std::array<std::uint32_t, 3>> beyond(mesh.triangles.size(), {none, none, none});
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high)
      ++end;
    if (end - i != 2) continue;
    beyond[edges[i].face][edges[i].side] = edges[i + 1].face;
    beyond[edges[i + 1].face][edges[i + 1].side] = edges[i].face;
  }
  return beyond;
}

void set_bounds(MeshCharts& charts) {
  for (MeshCharts::Chart& chart : charts.charts) {
    chart.min = {infinity, infinity}, chart.max = {-infinity, -infinity};
    for (const std::uint32_t face : chart.faces) {
      for (const Vec2d& p : charts.faces[face].at) {
        chart.min = {std::min(chart.min.x, p.x), std::min(chart.min.y, p.y)};
        chart.max = {std::max(chart.max.x, p.x), std::max(chart.max.y, p.y)};
      }
    }
  }
}

/// Grows charts one after the other.
class Projection {
 public:
  explicit Projection(const TriangleMesh& mesh)
      : mesh_(mesh), beyond_(neighbours_of(mesh)), occupancy_(spacing_for(mesh)) {
    charts_.faces.resize(mesh.triangles.size());
  }

  MeshCharts all() {
    for (std::uint32_t f = 0; f < mesh_.triangles.size(); ++f) {
      if (charts_.faces[f].chart == MeshCharts::no_chart) grow(f);
    }
    set_bounds(charts_);
    return std::move(charts_);
  }

 private:
  /// A few points for each triangle of middling size.
  static double spacing_for(const TriangleMesh& mesh) {
    double area = 0.0;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      area += 0.5 * length(area_vector(corners_of(mesh, f)));
    }
    return std::sqrt(area / (4.0 * static_cast<double>(mesh.triangles.size()) + 1e4));
  }

  void grow(std::uint32_t seed) {
    const Vec3d direction = area_vector(corners_of(mesh_, seed));
    if (!(length(direction) > 0.0)) return;
    const Frame frame = Frame::from_normal(normalize(direction));
    const auto number = static_cast<std::uint32_t>(charts_.charts.size());
    charts_.charts.emplace_back();
    occupancy_.clear();
    std::deque<std::uint32_t> edge{seed};
    while (!edge.empty()) {
      const std::uint32_t f = edge.front();
      edge.pop_front();
      if (!accept(f, number, frame)) continue;
      for (const std::uint32_t next : beyond_[f]) {
        if (next != ~0u && charts_.faces[next].chart == MeshCharts::no_chart) edge.push_back(next);
      }
    }
  }

  bool accept(std::uint32_t f, std::uint32_t chart, const Frame& frame) {
    constexpr double least_cosine = 0.766;  // of 40 degrees
    if (charts_.faces[f].chart != MeshCharts::no_chart) return false;
    const auto corners = corners_of(mesh_, f);
    const Vec3d n = area_vector(corners);
    if (!(dot(n, frame.normal) > least_cosine * length(n))) return false;
    Corners2 at;
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = {dot(corners[i], frame.tangent), dot(corners[i], frame.bitangent)};
    }
    if (!occupancy_.take(at)) return false;
    charts_.faces[f] = {chart, at};
    charts_.charts[chart].faces.push_back(f);
    return true;
  }

  const TriangleMesh& mesh_;
  std::vector<std::array<std::uint32_t, 3>> beyond_;
  Occupancy occupancy_;
  MeshCharts charts_;
};

/// What keeps the mesh's own coordinates from being used; empty if nothing does.
std::string fault_of_own(const TriangleMesh& mesh, const std::vector<Corners2>& at) {
  constexpr double slack = 1e-6;
  double area = 0.0;
  for (std::size_t f = 0; f < at.size(); ++f) {
    for (const Vec2d& p : at[f]) {
      const bool inside = p.x >= -slack && p.y >= -slack && p.x <= 1 + slack && p.y <= 1 + slack;
      if (!inside) return fmt::format("triangle {} lies outside of [0, 1]", f + 1);
    }
    const double own = std::abs(doubled_area(at[f]));
    if (own == 0.0 && length(area_vector(corners_of(mesh, f))) > 0.0) {
      return fmt::format("triangle {} has no area in them", f + 1);
    }
    area += 0.5 * own;
  }
  const double points = std::max(1e6, 16.0 * static_cast<double>(at.size()));
  Occupancy occupancy(std::sqrt(area / points));
  for (std::size_t f = 0; f < at.size(); ++f) {
    if (!occupancy.take(at[f])) return fmt::format("triangle {} overlaps another", f + 1);
  }
  return {};
}

/// Of connected vertices one, the same for all of them.
class Islands {
 public:
  explicit Islands(std::size_t vertices) : parent_(vertices) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t of(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void connect(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t x = of(a), y = of(b);
    parent_[std::max(x, y)] = std::min(x, y);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

MeshCharts own_charts(const TriangleMesh& mesh, const std::vector<Corners2>& at) {
  Islands islands(mesh.positions.size());
  for (const auto& t : mesh.triangles) islands.connect(t[0], t[1]), islands.connect(t[0], t[2]);
  MeshCharts charts;
  charts.source = MeshCharts::Source::own_uvs;
  charts.faces.resize(mesh.triangles.size());
  std::vector<std::uint32_t> number(mesh.positions.size(), MeshCharts::no_chart);
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    if (doubled_area(at[f]) == 0.0) continue;
    std::uint32_t& chart = number[islands.of(mesh.triangles[f][0])];
    if (chart == MeshCharts::no_chart) {
      chart = static_cast<std::uint32_t>(charts.charts.size());
      charts.charts.emplace_back();
    }
    charts.faces[f] = {chart, at[f]};
    charts.charts[chart].faces.push_back(f);
  }
  set_bounds(charts);
  return charts;
}

}  // namespace

MeshCharts projected_charts(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return {};
  return Projection(mesh).all();
}

MeshCharts mesh_charts(const TriangleMesh& mesh) {
  if (mesh.uvs.empty() || mesh.triangles.empty()) return projected_charts(mesh);
  std::vector<Corners2> at(mesh.triangles.size());
  for (std::size_t f = 0; f < at.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2f uv = mesh.uvs[mesh.triangles[f][i]];
      at[f][i] = {static_cast<double>(uv.x), static_cast<double>(uv.y)};
    }
  }
  const std::string fault = fault_of_own(mesh, at);
  if (fault.empty()) return own_charts(mesh, at);
  MeshCharts charts = projected_charts(mesh);
  charts.why_not_own = fault;
  return charts;
}

}  // namespace lapidary::geometry
