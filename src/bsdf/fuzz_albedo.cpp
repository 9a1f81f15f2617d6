#include "bsdf/fuzz_albedo.h"

#include "bsdf/table_lookup.h"

namespace lapidary::bsdf {

FuzzAlbedo::FuzzAlbedo(double tilt) : tilt_(tilt) {
  const TablePlace row =
      table_place((tilt - smallest_tilt) / (1.0 - smallest_tilt), fuzz_albedo_size);
  row_ = row.index;
  fraction_ = row.fraction;
  average_ =
      between(fuzz_average_albedo_table[row_], fuzz_average_albedo_table[row_ + 1], fraction_);
}

double FuzzAlbedo::at(double mu) const {
  const TablePlace column = table_place(cosine_coordinate(mu, tilt_), fuzz_albedo_size);
  const auto& low = fuzz_albedo_table[row_];
  const auto& high = fuzz_albedo_table[row_ + 1];
  const std::size_t c = column.index;
  return between(between(low[c], low[c + 1], column.fraction),
                 between(high[c], high[c + 1], column.fraction), fraction_);
}

}  // namespace lapidary::bsdf
