#include "bsdf/ggx_albedo.h"

#include <algorithm>
#include <cmath>

namespace lapidary::bsdf {
namespace {

struct GridPlace {
  std::size_t index;  // leaves room for the next
  double fraction;
};

GridPlace place(double x) {
  const double scaled = x * (ggx_albedo_size - 1);
  const auto index = std::min(static_cast<std::size_t>(scaled), ggx_albedo_size - 2);
  return {index, scaled - static_cast<double>(index)};
}

double between(double a, double b, double t) {
  return a + (b - a) * t;
}

}  // namespace

GgxAlbedo::GgxAlbedo(double alpha) : alpha_(alpha) {
  const GridPlace row = place(std::sqrt(alpha));
  row_ = row.index;
  fraction_ = row.fraction;
  average_ = between(ggx_average_albedo_table[row_], ggx_average_albedo_table[row_ + 1], fraction_);
}

double GgxAlbedo::at(double mu) const {
  const GridPlace column = place(mu * (1.0 + alpha_) / (mu + alpha_));
  const auto& low = ggx_albedo_table[row_];
  const auto& high = ggx_albedo_table[row_ + 1];
  const std::size_t c = column.index;
  return between(between(low[c], low[c + 1], column.fraction),
                 between(high[c], high[c + 1], column.fraction), fraction_);
}

}  // namespace lapidary::bsdf
