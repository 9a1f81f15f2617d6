#include "render/block.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <vector>

#include "base/mix_bits.h"
#include "sampling/sobol.h"

namespace lapidary::render {
namespace {

// Numbers that all pixels of a pass share (`pass_sample`).
constexpr std::uint32_t wavelength_dimension = 0;

/// Which wavelength leads the `nth` sample of a pixel in a pass. Four samples have one each, and so
/// have the first ones of every four pixels in a square, in an order by chance: where glass splits
/// colours, neighbours have different ones.
std::size_t hero_of(std::uint32_t x, std::uint32_t y, std::uint32_t nth, std::uint64_t seed) {
  const std::uint64_t square = std::uint64_t{y / 2} << 32 | x / 2;
  const std::uint64_t order = mix_bits(square ^ mix_bits(seed)) % 4;
  return (((2 * (y % 2) + x % 2) ^ order) + nth) % 4;
}

}  // namespace

/// Says how much of a block is done, now and then. Threads share it, under a lock.
class BlockRenderer::ShareReport {
 public:
  explicit ShareReport(const Watch& watch) : watch_(watch) {}

  void add(double share) {
    constexpr std::chrono::milliseconds often(200);
    share_ += share;
    if (!watch_.on_share || Clock::now() - last_ < often) return;
    last_ = Clock::now();
    watch_.on_share(std::min(share_, 1.0));
  }

 private:
  using Clock = std::chrono::steady_clock;

  const Watch& watch_;
  double share_ = 0;
  Clock::time_point last_ = Clock::now();
};

/// What all pixels of a pass share: photons and camera paths can only meet at the same wavelengths.
struct BlockRenderer::Pass {
  std::uint32_t index;
  Heroes wavelengths;
  camera::Cone cone;  ///< of a pixel
  std::optional<transport::CausticPass> caustics;
};

BlockRenderer::BlockRenderer(const scene::Scene& scene, const SampleSettings& settings,
                             const Picture& picture, ThreadPool& pool)
    : scene_(scene),
      settings_(settings),
      tracer_(scene, settings.path),
      caustics_(
          scene,
          {settings.path.interreflection == transport::Interreflection::full
               ? settings.path.caustics
               : transport::CausticMethod::paths,
           settings.path.max_depth, settings.seed, picture.width, picture.height, settings.photons},
          pool),
      cone_(camera::pixel_cone(scene.camera(), {static_cast<double>(picture.width),
                                                static_cast<double>(picture.height)})),
      tile_(picture.tile) {
  if (!settings.illumination) return;
  maps_.emplace(scene, *settings.illumination, pool);
  map_tracer_.emplace(scene, *maps_, settings.path.max_depth);
}

film::PixelSample BlockRenderer::sample_pixel(Vec2d size, const Sample& sample, const Pass& pass,
                                              transport::Counters& counters) const {
  const auto [x, y, number, nth] = sample;
  const PixelSampler points(settings_.seed, x, y, number);
  const auto u = points.block(0);
  const Vec2d offset = settings_.filter.sample({u[0], u[1]});
  const Vec2d film{(x + 0.5 + offset.x) / size.x, (y + 0.5 + offset.y) / size.y};
  const auto ray = camera::generate_ray(scene_.camera(), {film, {u[2], u[3]}, u[4]});
  if (!ray) return {};

  transport::FirstSurface first;
  const Wavelengths& wavelengths = pass.wavelengths[hero_of(x, y, nth, settings_.seed)];
  const transport::SampleContext context{wavelengths, points, counters, pass.cone,
                                         pass.caustics ? &*pass.caustics : nullptr};
  const SampledSpectrum L = map_tracer_ ? map_tracer_->radiance(*ray, context, first)
                                        : tracer_.radiance(*ray, context, first);
  return {wavelengths.to_rgb(L), first.albedo, Vec3f(first.normal), static_cast<float>(first.depth),
          first.object};
}

film::PixelSums BlockRenderer::sum_pixel(int x, int y, std::span<const Pass> passes,
                                         const SampleMap& map, const film::Film& film,
                                         BlockTally& tally) const {
  const Vec2d size{static_cast<double>(film.width()), static_cast<double>(film.height())};
  film::PixelSums sums;
  for (const Pass& pass : passes) {
    const auto [first, count] = map.at(x, y, pass.index);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Sample sample{static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), first + i,
                          i};
      film.add(sample_pixel(size, sample, pass, tally.counters), sums, tally.faults);
    }
    tally.samples += count;
  }
  return sums;
}

double BlockRenderer::photons_share_of_work() const {
  if (caustics_.state() != transport::Caustics::State::active) return 0.0;
  return caustics_.share().cost / (1.0 + caustics_.share().cost);
}

std::vector<BlockRenderer::Pass> BlockRenderer::prepare(PassRange range, const SampleMap& map,
                                                        ThreadPool& pool, BlockTally& tally,
                                                        ShareReport& report) const {
  const double rotation = pass_sample(settings_.seed, 0, wavelength_dimension);
  std::vector<Pass> passes;
  for (std::uint32_t p = range.begin; p < range.end; ++p) {
    const Heroes wavelengths =
        every_hero(Wavelengths::sample(Wavelengths::pass_stratum(p, rotation)));
    passes.push_back({p, wavelengths, cone_, std::nullopt});
    if (caustics_.state() == transport::Caustics::State::active) {
      passes.back().caustics = caustics_.trace({p, map.photons(), map.photons_before(p)},
                                               wavelengths, pool, tally.counters);
      const transport::CausticPass& pass = *passes.back().caustics;
      tally.photon_bytes += pass.focused.map.bytes() + pass.diffused.map.bytes();
      report.add(photons_share_of_work() / range.size());
    }
  }
  return passes;
}

BlockTally BlockRenderer::render(PassRange range, const SampleMap& map, film::Film& film,
                                 ThreadPool& pool, const Watch& watch) const {
  BlockTally total;
  ShareReport report(watch);
  const std::vector<Pass> passes = prepare(range, map, pool, total, report);
  const int columns = (film.width() + tile_ - 1) / tile_;
  const int rows = (film.height() + tile_ - 1) / tile_;
  std::mutex mutex;
  const auto tiles = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  const double tile_share = (1.0 - photons_share_of_work()) / static_cast<double>(tiles);
  pool.parallel_for(tiles, 1, [&](IndexRange some) {
    if (watch.given_up != nullptr && *watch.given_up) return;
    BlockTally tally;
    for (std::size_t tile = some.begin; tile < some.end; ++tile) {
      const int x0 = static_cast<int>(tile % static_cast<std::size_t>(columns)) * tile_;
      const int y0 = static_cast<int>(tile / static_cast<std::size_t>(columns)) * tile_;
      for (int y = y0; y < std::min(y0 + tile_, film.height()); ++y) {
        for (int x = x0; x < std::min(x0 + tile_, film.width()); ++x) {
          film.add_block(range, x, y, sum_pixel(x, y, passes, map, film, tally));
        }
      }
    }
    const std::lock_guard lock(mutex);
    total += tally;
    report.add(tile_share * static_cast<double>(some.end - some.begin));
  });
  film.finish_block(range, total.faults);
  return total;
}

}  // namespace lapidary::render
