#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"
#include "math/vec.h"
#include "spectrum/rgb.h"
#include "texture/texels.h"
#include "texture/uv_footprint.h"

namespace lapidary::texture {

/// What is beside a picture: itself again, its mirror image, its edge drawn out, or nothing.
enum class Wrap : std::uint8_t { repeat, mirror, clamp, black };

/// A picture in all sizes, each half the one before down to a single pixel, to average it over any
/// footprint in a few looks. It covers the unit square; (0, 0) is its lower left corner.
///
/// Each size averages linear light exactly, whole pixels or not, so that all have the same mean.
///
/// Memory: 4/3 of the picture's own, with 1 byte for a value when all are 8-bit codes of sRGB or of
/// a linear scale, else 2; one channel where all are equal.
class Pyramid {
 public:
  /// Precondition: one channel or three, at least one pixel, all finite.
  explicit Pyramid(const image::Image& picture);

  /// The mean over the footprint of the picture and of what is beside it.
  ///
  /// Accuracy: the spread of what is averaged is that of the footprint, the shape is not quite; on
  /// photographs the error is below 2 % of the exact mean, on white noise about as large as the
  /// noise that is left. What spreads less than straight lines between pixels do is seen like
  /// those. Precondition: finite numbers.
  ///
  /// Source: Williams 1983, "Pyramidal Parametrics"; uv_footprint.h.
  Rgb mean(const UvFootprint& footprint, Wrap wrap, Filter filter) const;

  /// One look somewhere in the footprint at the size of its width; where and at which pixel is
  /// drawn by the last digits of `uv`. Over many places that differ a little it has the mean of
  /// `mean`, about.
  Rgb draw(const UvFootprint& footprint, Wrap wrap, Filter filter) const;

  /// One look at the size whose pixels are nearest to the footprint in area. Has the mean of
  /// `mean` where the footprint moves over the whole picture.
  Rgb glance(const UvFootprint& footprint, Wrap wrap, Filter filter) const;

  int width() const { return levels_.front().width; }
  int height() const { return levels_.front().height; }
  int channels() const { return channels_; }
  std::size_t level_count() const { return levels_.size(); }
  std::size_t bytes() const;

 private:
  /// One size. Its pixels lie in squares, row by row in each and of these: neighbours above and
  /// below are near in memory, too. Squares that it does not fill have room left over.
  struct Level {
    static constexpr std::size_t side = 8;  ///< of a square
    static constexpr std::size_t area = side * side;

    int width = 0;
    int height = 0;
    std::size_t first = 0;  ///< its upper left pixel in `texels_`

    std::size_t squares_across() const { return squares(width); }
    /// How many pixels there is room for.
    std::size_t room() const { return squares_across() * squares(height) * area; }
    /// Where the pixels of a column and of a row are; their sum is where a pixel is in `texels_`.
    std::size_t column(int x) const {
      const auto i = static_cast<std::size_t>(x);
      return first + i / side * area + i % side;
    }
    std::size_t row(int y) const {
      const auto j = static_cast<std::size_t>(y);
      return j / side * area * squares_across() + j % side * side;
    }

   private:
    static std::size_t squares(int size) {
      return (static_cast<std::size_t>(size) + side - 1) / side;
    }
  };

  static std::vector<Level> levels_of(const image::Image& picture);
  void append(const image::Image& picture, const Level& level);

  template <typename Fetch>
  friend class PyramidSampler;

  std::vector<Level> levels_;
  int channels_;
  Texels texels_;
};

}  // namespace lapidary::texture
