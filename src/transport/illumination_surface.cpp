#include "transport/illumination_surface.h"

#include <algorithm>
#include <cmath>

#include "geometry/sweep.h"
#include "math/frame.h"

namespace lapidary::transport {
namespace {

using geometry::PlacedSolid;
using geometry::SolidScene;
using geometry::SurfaceKind;
using geometry::UvChart;

/// Points that a texel is looked at where an edge crosses it, along each side.
constexpr int fine = 4;

const PlacedSolid& solid_of(const SolidScene& solids, const SurfaceKey& key) {
  return solids.compound(key.place).leaf(key.index).solid;
}

/// From the coordinates in which a leaf was stated, when the frame begins.
Transform world_from_leaf(const SolidScene& solids, const SurfaceKey& key) {
  const Transform& of_leaf = solid_of(solids, key).world_from_solid();
  if (key.place == 0) return of_leaf;
  return solids.places()[key.place - 1].at(
      0.0, [&](const geometry::OwnSpace& space) { return space.world_from_own() * of_leaf; });
}

/// A world point in the coordinates in which a leaf was stated.
Vec3d in_leaf(const SolidScene& solids, const SurfaceKey& key, Vec3d p, double time) {
  if (key.place != 0) {
    p = solids.places()[key.place - 1].at(
        time, [&](const geometry::OwnSpace& space) { return space.point(p); });
  }
  const geometry::OwnSpace* own = solid_of(solids, key).own_space();
  return own == nullptr ? p : own->point(p);
}

/// Weights of the second and third corner of the triangle that p lies in.
Vec2d weights_in(const geometry::TriangleMesh& mesh, std::uint32_t triangle, Vec3d p) {
  const auto& t = mesh.triangles[triangle];
  const Vec3d p0 = mesh.position(t[0]);
  const Vec3d d1 = mesh.position(t[1]) - p0, d2 = mesh.position(t[2]) - p0, q = p - p0;
  const double a = dot(d1, d1), b = dot(d1, d2), c = dot(d2, d2), det = a * c - b * b;
  if (!(det > 0.0)) return {};
  const double x = dot(q, d1), y = dot(q, d2);
  return {(c * x - b * y) / det, (a * y - b * x) / det};
}

TexelMetric metric_of(const geometry::SurfaceUv& uv) {
  return {static_cast<float>(dot(uv.dpdu, uv.dpdu)), static_cast<float>(dot(uv.dpdu, uv.dpdv)),
          static_cast<float>(dot(uv.dpdv, uv.dpdv))};
}

/// Steps of one texel instead of one unit.
TexelMetric per_texel(const TexelMetric& m, Vec2d step) {
  return {static_cast<float>(static_cast<double>(m.uu) * step.x * step.x),
          static_cast<float>(static_cast<double>(m.uv) * step.x * step.y),
          static_cast<float>(static_cast<double>(m.vv) * step.y * step.y)};
}

Vec2d step_of(const TexelGrid& grid, const MappedSurface::Range& over) {
  return {(over.max.x - over.min.x) / grid.width, (over.max.y - over.min.y) / grid.height};
}

bool is_opaque(const SolidScene& solids, std::uint32_t region) {
  return region != SolidScene::no_region &&
         solids.region(region).opacity == geometry::Opacity::opaque;
}

/// A diagonal that has room for the world; of one without bounds, some length.
double size_of(const geometry::World& world) {
  const Box3d box = world.bounds();
  const double size = box.empty() ? 0.0 : length(box.extent());
  return size > 0.0 ? size : 1.0;
}

}  // namespace

SurfacePlace place_on_surface(const geometry::World& world, const geometry::Hit& hit,
                              const geometry::Surface& surface) {
  switch (hit.kind) {
    case SurfaceKind::sheet:
      return {{hit.kind, 0, hit.index}, 0, world.surface_uv(hit, surface).uv};
    case SurfaceKind::triangle:
      return {{hit.kind, 0, hit.index}, hit.triangle, {hit.b1, hit.b2}};
    case SurfaceKind::none:
      return {};
    case SurfaceKind::solid:
      break;
  }
  const SurfaceKey key{hit.kind, hit.place, hit.worn_leaf};
  const PlacedSolid& leaf = solid_of(world.solids(), key);
  if (const auto* body = std::get_if<geometry::MeshBody>(&leaf.solid())) {
    const Vec3d p = in_leaf(world.solids(), key, surface.p, surface.time);
    return {key, hit.worn_patch, weights_in(body->mesh(), hit.worn_patch, p)};
  }
  const Vec2d uv = world.surface_uv(hit, surface).uv;
  if (const auto* quadric = std::get_if<geometry::Quadric>(&leaf.solid())) {
    const Vec3d p = in_leaf(world.solids(), key, surface.p, surface.time);
    return {key, geometry::facing_of(*quadric, p), uv};
  }
  return {key, hit.worn_patch, uv};
}

bool is_unbounded(const geometry::World& world, const SurfaceKey& key) {
  if (key.kind != SurfaceKind::solid) return false;
  const geometry::Solid& solid = solid_of(world.solids(), key).solid();
  if (std::holds_alternative<geometry::HalfSpace>(solid)) return true;
  const bool may_be = std::holds_alternative<geometry::Quadric>(solid) ||
                      std::holds_alternative<geometry::Polyhedron>(solid);
  return may_be && !geometry::bounds(solid).bounded();
}

const geometry::TriangleMesh* MappedSurface::mesh_of(const geometry::World& world,
                                                     const SurfaceKey& key) {
  if (key.kind == SurfaceKind::triangle) return world.triangles().placement(key.index).mesh.get();
  if (key.kind != SurfaceKind::solid) return nullptr;
  const auto* body = std::get_if<geometry::MeshBody>(&solid_of(world.solids(), key).solid());
  return body == nullptr ? nullptr : &body->mesh();
}

MappedSurface::MappedSurface(const geometry::World& world, const SurfaceKey& key, Meshes mesh)
    : world_(&world), key_(key), mesh_(std::move(mesh)) {
  // Far more than any rounding, and so little that few other surfaces come into it.
  constexpr double share_of_size = 0x1p-14;
  height_ = share_of_size * size_of(world);
  const SolidScene& solids = world.solids();
  for (std::uint32_t region = 0; region < solids.region_count() && !has_opaque_; ++region) {
    has_opaque_ = is_opaque(solids, region);
  }
  if (mesh_) mesh_scale_ = measure_mesh();
  if (key.kind != SurfaceKind::solid || mesh_) return;
  const PlacedSolid& leaf = solid_of(solids, key);
  charts_ = geometry::uv_charts(leaf.solid());
  const Box3d box = geometry::bounds(leaf);
  if (box.bounded()) height_ = std::min(height_, 0x1p-12 * length(box.extent()));
}

double MappedSurface::measure_mesh() const {
  double area = 0, in_charts = 0;
  for (std::uint32_t f = 0; f < mesh_->faces.size(); ++f) {
    const auto& [chart, at] = mesh_->faces[f];
    if (chart == geometry::MeshCharts::no_chart) continue;
    const geometry::Corners c = corners(f);
    area += length(cross(c.p1 - c.p0, c.p2 - c.p0));
    const Vec2d a = at[1] - at[0], b = at[2] - at[0];
    in_charts += std::abs(a.x * b.y - a.y * b.x);
  }
  return in_charts > 0.0 ? std::sqrt(area / in_charts) : 0.0;
}

std::size_t MappedSurface::chart_count() const {
  if (mesh_) return mesh_->charts.size();
  return key_.kind == SurfaceKind::sheet ? 1 : charts_.size();
}

std::optional<MappedSurface::ChartPoint> MappedSurface::locate(const SurfacePlace& place) const {
  if (mesh_) {
    const auto& [chart, at] = mesh_->faces[place.piece];
    if (chart == geometry::MeshCharts::no_chart) return {};
    const double b1 = place.at.x, b2 = place.at.y;
    return ChartPoint{chart, at[0] * (1.0 - b1 - b2) + at[1] * b1 + at[2] * b2};
  }
  if (key_.kind == SurfaceKind::sheet) return ChartPoint{0, place.at};
  if (charts_.front().facing != UvChart::faces_anywhere) return ChartPoint{place.piece, place.at};
  // Charts are in the order of their patches, of which those on the axis of a lathe have none.
  const auto found =
      std::partition_point(charts_.begin(), charts_.end(),
                           [&](const UvChart& chart) { return chart.last < place.piece; });
  if (found == charts_.end() || found->first > place.piece) return {};
  return ChartPoint{static_cast<std::uint32_t>(found - charts_.begin()), place.at};
}

MappedSurface::Range MappedSurface::range(std::uint32_t chart) const {
  if (mesh_) return {mesh_->charts[chart].min, mesh_->charts[chart].max};
  if (key_.kind == SurfaceKind::sheet) return {{0, 0}, {1, 1}};
  return {charts_[chart].min, charts_[chart].max};
}

TexelGrid MappedSurface::ends(std::uint32_t chart) const {
  TexelGrid grid;
  if (key_.kind != SurfaceKind::solid || mesh_) return grid;
  grid.u = charts_[chart].u;
  grid.v_low = charts_[chart].v_low, grid.v_high = charts_[chart].v_high;
  return grid;
}

std::optional<geometry::SurfaceUv> MappedSurface::uv_at(std::uint32_t chart, Vec2d at, Vec3d& p,
                                                        geometry::Patch& patch) const {
  if (key_.kind == SurfaceKind::sheet) {
    const geometry::Sheet& sheet = world_->sheets()[key_.index];
    const auto* disk = std::get_if<geometry::Disk>(&sheet);
    const Vec2d off = at - Vec2d{0.5, 0.5};
    if (disk != nullptr && off.x * off.x + off.y * off.y > 0.25) return {};
    const Vec3d middle = disk != nullptr ? disk->center
                                         : std::get<geometry::Rectangle>(sheet).corner +
                                               (std::get<geometry::Rectangle>(sheet).edge_u +
                                                std::get<geometry::Rectangle>(sheet).edge_v) *
                                                   0.5;
    const geometry::SurfaceUv uv = geometry::surface_uv(sheet, middle);
    p = middle + uv.dpdu * off.x + uv.dpdv * off.y;
    patch = 0;
    return uv;
  }
  const SolidScene& solids = world_->solids();
  const auto found = solids.point_at(key_.place, key_.index, charts_[chart], at);
  if (!found) return {};
  p = found->p, patch = found->patch;
  return solids.surface_uv(key_.place, key_.index, patch, p);
}

std::optional<TexelMetric> MappedSurface::metric_at(std::uint32_t chart, Vec2d at) const {
  Vec3d p;
  geometry::Patch patch;
  const auto uv = uv_at(chart, at, p, patch);
  return uv ? std::optional(metric_of(*uv)) : std::nullopt;
}

std::optional<Vec3d> MappedSurface::point_at(std::uint32_t chart, Vec2d at) const {
  Vec3d p;
  geometry::Patch patch;
  return uv_at(chart, at, p, patch) ? std::optional(p) : std::nullopt;
}

bool MappedSurface::is_buried(Vec3d p) const {
  return is_opaque(world_->solids(), geometry::region_at(world_->solids(), p));
}

/// Whether a line through p along the normal meets just this piece of the leaf as what is seen.
bool MappedSurface::is_worn_there(Vec3d p, geometry::Patch patch) const {
  const SolidScene& solids = world_->solids();
  const Vec3d n = solids.outward_normal(key_.place, key_.index, patch, p);
  geometry::Ray ray;
  ray.origin = p + n * height_;
  ray.direction = -n;
  ray.t_max = 2.0 * height_;
  const geometry::LeafPatch wanted{key_.place, key_.index, patch};
  geometry::Sweep sweep(solids, ray);
  for (geometry::Transition found; sweep.next(found);) {
    if (geometry::LeafPatch{found.place, found.worn_leaf, found.worn_patch} != wanted) continue;
    if (is_opaque(solids, found.before) && is_opaque(solids, found.after)) continue;
    if (solids.is_same_crossing(wanted, ray, height_, found.t)) return true;
  }
  return false;
}

/// `density`: area per unit of the chart.
bool MappedSurface::is_there(std::uint32_t chart, Vec2d at, double& density) const {
  Vec3d p;
  geometry::Patch patch;
  const auto uv = uv_at(chart, at, p, patch);
  if (!uv) return false;
  const Vec3d winding = cross(uv->dpdu, uv->dpdv);
  density = length(winding);
  if (key_.kind == SurfaceKind::solid) return is_worn_there(p, patch);
  if (!has_opaque_) return true;
  const Vec3d off = winding * (height_ / density);
  return !(is_buried(p + off) && is_buried(p - off));
}

TexelGround MappedSurface::ground(std::uint32_t chart, const TexelGrid& grid,
                                  const Range& over) const {
  if (!mesh_) return flat_ground(chart, grid, over);
  TexelGround ground{grid, over.min, over.max, std::vector<double>(grid.size()),
                     std::vector<TexelMetric>(grid.size())};
  add_faces(chart, ground);
  return ground;
}

TexelGround MappedSurface::flat_ground(std::uint32_t chart, const TexelGrid& grid,
                                       const Range& over) const {
  TexelGround ground{grid, over.min, over.max, std::vector<double>(grid.size()),
                     std::vector<TexelMetric>(grid.size())};
  const Vec2d step = step_of(grid, over);
  const auto place = [&](double x, double y) {
    return Vec2d{over.min.x + x * step.x, over.min.y + y * step.y};
  };
  std::vector<std::uint8_t> there(grid.size());
  std::optional<TexelMetric> last;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const std::size_t i = grid.index(x, y);
      const Vec2d at = place(x + 0.5, y + 0.5);
      double density = 0.0;
      there[i] = is_there(chart, at, density);
      if (there[i] != 0) ground.area[i] = density * step.x * step.y;
      if (const auto metric = metric_at(chart, at)) last = per_texel(*metric, step);
      ground.metrics[i] = last.value_or(TexelMetric{});
    }
  }
  const auto at_edge = [&](int x, int y) {
    const std::uint8_t here = there[grid.index(x, y)];
    return (x > 0 && there[grid.index(x - 1, y)] != here) ||
           (x + 1 < grid.width && there[grid.index(x + 1, y)] != here) ||
           (y > 0 && there[grid.index(x, y - 1)] != here) ||
           (y + 1 < grid.height && there[grid.index(x, y + 1)] != here);
  };
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      if (!at_edge(x, y)) continue;
      double sum = 0.0;
      for (int k = 0; k < fine * fine; ++k) {
        double density = 0.0;
        const Vec2d at = place(x + (k % fine + 0.5) / fine, y + (k / fine + 0.5) / fine);
        if (is_there(chart, at, density)) sum += density;
      }
      ground.area[grid.index(x, y)] = sum * step.x * step.y / (fine * fine);
    }
  }
  return ground;
}

geometry::Corners MappedSurface::corners(std::uint32_t triangle) const {
  if (key_.kind == SurfaceKind::triangle) return world_->triangles().corners(key_.index, triangle);
  const Transform map = world_from_leaf(world_->solids(), key_);
  const geometry::TriangleMesh& mesh = *mesh_of(*world_, key_);
  const auto& t = mesh.triangles[triangle];
  return {map.point(mesh.position(t[0])), map.point(mesh.position(t[1])),
          map.point(mesh.position(t[2]))};
}

namespace {

/// Cuts a triangle along its longest side until no side is longer than half a texel, and gives the
/// middle of each part to `use`.
template <typename Use>
void for_small_parts(const std::array<Vec2d, 3>& c, int depth, Use&& use) {
  std::size_t longest = 0;
  double most = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2d d = c[(i + 1) % 3] - c[i];
    const double size = d.x * d.x + d.y * d.y;
    if (size > most) most = size, longest = i;
  }
  if (most <= 0.25 || depth >= 40) {
    use((c[0] + c[1] + c[2]) * (1.0 / 3.0), depth);
    return;
  }
  const Vec2d a = c[longest], b = c[(longest + 1) % 3], top = c[(longest + 2) % 3];
  const Vec2d middle = (a + b) * 0.5;
  for_small_parts(std::array{a, middle, top}, depth + 1, use);
  for_small_parts(std::array{middle, b, top}, depth + 1, use);
}

/// The metric of a triangle with these corners whose coordinates are `at`.
TexelMetric metric_of(const geometry::Corners& c, const std::array<Vec2d, 3>& at) {
  const Vec2d d1 = at[1] - at[0], d2 = at[2] - at[0];
  const Vec3d e1 = c.p1 - c.p0, e2 = c.p2 - c.p0;
  const double det = d1.x * d2.y - d1.y * d2.x;
  return metric_of(
      geometry::SurfaceUv{{}, (e1 * d2.y - e2 * d1.y) / det, (e2 * d1.x - e1 * d2.x) / det});
}

/// A sum of metrics by area.
struct MeanMetric {
  double uu = 0, uv = 0, vv = 0, area = 0;

  void add(const TexelMetric& m, double weight) {
    uu += weight * static_cast<double>(m.uu), uv += weight * static_cast<double>(m.uv);
    vv += weight * static_cast<double>(m.vv), area += weight;
  }
  TexelMetric mean() const {
    return {static_cast<float>(uu / area), static_cast<float>(uv / area),
            static_cast<float>(vv / area)};
  }
};

/// The point of a triangle with corners `c` that has coordinates p where these have `at`.
Vec3d point_in(const geometry::Corners& c, const std::array<Vec2d, 3>& at, Vec2d p) {
  const Vec2d d1 = at[1] - at[0], d2 = at[2] - at[0], q = p - at[0];
  const double det = d1.x * d2.y - d1.y * d2.x;
  return c.p0 + (c.p1 - c.p0) * ((q.x * d2.y - q.y * d2.x) / det) +
         (c.p2 - c.p0) * ((d1.x * q.y - d1.y * q.x) / det);
}

}  // namespace

/// Every triangle gives all of its area, however small it is.
void MappedSurface::add_faces(std::uint32_t chart, TexelGround& ground) const {
  const Vec2d step = step_of(ground.grid, {ground.min, ground.max});
  std::vector<MeanMetric> metrics(ground.grid.size());
  MeanMetric everywhere;
  for (const std::uint32_t face : mesh_->charts[chart].faces) {
    const geometry::Corners c = corners(face);
    const Vec3d winding = cross(c.p1 - c.p0, c.p2 - c.p0);
    const double area = 0.5 * length(winding);
    if (!(area > 0.0)) continue;
    std::array<Vec2d, 3> at = mesh_->faces[face].at;
    for (Vec2d& p : at) p = {(p.x - ground.min.x) / step.x, (p.y - ground.min.y) / step.y};
    const TexelMetric metric = metric_of(c, at);
    everywhere.add(metric, area);
    const Vec3d off = winding * (0.5 * height_ / area);
    for_small_parts(at, 0, [&](Vec2d middle, int depth) {
      const double part = std::ldexp(area, -depth);
      const int x = std::clamp(static_cast<int>(middle.x), 0, ground.grid.width - 1);
      const int y = std::clamp(static_cast<int>(middle.y), 0, ground.grid.height - 1);
      const std::size_t i = ground.grid.index(x, y);
      metrics[i].add(metric, part);
      const Vec3d p = point_in(c, at, middle);
      const bool is_hidden = has_opaque_ && key_.kind == SurfaceKind::triangle &&
                             is_buried(p + off) && is_buried(p - off);
      if (!is_hidden) ground.area[i] += part;
    });
  }
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    // Where no surface is, as it is on the average.
    const MeanMetric& sum = metrics[i].area > 0.0 ? metrics[i] : everywhere;
    if (sum.area > 0.0) ground.metrics[i] = sum.mean();
  }
}

}  // namespace lapidary::transport
