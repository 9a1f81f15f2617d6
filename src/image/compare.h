#pragma once

#include <optional>
#include <string_view>

#include "image/image.h"

namespace lapidary::image {

/// How far an image is from its reference. All but `flip` look at linear light.
enum class Metric {
  relmse,  ///< (I - R)^2 / (|R| + 0.01)^2, mean of the channels; R is below 0 out of the gamut
  mse,     ///< (I - R)^2, mean of the channels
  mae,     ///< |I - R|, mean of the channels
  energy,  ///< sum of I over that of R, of the first three channels together; 1 is right
  flip,    ///< what an eye sees when the two alternate, in [0, 1] (flip.h)
};

/// The metric called "relmse", "mse", "mae", "energy" or "flip"; empty for any other name.
std::optional<Metric> metric_of_name(std::string_view name);

struct Crop {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

struct CompareOptions {
  Metric metric = Metric::relmse;
  /// Share of the pixels to leave out, in [0, 1): those with the largest error, rounded down to
  /// whole pixels.
  double trim = 0;
  /// Compares only this rectangle, as if the rest did not exist.
  std::optional<Crop> crop;
};

/// The error of each pixel, row by row, of the crop if there is one.
///
/// Only the first three channels count. A pixel that is NaN has infinite error; FLIP, which sees
/// only what a display can show, takes NaN as black and infinity as white. Throws Error if the
/// sizes differ, an image has fewer than three channels, the crop leaves the image, or for
/// `energy`.
std::vector<float> error_map(const Image& image, const Image& reference,
                             const CompareOptions& options);

/// The mean over the pixels of `error_map`, with the worst ones trimmed; of `energy` the ratio of
/// the sums, untrimmed. Throws Error as that does, and if trim is not in [0, 1) or a
/// reference has no energy.
double compare(const Image& image, const Image& reference, const CompareOptions& options);

}  // namespace lapidary::image
