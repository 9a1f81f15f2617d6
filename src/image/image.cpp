#include "image/image.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace lapidary::image {

Image::Image(int width_, int height_, int channels_)
    : width(width_),
      height(height_),
      channels(channels_),
      pixels(static_cast<std::size_t>(width_) * height_ * channels_) {}

Rgb Image::rgb(int x, int y) const {
  const auto values = pixel(x, y);
  return {values[0], values[1], values[2]};
}

std::size_t count_non_finite(const Image& image) {
  const auto channels = static_cast<std::size_t>(image.channels);
  std::size_t count = 0;
  for (std::size_t at = 0; at < image.pixels.size(); at += channels) {
    const auto first = image.pixels.begin() + static_cast<std::ptrdiff_t>(at);
    count += !std::all_of(first, first + image.channels, [](float v) { return std::isfinite(v); });
  }
  return count;
}

std::string to_text(const Attribute& attribute) {
  if (const auto* text = std::get_if<std::string>(&attribute.value)) return *text;
  return fmt::format("{}", std::get<double>(attribute.value));
}

const Channel* LayeredImage::find(std::string_view name) const {
  const auto found = std::find_if(channels.begin(), channels.end(),
                                  [&](const Channel& channel) { return channel.name == name; });
  return found == channels.end() ? nullptr : &*found;
}

}  // namespace lapidary::image
