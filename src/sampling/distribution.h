#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace lapidary {

/// Chooses an index with probability proportional to its weight.
///
/// By inversion of the cumulative sum, so that well-spread numbers choose well-spread indices. An
/// index of weight 0 is never chosen, unless all weights are 0: then all are equally likely.
/// Probabilities are differences of the stored sums: exactly those that `sample` has.
class DiscreteDistribution {
 public:
  struct Sample {
    std::size_t index = 0;
    double probability = 0.0;
    double remainder = 0.0;  ///< what is left of u, again uniform in [0, 1)
  };

  /// 1 to 2^32 - 1 weights >= 0, their sum finite. Memory: 9 bytes per weight.
  explicit DiscreteDistribution(std::span<const double> weights);

  std::size_t size() const { return cumulative_.size() - 1; }
  double probability(std::size_t index) const {
    return cumulative_[index + 1] - cumulative_[index];
  }
  /// The sum of the weights.
  double total() const { return total_; }

  /// u in [0, 1). Time: constant on average over u, logarithmic at worst.
  Sample sample(double u) const;

 private:
  std::vector<double> cumulative_;  // size() + 1 sums, from 0 to 1
  // The index chosen by the first u of each equal part of [0, 1), and the last index: where to
  // search. Source: Chen & Asau 1974, "On Generating Random Variates from an Empirical
  // Distribution".
  std::vector<std::uint32_t> guide_;
  double total_ = 0.0;
};

/// A density over [0, 1) that is constant on equal pieces.
class PiecewiseConstant1D {
 public:
  struct Sample {
    double x = 0.0;
    double pdf = 0.0;
    std::size_t index = 0;  ///< of the piece that holds x
  };

  /// As DiscreteDistribution.
  explicit PiecewiseConstant1D(std::span<const double> values) : pieces_(values) {}

  std::size_t size() const { return pieces_.size(); }
  /// Mean of the values: the integral over [0, 1).
  double integral() const { return pieces_.total() / static_cast<double>(size()); }

  Sample sample(double u) const;
  /// 0 outside [0, 1).
  double pdf(double x) const;
  /// Of any point in piece `index`.
  double pdf_of_piece(std::size_t index) const {
    return pieces_.probability(index) * static_cast<double>(size());
  }

 private:
  DiscreteDistribution pieces_;
};

/// A density over [0, 1)^2 that is constant on each pixel of a grid, as image environments need.
///
/// A row is chosen first, then a pixel in it. Rows of zeros are never chosen; an image of zeros is
/// uniform. Memory: 9 bytes per pixel.
class PiecewiseConstant2D {
 public:
  struct Sample {
    Vec2d point;
    double pdf = 0.0;
    std::size_t column = 0, row = 0;  ///< the pixel that holds the point
  };

  /// `values` row by row, `width` of them each: at least one pixel, none negative, the sum finite.
  PiecewiseConstant2D(std::span<const double> values, std::size_t width);

  std::size_t width() const { return rows_.front().size(); }
  std::size_t height() const { return rows_.size(); }
  /// Mean of the values: the integral over [0, 1)^2.
  double integral() const { return marginal_.integral() / static_cast<double>(width()); }

  Sample sample(Vec2d u) const;
  /// 0 outside [0, 1)^2.
  double pdf(Vec2d point) const;

 private:
  std::vector<PiecewiseConstant1D> rows_;
  PiecewiseConstant1D marginal_;  // over rows
};

}  // namespace lapidary
