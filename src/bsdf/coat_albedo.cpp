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
      index_(table_place(coat_index_coordinate(eta), coat_albedo_indices)),
      roughness_(table_place(roughness_coordinate(alpha_), coat_albedo_size)),
      is_even_(grain.is_even()) {
  if (is_even_) {
    average_ =
        between(in_row(coat_average_albedo_table[index_.index], roughness_),
                in_row(coat_average_albedo_table[index_.index + 1], roughness_), index_.fraction);
  } else {
    grained_ = GrainAlbedo(GrainAlbedo::Part::reflected_by_coat, grain, eta);
    average_ = grained_.average();
  }
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

}  // namespace lapidary::bsdf
