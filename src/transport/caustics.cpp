#include "transport/caustics.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace lapidary::transport {
namespace {

/// Radius for diffused photons over that for focused ones: there are few of them, and what they
/// show is smooth but for contact shadows, which must not be lost.
constexpr double diffused_radius = 4.0;
/// Photons of a pass for each pixel: bounds of what is best.
constexpr double fewest_per_pixel = 0.125;
constexpr double most_per_pixel = 2.0;
/// The mean, over the first 64 passes, of the inverse of the squares that radii have shrunk by.
constexpr double mean_inverse_shrinkage = 3.0;
constexpr double most_emitted = 1 << 24;
/// Photons that a pass leaves, which stay in memory for a block of passes: 64 bytes each.
constexpr double most_left = 1 << 22;
/// Photons of the first phase.
constexpr std::uint32_t fewest_to_learn_from = 1u << 12;
constexpr std::uint32_t most_to_learn_from = 1u << 16;
/// Photons traced together by one thread.
constexpr std::size_t chunk = 1024;
/// Numbers of passes that no render gets to, for the first phase.
constexpr std::uint32_t probing_pass = 0xffffff00u;
/// Side, in pixels, of the small picture that a first phase looks at, and the samples of each.
constexpr std::size_t small_side = 64;
constexpr std::uint32_t small_samples = 4;
/// As PhotonSettings::first_radius, in its pixels.
constexpr double small_radius = 1.5;
/// Of the mean radiance of a picture, the error that nobody minds where it is dark.
constexpr double tolerated_share = 0.1;

const Heroes& probing_wavelengths() {
  static const Heroes wavelengths = every_hero(Wavelengths::sample(0.5));
  return wavelengths;
}

Vec3d origin_of(const scene::Scene& scene) {
  const Box3d box = scene.world().bounds();
  return box.empty() ? Vec3d() : box.center();
}

/// A path into the small picture, the `number`-th at its pixel `index`, and what it needs.
class SmallSample {
 public:
  SmallSample(const Caustics::Settings& settings, std::size_t index, std::uint32_t number)
      : settings_(settings),
        x_(static_cast<std::uint32_t>(index % small_side)),
        y_(static_cast<std::uint32_t>(index / small_side)),
        wavelengths_(probing_wavelengths()[number % SampledSpectrum::size]),
        points_(settings.seed, x_, y_, probing_pass + number) {}

  std::optional<geometry::Ray> ray(const camera::Camera& camera) const {
    const Block8 u = points_.block(0);
    const Vec2d film{(x_ + u[0]) / small_side, (y_ + u[1]) / small_side};
    return camera::generate_ray(camera, {film, {u[2], u[3]}, u[4]});
  }
  /// Widths are those of the picture's own pixels.
  SampleContext context(const camera::Camera& camera, Counters& counters) const {
    const Vec2d size{static_cast<double>(settings_.width), static_cast<double>(settings_.height)};
    return {wavelengths_, points_, counters, camera::pixel_cone(camera, size)};
  }

 private:
  const Caustics::Settings& settings_;
  std::uint32_t x_, y_;
  const Wavelengths& wavelengths_;
  PixelSampler points_;
};

double trimmed_mean(std::vector<double>& values) {
  constexpr double share_left_out = 0.02;
  std::sort(values.begin(), values.end());
  const auto kept =
      static_cast<std::size_t>((1.0 - share_left_out) * static_cast<double>(values.size()));
  double sum = 0.0;
  for (std::size_t i = 0; i < kept; ++i) sum += values[i];
  return kept > 0 ? sum / static_cast<double>(kept) : 0.0;
}

}  // namespace

/// A picture of few pixels, with what each gathered.
struct Caustics::SmallPicture {
  struct Pixel {
    double radiance = 0;                   ///< the mean of its wavelengths
    double variance_of_paths = 0;          ///< of a sample, photons left out
    std::vector<GatheredPhoton> gathered;  ///< by all of its samples
  };
  std::vector<Pixel> pixels;
  double cost = 0;  ///< rays of a sample

  static Pixel render(const Caustics& caustics, const PathTracer& tracer, const CausticPass& pass,
                      std::size_t index, Counters& counters);

  double mean_radiance() const {
    double sum = 0.0;
    for (const Pixel& pixel : pixels) sum += pixel.radiance;
    return sum / static_cast<double>(pixels.size());
  }
};

double radius_shrinkage(std::uint32_t passes) {
  double squared = 1.0;
  for (std::uint32_t k = 1; k <= passes; ++k) squared *= (k + 2.0 / 3.0) / (k + 1.0);
  return std::sqrt(squared);
}

Caustics::Caustics(const scene::Scene& scene, const Settings& settings, ThreadPool& pool)
    : scene_(scene),
      settings_(settings),
      emitter_(scene, settings.photons.aim),
      tracer_(scene, emitter_, settings.max_depth) {
  state_ = prepare(pool);
}

Caustics::State Caustics::prepare(ThreadPool& pool) {
  if (settings_.method != CausticMethod::automatic && settings_.method != CausticMethod::photons) {
    return State::not_wanted;
  }
  if (scene_.casters().empty()) return State::no_caster;
  if (!emitter_.is_useful()) return State::no_light;
  if (!measure_widths(pool)) return State::not_seen;
  return learn(pool) ? State::active : State::nothing_arrives;
}

bool Caustics::measure_widths(ThreadPool& pool) {
  const PathTracer tracer(scene_, {settings_.max_depth, Interreflection::full, CausticMethod::off});
  std::vector<double> found(small_side * small_side);
  pool.parallel_for(small_side, 1, [&](IndexRange rows) {
    Counters counters;
    for (std::size_t i = rows.begin * small_side; i < rows.end * small_side; ++i) {
      const SmallSample sample(settings_, i, 0);
      const auto ray = sample.ray(scene_.camera());
      if (!ray) continue;
      const auto place = tracer.first_wide(*ray, sample.context(scene_.camera(), counters));
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

Caustics::SmallPicture::Pixel Caustics::SmallPicture::render(const Caustics& caustics,
                                                             const PathTracer& tracer,
                                                             const CausticPass& pass,
                                                             std::size_t index,
                                                             Counters& counters) {
  Pixel pixel;
  double sum = 0.0, squares = 0.0;
  for (std::uint32_t i = 0; i < small_samples; ++i) {
    const SmallSample sample(caustics.settings_, index, i);
    const auto ray = sample.ray(caustics.scene_.camera());
    if (!ray) continue;
    SampleContext context = sample.context(caustics.scene_.camera(), counters);
    context.caustics = &pass;
    context.gathered = &pixel.gathered;
    const std::size_t before = pixel.gathered.size();
    FirstSurface first;
    const double radiance = tracer.radiance(*ray, context, first).average();
    if (!std::isfinite(radiance)) {
      pixel.gathered.resize(before);
      continue;
    }
    double of_path = radiance;
    for (std::size_t g = before; g < pixel.gathered.size(); ++g) {
      of_path -= pixel.gathered[g].radiance;
    }
    pixel.radiance += radiance / small_samples;
    sum += of_path;
    squares += of_path * of_path;
  }
  pixel.variance_of_paths =
      std::max(0.0, squares - sum * sum / small_samples) / (small_samples - 1);
  return pixel;
}

Caustics::SmallPicture Caustics::render_small(const CausticPass& pass, ThreadPool& pool) const {
  const PathTracer tracer(scene_, {settings_.max_depth, Interreflection::full, settings_.method});
  SmallPicture picture;
  picture.pixels.resize(small_side * small_side);
  std::array<std::uint64_t, small_side> rays{};
  pool.parallel_for(small_side, 1, [&](IndexRange rows) {
    for (std::size_t row = rows.begin; row < rows.end; ++row) {
      Counters counters;
      for (std::size_t i = row * small_side; i < (row + 1) * small_side; ++i) {
        picture.pixels[i] = SmallPicture::render(*this, tracer, pass, i, counters);
      }
      rays[row] = counters.nearest_queries + counters.occlusion_queries;
    }
  });
  for (const std::uint64_t some : rays) picture.cost += static_cast<double>(some);
  picture.cost /= small_side * small_side * small_samples;
  return picture;
}

Caustics::Judgement Caustics::judge(Yield yield, std::uint32_t count, ThreadPool& pool) const {
  const std::vector<Useful> useful = std::move(yield.useful);
  Judgement judgement;
  judgement.cost_of_photons = static_cast<double>(yield.counters.nearest_queries) / count;
  judgement.left = static_cast<double>(yield.photons.size()) / count;
  const double pixels = double(settings_.width) * double(settings_.height);
  const CausticPass pass =
      pass_of(std::move(yield), count, small_radius * std::sqrt(pixels) / small_side);
  const SmallPicture picture = render_small(pass, pool);

  const double tolerated = tolerated_share * picture.mean_radiance();
  std::vector<double> worth(count);
  std::vector<double> of_paths, of_photons;
  for (const SmallPicture::Pixel& pixel : picture.pixels) {
    const double scale = 1.0 / (pixel.radiance + tolerated);
    if (!std::isfinite(scale)) continue;
    double photons = 0.0;
    for (const GatheredPhoton& given : pixel.gathered) {
      const double share = given.radiance * scale;
      worth[given.number] += share * share;
      photons += share * share / small_samples;
    }
    of_paths.push_back(pixel.variance_of_paths * scale * scale);
    of_photons.push_back(photons);
  }
  judgement.variance_of_paths = trimmed_mean(of_paths);
  const double first_radius = settings_.photons.first_radius;
  const double widths = small_radius * small_radius / (first_radius * first_radius);
  judgement.variance_of_photons =
      trimmed_mean(of_photons) * widths * count / static_cast<double>(picture.pixels.size());
  judgement.cost_of_paths = picture.cost;
  for (const auto& [number, origin] : useful) judgement.lessons.push_back({origin, worth[number]});
  return judgement;
}

bool Caustics::learn(ThreadPool& pool) {
  const Heroes& wavelengths = probing_wavelengths();
  std::uint32_t pass = probing_pass;
  const double pixels = double(settings_.width) * double(settings_.height);
  // Of the order of a pass, and no more than a grid can learn from.
  std::uint32_t count = std::bit_ceil(static_cast<std::uint32_t>(
      std::clamp(pixels, double{fewest_to_learn_from}, double{most_to_learn_from})));
  for (int tries = 0; tries < 3; ++tries, count *= 4) {
    const Yield yield = emit(pass++, count, wavelengths, pool);
    if (yield.useful.empty()) continue;
    if (settings_.photons.aim != Aim::nowhere) {
      // First where there is anything to be had at all, and then what it is worth.
      std::vector<PhotonEmitter::Lesson> any;
      for (const Useful& useful : yield.useful) any.push_back({useful.origin, 1.0});
      emitter_.learn(any, count);
      emitter_.learn(judge(emit(pass++, count, wavelengths, pool), count, pool).lessons, count);
    }
    // What it has learned decides how many photons are emitted.
    choose_number(judge(emit(pass++, count, wavelengths, pool), count, pool));
    return true;
  }
  return false;
}

// Of n photons a pixel the cost of a pass is proportional to c + n d, and its error to v + w / n:
// their product is least at n^2 = c w / (d v).
void Caustics::choose_number(const Judgement& judgement) {
  const double pixels = double(settings_.width) * double(settings_.height);
  const double photons = judgement.variance_of_photons * mean_inverse_shrinkage;
  const double paths = judgement.variance_of_paths;
  const double relative_cost = judgement.cost_of_photons / judgement.cost_of_paths;
  const double squared = photons / (relative_cost * paths);
  // Where nothing is left of either, more photons do no harm.
  const double wanted = std::isnan(squared) ? most_per_pixel : std::sqrt(squared);
  const double per_pixel = std::clamp(wanted, fewest_per_pixel, most_per_pixel);
  most_per_pass_ = std::clamp(most_left / judgement.left, 1024.0, double{most_emitted});
  photons_per_pass_ = std::clamp(per_pixel * pixels, 1024.0, most_per_pass_);
  const double error = photons / per_pixel;
  share_ = {per_pixel * relative_cost, error > 0.0 ? error / (error + paths) : 0.0};
}

Caustics::Yield Caustics::emit(std::uint32_t pass, std::uint32_t count, const Heroes& wavelengths,
                               ThreadPool& pool) const {
  const Vec3d origin = origin_of(scene_);
  std::vector<Yield> parts((count + chunk - 1) / chunk);
  pool.parallel_for(parts.size(), 1, [&](IndexRange some) {
    for (std::size_t part = some.begin; part < some.end; ++part) {
      const std::size_t end = std::min<std::size_t>((part + 1) * chunk, count);
      Yield& mine = parts[part];
      for (std::size_t i = part * chunk; i < end; ++i) {
        const std::size_t before = mine.photons.size();
        const auto number = static_cast<std::uint32_t>(i);
        const Wavelengths& led = wavelengths[number % SampledSpectrum::size];
        const auto drawn =
            tracer_.trace({settings_.seed, pass, number}, led, origin, mine.photons, mine.counters);
        if (mine.photons.size() > before) mine.useful.push_back({number, *drawn});
      }
    }
  });
  Yield yield;
  const auto join = [&](std::vector<Photon> Photons::*alike) {
    std::size_t size = 0;
    for (const Yield& part : parts) size += (part.photons.*alike).size();
    std::vector<Photon>& all = yield.photons.*alike;
    all.reserve(size);
    for (const Yield& part : parts) {
      all.insert(all.end(), (part.photons.*alike).begin(), (part.photons.*alike).end());
    }
  };
  join(&Photons::focused);
  join(&Photons::diffused);
  for (const Yield& part : parts) {
    yield.useful.insert(yield.useful.end(), part.useful.begin(), part.useful.end());
    yield.counters += part.counters;
  }
  yield.counters.photons_left = yield.photons.size();
  return yield;
}

CausticPass Caustics::pass_of(Yield yield, std::uint32_t count, double radius_per_width) const {
  const auto layer = [&](std::vector<Photon> photons, double radius) {
    const PhotonMap::Radii radii{widths_.smallest * radius, widths_.largest * radius};
    return CausticLayer{PhotonMap(std::move(photons), origin_of(scene_), radii), radius};
  };
  return {&emitter_, static_cast<double>(count),
          layer(std::move(yield.photons.focused), radius_per_width),
          layer(std::move(yield.photons.diffused), diffused_radius * radius_per_width)};
}

CausticPass Caustics::trace(const Pass& pass, const Heroes& wavelengths, ThreadPool& pool,
                            Counters& counters) const {
  const auto count =
      static_cast<std::uint32_t>(std::min(pass.photons * photons_per_pass_, most_per_pass_));
  Yield yield = emit(pass.index, count, wavelengths, pool);
  counters += yield.counters;
  const double shrinkage = radius_shrinkage(static_cast<std::uint32_t>(pass.photons_before));
  return pass_of(std::move(yield), count, settings_.photons.first_radius * shrinkage);
}

}  // namespace lapidary::transport
