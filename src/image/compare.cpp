#include "image/compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "base/error.h"
#include "image/flip.h"

namespace lapidary::image {
namespace {

void check_comparable(const Image& image, const Image& reference) {
  if (image.width != reference.width || image.height != reference.height) {
    throw Error({}, fmt::format("the images differ in size: {} x {} and {} x {}", image.width,
                                image.height, reference.width, reference.height));
  }
  if (image.channels < 3 || reference.channels < 3) {
    throw Error({}, "only images of three or more channels can be compared");
  }
  if (image.pixels.empty()) throw Error({}, "images without pixels cannot be compared");
}

void check_crop(const Crop& crop, const Image& image) {
  // Differences, because the sums of hostile numbers may overflow.
  const bool inside = crop.x >= 0 && crop.y >= 0 && crop.width > 0 && crop.height > 0 &&
                      crop.x < image.width && crop.y < image.height &&
                      crop.width <= image.width - crop.x && crop.height <= image.height - crop.y;
  if (inside) return;
  throw Error({.parameter = "crop"},
              fmt::format("the crop {},{},{},{} is not inside the image of {} x {} pixels", crop.x,
                          crop.y, crop.width, crop.height, image.width, image.height),
              "give X,Y,WIDTH,HEIGHT in pixels from the top left corner");
}

double channel_error(Metric metric, double value, double reference) {
  const double difference = value - reference;
  if (metric == Metric::mae) return std::abs(difference);
  if (metric == Metric::mse) return difference * difference;
  const double relative = difference / (std::abs(reference) + 0.01);
  return relative * relative;
}

double energy(const Image& image, const Crop& crop) {
  double sum = 0.0;
  for (int y = crop.y; y < crop.y + crop.height; ++y) {
    for (int x = crop.x; x < crop.x + crop.width; ++x) {
      const Rgb pixel = image.rgb(x, y);
      sum += static_cast<double>(pixel.r) + static_cast<double>(pixel.g) +
             static_cast<double>(pixel.b);
    }
  }
  return sum;
}

float pixel_error(Metric metric, Rgb value, Rgb reference) {
  const double error =
      (channel_error(metric, value.r, reference.r) + channel_error(metric, value.g, reference.g) +
       channel_error(metric, value.b, reference.b)) /
      3;
  return std::isnan(error) ? std::numeric_limits<float>::infinity() : static_cast<float>(error);
}

}  // namespace

std::optional<Metric> metric_of_name(std::string_view name) {
  if (name == "relmse") return Metric::relmse;
  if (name == "mse") return Metric::mse;
  if (name == "mae") return Metric::mae;
  if (name == "energy") return Metric::energy;
  if (name == "flip") return Metric::flip;
  return std::nullopt;
}

std::vector<float> error_map(const Image& image, const Image& reference,
                             const CompareOptions& options) {
  if (options.metric == Metric::energy) {
    throw Error({.parameter = "metric"}, "single pixels have no energy to compare",
                "it is that of a whole picture, or of a crop");
  }
  check_comparable(image, reference);
  const Crop crop = options.crop.value_or(Crop{0, 0, image.width, image.height});
  check_crop(crop, image);
  if (options.metric == Metric::flip) return flip_map(image, reference, crop);
  std::vector<float> errors;
  errors.reserve(static_cast<std::size_t>(crop.width) * crop.height);
  for (int y = crop.y; y < crop.y + crop.height; ++y) {
    for (int x = crop.x; x < crop.x + crop.width; ++x) {
      errors.push_back(pixel_error(options.metric, image.rgb(x, y), reference.rgb(x, y)));
    }
  }
  return errors;
}

double compare(const Image& image, const Image& reference, const CompareOptions& options) {
  if (!(options.trim >= 0 && options.trim < 1)) {
    throw Error({.parameter = "trim"}, fmt::format("{} is not a share to trim", options.trim),
                "0.001 leaves out one pixel in a thousand; it must be at least 0 and less than 1");
  }
  if (options.metric == Metric::energy) {
    check_comparable(image, reference);
    const Crop crop = options.crop.value_or(Crop{0, 0, image.width, image.height});
    check_crop(crop, image);
    const double right = energy(reference, crop);
    if (right == 0.0) throw Error({}, "the reference is black: no energy to compare with");
    return energy(image, crop) / right;
  }
  std::vector<float> errors = error_map(image, reference, options);
  const auto left_out = static_cast<std::size_t>(options.trim * static_cast<double>(errors.size()));
  const std::size_t kept = errors.size() - left_out;
  if (left_out > 0) {
    std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(kept) - 1,
                     errors.end());
  }
  const double sum =
      std::accumulate(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(kept), 0.0);
  return sum / static_cast<double>(kept);
}

}  // namespace lapidary::image
