#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "spectrum/rgb.h"

namespace lapidary::image {

/// Pixels of a picture or a texture: linear Rec. 709 unless the one who made it says otherwise.
/// Rows go from top to bottom, pixels from left to right, channels are interleaved.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 3;
  std::vector<float> pixels;  ///< width * height * channels

  Image() = default;
  /// Black.
  Image(int width_, int height_, int channels_ = 3);

  std::span<float> row(int y) { return {pixels.data() + row_offset(y), row_size()}; }
  std::span<const float> row(int y) const { return {pixels.data() + row_offset(y), row_size()}; }
  std::span<float> pixel(int x, int y) {
    return row(y).subspan(static_cast<std::size_t>(x) * channels, channels);
  }
  std::span<const float> pixel(int x, int y) const {
    return row(y).subspan(static_cast<std::size_t>(x) * channels, channels);
  }
  /// Precondition: at least three channels.
  Rgb rgb(int x, int y) const;

  bool operator==(const Image&) const = default;

 private:
  std::size_t row_size() const { return static_cast<std::size_t>(width) * channels; }
  std::size_t row_offset(int y) const { return static_cast<std::size_t>(y) * row_size(); }
};

/// Pixels that have a channel that is NaN or infinite. Readers and writers keep such values as far
/// as the file format can; this is how a caller finds out and tells the user.
std::size_t count_non_finite(const Image& image);

/// How the values of a float channel are stored in a file; in memory they are always float.
/// A finite value that half cannot hold becomes the largest it can, +-65504, not infinity.
enum class Precision { half, full };

/// One channel of a layered image. The name is "layer.component", or the component alone for the
/// beauty: "R", "albedo.R", "normal.X", "depth.Z", "id.object", "variance.R".
struct Channel {
  using Samples = std::variant<std::vector<float>, std::vector<std::uint32_t>>;

  std::string name;
  Samples samples;                        ///< width * height, row by row from the top
  Precision precision = Precision::full;  ///< of float samples; integers are stored in 32 bits

  bool operator==(const Channel&) const = default;
};

/// Something a file says about its picture: scene, samples, seed, render time, version.
/// A number is exact up to 2^53; a larger integer is better written as text.
struct Attribute {
  std::string name;
  std::variant<std::string, double> value;

  bool operator==(const Attribute&) const = default;
};
using Metadata = std::vector<Attribute>;

/// The value as text: a number in the fewest digits that read back as the same number.
std::string to_text(const Attribute& attribute);

/// What a renderer knows of a picture, and what one part of an OpenEXR file holds.
struct LayeredImage {
  int width = 0;
  int height = 0;
  std::vector<Channel> channels;
  Metadata metadata;

  /// The channel of this name, or null.
  const Channel* find(std::string_view name) const;

  bool operator==(const LayeredImage&) const = default;
};

}  // namespace lapidary::image
