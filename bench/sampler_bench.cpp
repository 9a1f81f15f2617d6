// What random numbers and warps cost.

#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "sampling/distribution.h"
#include "sampling/filter.h"
#include "sampling/sobol.h"
#include "sampling/warp.h"

namespace lapidary {
namespace {

// Blocks that do not wait for each other: what a block costs a renderer that has other work.
void block_throughput(benchmark::State& state) {
  const PixelSampler sampler(1, 320, 240, 77);
  std::uint32_t k = 0;
  for (auto _ : state) {
    Block8 block = sampler.block(k++ & 15U);
    benchmark::DoNotOptimize(block);
  }
}
BENCHMARK(block_throughput);

// Each block waits for the one before: the whole latency.
void block_latency(benchmark::State& state) {
  const PixelSampler sampler(1, 320, 240, 77);
  std::uint32_t k = 0;
  for (auto _ : state) {
    const Block8 block = sampler.block(k);
    k = block[7] < 0.5 ? 3U : 5U;
    benchmark::DoNotOptimize(k);
  }
}
BENCHMARK(block_latency);

void make_sampler_and_block(benchmark::State& state) {
  std::uint32_t sample = 0;
  for (auto _ : state) {
    Block8 block = PixelSampler(1, 320, 240, sample++).block(0);
    benchmark::DoNotOptimize(block);
  }
}
BENCHMARK(make_sampler_and_block);

void pass_number(benchmark::State& state) {
  std::uint32_t pass = 0;
  for (auto _ : state) benchmark::DoNotOptimize(pass_sample(1, pass++, 0));
}
BENCHMARK(pass_number);

template <typename Warp>
void run_warp(benchmark::State& state, Warp warp) {
  Vec2d u{0.1, 0.7};
  for (auto _ : state) {
    benchmark::DoNotOptimize(u);
    auto point = warp(u);
    benchmark::DoNotOptimize(point);
  }
}

void warp_disk(benchmark::State& state) {
  run_warp(state, sample_uniform_disk);
}
BENCHMARK(warp_disk);
void warp_cosine_hemisphere(benchmark::State& state) {
  run_warp(state, sample_cosine_hemisphere);
}
BENCHMARK(warp_cosine_hemisphere);
void warp_cone(benchmark::State& state) {
  run_warp(state, [](Vec2d u) { return sample_uniform_cone(u, 0.01); });
}
BENCHMARK(warp_cone);

// An image of noise: nothing stays in the cache by being likely.
void image_distribution(benchmark::State& state) {
  const auto width = static_cast<std::size_t>(state.range(0));
  std::vector<double> image(width * width / 2);
  for (std::size_t i = 0; i < image.size(); ++i) image[i] = static_cast<double>(i * 7919 % 1000);
  const PiecewiseConstant2D distribution(image, width);
  const PixelSampler sampler(1, 0, 0, 0);
  std::uint32_t k = 0;
  for (auto _ : state) {
    const Block8 u = sampler.block(k++ & 0xffffU);
    auto sample = distribution.sample({u[0], u[1]});
    benchmark::DoNotOptimize(sample);
  }
}
BENCHMARK(image_distribution)->Arg(256)->Arg(512)->Arg(1024)->Arg(2048);

void filter(benchmark::State& state) {
  const FilterSampler sampler(FilterKind::blackman_harris, 1.5);
  const PixelSampler points(1, 0, 0, 0);
  std::uint32_t k = 0;
  for (auto _ : state) {
    const Block8 u = points.block(k++ & 0xffffU);
    auto offset = sampler.sample({u[0], u[1]});
    benchmark::DoNotOptimize(offset);
  }
}
BENCHMARK(filter);

}  // namespace
}  // namespace lapidary
