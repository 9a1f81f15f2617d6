#pragma once

#include <algorithm>
#include <cmath>

#include "math/constants.h"
#include "texture/box_filter.h"

namespace lapidary::texture {

// Functions of one coordinate, as their means over [x - width / 2, x + width / 2].

/// The mean of a function with the antiderivative `integral`; `at` is the function itself.
template <typename Function, typename Integral>
double mean_over(double x, double width, const Function& at, const Integral& integral) {
  if (!(width > narrowest(x))) return at(x);
  return (integral(x + 0.5 * width) - integral(x - 0.5 * width)) / width;
}

/// The part of a coordinate behind the last whole number: 0 to 1, again and again.
inline double mean_saw(double x, double width) {
  // The periodic part of the antiderivative, and the mean, which is 1/2.
  const auto saw = [](double t) { return t - std::floor(t); };
  const auto wave = [&](double t) { return 0.5 * saw(t) * (saw(t) - 1.0); };
  if (!(width > narrowest(x))) return saw(x);
  return 0.5 + (wave(x + 0.5 * width) - wave(x - 0.5 * width)) / width;
}

/// From 0 up to 1 on [0, 1] and down again on [1, 2], again and again.
inline double mean_zigzag(double x, double width) {
  const auto place = [](double t) { return t - 2.0 * std::floor(0.5 * t); };
  const auto zigzag = [&](double t) { return 1.0 - std::abs(place(t) - 1.0); };
  const auto wave = [&](double t) {
    const double s = place(t);
    return s < 1.0 ? 0.5 * (s * s - s) : 0.5 * (s - 1.0) * (2.0 - s);
  };
  if (!(width > narrowest(x))) return zigzag(x);
  return 0.5 + (wave(x + 0.5 * width) - wave(x - 0.5 * width)) / width;
}

/// 0 below 0, 1 above 1, straight between.
inline double mean_step(double x, double width) {
  const auto integral = [](double t) { return t < 0.0 ? 0.0 : t < 1.0 ? 0.5 * t * t : t - 0.5; };
  return mean_over(
      x, width, [](double t) { return std::clamp(t, 0.0, 1.0); }, integral);
}

/// 1 where the coordinate is less than `half` from a whole number, else 0; `half` <= 1/2.
inline double mean_line(double x, double width, double half) {
  const auto within = [&](double t) {
    return std::abs(t - std::floor(t + 0.5)) < half ? 1.0 : 0.0;
  };
  // Without the mean, which is 2 half: so large coordinates keep their digits.
  const auto wave = [&](double t) {
    const double s = t - std::floor(t + 0.5);
    return std::clamp(s, -half, half) - 2.0 * half * s;
  };
  if (!(width > narrowest(x))) return within(x);
  return 2.0 * half + (wave(x + 0.5 * width) - wave(x - 0.5 * width)) / width;
}

/// 1/2 + 1/2 cos(2 pi x).
inline double mean_wave(double x, double width) {
  const double angle = pi * width;
  const double left = angle > 1e-6 ? std::sin(angle) / angle : 1.0;
  return 0.5 + 0.5 * left * std::cos(2.0 * pi * (x - std::floor(x)));
}

}  // namespace lapidary::texture
