#pragma once

#include <cstddef>
#include <vector>

#include "math/vec.h"

namespace lapidary {

/// Shape of a pixel's reconstruction filter along one axis, 0 beyond its radius r.
enum class FilterKind {
  box,              ///< constant
  tent,             ///< 1 - |x| / r
  gaussian,         ///< standard deviation r / 3, lowered to reach 0 at r
  blackman_harris,  ///< the 4-term window over [-r, r]. Source: Harris 1978, 92 dB
};

/// Value of the filter of radius 1 at x, not normalised. Negative nowhere.
double evaluate_filter(FilterKind kind, double x);

/// Draws offsets from a pixel's centre with the density of its filter, so that every sample counts
/// with weight 1 and pixels are independent. Source: Ernst et al. 2006, "Filter Importance
/// Sampling".
///
/// The filter of two axes is the product of two of one. Along one axis the density is the filter
/// linearised between 128 knots from its centre to its radius, within 1e-4 of its peak.
class FilterSampler {
 public:
  /// `radius` in pixels, > 0.
  FilterSampler(FilterKind kind, double radius);

  FilterKind kind() const { return kind_; }
  double radius() const { return radius_; }

  /// Offset in pixels, each component in (-radius, radius) or on the edge by rounding; monotone in
  /// u's component. u in [0, 1)^2.
  Vec2d sample(Vec2d u) const { return {sample_1d(u.x), sample_1d(u.y)}; }
  /// Per square pixel.
  double pdf(Vec2d offset) const { return pdf_1d(offset.x) * pdf_1d(offset.y); }

  double sample_1d(double u) const;
  double pdf_1d(double x) const;

 private:
  FilterKind kind_;
  double radius_;
  // Of |x| / radius, at knots i / (knots - 1).
  std::vector<double> density_;
  std::vector<double> cumulative_;
  std::vector<std::size_t> first_;  // where to begin looking, by the leading part of u
};

}  // namespace lapidary
