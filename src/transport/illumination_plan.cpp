#include "transport/illumination_plan.h"

#include <algorithm>
#include <cmath>

namespace lapidary::transport {
namespace {

using Sides = std::array<std::span<const ChartPhoton>, 2>;
using Range = MappedSurface::Range;

bool is_finite(const Range& range) {
  return std::isfinite(range.min.x + range.max.x + range.min.y + range.max.y);
}

Range range_of(const Sides& sides) {
  Range range{{infinity, infinity}, {-infinity, -infinity}};
  for (const auto& side : sides) {
    for (const ChartPhoton& p : side) {
      range.min = {std::min(range.min.x, p.at.x), std::min(range.min.y, p.at.y)};
      range.max = {std::max(range.max.x, p.at.x), std::max(range.max.y, p.at.y)};
    }
  }
  return range;
}

/// How a chart stretches over its surface.
struct Stretch {
  Vec2d lengths;
  double area = 0;
};

/// By points spread over the range.
Stretch stretch_of(const MappedSurface& surface, std::uint32_t chart, const Range& range) {
  constexpr int side = 16;
  Stretch stretch;
  int found = 0;
  for (int k = 0; k < side * side; ++k) {
    const double x = (k % side + 0.5) / side, y = (k / side + 0.5) / side;
    const auto metric = surface.metric_at(
        chart, {std::lerp(range.min.x, range.max.x, x), std::lerp(range.min.y, range.max.y, y)});
    if (!metric) continue;
    const double uu = static_cast<double>(metric->uu), uv = static_cast<double>(metric->uv);
    const double vv = static_cast<double>(metric->vv);
    stretch.lengths = {std::max(stretch.lengths.x, std::sqrt(uu)),
                       std::max(stretch.lengths.y, std::sqrt(vv))};
    stretch.area += std::sqrt(std::max(uu * vv - uv * uv, 0.0)), ++found;
  }
  if (found > 0) stretch.area /= found;
  return stretch;
}

/// Some part of a chart with photons.
struct Cell {
  double density;  ///< per area of the surface
  std::size_t photons;
};

/// Cells such that many photons share one, were all as dense.
void add_cells(const ChartPlan& plan, std::vector<Cell>& cells) {
  constexpr double photons_per_cell = 16.0, most_along = 64.0;
  const double along = std::clamp(std::sqrt(static_cast<double>(plan.photons()) / photons_per_cell),
                                  1.0, most_along);
  const auto n = static_cast<std::size_t>(along);
  const Vec2d size = plan.range.max - plan.range.min;
  const double area = plan.area * size.x * size.y / static_cast<double>(n * n);
  if (!(area > 0.0)) return;
  const auto number = [n](double at, double min, double extent) {
    const double x = (at - min) / extent * static_cast<double>(n);
    return std::min(static_cast<std::size_t>(std::max(x, 0.0)), n - 1);
  };
  std::vector<std::size_t> counts(n * n);
  for (const auto& side : plan.sides) {
    for (const ChartPhoton& p : side) {
      const std::size_t row = number(p.at.y, plan.range.min.y, size.y);
      ++counts[row * n + number(p.at.x, plan.range.min.x, size.x)];
    }
  }
  for (const std::size_t count : counts) {
    if (count > 0) cells.push_back({static_cast<double>(count) / area, count});
  }
}

}  // namespace

ChartPlan plan_of(const MappedSurface& surface, std::uint32_t chart, Sides sides) {
  ChartPlan plan;
  plan.chart = chart;
  plan.sides = sides;
  plan.range = surface.range(chart);
  plan.grid = surface.ends(chart);
  if (!is_finite(plan.range)) plan.range = range_of(sides);
  const double scale = surface.mesh_scale();
  const Stretch stretch = surface.mesh_charts() ? Stretch{{scale, scale}, scale * scale}
                                                : stretch_of(surface, chart, plan.range);
  plan.lengths = stretch.lengths, plan.area = stretch.area;
  return plan;
}

double radius_by_density(std::span<const ChartPlan> plans, double size) {
  constexpr double photons_within = 1500.0;
  const double most = 0.25 * size;
  std::vector<Cell> cells;
  std::size_t all = 0;
  for (const ChartPlan& plan : plans) add_cells(plan, cells);
  for (const Cell& cell : cells) all += cell.photons;
  std::sort(cells.begin(), cells.end(),
            [](const Cell& a, const Cell& b) { return a.density < b.density; });
  std::size_t before = 0;
  for (const Cell& cell : cells) {
    before += cell.photons;
    if (2 * before >= all) return std::min(std::sqrt(photons_within / (pi * cell.density)), most);
  }
  return most;
}

void set_grid(const MappedSurface& surface, double texel, double radius, ChartPlan& plan) {
  // Not so many that a count overflows; the caller adds them up.
  constexpr double most_along = 1 << 24, fewest_along = 4;
  const auto count = [=](double texels, double fewest) {
    return static_cast<int>(std::clamp(std::ceil(texels), fewest, most_along));
  };
  Range& range = plan.range;
  if (surface.mesh_charts()) {
    // Whole texels of a lattice: of own coordinates one that fits into [0, 1].
    double step = texel / plan.lengths.x;
    const bool is_own = surface.mesh_charts()->source == geometry::MeshCharts::Source::own_uvs;
    if (is_own) step = 1.0 / std::max(std::ceil(1.0 / step), fewest_along);
    const auto snapped = [step](Vec2d p, double (*round)(double), double slack) {
      return Vec2d{round(p.x / step + slack), round(p.y / step + slack)};
    };
    const Vec2d low = snapped(range.min, std::floor, 1e-6);
    const Vec2d high = snapped(range.max, std::ceil, -1e-6);
    plan.grid.width = count(high.x - low.x, 1), plan.grid.height = count(high.y - low.y, 1);
    range.min = low * step;
    range.max = {(low.x + plan.grid.width) * step, (low.y + plan.grid.height) * step};
    return;
  }
  if (!is_finite(surface.range(plan.chart))) {
    const Vec2d more{radius / plan.lengths.x, radius / plan.lengths.y};
    range = {range.min - more, range.max + more};
  }
  const Vec2d size = range.max - range.min;
  plan.grid.width = count(size.x * plan.lengths.x / texel, fewest_along);
  plan.grid.height = count(size.y * plan.lengths.y / texel, fewest_along);
}

}  // namespace lapidary::transport
