#include "spectrum/color.h"

#include <cmath>

#include "spectrum/cie_functions.h"

namespace lapidary {
namespace {

/// XYZ per unit of the observer's own scale: 1 W/(m2 sr) at 555 nm has about Y = 1.
template <typename Radiance>
Vec3d observed(const Radiance& radiance_at, const std::vector<double>& knots) {
  const auto integrand = [&](double nm) {
    const auto [x, y, z] = observer_at(nm);
    return radiance_at(nm) * Vec3d{x, y, z};
  };
  Vec3d sum;
  for (std::size_t i = 1; i < knots.size(); ++i) sum += simpson(integrand, knots[i - 1], knots[i]);
  return sum;
}

Vec3d observed(const Spectrum& radiance) {
  return observed([&](double nm) { return radiance.at(nm); }, radiance.knots());
}

Vec3d white() {
  static const Vec3d xyz = observed(Spectrum::illuminant({1, 1, 1}));
  return xyz;
}

Vec3d xyz_at_unit_luminance(Chromaticity c) {
  return {c.x / c.y, 1.0, (1.0 - c.x - c.y) / c.y};
}

Mat3 from_columns(Vec3d a, Vec3d b, Vec3d c) {
  return {{Vec3d{a.x, b.x, c.x}, Vec3d{a.y, b.y, c.y}, Vec3d{a.z, b.z, c.z}}};
}

Mat3 inverse(const Mat3& m) {
  const Vec3d a = m.column(0), b = m.column(1), c = m.column(2);
  const double scale = 1.0 / dot(a, cross(b, c));
  return {{cross(b, c) * scale, cross(c, a) * scale, cross(a, b) * scale}};
}

/// The primaries, each as bright as it must be for their sum to be white.
Mat3 make_xyz_from_rgb() {
  const Vec3d r = xyz_at_unit_luminance(rec709_red);
  const Vec3d g = xyz_at_unit_luminance(rec709_green);
  const Vec3d b = xyz_at_unit_luminance(rec709_blue);
  const Vec3d share = inverse(from_columns(r, g, b)) * (white() / white().y);
  return from_columns(r * share.x, g * share.y, b * share.z);
}

Rgb rgb_from(Vec3d xyz) {
  const Vec3d rgb = rgb_from_xyz() * xyz;
  return {static_cast<float>(rgb.x), static_cast<float>(rgb.y), static_cast<float>(rgb.z)};
}

}  // namespace

Chromaticity d65_white() {
  return chromaticity(white());
}

const Mat3& xyz_from_rgb() {
  static const Mat3 matrix = make_xyz_from_rgb();
  return matrix;
}

const Mat3& rgb_from_xyz() {
  static const Mat3 matrix = inverse(xyz_from_rgb());
  return matrix;
}

Chromaticity chromaticity(Vec3d xyz) {
  const double sum = xyz.x + xyz.y + xyz.z;
  return {xyz.x / sum, xyz.y / sum};
}

Vec3d xyz_of(const Spectrum& radiance) {
  return observed(radiance) / white().y;
}

Rgb rgb_of(const Spectrum& radiance) {
  return rgb_from(xyz_of(radiance));
}

Rgb reflected_daylight(const Spectrum& reflectance) {
  if (const Rgb* stated = reflectance.as_reflectance()) return *stated;
  const auto reflected = [&](double nm) { return reflectance.at(nm) * d65_at(nm); };
  return rgb_from(observed(reflected, reflectance.knots()) / white().y);
}

float luminance(Rgb c) {
  const Vec3d weight = xyz_from_rgb().row[1];
  return static_cast<float>(dot(weight, Vec3d{c.r, c.g, c.b}));
}

double luminous_efficacy(const Spectrum& radiance) {
  const double power = radiance.integral();
  return power > 0.0 ? peak_luminous_efficacy * observed(radiance).y / power : 0.0;
}

float srgb_encode(float linear) {
  const float x = std::abs(linear);
  const float y = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
  return std::copysign(y, linear);
}

float srgb_decode(float encoded) {
  const float x = std::abs(encoded);
  const float y = x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
  return std::copysign(y, encoded);
}

Rgb srgb_encode(Rgb linear) {
  return {srgb_encode(linear.r), srgb_encode(linear.g), srgb_encode(linear.b)};
}

Rgb srgb_decode(Rgb encoded) {
  return {srgb_decode(encoded.r), srgb_decode(encoded.g), srgb_decode(encoded.b)};
}

}  // namespace lapidary
