#include "sampling/distribution.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace lapidary {
namespace {

// The largest double below 1.
constexpr double below_one = 1.0 - 0x1p-53;

// The part of [0, 1) that holds x, of `count` equal ones.
std::size_t part_of(double x, std::size_t count) {
  return std::min(static_cast<std::size_t>(x * static_cast<double>(count)), count - 1);
}

// The point at `offset` in [0, 1) of piece `index`. Rounding may carry it over the edge, where
// `pdf` would see another piece, so it is brought back.
double point_in_piece(std::size_t index, double offset, std::size_t count) {
  double x = (static_cast<double>(index) + offset) / static_cast<double>(count);
  x = std::min(x, below_one);
  while (part_of(x, count) < index) x = std::nextafter(x, 1.0);
  while (part_of(x, count) > index) x = std::nextafter(x, 0.0);
  return x;
}

// A power of two of parts, so that u * parts is exact and no u falls into a wrong part.
std::vector<std::uint32_t> guide_of(const std::vector<double>& cumulative) {
  const std::size_t parts = std::bit_ceil((cumulative.size() + 6) / 8);
  std::vector<std::uint32_t> guide;
  guide.reserve(parts + 1);
  std::uint32_t index = 0;
  for (std::size_t part = 0; part < parts; ++part) {
    while (cumulative[index + 1] <= static_cast<double>(part) / static_cast<double>(parts)) ++index;
    guide.push_back(index);
  }
  guide.push_back(static_cast<std::uint32_t>(cumulative.size() - 2));
  return guide;
}

bool in_unit_interval(double x) {
  return x >= 0.0 && x < 1.0;
}

std::vector<PiecewiseConstant1D> rows_of(std::span<const double> values, std::size_t width) {
  assert(width > 0 && !values.empty() && values.size() % width == 0);
  std::vector<PiecewiseConstant1D> rows;
  rows.reserve(values.size() / width);
  for (std::size_t begin = 0; begin < values.size(); begin += width)
    rows.emplace_back(values.subspan(begin, width));
  return rows;
}

std::vector<double> sums_of(std::span<const double> values, std::size_t width) {
  std::vector<double> sums;
  sums.reserve(values.size() / width);
  for (std::size_t begin = 0; begin < values.size(); begin += width) {
    double sum = 0.0;
    for (const double value : values.subspan(begin, width)) sum += value;
    sums.push_back(sum);
  }
  return sums;
}

}  // namespace

DiscreteDistribution::DiscreteDistribution(std::span<const double> weights) {
  assert(!weights.empty());
  cumulative_.reserve(weights.size() + 1);
  cumulative_.push_back(0.0);
  for (const double weight : weights) {
    assert(weight >= 0.0);
    cumulative_.push_back(cumulative_.back() + weight);
  }
  total_ = cumulative_.back();
  assert(std::isfinite(total_));
  if (total_ > 0.0) {
    for (double& sum : cumulative_) sum /= total_;
  } else {
    const auto count = static_cast<double>(weights.size());
    for (std::size_t i = 0; i < cumulative_.size(); ++i)
      cumulative_[i] = static_cast<double>(i) / count;
  }
  guide_ = guide_of(cumulative_);
}

DiscreteDistribution::Sample DiscreteDistribution::sample(double u) const {
  // The first sum above u ends the piece; u < 1 and the last sum is 1, so there is one, and its
  // piece is not empty. The guide says between which pieces to look.
  const std::size_t part = part_of(u, guide_.size() - 1);
  const auto first = cumulative_.begin() + guide_[part] + 1;
  const auto last = cumulative_.begin() + guide_[part + 1] + 1;
  const auto end = std::upper_bound(first, last, u);
  const auto index = static_cast<std::size_t>(end - cumulative_.begin()) - 1;
  const double low = cumulative_[index];
  const double p = cumulative_[index + 1] - low;
  return {index, p, std::min((u - low) / p, below_one)};
}

PiecewiseConstant1D::Sample PiecewiseConstant1D::sample(double u) const {
  const DiscreteDistribution::Sample piece = pieces_.sample(u);
  return {point_in_piece(piece.index, piece.remainder, size()),
          piece.probability * static_cast<double>(size()), piece.index};
}

double PiecewiseConstant1D::pdf(double x) const {
  return in_unit_interval(x) ? pdf_of_piece(part_of(x, size())) : 0.0;
}

PiecewiseConstant2D::PiecewiseConstant2D(std::span<const double> values, std::size_t width)
    : rows_(rows_of(values, width)), marginal_(sums_of(values, width)) {}

PiecewiseConstant2D::Sample PiecewiseConstant2D::sample(Vec2d u) const {
  const PiecewiseConstant1D::Sample row = marginal_.sample(u.y);
  const PiecewiseConstant1D::Sample column = rows_[row.index].sample(u.x);
  return {{column.x, row.x}, row.pdf * column.pdf, column.index, row.index};
}

double PiecewiseConstant2D::pdf(Vec2d point) const {
  if (!in_unit_interval(point.x) || !in_unit_interval(point.y)) return 0.0;
  const std::size_t row = part_of(point.y, height());
  return marginal_.pdf_of_piece(row) * rows_[row].pdf(point.x);
}

}  // namespace lapidary
