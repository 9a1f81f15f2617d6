#include "sampling/sobol.h"

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/chi_squared.h"
#include "support/random.h"
#include "support/statistics.h"

namespace lapidary {
namespace {

using test::Random;
using test::RunningMean;

struct Pixel {
  std::uint64_t seed = 0;
  std::uint32_t x = 0, y = 0;
};

using Points = std::vector<Block8>;

Points points_of(const Pixel& pixel, std::uint32_t block, std::uint32_t first,
                 std::uint32_t count) {
  Points points;
  for (std::uint32_t i = 0; i < count; ++i)
    points.push_back(PixelSampler(pixel.seed, pixel.x, pixel.y, first + i).block(block));
  return points;
}

// Whether every box with 2^bits[i] equal cuts along dimension dims[i] holds exactly one point.
bool one_point_per_box(const Points& points, const std::vector<std::size_t>& dims,
                       const std::vector<int>& bits) {
  std::vector<bool> taken(points.size(), false);
  for (const Block8& point : points) {
    std::size_t box = 0;
    for (std::size_t i = 0; i < dims.size(); ++i)
      box = (box << bits[i]) + static_cast<std::size_t>(std::ldexp(point[dims[i]], bits[i]));
    if (taken.at(box)) return false;
    taken[box] = true;
  }
  return true;
}

// Every way to write `sum` as a sum of `parts` multiples of `step`; `step` divides `sum`.
std::vector<std::vector<int>> splits(int sum, std::size_t parts, int step) {
  std::vector<int> split(parts, 0);
  split.back() = sum;
  std::vector<std::vector<int>> all{split};
  // Odometer: the last part pays for what the others take.
  for (std::size_t i = 0; i + 1 < parts;) {
    if (split.back() >= step) {
      split[i] += step;
      split.back() -= step;
      all.push_back(split);
      i = 0;
    } else {
      split.back() += split[i];
      split[i++] = 0;
    }
  }
  return all;
}

// Pixels, blocks and aligned runs of samples from all over their ranges.
struct AlignedRun {
  Pixel pixel;
  std::uint32_t block = 0;
  std::uint32_t first = 0;
};

std::vector<AlignedRun> runs_of(std::uint32_t length, int count, std::uint64_t seed) {
  Random random(seed);
  const auto any = [&] { return static_cast<std::uint32_t>(random.bits()); };
  std::vector<AlignedRun> runs{{{0, 0, 0}, 0, 0}, {{0, 0, 0}, 0, 0U - length}};
  while (runs.size() < static_cast<std::size_t>(count))
    runs.push_back(
        {{random.bits(), any() % 8192, any() % 8192}, any() % 64, any() & ~(length - 1)});
  return runs;
}

TEST(PixelSampler, PairsAreZeroTwoSequences) {
  for (int n = 0; n <= 10; ++n)
    for (const AlignedRun& run : runs_of(1U << n, 12, 11)) {
      const Points points = points_of(run.pixel, run.block, run.first, 1U << n);
      for (std::size_t pair = 0; pair < 8; pair += 2)
        for (const std::vector<int>& bits : splits(n, 2, 1)) {
          ASSERT_TRUE(one_point_per_box(points, {pair, pair + 1}, bits))
              << "pair " << pair << ", 2^" << n << " samples, " << bits[0] << " bits of the first";
        }
    }
}

TEST(PixelSampler, HalvesAreZeroFourSequencesInBaseFour) {
  for (int n = 2; n <= 8; n += 2)
    for (const AlignedRun& run : runs_of(1U << n, 12, 12)) {
      const Points points = points_of(run.pixel, run.block, run.first, 1U << n);
      for (std::size_t half = 0; half < 8; half += 4)
        for (const std::vector<int>& bits : splits(n, 4, 2)) {
          ASSERT_TRUE(one_point_per_box(points, {half, half + 1, half + 2, half + 3}, bits));
        }
    }
}

TEST(PixelSampler, BlocksAreZeroEightSequencesInBaseSixteen) {
  for (int n = 4; n <= 12; n += 4)
    for (const AlignedRun& run : runs_of(1U << n, 4, 13)) {
      const Points points = points_of(run.pixel, run.block, run.first, 1U << n);
      for (const std::vector<int>& bits : splits(n, 8, 4)) {
        ASSERT_TRUE(one_point_per_box(points, {0, 1, 2, 3, 4, 5, 6, 7}, bits));
      }
    }
}

TEST(PixelSampler, IsAPureFunctionWithDistinctKeys) {
  std::set<std::string> seen;
  const auto expect_new = [&](const PixelSampler& sampler, std::uint32_t block) {
    std::string text;
    const Block8 u = sampler.block(block);
    const Block8 again = sampler.block(block);
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_EQ(u[i], again[i]);
      text += std::to_string(u[i]) + " ";
    }
    EXPECT_TRUE(seen.insert(text).second) << text;
  };
  expect_new({0, 0, 0, 0}, 0);
  expect_new({1, 0, 0, 0}, 0);
  expect_new({1ULL << 63, 0, 0, 0}, 0);
  expect_new({0, 1, 0, 0}, 0);
  expect_new({0, 0, 1, 0}, 0);
  expect_new({0, 0, 0, 1}, 0);
  expect_new({0, 0, 0, 0xffffffffU}, 0);
  expect_new({0, 0xffffffffU, 0xffffffffU, 0}, 0);
  expect_new({0, 0, 0, 0}, 1);
  expect_new({0, 0, 0, 0}, (1U << 28) - 1);
}

// One value by value: a change of these numbers changes every picture.
TEST(PixelSampler, KeepsItsNumbers) {
  const Block8 u = PixelSampler(1, 2, 3, 4).block(5);
  EXPECT_EQ(u[0], 0x1.7f905d04p-3);
  EXPECT_EQ(u[7], 0x1.f5ef000cp-3);
}

TEST(PixelSampler, NumbersAreOddMultiplesInsideTheUnitInterval) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const Block8 u = PixelSampler(random.bits(), 1, 2, static_cast<std::uint32_t>(random.bits()))
                         .block(static_cast<std::uint32_t>(i));
    for (std::size_t d = 0; d < 8; ++d) {
      ASSERT_GT(u[d], 0.0);
      ASSERT_LT(u[d], 1.0);
      ASSERT_EQ(std::fmod(std::ldexp(u[d], 33), 2.0), 1.0);
    }
  }
}

// One number, and one pair, over independent pixels: uniform. False-alarm rate 1e-3 in all.
TEST(PixelSampler, EachSampleIsUniform) {
  test::SamplerTest settings;
  settings.significance = 1e-3;
  settings.tests = 3 * 28;
  settings.samples = 20000;
  const test::Grid grid{{0, 0}, {1, 1}, 16, 16};
  for (const std::uint32_t sample : {0U, 1U, 77U})
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = i + 1; j < 8; ++j) {
        std::uint32_t pixel = 0;
        const auto draw = [&](Random&) -> std::optional<Vec2d> {
          const std::uint32_t n = pixel++;
          const Block8 u = PixelSampler(9, n % 200, n / 200, sample).block(sample % 3);
          return Vec2d{u[i], u[j]};
        };
        const test::ChiSquaredResult result = test::test_points(
            grid, draw, [](Vec2d) { return 1.0; }, settings);
        EXPECT_TRUE(result.accepted) << i << " " << j << ": " << result.message;
      }
}

// Every bit of every number is set in half of the pixels, and where two samples of a pixel fall
// into one half of the interval or not, their lower bits agree in half of the pixels. 6 standard
// errors: false-alarm rate 1e-6 in all.
TEST(PixelSampler, BitsAreBalanced) {
  constexpr int pixels = 40000;
  std::array<std::array<int, 32>, 8> set_bits{};
  std::array<std::array<int, 32>, 8> equal_bits{};  // to the same bit of the next sample's number
  for (std::uint32_t n = 0; n < pixels; ++n) {
    const Block8 u = PixelSampler(n / 7, n % 7, 5, 6).block(2);
    const Block8 v = PixelSampler(n / 7, n % 7, 5, 9).block(2);
    for (std::size_t d = 0; d < 8; ++d) {
      const auto bits = static_cast<std::uint32_t>(std::ldexp(u[d], 32));
      const auto same = ~(bits ^ static_cast<std::uint32_t>(std::ldexp(v[d], 32)));
      for (std::size_t b = 0; b < 32; ++b) {
        set_bits[d][b] += static_cast<int>(bits >> b & 1U);
        equal_bits[d][b] += static_cast<int>(same >> b & 1U);
      }
    }
  }
  const double allowed = 6.0 * std::sqrt(0.25 * pixels);
  for (std::size_t d = 0; d < 8; ++d)
    for (std::size_t b = 0; b < 32; ++b) {
      EXPECT_NEAR(set_bits[d][b], 0.5 * pixels, allowed) << d << " " << b;
      // Samples 6 and 9 differ in their highest four bits' stratum only: lower bits are free.
      if (b < 24) {
        EXPECT_NEAR(equal_bits[d][b], 0.5 * pixels, allowed) << d << " " << b;
      }
    }
}

// Correlation of two numbers over many pixels; 12 u v of centred uniform numbers has variance 1.
// 5 standard errors: false-alarm rate 6e-7 each, below 1e-4 in all.
TEST(PixelSampler, PixelsAndBlocksAreUncorrelated) {
  constexpr std::uint32_t pixels = 20000;
  const auto at = [](std::uint32_t n, std::uint32_t dx, std::uint32_t dy, std::uint32_t block) {
    return PixelSampler(21, 2 * (n % 160) + dx, 2 * (n / 160) + dy, 3).block(block);
  };
  struct Other {
    std::uint32_t dx, dy, block;
  };
  for (const Other& other : {Other{1, 0, 0}, Other{0, 1, 0}, Other{1, 1, 0}, Other{0, 0, 1},
                             Other{0, 0, 2}, Other{1, 0, 1}})
    for (std::size_t i = 0; i < 8; ++i) {
      RunningMean correlation;
      for (std::uint32_t n = 0; n < pixels; ++n) {
        const double u = at(n, 0, 0, 0)[i] - 0.5;
        const double v = at(n, other.dx, other.dy, other.block)[(i + 3 * other.block) % 8] - 0.5;
        correlation.add(12.0 * u * v);
      }
      const test::ZTestResult z = test::z_test(correlation, 0.0, 5.0);
      EXPECT_TRUE(z.accepted) << i << ": " << z.message;
    }
}

// Within a pixel, numbers of two blocks must meet by chance. The first 16 samples are four runs of
// four, in each of which both blocks visit all four intervals of length 1/4 once, in independent
// orders: a cell of the 4 x 4 grid gets a sample of each run with probability 1/4, so the mean
// squared count is 1 + 4 (1/4) (3/4). On a diagonal it would be 4, on a lattice 1. Mean over
// pixels, 5 standard errors: false-alarm rate 6e-7 each.
TEST(PixelSampler, BlocksAreShuffledAgainstEachOther) {
  for (const std::size_t i : {0U, 3U, 5U}) {
    RunningMean squares;
    for (std::uint32_t pixel = 0; pixel < 4000; ++pixel) {
      std::array<int, 16> count{};
      for (std::uint32_t n = 0; n < 16; ++n) {
        const PixelSampler sampler(5, pixel, 7, n);
        const auto x = static_cast<std::size_t>(4 * sampler.block(1)[i]);
        const auto y = static_cast<std::size_t>(4 * sampler.block(2)[i]);
        ++count[4 * x + y];
      }
      double sum = 0.0;
      for (const int c : count) sum += c * c / 16.0;
      squares.add(sum);
    }
    const test::ZTestResult z = test::z_test(squares, 1.75, 5.0);
    EXPECT_TRUE(z.accepted) << z.message;
  }
}

TEST(PassSample, IsAScrambledVanDerCorputSequence) {
  Random random(8);
  for (int n = 0; n <= 12; ++n)
    for (int trial = 0; trial < 8; ++trial) {
      const std::uint64_t seed = random.bits();
      const auto dimension = static_cast<std::uint32_t>(random.index(100));
      const auto first = trial == 0 ? 0U : static_cast<std::uint32_t>(random.bits()) << n;
      std::vector<bool> taken(1U << n, false);
      for (std::uint32_t i = 0; i < 1U << n; ++i) {
        const double u = pass_sample(seed, first + i, dimension);
        ASSERT_GT(u, 0.0);
        ASSERT_LT(u, 1.0);
        const auto stratum = static_cast<std::size_t>(std::ldexp(u, n));
        ASSERT_FALSE(taken[stratum]);
        taken[stratum] = true;
      }
    }
}

// 5 standard errors: false-alarm rate 6e-7 each.
TEST(PassSample, DimensionsAndSeedsAreUncorrelated) {
  RunningMean dimensions;
  RunningMean seeds;
  RunningMean pixels;
  for (std::uint32_t n = 0; n < 20000; ++n) {
    const double u = pass_sample(n, n % 50, 0) - 0.5;
    dimensions.add(12 * u * (pass_sample(n, n % 50, 1) - 0.5));
    seeds.add(12 * u * (pass_sample(n + 1, n % 50, 0) - 0.5));
    pixels.add(12 * u * (PixelSampler(n, 0, 0, n % 50).block(0)[0] - 0.5));
  }
  for (const RunningMean& mean : {dimensions, seeds, pixels}) {
    const test::ZTestResult z = test::z_test(mean, 0.0, 5.0);
    EXPECT_TRUE(z.accepted) << z.message;
  }
}

}  // namespace
}  // namespace lapidary
