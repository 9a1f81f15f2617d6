#include "bsdf/glass_albedo.h"

namespace lapidary::bsdf {
namespace {

// In one row of a table, between two of its entries.
double in_row(const GlassAlbedoRow& row, TablePlace place) {
  return between(row[place.index], row[place.index + 1], place.fraction);
}

}  // namespace

GlassAlbedo::GlassAlbedo(const Grain& grain, double eta)
    : alpha_(grain.alpha),
      index_(table_place(index_coordinate(eta), glass_albedo_indices)),
      roughness_(table_place(roughness_coordinate(alpha_), glass_albedo_size)),
      is_even_(grain.is_even()) {
  if (is_even_) {
    average_ =
        between(in_row(glass_average_albedo_table[index_.index], roughness_),
                in_row(glass_average_albedo_table[index_.index + 1], roughness_), index_.fraction);
  } else {
    grained_ = GrainAlbedo(GrainAlbedo::Part::lost_by_glass, grain, eta);
    average_ = 1.0 - grained_.average();
  }
}

double GlassAlbedo::at(double mu) const {
  const TablePlace cosine = table_place(cosine_coordinate(mu, alpha_), glass_albedo_size);
  const auto by_roughness = [&](const auto& rows) {
    return between(in_row(rows[roughness_.index], cosine),
                   in_row(rows[roughness_.index + 1], cosine), roughness_.fraction);
  };
  return between(by_roughness(glass_albedo_table[index_.index]),
                 by_roughness(glass_albedo_table[index_.index + 1]), index_.fraction);
}

}  // namespace lapidary::bsdf
