#include "geometry/superellipsoid.h"

#include "geometry/rounded_bounds.h"
#include "geometry/superellipsoid_norm.h"
#include "sampling/warp.h"

namespace lapidary::geometry {
namespace {

Vec3d product(Vec3d a, Vec3d b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

Vec3d quotient(Vec3d a, Vec3d b) {
  return {a.x / b.x, a.y / b.y, a.z / b.z};
}

/// Where the norm is that of the solid.
Vec3d scaled(const Superellipsoid& solid, Vec3d p) {
  return quotient(p - solid.center, solid.radii);
}

/// The middle of the solid has no direction of its own.
Vec3d gradient_at(const Superellipsoid& solid, Vec3d q) {
  return q == Vec3d{} ? Vec3d{0, 0, 1} : norm_at(norm_exponents(solid), q).gradient;
}

/// Of a point q of the surface, scaled, where the gradient of the norm is g.
///
/// A cone of solid angle w about q has, with the unit normal n, the area w |q|^2 / (q/|q| . n) on
/// the surface, and q . g = N(q) = 1 makes q . n = 1 / |g|. Scaling by the radii multiplies an area
/// along n by the length of the cofactors' product with n.
double direction_pdf_area(const Superellipsoid& solid, Vec3d q, Vec3d g) {
  const Vec3d r = solid.radii;
  const double stretch = length(product({r.y * r.z, r.z * r.x, r.x * r.y}, g));
  const double distance = length(q);
  return 1.0 / (4.0 * pi * distance * distance * distance * stretch);
}

}  // namespace

Vec3d outward_normal(const Superellipsoid& solid, Patch, Vec3d p) {
  return normalize(quotient(gradient_at(solid, scaled(solid, p)), solid.radii));
}

/// The point is d / N(d) for the direction d, so it moves by (d' - (g . d') d / N) / N.
SurfaceUv surface_uv(const Superellipsoid& solid, Patch, Vec3d p) {
  const Vec3d q = scaled(solid, p), d = q == Vec3d{} ? Vec3d{0, 0, 1} : normalize(q);
  const double cos_latitude = std::hypot(d.x, d.y);
  const double turn = std::atan2(d.y, d.x) * (0.5 * inv_pi);
  const double latitude = std::atan2(d.z, cos_latitude);
  const double u = turn < 0.0 ? turn + 1.0 : turn;
  const Vec2d east =
      cos_latitude > 0.0 ? Vec2d{d.x / cos_latitude, d.y / cos_latitude} : Vec2d{1.0, 0.0};
  const Vec3d by_u = Vec3d{-d.y, d.x, 0.0} * (2.0 * pi);
  const Vec3d by_v = Vec3d{-d.z * east.x, -d.z * east.y, cos_latitude} * pi;
  const NormAt at = norm_at(norm_exponents(solid), d);
  const auto moved = [&](Vec3d change) {
    const Vec3d along = d * (dot(at.gradient, change) / at.value);
    return product(change - along, solid.radii) / at.value;
  };
  return {{u < 1.0 ? u : 0.0, latitude * inv_pi + 0.5}, moved(by_u), moved(by_v)};
}

bool contains(const Superellipsoid& solid, Vec3d p) {
  return norm_at(norm_exponents(solid), scaled(solid, p)).value <= 1.0;
}

Box3d bounds(const Superellipsoid& solid) {
  return rounded_outward({solid.center - solid.radii, solid.center + solid.radii});
}

/// Support in the direction w is the dual norm, which has the exponents q with 1/p + 1/q = 1: those
/// of 2 - e and 2 - n.
Box3d affine_bounds(const Superellipsoid& solid, const Transform& map) {
  const NormExponents dual{2.0 / (2.0 - solid.e), 2.0 / (2.0 - solid.n)};
  Vec3d half;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d w = product(map.linear().row[i], solid.radii);
    half[i] = norm_at(dual, w).value * (1 + 32 * rounding_unit);
  }
  const Vec3d center = map.point(solid.center);
  return {center - half, center + half};
}

/// By Dirichlet's integrals: the section at the height z is its form at 0 times (1 -
/// z^(2/n))^(n/2).
double volume(const Superellipsoid& solid) {
  const double e = solid.e, n = solid.n;
  const double half_e = std::tgamma(1 + 0.5 * e);
  const double across = half_e * half_e / std::tgamma(1 + e);
  const double along = std::tgamma(1 + 0.5 * n) * std::tgamma(1 + n) / std::tgamma(1 + 1.5 * n);
  return 8.0 * solid.radii.x * solid.radii.y * solid.radii.z * across * along;
}

BoundaryPoint sample_boundary(const Superellipsoid& solid, Vec2d u, double) {
  const Vec3d d = sample_uniform_sphere(u);
  const NormAt at = norm_at(norm_exponents(solid), d);
  const Vec3d q = d / at.value;
  return {solid.center + product(q, solid.radii), normalize(quotient(at.gradient, solid.radii)), 0,
          direction_pdf_area(solid, q, at.gradient)};
}

double sampling_pdf_area(const Superellipsoid& solid, Patch, Vec3d p) {
  const Vec3d q = scaled(solid, p);
  return q == Vec3d{} ? 0.0 : direction_pdf_area(solid, q, gradient_at(solid, q));
}

std::vector<UvChart> uv_charts(const Superellipsoid&) {
  return {round_chart()};
}

std::optional<PatchPoint> point_at(const Superellipsoid& solid, const UvChart&, Vec2d uv) {
  const Vec3d d = round_direction(uv);
  const double norm = norm_at(norm_exponents(solid), d).value;
  return PatchPoint{0, solid.center + product(d, solid.radii) / norm};
}

}  // namespace lapidary::geometry
