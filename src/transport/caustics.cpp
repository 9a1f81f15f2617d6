#include "transport/caustics.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lapidary::transport {
namespace {

/// In diameters of the camera's cone, which is a pixel's: the radius of the first pass.
constexpr double first_radius = 2.5;
/// Photons of a pass that bring light somewhere, for each pixel.
constexpr double photons_per_pixel = 0.25;
/// And for a picture, however large: what they leave has to stay in memory for a block of passes.
constexpr double most_useful = 1 << 22;
/// Where few do: the most that are traced, and that are emitted with those known to miss.
constexpr double most_traced_per_pixel = 0.75;
constexpr double most_emitted_per_pixel = 4.0;
constexpr std::uint32_t most_per_pass = 1u << 24;
/// Photons of the first phase.
constexpr std::uint32_t fewest_to_learn_from = 1u << 12;
constexpr std::uint32_t most_to_learn_from = 1u << 16;
/// Photons traced together by one thread.
constexpr std::size_t chunk = 1024;
/// Numbers of passes that no render gets to, for the first phase.
constexpr std::uint32_t probing_pass = 0xffffff00u;

Vec3d origin_of(const scene::Scene& scene) {
  const Box3d box = scene.world().bounds();
  return box.empty() ? Vec3d() : box.center();
}

}  // namespace

double radius_shrinkage(std::uint32_t pass) {
  double squared = 1.0;
  for (std::uint32_t k = 1; k <= pass; ++k) squared *= (k + 2.0 / 3.0) / (k + 1.0);
  return std::sqrt(squared);
}

Caustics::Caustics(const scene::Scene& scene, const Settings& settings, ThreadPool& pool)
    : scene_(scene),
      settings_(settings),
      emitter_(scene),
      tracer_(scene, emitter_, settings.max_depth) {
  state_ = prepare(pool);
}

Caustics::State Caustics::prepare(ThreadPool& pool) {
  if (settings_.method != CausticMethod::automatic && settings_.method != CausticMethod::photons) {
    return State::not_wanted;
  }
  if (emitter_.targets().empty()) return State::no_caster;
  if (!emitter_.is_useful()) return State::no_light;
  if (!measure_widths(pool)) return State::not_seen;
  return learn(pool) ? State::active : State::nothing_arrives;
}

bool Caustics::measure_widths(ThreadPool& pool) {
  constexpr int side = 64;
  const PathTracer tracer(scene_, {settings_.max_depth, Interreflection::full, CausticMethod::off});
  const Wavelengths wavelengths = Wavelengths::sample(0.5);
  const camera::Cone cone =
      camera::pixel_cone(scene_.camera(), {double(settings_.width), double(settings_.height)});
  std::vector<double> found(side * side);
  pool.parallel_for(side, 1, [&](IndexRange rows) {
    Counters counters;
    for (std::size_t i = rows.begin * side; i < rows.end * side; ++i) {
      const PixelSampler points(settings_.seed, static_cast<std::uint32_t>(i % side),
                                static_cast<std::uint32_t>(i / side), probing_pass);
      const Block8 u = points.block(0);
      const Vec2d film{(static_cast<double>(i % side) + u[0]) / side,
                       (static_cast<double>(i / side) + u[1]) / side};
      const auto ray = camera::generate_ray(scene_.camera(), {film, {u[2], u[3]}, u[4]});
      if (!ray) continue;
      const auto place = tracer.first_wide(*ray, {wavelengths, points, counters, cone});
      if (place) found[i] = place->width;
    }
  });
  std::erase_if(found, [](double width) { return !(width > 0.0); });
  if (found.empty()) return false;
  std::sort(found.begin(), found.end());
  const auto quantile = [&](double q) {
    return found[static_cast<std::size_t>(q * static_cast<double>(found.size() - 1))];
  };
  // A wider range would cost every pass tables for cells of more sizes.
  constexpr double widest_range = 256.0;
  const double largest = quantile(0.99);
  widths_ = {std::max(quantile(0.01), largest / widest_range), largest};
  return true;
}

bool Caustics::learn(ThreadPool& pool) {
  const Wavelengths wavelengths = Wavelengths::sample(0.5);
  std::uint32_t pass = probing_pass;
  const double pixels = double(settings_.width) * double(settings_.height);
  // Of the order of a pass, and no more than a grid can learn from.
  std::uint32_t count = std::bit_ceil(static_cast<std::uint32_t>(
      std::clamp(pixels, double{fewest_to_learn_from}, double{most_to_learn_from})));
  for (int tries = 0; tries < 3; ++tries, count *= 4) {
    const Yield yield = emit(pass++, count, wavelengths, pool);
    if (yield.useful.empty()) continue;
    emitter_.learn(yield.useful);
    // What it has learned decides how many photons are emitted for those that are wanted.
    const std::uint32_t again = count / 4;
    const Yield now = emit(pass++, again, wavelengths, pool);
    const double useful = static_cast<double>(now.useful.size()) / again;
    const double traced = static_cast<double>(now.counters.photons_traced) / again;
    const double wanted =
        std::min({std::min(photons_per_pixel * pixels, most_useful) / useful,
                  most_traced_per_pixel * pixels / traced, most_emitted_per_pixel * pixels});
    photons_per_pass_ =
        static_cast<std::uint32_t>(std::clamp(wanted, 1024.0, double{most_per_pass}));
    return true;
  }
  return false;
}

Caustics::Yield Caustics::emit(std::uint32_t pass, std::uint32_t count,
                               const Wavelengths& wavelengths, ThreadPool& pool) const {
  const Vec3d origin = origin_of(scene_);
  std::vector<Yield> parts((count + chunk - 1) / chunk);
  pool.parallel_for(parts.size(), 1, [&](IndexRange some) {
    for (std::size_t part = some.begin; part < some.end; ++part) {
      const std::size_t end = std::min<std::size_t>((part + 1) * chunk, count);
      Yield& mine = parts[part];
      for (std::size_t i = part * chunk; i < end; ++i) {
        const std::size_t before = mine.photons.size();
        const auto drawn = tracer_.trace({settings_.seed, pass, static_cast<std::uint32_t>(i)},
                                         wavelengths, origin, mine.photons, mine.counters);
        if (mine.photons.size() > before) mine.useful.push_back(*drawn);
      }
    }
  });
  Yield yield;
  std::size_t size = 0;
  for (const Yield& part : parts) size += part.photons.size();
  yield.photons.reserve(size);
  for (const Yield& part : parts) {
    yield.photons.insert(yield.photons.end(), part.photons.begin(), part.photons.end());
    yield.useful.insert(yield.useful.end(), part.useful.begin(), part.useful.end());
    yield.counters += part.counters;
  }
  yield.counters.photons_left = size;
  return yield;
}

CausticPass Caustics::trace(std::uint32_t pass, const Wavelengths& wavelengths, ThreadPool& pool,
                            Counters& counters) const {
  Yield yield = emit(pass, photons_per_pass_, wavelengths, pool);
  counters += yield.counters;
  const double per_width = first_radius * radius_shrinkage(pass);
  const PhotonMap::Radii radii{widths_.smallest * per_width, widths_.largest * per_width};
  return {&emitter_, PhotonMap(std::move(yield.photons), origin_of(scene_), radii),
          static_cast<double>(photons_per_pass_), per_width};
}

}  // namespace lapidary::transport
