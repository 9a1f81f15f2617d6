#pragma once

#include <algorithm>
#include <cmath>

#include "math/constants.h"
#include "math/vec.h"

/// Maps from the unit square to the shapes that light transport samples. Each keeps neighbours
/// together, so that well-spread points stay well spread, and each has its density beside it.
/// `u` always lies in [0, 1)^2; directions are unit vectors about +z.
namespace lapidary {

struct SinCos {
  double sin = 0.0;
  double cos = 0.0;
};

/// Sine and cosine of x, |x| <= pi/4. Accuracy: 1 ulp of 1.
/// Taylor's series: on so short an interval it is as short as a minimax polynomial of this
/// accuracy, and three times as fast as the library's functions for any argument.
inline SinCos sin_cos_quarter(double x) {
  const double x2 = x * x;
  double s = -1.0 / 1307674368000.0;
  s = std::fma(s, x2, 1.0 / 6227020800.0);
  s = std::fma(s, x2, -1.0 / 39916800.0);
  s = std::fma(s, x2, 1.0 / 362880.0);
  s = std::fma(s, x2, -1.0 / 5040.0);
  s = std::fma(s, x2, 1.0 / 120.0);
  s = std::fma(s, x2, -1.0 / 6.0);
  double c = 1.0 / 20922789888000.0;
  c = std::fma(c, x2, -1.0 / 87178291200.0);
  c = std::fma(c, x2, 1.0 / 479001600.0);
  c = std::fma(c, x2, -1.0 / 3628800.0);
  c = std::fma(c, x2, 1.0 / 40320.0);
  c = std::fma(c, x2, -1.0 / 720.0);
  c = std::fma(c, x2, 1.0 / 24.0);
  c = std::fma(c, x2, -0.5);
  return {std::fma(s * x2, x, x), std::fma(c, x2, 1.0)};
}

/// A point of the unit disk in polar form, and in Cartesian form.
struct DiskPoint {
  double radius_squared = 0.0;  ///< uniform in [0, 1]
  Vec2d position;
};

/// The concentric map: squares about the centre become circles about it.
/// Source: Shirley & Chiu 1997, "A Low Distortion Map Between Disk and Square".
inline DiskPoint concentric_disk(Vec2d u) {
  const double a = 2.0 * u.x - 1.0;
  const double b = 2.0 * u.y - 1.0;
  const bool wide = std::abs(a) > std::abs(b);
  const double radius = wide ? a : b;
  const double ratio = radius == 0.0 ? 0.0 : (wide ? b : a) / radius;
  const SinCos angle = sin_cos_quarter(0.25 * pi * ratio);
  const double along = radius * angle.cos;
  const double across = radius * angle.sin;
  return {radius * radius, wide ? Vec2d{along, across} : Vec2d{across, along}};
}

/// The point of [0, 1]^2 that `concentric_disk` takes to `p`, in the unit disk.
inline Vec2d concentric_square(Vec2d p) {
  const double radius = std::sqrt(p.x * p.x + p.y * p.y);
  if (radius == 0.0) return {0.5, 0.5};
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const double far = std::copysign(radius, wide ? p.x : p.y);
  const double near = far * (4.0 * inv_pi) * std::atan(wide ? p.y / p.x : p.x / p.y);
  const double a = wide ? far : near, b = wide ? near : far;
  return {0.5 * (a + 1.0), 0.5 * (b + 1.0)};
}

/// Uniform on the unit disk.
inline Vec2d sample_uniform_disk(Vec2d u) {
  return concentric_disk(u).position;
}
inline double pdf_uniform_disk(Vec2d p) {
  return p.x * p.x + p.y * p.y <= 1.0 ? inv_pi : 0.0;
}

/// Uniform in the cone of directions with 1 - cos theta <= `one_minus_cos`, which lies in (0, 2]:
/// so given, a cone of 1e-8 rad keeps all its digits.
inline Vec3d sample_uniform_cone(Vec2d u, double one_minus_cos) {
  const DiskPoint disk = concentric_disk(u);
  const double height = one_minus_cos * disk.radius_squared;
  const double stretch = std::sqrt(one_minus_cos * (2.0 - height));
  return {disk.position.x * stretch, disk.position.y * stretch, 1.0 - height};
}
/// Per solid angle, inside the cone.
inline double pdf_uniform_cone(double one_minus_cos) {
  return 0.5 * inv_pi / one_minus_cos;
}
/// Per solid angle, of any unit direction `w`; 0 outside the cone.
/// `w.z` near 1 has lost what tells a narrow cone's edge, so there x and y decide.
inline double pdf_uniform_cone(Vec3d w, double one_minus_cos) {
  const double sin_squared = w.x * w.x + w.y * w.y;
  const double height = w.z > 0.0 ? sin_squared / (1.0 + w.z) : 1.0 - w.z;
  return height <= one_minus_cos ? pdf_uniform_cone(one_minus_cos) : 0.0;
}

/// Uniform on the unit sphere.
inline Vec3d sample_uniform_sphere(Vec2d u) {
  return sample_uniform_cone(u, 2.0);
}
constexpr double pdf_uniform_sphere() {
  return 0.25 * inv_pi;
}

/// Uniform on the half z >= 0 of the unit sphere.
inline Vec3d sample_uniform_hemisphere(Vec2d u) {
  return sample_uniform_cone(u, 1.0);
}
constexpr double pdf_uniform_hemisphere(double cos_theta) {
  return cos_theta >= 0.0 ? 0.5 * inv_pi : 0.0;
}

/// Proportional to cos theta over the half sphere. z >= 2^-32, so that the density is never 0 at a
/// sampled direction, not even for u = 0.
inline Vec3d sample_cosine_hemisphere(Vec2d u) {
  const DiskPoint disk = concentric_disk(u);
  const double z = std::sqrt(std::max(1.0 - disk.radius_squared, 0x1p-64));
  return {disk.position.x, disk.position.y, z};
}
constexpr double pdf_cosine_hemisphere(double cos_theta) {
  return cos_theta > 0.0 ? cos_theta * inv_pi : 0.0;
}

/// Weights of a triangle's second and third corner, uniform over its area: the point is
/// p0 + b.x (p1 - p0) + b.y (p2 - p0). Source: Heitz 2019, "A Low-Distortion Map Between
/// Triangle and Square".
inline Vec2d sample_triangle(Vec2d u) {
  if (u.y > u.x) return {0.5 * u.x, u.y - 0.5 * u.x};
  return {u.x - 0.5 * u.y, 0.5 * u.y};
}
/// Per area in the plane of the weights, a right triangle of area 1/2; on a triangle of area A the
/// density per area is 1/A.
constexpr double pdf_triangle(Vec2d b) {
  return b.x >= 0.0 && b.y >= 0.0 && b.x + b.y <= 1.0 ? 2.0 : 0.0;
}

}  // namespace lapidary
