#include "texture/noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.h"
#include "texture/cells.h"
#include "texture/lattice.h"

namespace lapidary::texture {
namespace {

using test::Random;

Vec3d anywhere(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

TEST(Noise, IsZeroAtWholeNumbers) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = anywhere(random, 1000);
    EXPECT_EQ(gradient_noise({std::floor(p.x), std::floor(p.y), std::floor(p.z)}, 5), 0.0);
  }
}

TEST(Noise, IsSmoothAcrossCells) {
  Random random(2);
  constexpr double step = 1e-5;
  for (int i = 0; i < 1000; ++i) {
    Vec3d p = anywhere(random, 20);
    const std::size_t axis = random.index(3);
    p[axis] = std::floor(p[axis]);
    const auto at = [&](double offset) {
      Vec3d q = p;
      q[axis] += offset;
      return gradient_noise(q, 0);
    };
    // Value, slope and curvature go on.
    EXPECT_NEAR(at(-1e-12), at(1e-12), 1e-10);
    const double before = (at(0) - at(-step)) / step, after = (at(step) - at(0)) / step;
    EXPECT_NEAR(before, after, 1e-3);
  }
}

TEST(Noise, HasItsMeanAndSpreadInAnyPartOfSpace) {
  for (const double far : {0.0, 1e5, -3e8}) {
    Random random(3);
    double sum = 0, squares = 0, most = 0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
      const double v = gradient_noise(anywhere(random, 500) + Vec3d{far, -far, far}, 9);
      sum += v;
      squares += v * v;
      most = std::max(most, std::abs(v));
    }
    // Five standard errors, of noise that has a standard deviation of 0.27.
    EXPECT_NEAR(sum / count, 0.0, 5 * 0.27 / std::sqrt(count));
    EXPECT_NEAR(std::sqrt(squares / count), 0.27, 0.005);
    EXPECT_LT(most, 1.1);
  }
}

TEST(Noise, SeedsAreIndependent) {
  Random random(4);
  double product = 0;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    const Vec3d p = anywhere(random, 100);
    product += gradient_noise(p, 1) * gradient_noise(p, 2);
  }
  EXPECT_NEAR(product / count, 0.0, 5 * 0.27 * 0.27 / std::sqrt(count));
}

TEST(Noise, IsTheSameOnEveryMachine) {
  EXPECT_EQ(lattice_hash(1, 2, 3, 4), lattice_hash(1, 2, 3, 4));
  // Cells are counted modulo 2^32, so that noise repeats there and nowhere nearer.
  EXPECT_EQ(gradient_noise({0.5 + 0x1p32, 0.25, 0.75}, 0), gradient_noise({0.5, 0.25, 0.75}, 0));
  EXPECT_NE(gradient_noise({0.5 + 0x1p31, 0.25, 0.75}, 0), gradient_noise({0.5, 0.25, 0.75}, 0));
}

TEST(Noise, LosesAsMuchAsIsMeasured) {
  for (const double width : {0.25, 0.5, 1.0, 1.5, 2.0}) {
    Random random(5);
    double with_mean = 0, with_itself = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3d p = anywhere(random, 100), a = random.direction();
      const Vec3d b = normalize(cross(a, random.direction()));
      double mean = 0;
      for (int k = 0; k < 100; ++k) {
        const double s = (k % 10 + 0.5) / 10 - 0.5, t = (k / 10 + 0.5) / 10 - 0.5;
        mean += 0.01 * gradient_noise(p + a * (s * width) + b * (t * width), 0);
      }
      const double here = gradient_noise(p, 0);
      with_mean += here * mean;
      with_itself += here * here;
    }
    EXPECT_NEAR(noise_left(width), with_mean / with_itself, 0.05) << width;
  }
}

TEST(Noise, OctavesTooFineForTheFootprintAreLeftOut) {
  const Place near{{0.3, 0.4, 0.5}, {}, {}};
  const Place wide{near.p, {1, 0, 0}, {0, 1, 0}};
  const Octaves many{.count = 10}, few{.count = 3};
  EXPECT_NE(fractal_noise(many, near), fractal_noise(few, near));
  // Of octaves from the third on, less than a thousandth is left. Both are scaled by their power.
  const double scale = std::sqrt((1 - std::pow(0.25, 10)) / (1 - std::pow(0.25, 3)));
  EXPECT_NEAR(fractal_noise(many, wide) * scale, fractal_noise(few, wide), 1e-3);
}

/// The points in all cells around, by the rule of `near_points`.
NearPoints by_hand(Vec3d p, double scatter, std::uint32_t seed) {
  const LatticePoint at = lattice_point(p);
  std::vector<double> distances;
  for (int i = 0; i < 9 * 9 * 9; ++i) {
    const int step[3] = {i % 9 - 4, i / 9 % 9 - 4, i / 81 - 4};
    const auto cell = [&](int axis) {
      return at.cell[static_cast<std::size_t>(axis)] + static_cast<std::uint32_t>(step[axis]);
    };
    const std::uint32_t bits = lattice_hash(cell(0), cell(1), cell(2), seed);
    Vec3d point;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      point[axis] =
          step[axis] + 0.5 + scatter * (lattice_hash(bits, axis + 1, 0, seed) * 0x1p-32 - 0.5);
    }
    distances.push_back(length(point - at.within));
  }
  std::sort(distances.begin(), distances.end());
  return {distances[0], distances[1]};
}

TEST(Cells, NearPointsAreTheNearest) {
  Random random(6);
  for (int i = 0; i < 3000; ++i) {
    const Vec3d p = anywhere(random, 1000);
    const double scatter = i % 3 == 0 ? 1.0 : random.uniform();
    const NearPoints found = near_points(p, scatter, 3), expected = by_hand(p, scatter, 3);
    EXPECT_NEAR(found.first, expected.first, 1e-12);
    EXPECT_NEAR(found.second, expected.second, 1e-12);
  }
}

TEST(Cells, WithoutScatterAreCubes) {
  EXPECT_NEAR(near_points({3.5, -2.5, 0.5}, 0, 1).first, 0.0, 1e-12);
  EXPECT_NEAR(near_points({4.0, 0.5, 0.5}, 0, 1).second, 0.5, 1e-12);
}

}  // namespace
}  // namespace lapidary::texture
