// What it costs to look at a texture.

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "report.h"
#include "texture/texture.h"

namespace lapidary::texture {
namespace {

constexpr int size = 4096;

/// As large as pictures are, of 8-bit colours.
image::Image picture() {
  image::Image p(size, size, 3);
  std::mt19937 random(1);
  const ByteScale& scale = ByteScale::srgb();
  for (float& v : p.pixels) v = scale.value(static_cast<std::uint8_t>(random() >> 24));
  return p;
}

/// Where rays of a picture meet a surface: neighbours near each other, as tiles of pixels are, with
/// bounces to anywhere in between. The footprint is `pixels` wide and `ratio` times as long.
std::vector<Lookup> lookups(double pixels, double ratio) {
  std::vector<Lookup> all(1 << 16);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  const double step = pixels / size;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Lookup& l = all[i];
    const auto tile = static_cast<double>(i / 256);
    const bool bounce = i % 4 == 3;
    const double x =
        bounce ? uniform(random) : std::fmod(tile * 0.37, 1.0) + uniform(random) * 16 * step;
    const double y =
        bounce ? uniform(random) : std::fmod(tile * 0.73, 1.0) + uniform(random) * 16 * step;
    const double angle = 0.3 + 0.001 * tile;
    l.uv = {x, y};
    l.duvdx = Vec2d{std::cos(angle), std::sin(angle)} * (step * ratio);
    l.duvdy = Vec2d{-std::sin(angle), std::cos(angle)} * step;
    l.p = {8 * x, 8 * y, 0.3};
    l.normal = {0, 0, 1};
    l.dpdx = {8 * l.duvdx.x, 8 * l.duvdx.y, 0};
    l.dpdy = {8 * l.duvdy.x, 8 * l.duvdy.y, 0};
  }
  return all;
}

void measure(std::string_view key, const Texture::Kind& kind, const std::vector<Lookup>& where,
             std::string_view target = "-") {
  const Color color(std::make_shared<const Texture>(kind));
  const Wavelengths w = Wavelengths::sample(0.3);
  SampledSpectrum sum;
  const double seconds = bench::best_cpu_seconds(5, [&] {
    for (const Lookup& lookup : where) {
      lookup.shown = {};  // or all but the first run would ask for what is known
      sum += color.at(lookup, w);
    }
  });
  bench::report(key, seconds * 1e9 / static_cast<double>(where.size()),
                sum.is_finite() ? "ns" : "-", target);
}

void measure_all() {
  const image::Image p = picture();
  std::shared_ptr<const Pyramid> pyramid;
  const double seconds = bench::cpu_seconds([&] { pyramid = std::make_shared<const Pyramid>(p); });
  bench::report("texture.build_4096", seconds, "s");
  bench::report("texture.memory_4096", static_cast<double>(pyramid->bytes()) / (1 << 20), "MB",
                "<=65");
  const Picture whole{pyramid};
  measure("texture.image_point", whole, lookups(0, 1));
  measure("texture.image_trilinear", whole, lookups(3, 1), "<=150");
  measure("texture.image_anisotropic_4", whole, lookups(3, 4), "<=500");
  measure("texture.image_anisotropic_16", whole, lookups(3, 16));
  measure("texture.checker", Checker{}, lookups(3, 1));
  measure("texture.noise", Clouds{}, lookups(3, 1), "<=100");
  measure("texture.fbm_6", Clouds{{}, {.count = 6}}, lookups(3, 1), "<=500");
  measure("texture.marble", Marble{}, lookups(3, 1));
  measure("texture.wood", Wood{}, lookups(3, 1));
  measure("texture.voronoi", Voronoi{}, lookups(3, 1));
}

}  // namespace
}  // namespace lapidary::texture

int main() {
  lapidary::texture::measure_all();
}
