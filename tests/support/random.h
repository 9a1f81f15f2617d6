#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "math/constants.h"
#include "math/vec.h"

namespace lapidary::test {

/// Independent random numbers for tests: the same on every machine for the same seed, and nothing
/// that the renderer itself uses.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }
  /// In [0, 1), all 53 bits.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  Vec2d uniform2() {
    const double x = uniform();
    return {x, uniform()};
  }
  /// In 0 .. count-1; `count` >= 1. Its bias is below 2^-32 for counts below 2^32.
  std::uint64_t index(std::uint64_t count) { return engine_() % count; }
  /// 10 to the power of a uniform number: magnitudes over many decades.
  double magnitude(double low_exponent, double high_exponent) {
    return std::pow(10.0, uniform(low_exponent, high_exponent));
  }
  /// Uniform on the unit sphere.
  Vec3d direction() {
    const double z = uniform(-1.0, 1.0);
    const double phi = uniform(0.0, 2.0 * pi);
    const double r = std::sqrt((1.0 - z) * (1.0 + z));
    return {r * std::cos(phi), r * std::sin(phi), z};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace lapidary::test
