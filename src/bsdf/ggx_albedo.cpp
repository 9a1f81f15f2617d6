#include "bsdf/ggx_albedo.h"

#include <algorithm>
#include <cmath>

#include "bsdf/table_lookup.h"

namespace lapidary::bsdf {
namespace {

// What even facets lose on average falls as alpha^2 (a - b log alpha) as they become smooth:
// between rows the factor of alpha^2 is a straight line, and one over log alpha near the first.
double average_loss(double roughness) {
  const auto factor = [](std::size_t row) {
    const double r = static_cast<double>(row) / (ggx_albedo_size - 1);
    return (1.0 - static_cast<double>(ggx_average_albedo_table[row])) / (r * r * r * r);
  };
  // Smooth facets, of row 0, lose nothing, which says nothing of the factor.
  const std::size_t row = std::max<std::size_t>(table_place(roughness, ggx_albedo_size).index, 1);
  const double low = static_cast<double>(row) / (ggx_albedo_size - 1);
  const double high = static_cast<double>(row + 1) / (ggx_albedo_size - 1);
  const double t = row == 1 ? std::log(roughness / low) / std::log(high / low)
                            : (roughness - low) / (high - low);
  const double alpha2 = roughness * roughness * roughness * roughness;
  return alpha2 * between(factor(row), factor(row + 1), t);
}

}  // namespace

GgxAlbedo::GgxAlbedo(const Grain& grain) : alpha_(grain.alpha), is_even_(grain.is_even()) {
  const double roughness = roughness_coordinate(alpha_);
  const TablePlace row = table_place(roughness, ggx_albedo_size);
  row_ = row.index;
  fraction_ = row.fraction;
  if (is_even_) {
    average_ = 1.0 - average_loss(roughness);
  } else {
    grained_ = GrainAlbedo(GrainAlbedo::Part::lost_by_metal, grain, 1.0);
    average_ = 1.0 - grained_.average();
  }
}

double GgxAlbedo::at(double mu) const {
  const TablePlace column = table_place(cosine_coordinate(mu, alpha_), ggx_albedo_size);
  const auto& low = ggx_albedo_table[row_];
  const auto& high = ggx_albedo_table[row_ + 1];
  const std::size_t c = column.index;
  return between(between(low[c], low[c + 1], column.fraction),
                 between(high[c], high[c + 1], column.fraction), fraction_);
}

}  // namespace lapidary::bsdf
