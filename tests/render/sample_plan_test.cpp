#include "render/sample_plan.h"

#include <gtest/gtest.h>

#include "render/render.h"
#include "scene/tiny_scene.h"
#include "support/random.h"
#include "support/statistics.h"

namespace lapidary::test {
namespace {

using render::Allocation;
using render::best_allocation;
using render::PhotonShare;
using render::SampleMap;
using render::SamplePlan;

/// Cost times error, as best_allocation states them.
double product(const std::vector<double>& variances, const PhotonShare& photons,
               const Allocation& allocation) {
  double cost = allocation.photons * photons.cost * static_cast<double>(variances.size());
  double error = 0.0;
  for (std::size_t i = 0; i < variances.size(); ++i) {
    const double count = allocation.counts[i];
    cost += count;
    error += variances[i] * ((1.0 - photons.error) / count + photons.error / allocation.photons);
  }
  return cost * error;
}

TEST(BestAllocation, IsOneSampleWherePixelsAreAlike) {
  for (const double variance : {0.0, 1e-9, 3.0}) {
    const auto best = best_allocation(std::vector<double>(100, variance), {});
    EXPECT_EQ(best.counts, std::vector<std::uint8_t>(100, 1));
    EXPECT_EQ(best.photons, 1.0);
  }
}

TEST(BestAllocation, IsBetterThanOneSampleAndThanRandomOnes) {
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    std::vector<double> variances(200);
    for (double& variance : variances) variance = random.magnitude(-4, 0);
    const PhotonShare photons{random.uniform(0, 2), random.uniform()};
    const Allocation best = best_allocation(variances, photons);
    const double least = product(variances, photons, best);
    Allocation other{std::vector<std::uint8_t>(variances.size(), 1)};
    EXPECT_LE(least, 1.05 * product(variances, photons, other));
    for (int i = 0; i < 20; ++i) {
      for (std::uint8_t& count : other.counts) {
        count = static_cast<std::uint8_t>(1 + random.index(Allocation::most));
      }
      other.photons = random.uniform(1, 4);
      EXPECT_LE(least, 1.05 * product(variances, photons, other));
    }
    for (std::size_t i = 0; i < variances.size(); ++i) {
      EXPECT_GE(best.counts[i], 1);
      EXPECT_LE(best.counts[i], Allocation::most);
      if (variances[i] > variances[0]) continue;
      EXPECT_LE(best.counts[i], best.counts[0]);
    }
  }
}

constexpr int width = 20, height = 14;

/// A film after two blocks of four passes, noisy on its right; the pixel gets `of_pixel` instead.
film::Film noisy_film(int px, int py, float of_pixel) {
  film::Film film({.width = width, .height = height});
  film::SampleFaults faults;
  Random random(3);
  for (const film::PassRange passes : {film::PassRange{0, 4}, {4, 8}}) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        film::PixelSums sums;
        for (std::uint32_t i = 0; i < 4; ++i) {
          const auto noise = static_cast<float>(random.uniform() * (x > width / 2 ? 1.0 : 0.01));
          const float value = x == px && y == py ? of_pixel * noise : 0.5f + noise;
          film.add({{value, value, value}, {}, {}}, sums, faults);
        }
        film.add_block(passes, x, y, sums);
      }
    }
    film.finish_block(passes);
  }
  return film;
}

SampleMap map_after(const film::Film& film) {
  SamplePlan plan({}, width, height);
  EXPECT_TRUE(plan.map(0).is_uniform());
  EXPECT_EQ(plan.known_until(), 8u);
  plan.block_done(film);
  EXPECT_EQ(plan.known_until(), 32u);
  return plan.map(8);
}

TEST(SamplePlan, SamplesMoreWhereItIsNoisy) {
  const SampleMap map = map_after(noisy_film(0, 0, 0.5f));
  EXPECT_EQ(map.at(2, 7, 8).count, 1u);
  EXPECT_GT(map.at(width - 3, 7, 8).count, 4u);
  EXPECT_GT(map.mean(), 1.5);
}

// What keeps pictures unbiased: a pixel's own samples do not decide how many follow.
TEST(SamplePlan, NobodyDecidesForItself) {
  for (const auto& [x, y] : {std::pair{0, 0}, {10, 7}, {15, 3}, {width - 1, height - 1}}) {
    const SampleMap dark = map_after(noisy_film(x, y, 0.0f));
    const SampleMap bright = map_after(noisy_film(x, y, 1e-3f));
    EXPECT_EQ(dark.at(x, y, 8).count, bright.at(x, y, 8).count);
  }
  // But it does for others.
  const SampleMap calm = map_after(noisy_film(4, 7, 0.5f)),
                  wild = map_after(noisy_film(4, 7, 900.0f));
  EXPECT_NE(calm.at(5, 7, 8).count, wild.at(5, 7, 8).count);
}

// Radii shrink with the photons of all passes before, however these were shared out.
TEST(SamplePlan, CountsThePhotonsOfThePassesBefore) {
  SamplePlan plan({.cost = 0.1, .error = 0.9}, width, height);
  EXPECT_EQ(plan.map(5).photons_before(5), 5.0);
  plan.block_done(noisy_film(0, 0, 0.5f));
  const double factor = plan.map(8).photons();
  EXPECT_GT(factor, 1.0);
  EXPECT_EQ(plan.map(8).photons_before(8), 8.0);
  EXPECT_EQ(plan.map(11).photons_before(11), 8.0 + 3.0 * factor);
  EXPECT_EQ(plan.map(18).photons_before(18), 8.0 + 8.0 * factor + 2.0 * plan.map(18).photons());
}

// Numbers of a pixel's samples follow one another through passes and epochs.
TEST(SamplePlan, LeavesNoNumberOutAndTakesNoneTwice) {
  film::Film film = noisy_film(0, 0, 0.5f);
  SamplePlan plan({}, width, height);
  plan.block_done(film);
  film::SampleFaults faults;
  Random random(5);
  std::vector<std::uint32_t> next(width * height, 8);
  for (std::uint32_t pass = 8; pass < 70; pass += 2) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        film::PixelSums sums;
        for (std::uint32_t p = pass; p < pass + 2; ++p) {
          const auto [first, count] = plan.map(p).at(x, y, p);
          std::uint32_t& expected = next[static_cast<std::size_t>(y * width + x)];
          ASSERT_EQ(first, expected) << "pass " << p;
          expected += count;
          for (std::uint32_t i = 0; i < count; ++i) {
            const auto value = static_cast<float>(random.uniform() * (y > 5 ? 1.0 : 0.1));
            film.add({{value, value, value}, {}, {}}, sums, faults);
          }
        }
        film.add_block({pass, pass + 2}, x, y, sums);
      }
    }
    film.finish_block({pass, pass + 2});
    plan.block_done(film);
  }
  EXPECT_GT(plan.map(69).mean(), 1.1);
}

// Adaptive and uniform pictures have the same mean, over many seeds: within 4 standard errors, of
// which each is below 0.05 %. False alarms: 6e-5.
TEST(SamplePlan, KeepsTheMeanOfPictures) {
  const scene::Scene scene =
      TinyScene()
          .add(geometry::Rectangle{{-4, -4, -1}, {8, 0, 0}, {0, 8, 0}}, matte(0.5))
          .add(geometry::Sphere{{0.6, 0, 0}, 0.5}, matte(0.8))
          .add(geometry::Sphere{{1, -1, 4}, 0.5}, lamp(0.5))
          .sky(0.02)
          .build();
  ThreadPool pool(1);
  RunningMean means[2];
  double samples = 0.0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    for (const render::Sampling sampling :
         {render::Sampling::adaptive, render::Sampling::uniform}) {
      render::SampleSettings settings = render::sample_settings({});
      settings.seed = seed;
      settings.sampling = sampling;
      const render::BlockRenderer renderer(scene, settings, {10, 8}, pool);
      render::Canvas canvas({.width = 10, .height = 8}, renderer);
      const auto done = render::render(renderer, {.samples = 32}, {}, canvas, pool);
      const film::Film& film = canvas.film();
      const bool adaptive = sampling == render::Sampling::adaptive;
      if (adaptive) samples += static_cast<double>(done.tally.samples) / (200 * 32 * 80);
      double sum = 0.0;
      for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 10; ++x) sum += static_cast<double>(film.beauty(x, y).g);
      }
      means[adaptive ? 0 : 1].add(sum / 80);
    }
  }
  EXPECT_GT(samples, 1.2) << "hardly adaptive";
  EXPECT_LT(means[0].standard_error(), 5e-4 * means[0].mean());
  EXPECT_LT(means[1].standard_error(), 5e-4 * means[1].mean());
  EXPECT_NEAR(means[0].mean(), means[1].mean(),
              4.0 * std::hypot(means[0].standard_error(), means[1].standard_error()));
}

}  // namespace
}  // namespace lapidary::test
