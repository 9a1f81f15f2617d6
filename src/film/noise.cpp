#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "film/film.h"

namespace lapidary::film {
namespace {

constexpr double worst_share = 0.001;

double relative(float variance, float mean) {
  const double reference = std::abs(static_cast<double>(mean)) + dark;
  return static_cast<double>(variance) / (reference * reference);
}

/// Of what is left without the worst.
double trimmed_mean(std::vector<double> values) {
  const double count = static_cast<double>(values.size());
  const auto kept = values.size() - static_cast<std::size_t>(worst_share * count);
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(kept);
  if (end != values.end()) std::nth_element(values.begin(), end, values.end());
  double sum = 0.0;
  for (auto value = values.begin(); value != end; ++value) sum += *value;
  return sum / static_cast<double>(kept);
}

}  // namespace

double Film::noise() const {
  if (state_.blocks < 2) return std::numeric_limits<double>::infinity();
  std::vector<double> errors;
  errors.reserve(state_.samples.size());
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) {
      const Rgb m = beauty(x, y), v = variance(x, y);
      errors.push_back((relative(v.r, m.r) + relative(v.g, m.g) + relative(v.b, m.b)) / 3.0);
    }
  }
  return std::sqrt(trimmed_mean(std::move(errors)));
}

}  // namespace lapidary::film
