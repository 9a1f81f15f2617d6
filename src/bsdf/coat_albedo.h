#pragma once

#include <array>
#include <cstddef>

#include "bsdf/fresnel.h"
#include "bsdf/grain_albedo.h"
#include "bsdf/table_lookup.h"

namespace lapidary::bsdf {

/// Directional albedo of one reflection by the GGX facets of a dielectric, seen from outside: the
/// share of light from direction mu that comes back. The rest enters.
/// Accuracy: 0.003, and 0.006 for mu < 0.1, by linear interpolation in a table made by
/// tools/coat_albedo.cpp; a smooth surface's is exact. With a grain that of grain_albedo.h.
class CoatAlbedo {
 public:
  /// An alpha of 0 is a smooth surface; `eta` >= 1 is the index inside over that outside. Beyond 3
  /// the ratio of rough to smooth is that at 3.
  CoatAlbedo(const Grain& grain, double eta);

  /// Of even facets; `mu` in [0, 1], the cosine to the normal.
  double at(double mu) const;
  /// `facets` are those of the grain; v.z in [0, 1].
  double at(const Ggx& facets, Vec3d v) const {
    return is_even_ ? at(v.z) : refract(v.z, eta_).reflectance * grained_.at(facets, v);
  }
  /// 1/pi times the integral of at(v) v.z over the half sphere.
  double average() const { return average_; }

 private:
  double alpha_, eta_;
  TablePlace index_, roughness_;
  double average_;
  bool is_even_;
  GrainAlbedo grained_;
};

/// From 0 for eta = 1 to 1 for eta = 3, closest around eta = 1.
inline double coat_index_coordinate(double eta) {
  return std::sqrt(2.0 * (eta - 1.0) / (eta + 1.0));
}

/// Albedo over that of a smooth surface, which takes Fresnel's steep rise out of it; evenly spaced
/// in `coat_index_coordinate`, `roughness_coordinate` and `cosine_coordinate`.
inline constexpr std::size_t coat_albedo_indices = 9;
inline constexpr std::size_t coat_albedo_size = 16;
using CoatAlbedoRow = std::array<float, coat_albedo_size>;
extern const std::array<std::array<CoatAlbedoRow, coat_albedo_size>, coat_albedo_indices>
    coat_albedo_table;
/// Averages of the albedo itself, by index and roughness.
extern const std::array<CoatAlbedoRow, coat_albedo_indices> coat_average_albedo_table;

}  // namespace lapidary::bsdf
