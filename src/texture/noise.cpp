#include "texture/noise.h"

#include <cmath>

#include "texture/box_filter.h"
#include "texture/lattice.h"

namespace lapidary::texture {
namespace {

double eased(double t) {
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

double mixed(double a, double b, double t) {
  return a + t * (b - a);
}

/// Along one of the twelve directions from the centre of a cube to its edges, four of them twice.
double slope(std::uint32_t hash, double x, double y, double z) {
  const std::uint32_t h = hash >> 28;
  const double u = h < 8 ? x : y;
  const double v = h < 4 ? y : h == 12 || h == 14 ? x : z;
  return ((h & 1) != 0 ? -u : u) + ((h & 2) != 0 ? -v : v);
}

/// Calls `use(octave's seed, scale, amplitude, how much of it is left)`, until nothing is.
template <typename Use>
void for_each_octave(const Octaves& octaves, double width, Use use) {
  double scale = 1, amplitude = 1;
  for (int i = 0; i < octaves.count; ++i) {
    const double left = noise_left(width * scale);
    use(octaves.seed + 0x9E3779B9u * static_cast<std::uint32_t>(i), scale, amplitude, left);
    scale *= octaves.lacunarity;
    amplitude *= octaves.gain;
  }
}

}  // namespace

double gradient_noise(Vec3d p, std::uint32_t seed) {
  const LatticePoint at = lattice_point(p);
  const auto [i, j, k] = at.cell;
  const auto [x, y, z] = at.within;
  const double u = eased(x), v = eased(y), w = eased(z);
  const auto corner = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return slope(lattice_hash(i + a, j + b, k + c, seed), x - a, y - b, z - c);
  };
  const auto side = [&](std::uint32_t c) {
    return mixed(mixed(corner(0, 0, c), corner(1, 0, c), u),
                 mixed(corner(0, 1, c), corner(1, 1, c), u), v);
  };
  return mixed(side(0), side(1), w);
}

double noise_left(double width) {
  const double w2 = width * width;
  return w2 < 8.0 ? std::exp(-0.53 * w2) : 0.0;
}

double fractal_noise(const Octaves& octaves, const Place& place) {
  double sum = 0, power = 0;
  for_each_octave(octaves, mean_width(place),
                  [&](std::uint32_t seed, double scale, double amplitude, double left) {
                    power += amplitude * amplitude;
                    if (left > 0.0) {
                      sum += amplitude * left * gradient_noise(place.p * scale, seed);
                    }
                  });
  return sum / std::sqrt(power);
}

double turbulent_noise(const Octaves& octaves, const Place& place) {
  constexpr double mean_magnitude = 0.22;
  double sum = 0, whole = 0;
  for_each_octave(octaves, mean_width(place),
                  [&](std::uint32_t seed, double scale, double amplitude, double left) {
                    whole += amplitude;
                    sum += amplitude * mean_magnitude * (1.0 - left);
                    if (left > 0.0) {
                      sum += amplitude * left * std::abs(gradient_noise(place.p * scale, seed));
                    }
                  });
  return 2.0 * sum / whole;
}

}  // namespace lapidary::texture
