// Writes a picture of 4096 x 4096 pixels, tiles with grain, and prints its mean as "#rrggbb":
// write_picture FILE SEED.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include <fmt/core.h>

#include "image/image_io.h"
#include "spectrum/color.h"

namespace {

using lapidary::Rgb;
using lapidary::image::Image;

constexpr int side = 4096;
constexpr int tile = 256;

Image tiles(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  const Rgb light{uniform(random), uniform(random), uniform(random)};
  Image picture(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const float shade = (x / tile + y / tile) % 2 == 0 ? 0.5f : 0.3f;
      const float grain = 0.6f + 0.8f * uniform(random);
      const auto pixel = picture.pixel(x, y);
      pixel[0] = shade * grain * (0.5f + light.r);
      pixel[1] = shade * grain * (0.5f + light.g);
      pixel[2] = shade * grain * (0.5f + light.b);
    }
  }
  return picture;
}

int mean_code(const Image& picture, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = channel; i < picture.pixels.size(); i += 3) {
    sum += std::fmin(picture.pixels[i], 1.0f);
  }
  const auto mean = static_cast<float>(sum / (1.0 * side * side));
  return static_cast<int>(std::lround(255 * lapidary::srgb_encode(mean)));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: write_picture FILE SEED\n", stderr);
    return 2;
  }
  const Image picture = tiles(static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)));
  lapidary::image::write_image(argv[1], picture);
  fmt::print("#{:02x}{:02x}{:02x}\n", mean_code(picture, 0), mean_code(picture, 1),
             mean_code(picture, 2));
}
