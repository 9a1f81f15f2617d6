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

}  // namespace
}  // namespace lapidary
