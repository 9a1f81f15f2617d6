#pragma once

#include <cstdint>

#include "texture/mapping.h"

namespace lapidary::texture {

/// Smooth, with mean 0, about as many bumps as whole numbers, and never far beyond [-1, 1]; 0 at
/// whole numbers. Its standard deviation is 0.27. The same for the same seed on every machine.
/// Source: Perlin 2002, "Improving Noise"; directions by a hash instead of a table.
double gradient_noise(Vec3d p, std::uint32_t seed);

/// What is left of `gradient_noise`, as a factor, in the mean over a square of side `width`: within
/// 0.03 of the regression measured on squares in all directions; 0 from 2.8 on.
double noise_left(double width);

/// Sums of noise, each `lacunarity` times as fine and `gain` times as high as the one before; what
/// the footprint averages away is left out.
struct Octaves {
  int count = 1;
  double lacunarity = 2;
  double gain = 0.5;
  std::uint32_t seed = 0;
};

/// The sum, with mean 0 and a spread of about that of one noise.
double fractal_noise(const Octaves& octaves, const Place& place);
/// The sum of magnitudes, from 0 to about 1.
double turbulent_noise(const Octaves& octaves, const Place& place);

}  // namespace lapidary::texture
