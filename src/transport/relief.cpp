#include "transport/relief.h"

#include <algorithm>
#include <cmath>

namespace lapidary::transport {
namespace {

using texture::Lookup;

/// Differences of heights over less than this share of the coordinates would be of roundings.
constexpr double least_step = 1e-7;

Lookup moved(const Lookup& at, Vec3d step, Vec2d uv_step) {
  Lookup there = at;
  there.p = at.p + step;
  there.uv = at.uv + uv_step;
  return there;
}

/// How steeply the height rises along one axis of the footprint, by a central difference.
double slope(const texture::Number& height, const Lookup& at, Vec3d axis, Vec2d uv_axis) {
  const double size = length(axis);
  if (!(size > 0.0)) return 0.0;
  const double share = 0.5 * std::max(1.0, least_step * max_component(abs(at.p)) / size);
  const double rise = height.at(moved(at, axis * share, uv_axis * share)) -
                      height.at(moved(at, axis * -share, uv_axis * -share));
  return rise / (2.0 * share * size);
}

/// `v` without what is along `n`, unit length; zero where nothing is left.
Vec3d tangential(Vec3d v, Vec3d n) {
  const Vec3d t = v - n * dot(v, n);
  const double size = length(t);
  return size > 0.0 ? t / size : Vec3d{};
}

Vec3d from_picture(const texture::Color& picture, Vec3d n, const SurfaceLookup& lookup) {
  const Rgb c = picture.rgb_at(lookup.at);
  const Vec3d local{2.0 * c.r - 1.0, 2.0 * c.g - 1.0, std::max(2.0 * c.b - 1.0, 0.0)};
  const Vec3d tangent = tangential(lookup.dpdu, n);
  Vec3d bitangent = cross(n, tangent);
  if (dot(bitangent, lookup.dpdv) < 0.0) bitangent = -bitangent;  // mirrored texture coordinates
  return tangent * local.x + bitangent * local.y + n * local.z;
}

}  // namespace

Vec3d relief_normal(const bsdf::SurfaceDetail& detail, const geometry::Surface& surface,
                    const SurfaceLookup& seen, Vec3d direction) {
  SurfaceLookup lookup = seen;
  lookup.at.care = Lookup::Care::mean;  // differences between draws would be of chance
  Vec3d n = surface.shading_normal;
  if (detail.normal) n = from_picture(*detail.normal, n, lookup);
  if (detail.bump) {
    const double x = slope(*detail.bump, lookup.at, lookup.at.dpdx, lookup.at.duvdx);
    const double y = slope(*detail.bump, lookup.at, lookup.at.dpdy, lookup.at.duvdy);
    n = normalize(n) - tangential(lookup.dpdx, n) * x - tangential(lookup.dpdy, n) * y;
  }
  const double size = length(n);
  if (!(size > 0.0 && std::isfinite(size))) return surface.shading_normal;
  n = n / size;
  // Facets that turn away are not seen: those at the edge of sight stand for them.
  constexpr double least_cosine = 1e-2;
  const double side = dot(direction, surface.geometric_normal) < 0.0 ? -1.0 : 1.0;
  const Vec3d towards = direction * side;
  const double cosine = dot(n, towards);
  if (cosine < least_cosine) n = normalize(n + towards * (least_cosine - cosine));
  return n;
}

}  // namespace lapidary::transport
