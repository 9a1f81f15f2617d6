// Pictures that surfaces wear, seen by paths.

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "texture/texture.h"
#include "transport/probe.h"

namespace lapidary::test {
namespace {

/// Tiles with grain.
image::Image tiles() {
  constexpr int size = 512, tile = 32;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> grain(-0.1f, 0.1f);
  image::Image picture(size, size, 1);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      picture.pixel(x, y)[0] = ((x / tile + y / tile) % 2 == 0 ? 0.2f : 0.8f) + grain(random);
    }
  }
  return picture;
}

/// A floor that wears them, 8 units wide.
scene::Scene tiled_floor() {
  const texture::Picture picture{std::make_shared<const texture::Pyramid>(tiles())};
  TinyScene tiny;
  tiny.add(geometry::Sheet(geometry::Rectangle{{-4, 0, 0}, {8, 0, 0}, {0, 8, 0}}),
           material(description::Matte{
               std::make_shared<const texture::Texture>(texture::Texture{picture})}));
  return tiny.build();
}

/// A pixel of an eye above the edge of the floor.
struct Pixel {
  double right = 0, down = 0;  ///< of its middle, as slopes
  double size = 0;

  geometry::Ray ray_at(double x, double y) const {
    return ray({0, -0.5, 0.2}, {right + x * size, 1.0, -down + y * size});
  }
};

/// As far from the middle of a pixel as its filter reaches: in [-1, 1], of `u` in [0, 1].
double tent(double u) {
  return u < 0.5 ? std::sqrt(2.0 * u) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * u);
}

/// What the albedo layer has of a pixel by `side` x `side` samples, each with a cone of a part of
/// it.
double seen(const scene::Scene& scene, const Pixel& pixel, int side, double cone_share) {
  const transport::PathTracer tracer(scene, {.max_depth = 0});
  transport::Counters counters;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  double sum = 0;
  for (int i = 0; i < side * side; ++i) {
    const double x = tent((i % side + uniform(random)) / side);
    const double y = tent((i / side + uniform(random)) / side);
    const PixelSampler points(1, 2, 3, static_cast<std::uint32_t>(i));
    transport::FirstSurface first;
    tracer.radiance(pixel.ray_at(x, y),
                    {Wavelengths::sample(0.5), points, counters, {0.0, cone_share * pixel.size}},
                    first);
    sum += static_cast<double>(first.albedo.g);
  }
  return sum / (side * side);
}

// Over floors seen at grazing angles pixels cover many tiles in one direction and parts of one in
// the other: samples that draw looks from the sizes of the picture see what very many samples see
// of the picture itself.
TEST(Picture, AtGrazingAnglesIsWhatManySamplesOfPointsSee) {
  const scene::Scene scene = tiled_floor();
  double error = 0;
  int pixels = 0;
  for (double down = 0.03; down < 0.25; down += 0.01) {
    for (const double right : {-0.07, 0.013, 0.21}) {
      const Pixel pixel{right, down, 0.006};
      const double reference = seen(scene, pixel, 96, 0.0);
      const double found = seen(scene, pixel, 16, 0.5);
      error += (found - reference) * (found - reference) / (reference * reference);
      ++pixels;
    }
  }
  EXPECT_LT(error / pixels, 3e-4);
}

}  // namespace
}  // namespace lapidary::test
