#include "light/mesh_light.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "sampling/warp.h"

namespace lapidary::light {
namespace {

std::vector<std::uint32_t> all_triangles(const geometry::TriangleMesh& mesh) {
  std::vector<std::uint32_t> indices(mesh.triangles.size());
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

}  // namespace

MeshLight::MeshLight(const geometry::TriangleMesh& mesh, const Transform& world_from_mesh,
                     Spectrum radiance)
    : MeshLight(mesh, all_triangles(mesh), world_from_mesh, std::move(radiance)) {}

MeshLight::MeshLight(const geometry::TriangleMesh& mesh, std::span<const std::uint32_t> chosen,
                     const Transform& world_from_mesh, Spectrum radiance)
    : radiance_(std::move(radiance)) {
  std::vector<double> areas;
  for (const std::uint32_t index : chosen) {
    const auto& [a, b, c] = mesh.triangles[index];
    const Vec3d corner = world_from_mesh.point(mesh.position(a));
    Vec3d edge1 = world_from_mesh.point(mesh.position(b)) - corner;
    Vec3d edge2 = world_from_mesh.point(mesh.position(c)) - corner;
    if (world_from_mesh.mirrors()) std::swap(edge1, edge2);
    const double area = 0.5 * length(cross(edge1, edge2));
    if (!(area > 0.0)) continue;
    triangles_.push_back({corner, edge1, edge2});
    areas.push_back(area);
    for (const Vec3d& q : {corner, corner + edge1, corner + edge2}) bounds_.extend(q);
  }
  if (areas.empty()) return;
  by_area_.emplace(areas);
  area_ = by_area_->total();
  normals_ = cone_of_normals();
}

MeshLight::Normals MeshLight::cone_of_normals() const {
  Vec3d sum;
  for (const Triangle& t : triangles_) sum += cross(t.edge1, t.edge2);
  if (!(length(sum) > 0.0)) return {};  // closed, or nearly so
  Normals all{normalize(sum), 1.0};
  for (const Triangle& t : triangles_) {
    all.cosine = std::min(all.cosine, dot(all.axis, normalize(cross(t.edge1, t.edge2))));
  }
  return all;
}

std::optional<SurfacePoint> MeshLight::draw(const LightNumbers& numbers) const {
  if (!by_area_) return {};
  const Triangle& triangle = triangles_[by_area_->sample(numbers.part).index];
  const Vec2d b = sample_triangle(numbers.u);
  return SurfacePoint{triangle.corner + b.x * triangle.edge1 + b.y * triangle.edge2,
                      normalize(cross(triangle.edge1, triangle.edge2)), 1.0 / area_};
}

std::optional<LightSample> MeshLight::sample_illumination(Vec3d p, const LightNumbers& numbers,
                                                          const Wavelengths& wavelengths) const {
  const auto from = draw(numbers);
  if (!from) return {};
  return illumination_from(*from, p, radiance_, wavelengths);
}

double MeshLight::pdf_illumination(Vec3d p, Vec3d wi, const LightHit& hit) const {
  return by_area_ ? pdf_illumination_from(1.0 / area_, p, wi, hit) : 0.0;
}

std::optional<Departure> MeshLight::sample_departure(Vec3d direction, const LightNumbers& numbers,
                                                     const Wavelengths& wavelengths) const {
  const auto from = draw(numbers);
  if (!from) return {};
  return departure_from(*from, direction, radiance_, wavelengths);
}

double MeshLight::pdf_departure(Vec3d direction, const LightHit& hit) const {
  return by_area_ ? pdf_departure_from(1.0 / area_, direction, hit.normal) : 0.0;
}

SampledSpectrum MeshLight::emitted(Vec3d wi, const LightHit& hit,
                                   const Wavelengths& wavelengths) const {
  return dot(hit.normal, wi) < 0.0 ? radiance_.at(wavelengths) : SampledSpectrum();
}

double MeshLight::power(double) const {
  return pi * area_ * radiance_.integral();
}

Influence MeshLight::influence() const {
  return {.reach = Influence::Reach::around,
          .strength = power(0) / (4.0 * pi),
          .center = bounds_.center(),
          .front = normals_.axis,
          .radius_squared = 0.25 * length_squared(bounds_.extent()),
          .box = bounds_,
          .normal_cosine = normals_.cosine};
}

}  // namespace lapidary::light
