#include "texture/mapping.h"

#include <algorithm>
#include <cmath>

#include "math/constants.h"

namespace lapidary::texture {
namespace {

/// A step as part of a whole picture: more than all of it means nothing.
double part_of_whole(double step) {
  return std::clamp(step, -1.0, 1.0);
}

/// From +x over +y, in turns, in [0, 1).
double azimuth(Vec3d p) {
  const double turn = std::atan2(p.y, p.x) * (0.5 * inv_pi);
  const double u = turn < 0.0 ? turn + 1.0 : turn;
  return u < 1.0 ? u : 0.0;
}

/// Projections from an axis or a point are the same near and far: at a size where squares do not
/// overflow.
struct Scaled {
  Vec3d p;
  Vec3d dx, dy;

  explicit Scaled(const Lookup& lookup) {
    const double size = max_component(abs(lookup.p));
    const double inverse = size > 1e-300 ? 1.0 / size : 0.0;
    const auto step = [&](Vec3d d) {
      const auto held = [&](double x) { return std::clamp(x * inverse, -1e6, 1e6); };
      return Vec3d{held(d.x), held(d.y), held(d.z)};
    };
    p = lookup.p * inverse;
    dx = step(lookup.dpdx);
    dy = step(lookup.dpdy);
  }
};

Place spherical(const Lookup& lookup) {
  const Scaled s(lookup);
  const double rho = std::sqrt(s.p.x * s.p.x + s.p.y * s.p.y);
  const double r2 = rho * rho + s.p.z * s.p.z;
  const Vec2d east = rho > 0.0 ? Vec2d{s.p.x / rho, s.p.y / rho} : Vec2d{1.0, 0.0};
  const auto step = [&](Vec3d d) {
    if (!(r2 > 0.0)) return Vec3d{1, 1, 0};
    const double around = east.x * d.y - east.y * d.x, outward = east.x * d.x + east.y * d.y;
    const double u = around == 0.0 ? 0.0 : around / rho * (0.5 * inv_pi);
    const double v = (rho * d.z - s.p.z * outward) / r2 * inv_pi;
    return Vec3d{part_of_whole(u), part_of_whole(v), 0.0};
  };
  return {{azimuth(s.p), std::atan2(s.p.z, rho) * inv_pi + 0.5, 0.0}, step(s.dx), step(s.dy)};
}

Place cylindrical(const Lookup& lookup) {
  const Scaled s(lookup);
  const double rho2 = s.p.x * s.p.x + s.p.y * s.p.y;
  const auto step = [&](Vec3d d, double along) {
    const double around = s.p.x * d.y - s.p.y * d.x;
    const double u = around == 0.0 ? 0.0 : around / rho2 * (0.5 * inv_pi);
    return Vec3d{part_of_whole(u), along, 0.0};
  };
  return {{azimuth(s.p), lookup.p.z, 0.0}, step(s.dx, lookup.dpdx.z), step(s.dy, lookup.dpdy.z)};
}

Vec3d flat(Vec2d v) {
  return {v.x, v.y, 0.0};
}

/// The components `i` and `j`, the first with `sign`.
Place side(const Lookup& lookup, std::size_t i, std::size_t j, double sign) {
  const auto of = [&](Vec3d v) { return Vec3d{sign * v[i], v[j], 0.0}; };
  return {of(lookup.p), of(lookup.dpdx), of(lookup.dpdy)};
}

}  // namespace

Place place_of(Projection projection, const Lookup& lookup) {
  switch (projection) {
    case Projection::uv:
      return {flat(lookup.uv), flat(lookup.duvdx), flat(lookup.duvdy)};
    case Projection::planar:
      return side(lookup, 0, 1, 1.0);
    case Projection::cylindrical:
      return cylindrical(lookup);
    case Projection::spherical:
      return spherical(lookup);
    case Projection::object:
    case Projection::box:
      break;
  }
  return {lookup.p, lookup.dpdx, lookup.dpdy};
}

Place box_place(std::size_t axis, const Lookup& lookup) {
  const double outward = lookup.normal[axis] < 0.0 ? -1.0 : 1.0;
  if (axis == 0) return side(lookup, 1, 2, outward);
  if (axis == 1) return side(lookup, 0, 2, -outward);
  return side(lookup, 0, 1, outward);
}

std::array<float, 3> box_weights(Vec3d normal, double blend) {
  const Vec3d n = abs(normal);
  const double most = max_component(n);
  std::array<double, 3> weight{0, 0, 1};
  // The greatest component has the weight `blend`; without any blend it alone has one.
  const double below = std::max(blend, 1e-9);
  if (most > 0.0) {
    for (std::size_t i = 0; i < 3; ++i) weight[i] = std::max(0.0, n[i] / most - 1.0 + below);
  }
  const double sum = weight[0] + weight[1] + weight[2];
  return {static_cast<float>(weight[0] / sum), static_cast<float>(weight[1] / sum),
          static_cast<float>(weight[2] / sum)};
}

}  // namespace lapidary::texture
