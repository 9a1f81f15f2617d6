#include "image/codecs.h"

#include <algorithm>

#include <fmt/format.h>

#include "spectrum/color.h"

namespace lapidary::image {

Error broken_file(const Source& source, FileFormat format, const std::string& detail) {
  return file_error(source.file, fmt::format("is a broken {} file: {}", name_of(format), detail),
                    "make or copy it again");
}

void check_dimensions(const Source& source, std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0) throw file_error(source.file, "is a picture without pixels");
  // The sides come first, so that their product cannot wrap around.
  if (std::max(width, height) > max_side || width * height > max_pixels) {
    throw file_error(source.file,
                     fmt::format("claims {} x {} pixels, the limit is {} million and {} on a side",
                                 width, height, max_pixels / 1'000'000, max_side),
                     "scale it down, or make or copy it again if it is not that large");
  }
}

Image reserved_image(int width, int height, int channels) {
  Image image;
  image.width = width;
  image.height = height;
  image.channels = channels;
  image.pixels.reserve(static_cast<std::size_t>(width) * height * channels);
  return image;
}

std::vector<float> code_table(int largest, ColorSpace color_space) {
  std::vector<float> table(static_cast<std::size_t>(largest) + 1);
  for (std::size_t code = 0; code < table.size(); ++code) {
    const float signal = static_cast<float>(code) / static_cast<float>(largest);
    table[code] = color_space == ColorSpace::linear ? signal : srgb_decode(signal);
  }
  return table;
}

void encode_row(const RowSource& rows, int y, const Display& display, std::span<float> scratch,
                std::span<std::uint8_t> codes) {
  rows.read(y, scratch);
  for (int x = 0; x < rows.width; ++x) {
    const std::size_t at = static_cast<std::size_t>(x) * 3;
    const Rgb light{scratch[at], scratch[at + 1], scratch[at + 2]};
    const auto code = to_srgb8(light, x, y, display);
    std::copy(code.begin(), code.end(), codes.begin() + static_cast<std::ptrdiff_t>(at));
  }
}

}  // namespace lapidary::image
