#include "texture/noise_textures.h"

#include <algorithm>
#include <cmath>

#include "texture/periodic.h"

namespace lapidary::texture {
namespace {

/// Noise has a spread of 0.27: it fills the range of colours, and goes beyond in few places.
constexpr double contrast = 0.8;

Place stretched(const Place& place, Vec3d factors) {
  const auto of = [&](Vec3d v) { return Vec3d{v.x * factors.x, v.y * factors.y, v.z * factors.z}; };
  return {of(place.p), of(place.dx), of(place.dy)};
}

/// Of a ring: early wood grows slowly darker, late wood ends at once.
double ring_profile(double x, double width) {
  // The periodic part of the antiderivative of a squared saw, and its mean, which is 1/3.
  const auto wave = [](double t) {
    const double s = t - std::floor(t);
    return (s * s * s - s) / 3.0;
  };
  if (!(width > narrowest(x))) return std::pow(x - std::floor(x), 2);
  return 1.0 / 3.0 + (wave(x + 0.5 * width) - wave(x - 0.5 * width)) / width;
}

}  // namespace

Marble::Marble()
    : colors{{{0.0, Spectrum::reflectance({0.82f, 0.80f, 0.76f})},
              {0.5, Spectrum::reflectance({0.74f, 0.72f, 0.68f})},
              {0.85, Spectrum::reflectance({0.45f, 0.44f, 0.43f})},
              {1.0, Spectrum::reflectance({0.16f, 0.16f, 0.17f})}}} {}

Wood::Wood()
    : colors(Ramp::usual({{0.54f, 0.33f, 0.15f}, {0.42f, 0.23f, 0.09f}, {0.22f, 0.10f, 0.04f}})) {}

double pattern(const Clouds& clouds, const Place& place) {
  return std::clamp(0.5 + contrast * fractal_noise(clouds.octaves, place), 0.0, 1.0);
}

double pattern(const Turbulence& turbulence, const Place& place) {
  return std::min(turbulent_noise(turbulence.octaves, place), 1.0);
}

double pattern(const Marble& marble, const Place& place) {
  const double shift = marble.turbulence * fractal_noise(marble.octaves, place);
  return mean_wave(place.p.x + shift, box_of(place).x);
}

double pattern(const Wood& wood, const Place& place) {
  // Trunks change slowly along their length; fibres are long and thin.
  const Octaves bends{.count = 2, .seed = wood.seed};
  const double shift = wood.turbulence * fractal_noise(bends, stretched(place, {0.5, 0.5, 0.1}));
  const double radius = std::hypot(place.p.x, place.p.y);
  const double ring = ring_profile(radius + shift, mean_width(place));
  const Octaves fibres{.count = 2, .seed = wood.seed + 1};
  const double fibre = fractal_noise(fibres, stretched(place, {12, 12, 0.6}));
  return std::clamp(ring + wood.grain * fibre, 0.0, 1.0);
}

}  // namespace lapidary::texture
