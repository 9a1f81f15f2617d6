#include "transport/lookup.h"

#include <algorithm>
#include <cmath>

namespace lapidary::transport {
namespace {

/// What a cone covers of the surface's plane: its axes, the second along the ray.
struct Footprint {
  Vec3d across, along;
};

Footprint footprint(const Met& met) {
  // Seen from the very side a cone covers no finite piece.
  constexpr double least_cosine = 1e-3;
  const Vec3d n = met.surface.geometric_normal, d = met.direction;
  const double cosine = dot(n, d);
  const Vec3d in_plane = d - n * cosine;
  const double sine = length(in_plane);
  const Frame frame = Frame::from_normal(n);
  const Vec3d along = sine > 1e-6 ? in_plane / sine : frame.tangent;
  return {cross(n, along) * met.width,
          along * (met.width / std::max(std::abs(cosine), least_cosine))};
}

/// How far (u, v) go on the way `step` along the surface; nearest in the sense of least squares
/// where the step leaves the plane of dpdu and dpdv.
Vec2d uv_step(const geometry::SurfaceUv& at, Vec3d step) {
  const double uu = dot(at.dpdu, at.dpdu), vv = dot(at.dpdv, at.dpdv), uv = dot(at.dpdu, at.dpdv);
  const double u = dot(at.dpdu, step), v = dot(at.dpdv, step);
  const double determinant = uu * vv - uv * uv;
  // A pole, or a chart that is folded flat: any direction is as good as another.
  if (!(determinant > 1e-14 * uu * vv)) return {};
  return {(vv * u - uv * v) / determinant, (uu * v - uv * u) / determinant};
}

}  // namespace

SurfaceLookup lookup_at(const scene::Scene& scene, const Met& met) {
  const std::uint32_t number = scene.slot(met.hit).frame;
  if (number == scene::Slot::no_frame) return {};
  const scene::TextureFrame& frame = scene.texture_frame(number);
  const Footprint world = footprint(met);
  const geometry::SurfaceUv at = scene.world().surface_uv(met.hit, met.surface);
  Vec3d p = met.surface.p, n = met.surface.geometric_normal;
  Vec3d across = world.across, along = world.along;
  if (frame.base == scene::TextureFrame::Base::place) {
    const auto& space = scene.world().solids().places()[met.hit.place - 1].space;
    p = space.point(p);
    n = space.normal(n);
    across = space.own_from_world() * across;
    along = space.own_from_world() * along;
  }
  const Transform wearer_from_base = frame.base_from_wearer.inverse();
  texture::Lookup lookup;
  lookup.p = wearer_from_base.point(p);
  lookup.normal = normalize(wearer_from_base.normal(n));
  lookup.dpdx = wearer_from_base.vector(across);
  lookup.dpdy = wearer_from_base.vector(along);
  lookup.uv = at.uv;
  lookup.duvdx = uv_step(at, world.across);
  lookup.duvdy = uv_step(at, world.along);
  return {lookup, world.across, world.along, at.dpdu, at.dpdv};
}

}  // namespace lapidary::transport
