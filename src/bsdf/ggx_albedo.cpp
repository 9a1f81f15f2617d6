#include "bsdf/ggx_albedo.h"

#include "bsdf/table_lookup.h"

namespace lapidary::bsdf {

GgxAlbedo::GgxAlbedo(const Grain& grain) : alpha_(grain.alpha), grain_(grain) {
  if (!grain.is_even()) {
    average_ = grain_unit * interpolated(ggx_average_grain_table, grain_.of_facets().data());
    return;
  }
  const TablePlace row = table_place(roughness_coordinate(alpha_), ggx_albedo_size);
  row_ = row.index;
  fraction_ = row.fraction;
  average_ = between(ggx_average_albedo_table[row_], ggx_average_albedo_table[row_ + 1], fraction_);
}

double GgxAlbedo::at(double mu) const {
  const TablePlace column = table_place(cosine_coordinate(mu, alpha_), ggx_albedo_size);
  const auto& low = ggx_albedo_table[row_];
  const auto& high = ggx_albedo_table[row_ + 1];
  const std::size_t c = column.index;
  return between(between(low[c], low[c + 1], column.fraction),
                 between(high[c], high[c + 1], column.fraction), fraction_);
}

double GgxAlbedo::grained(const Ggx& facets, Vec3d v) const {
  return grain_unit * interpolated(ggx_grain_table, grain_.of(facets, v).data());
}

}  // namespace lapidary::bsdf
