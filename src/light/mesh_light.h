#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "light/area_sample.h"
#include "light/influence.h"
#include "math/transform.h"
#include "sampling/distribution.h"

namespace lapidary::light {

/// The triangles of a mesh that shine to their front. Sampled uniformly over their area.
class MeshLight {
 public:
  /// All triangles of the mesh, or those that `chosen` lists by index. Under a map that mirrors, a
  /// front stays a front. Triangles without area are left out; none at all make no light.
  MeshLight(const geometry::TriangleMesh& mesh, const Transform& world_from_mesh,
            Spectrum radiance);
  MeshLight(const geometry::TriangleMesh& mesh, std::span<const std::uint32_t> chosen,
            const Transform& world_from_mesh, Spectrum radiance);

  std::optional<LightSample> sample_illumination(Vec3d p, const LightNumbers& numbers,
                                                 const Wavelengths& wavelengths) const;
  double pdf_illumination(Vec3d p, Vec3d wi, const LightHit& hit) const;
  std::optional<Departure> sample_departure(Vec3d direction, const LightNumbers& numbers,
                                            const Wavelengths& wavelengths) const;
  double pdf_departure(Vec3d direction, const LightHit& hit) const;
  SampledSpectrum emitted(Vec3d wi, const LightHit& hit, const Wavelengths& wavelengths) const;
  double power(double scene_radius) const;
  Influence influence() const;

 private:
  struct Triangle {
    Vec3d corner;
    Vec3d edge1, edge2;  // cross(edge1, edge2) points to the front
  };

  /// What holds all normals, for `influence`.
  struct Normals {
    Vec3d axis;
    double cosine = -1;  ///< of the angle that none is further from the axis than
  };
  Normals cone_of_normals() const;
  /// Nothing without area.
  std::optional<SurfacePoint> draw(const LightNumbers& numbers) const;

  std::vector<Triangle> triangles_;
  std::optional<DiscreteDistribution> by_area_;  // none without area
  double area_ = 0;
  Box3d bounds_;
  Normals normals_;
  Spectrum radiance_;
};

}  // namespace lapidary::light
