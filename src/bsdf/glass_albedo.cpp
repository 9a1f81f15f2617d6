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
      grain_(grain) {
  const auto by_index = [&](const auto& at) {
    return between(at(index_.index), at(index_.index + 1), index_.fraction);
  };
  average_ = grain_.is_even()
                 ? by_index([&](std::size_t i) {
                     return in_row(glass_average_albedo_table[i], roughness_);
                   })
                 : grain_unit * by_index([&](std::size_t i) {
                     return interpolated(glass_average_grain_table[i], grain_.of_facets().data());
                   });
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

double GlassAlbedo::grained(const Ggx& facets, Vec3d v) const {
  const auto at = grain_.of(facets, v);
  return grain_unit * between(interpolated(glass_grain_table[index_.index], at.data()),
                              interpolated(glass_grain_table[index_.index + 1], at.data()),
                              index_.fraction);
}

}  // namespace lapidary::bsdf
