#include "film/film.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace lapidary::film {
namespace {

PixelSample grey(double value) {
  const auto v = static_cast<float>(value);
  return {{v, v, v}, {}, {}, 0, 0};
}

/// A film of one pixel that has been given `values` in blocks of `per_block`.
Film one_pixel(const std::vector<double>& values, std::size_t per_block,
               const std::vector<std::size_t>& block_order) {
  Film film({.width = 1, .height = 1});
  SampleFaults faults;
  for (const std::size_t block : block_order) {
    PixelSums sums;
    for (std::size_t i = 0; i < per_block; ++i) {
      const std::size_t pass = block * per_block + i;
      film.add(grey(values[pass]), sums, faults);
    }
    const auto begin = static_cast<std::uint32_t>(block * per_block);
    const PassRange passes{begin, begin + static_cast<std::uint32_t>(per_block)};
    film.add_block(passes, 0, 0, sums);
    film.finish_block(passes);
  }
  return film;
}

TEST(Film, SumsDoNotDependOnTheOrderOfBlocks) {
  std::mt19937_64 random(1);
  std::lognormal_distribution<double> bright(0.0, 4.0);
  std::vector<double> values(400);
  for (double& v : values) v = bright(random);
  std::vector<std::size_t> order(100);
  std::iota(order.begin(), order.end(), 0u);
  const Film forward = one_pixel(values, 4, order);
  for (int i = 0; i < 10; ++i) {
    std::shuffle(order.begin(), order.end(), random);
    const Film shuffled = one_pixel(values, 4, order);
    EXPECT_EQ(forward.beauty(0, 0), shuffled.beauty(0, 0));
    EXPECT_EQ(forward.variance(0, 0), shuffled.variance(0, 0));
    EXPECT_EQ(forward.noise(), shuffled.noise());
  }
}

TEST(Film, MeanAndVarianceAgreeWithTheTextbook) {
  std::mt19937_64 random(2);
  std::gamma_distribution<double> gamma(0.5, 0.8);
  std::vector<double> values(4000);
  for (double& v : values) v = static_cast<double>(static_cast<float>(gamma(random)));
  std::vector<std::size_t> order(1000);
  std::iota(order.begin(), order.end(), 0u);
  const Film film = one_pixel(values, 4, order);
  std::vector<double> means;
  for (std::size_t b = 0; b < order.size(); ++b) {
    means.push_back(std::accumulate(&values[4 * b], &values[4 * b] + 4, 0.0) / 4);
  }
  const double mean = std::accumulate(means.begin(), means.end(), 0.0) / 1000;
  double squares = 0;
  for (const double m : means) squares += (m - mean) * (m - mean);
  const double variance = squares / 999 / 1000;
  EXPECT_NEAR(static_cast<double>(film.beauty(0, 0).r), mean, 1e-7);
  EXPECT_NEAR(static_cast<double>(film.variance(0, 0).g) / variance, 1.0, 1e-4);
  const double noise = std::sqrt(variance) / (mean + 0.01);
  EXPECT_NEAR(film.noise() / noise, 1.0, 1e-4);
}

// Blocks of different numbers of samples, as adaptive sampling makes them: over many films the
// variance that is estimated is that of their means. The error of the ratio is 1.5 %, so 6 % are
// passed by chance once in 10,000.
TEST(Film, KnowsTheVarianceOfUnequalBlocks) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<float> uniform(0, 1);
  constexpr int films = 20'000;
  double sum = 0, squares = 0, estimated = 0;
  for (int i = 0; i < films; ++i) {
    Film film({.width = 1, .height = 1});
    SampleFaults faults;
    PassRange passes{0, 4};
    for (const std::uint32_t size : {4u, 4u, 24u, 64u}) {
      PixelSums sums;
      for (std::uint32_t s = 0; s < size; ++s) {
        const float value = uniform(random);
        film.add({{value, value, value}, {}, {}}, sums, faults);
      }
      film.add_block(passes, 0, 0, sums);
      film.finish_block(passes);
      passes = {passes.end, passes.end + 4};
    }
    EXPECT_EQ(film.samples(0, 0), 96u);
    const auto mean = static_cast<double>(film.beauty(0, 0).r);
    sum += mean, squares += mean * mean;
    estimated += static_cast<double>(film.variance(0, 0).r);
  }
  const double variance = squares / films - sum / films * (sum / films);
  EXPECT_NEAR(sum / films, 0.5, 1e-3);
  EXPECT_NEAR(variance * 96 * 12, 1.0, 0.06);
  EXPECT_NEAR(estimated / films / variance, 1.0, 0.06);
}

/// The samples of one block of a picture of 3 x 2 pixels: what they are depends on the pass alone.
void expose(Film& film, const PassRange& passes) {
  SampleFaults faults;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      PixelSums sums;
      for (std::uint32_t p = passes.begin; p < passes.end; ++p) {
        std::mt19937_64 random(p * 6 + static_cast<std::uint32_t>(y * 3 + x));
        std::lognormal_distribution<float> bright(0.0f, 3.0f);
        const bool hits = random() % 3 != 0;
        const float broken = random() % 50 == 0 ? NAN : bright(random);
        film.add({{broken, bright(random), -bright(random)},
                  {0.5f, 0.25f, 0.1f},
                  {0, 0, hits ? 1.0f : 0.0f},
                  hits ? bright(random) : 0.0f,
                  hits ? static_cast<std::uint32_t>(random() % 9 + 1) : 0u},
                 sums, faults);
      }
      film.add_block(passes, x, y, sums);
    }
  }
  film.finish_block(passes, faults);
}

// Films of blocks, put together in any order and grouping, are the film of all of them.
TEST(Film, AddingHasNoOrder) {
  std::mt19937_64 random(7);
  for (const Layers layers : {Layers::beauty, Layers::all}) {
    const Film::Settings settings{.width = 3, .height = 2, .layers = layers, .scene_size = 10};
    Film whole(settings);
    std::vector<PassRange> blocks;
    for (std::uint32_t begin = 0; begin < 40; begin += 4) blocks.push_back({begin, begin + 4});
    for (const PassRange& block : blocks) expose(whole, block);
    EXPECT_GT(whole.faults().not_finite, 0u);
    for (int round = 0; round < 20; ++round) {
      std::shuffle(blocks.begin(), blocks.end(), random);
      std::vector<Film> films(3, Film(settings));
      for (const PassRange& block : blocks) {
        Film& film = films[random() % 3];
        if (random() % 2 == 0) {
          expose(film, block);
        } else {
          Film one(settings);
          expose(one, block);
          film.add(one);
        }
      }
      for (const Film& film : films) {
        if (layers == Layers::beauty || film.passes().is_empty()) continue;
        Film alone(settings);
        expose(alone, {film.passes().begin(), film.passes().begin() + 4});
        EXPECT_EQ(film.object(1, 1), alone.object(1, 1)) << "of its own first pass";
      }
      films[1].add(films[2]);
      films[1].add(films[0]);
      EXPECT_EQ(films[1].state(), whole.state());
      EXPECT_EQ(Film(films[1].state()).noise(), whole.noise());
    }
  }
}

TEST(Film, CountsWhatItCannotAdd) {
  Film film({.width = 1, .height = 1});
  SampleFaults faults;
  PixelSums sums;
  film.add(grey(std::nan("")), sums, faults);
  film.add(grey(INFINITY), sums, faults);
  EXPECT_EQ(faults.not_finite, 6u);
  EXPECT_EQ(faults.saturated, 0u);
  film.add(grey(1e30), sums, faults);
  EXPECT_EQ(faults.saturated, 3u);
  film.add(grey(1.0), sums, faults);
  film.add_block({0, 4}, 0, 0, sums);
  film.finish_block({0, 4});
  EXPECT_EQ(film.beauty(0, 0).r, static_cast<float>((0x1p28 + 1.0) / 4));
}

TEST(Film, KeepsLayers) {
  Film film({.width = 2, .height = 1, .layers = Layers::all, .scene_size = 100});
  SampleFaults faults;
  PixelSums sums;
  film.add({{1, 2, 3}, {0.5f, 0.25f, 0.125f}, {0, 0, 1}, 40, 7}, sums, faults);
  film.add({{1, 2, 3}, {0.5f, 0.25f, 0.125f}, {1, 0, 0}, 60, 8}, sums, faults);
  film.add({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 0}, sums, faults);
  film.add({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 0}, sums, faults);
  film.add_block({0, 4}, 1, 0, sums);
  film.finish_block({0, 4});
  EXPECT_EQ(film.albedo(1, 0), (Rgb{0.25f, 0.125f, 0.0625f}));
  EXPECT_EQ(film.normal(1, 0), (Vec3f{0.25f, 0, 0.25f}));
  EXPECT_NEAR(static_cast<double>(film.depth(1, 0)), 50.0, 1e-6);
  EXPECT_EQ(film.object(1, 0), 7u) << "that of pass 0, whatever came later";
  EXPECT_EQ(film.object(0, 0), 0u);
}

TEST(FixedScale, RoundsToNearestAndBack) {
  const FixedScale scale(0.5);
  EXPECT_EQ(scale.fixed(0.5).units, INT64_C(1) << 32);
  EXPECT_EQ(scale.value(scale.fixed(0.3).units), std::nearbyint(0.6 * 0x1p32) * 0x1p-33);
  EXPECT_EQ(saturating_add(INT64_MAX - 1, 5), INT64_MAX);
  EXPECT_EQ(saturating_add(INT64_MIN + 1, -5), INT64_MIN);
}

}  // namespace
}  // namespace lapidary::film
