#include "sampling/filter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "math/constants.h"

namespace lapidary {
namespace {

constexpr std::size_t pieces = 128;

double blackman_harris(double x) {
  const double t = pi * x;  // the window's middle is at x = 0
  return 0.35875 + 0.48829 * std::cos(t) + 0.14128 * std::cos(2.0 * t) +
         0.01168 * std::cos(3.0 * t);
}

// Where the area of a trapezoid from 0 with end heights `a` and `b` over a width of 1 reaches
// `area`, of at most (a + b) / 2. The stable root of (b - a) / 2 t^2 + a t = area.
double invert_trapezoid(double a, double b, double area) {
  const double root = std::sqrt(std::max(0.0, a * a + 2.0 * (b - a) * area));
  return a + root > 0.0 ? std::min(1.0, 2.0 * area / (a + root)) : 0.0;
}

}  // namespace

double evaluate_filter(FilterKind kind, double x) {
  const double r = std::abs(x);
  if (!(r <= 1.0)) return 0.0;
  switch (kind) {
    case FilterKind::box:
      return 1.0;
    case FilterKind::tent:
      return 1.0 - r;
    case FilterKind::gaussian:
      return std::exp(-4.5 * r * r) - std::exp(-4.5);
    case FilterKind::blackman_harris:
      return blackman_harris(r);
  }
  return 0.0;
}

FilterSampler::FilterSampler(FilterKind kind, double radius) : kind_(kind), radius_(radius) {
  assert(radius > 0.0);
  for (std::size_t i = 0; i <= pieces; ++i)
    density_.push_back(
        std::max(0.0, evaluate_filter(kind, static_cast<double>(i) / static_cast<double>(pieces))));
  cumulative_.push_back(0.0);
  for (std::size_t i = 0; i < pieces; ++i)
    cumulative_.push_back(cumulative_.back() + 0.5 * (density_[i] + density_[i + 1]));
  const double total = cumulative_.back();
  for (double& c : cumulative_) c /= total;
  for (double& d : density_) d /= total;
  for (std::size_t i = 0, piece = 0; i < pieces; ++i) {
    while (cumulative_[piece + 1] <= static_cast<double>(i) / static_cast<double>(pieces)) ++piece;
    first_.push_back(piece);
  }
}

double FilterSampler::sample_1d(double u) const {
  // |2 u - 1| gives the distance, its sign the side: the result stays monotone in u.
  const double signed_mass = 2.0 * u - 1.0;
  const double mass = std::min(std::abs(signed_mass), 1.0 - unit_roundoff);
  std::size_t piece = first_[static_cast<std::size_t>(mass * static_cast<double>(pieces))];
  while (cumulative_[piece + 1] <= mass) ++piece;
  const double t =
      invert_trapezoid(density_[piece], density_[piece + 1], mass - cumulative_[piece]);
  const double distance = (static_cast<double>(piece) + t) / static_cast<double>(pieces);
  return std::copysign(distance * radius_, signed_mass);
}

double FilterSampler::pdf_1d(double x) const {
  const double position = std::abs(x) / radius_ * static_cast<double>(pieces);
  if (!(position <= static_cast<double>(pieces))) return 0.0;
  const std::size_t piece = std::min(static_cast<std::size_t>(position), pieces - 1);
  const double t = position - static_cast<double>(piece);
  const double density = density_[piece] + t * (density_[piece + 1] - density_[piece]);
  // Per piece of one side -> per pixel of both sides.
  return 0.5 * density * static_cast<double>(pieces) / radius_;
}

}  // namespace lapidary
