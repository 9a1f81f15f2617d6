#include "image/srgb.h"

#include <cmath>

namespace lapidary::image {

float srgb_from_linear(float linear) {
  if (linear <= 0.0031308f) return 12.92f * linear;
  return 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float linear_from_srgb(float signal) {
  if (signal <= 0.04045f) return signal / 12.92f;
  return std::pow((signal + 0.055f) / 1.055f, 2.4f);
}

}  // namespace lapidary::image
