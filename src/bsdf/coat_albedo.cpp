#include "bsdf/coat_albedo.h"

#include <algorithm>

namespace lapidary::bsdf {
namespace {

// In one row of a table, between two of its entries.
double in_row(const CoatAlbedoRow& row, TablePlace place) {
  return between(row[place.index], row[place.index + 1], place.fraction);
}

}  // namespace

CoatAlbedo::CoatAlbedo(const Grain& grain, double eta)
    : alpha_(grain.alpha),
      eta_(eta),
      index_(table_place(coat_index_coordinate(eta),
                         grain.is_even() ? coat_albedo_indices : coat_grain_indices)),
      roughness_(table_place(roughness_coordinate(alpha_), coat_albedo_size)),
      grain_(grain) {
  const auto by_index = [&](const auto& at) {
    return between(at(index_.index), at(index_.index + 1), index_.fraction);
  };
  average_ = grain_.is_even()
                 ? by_index([&](std::size_t i) {
                     return in_row(coat_average_albedo_table[i], roughness_);
                   })
                 : grain_unit * by_index([&](std::size_t i) {
                     return interpolated(coat_average_grain_table[i], grain_.of_facets().data());
                   });
}

double CoatAlbedo::at(double mu) const {
  const double smooth = refract(mu, eta_).reflectance;
  if (alpha_ == 0.0) return smooth;
  const TablePlace cosine = table_place(cosine_coordinate(mu, alpha_), coat_albedo_size);
  const auto by_roughness = [&](const auto& rows) {
    return between(in_row(rows[roughness_.index], cosine),
                   in_row(rows[roughness_.index + 1], cosine), roughness_.fraction);
  };
  const double ratio = between(by_roughness(coat_albedo_table[index_.index]),
                               by_roughness(coat_albedo_table[index_.index + 1]), index_.fraction);
  return std::min(smooth * ratio, 1.0);
}

double CoatAlbedo::grained(const Ggx& facets, Vec3d v) const {
  const auto at = grain_.of(facets, v);
  const double ratio =
      grain_unit * between(interpolated(coat_grain_table[index_.index], at.data()),
                           interpolated(coat_grain_table[index_.index + 1], at.data()),
                           index_.fraction);
  return std::min(refract(v.z, eta_).reflectance * ratio, 1.0);
}

}  // namespace lapidary::bsdf
