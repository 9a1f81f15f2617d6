#pragma once

#include <array>
#include <cstddef>

#include "bsdf/grain_albedo.h"
#include "bsdf/table_lookup.h"

namespace lapidary::bsdf {

/// Directional albedo of one reflection or refraction at GGX facets of glass, for light that comes
/// from one side: the share that leaves, to either side, after a single bounce.
/// Accuracy: 0.008, and 0.02 where the indices differ by less than 15 %, by linear interpolation in
/// a table made by tools/glass_albedo.cpp; with a grain that of grain_albedo.h.
class GlassAlbedo {
 public:
  /// `eta` is the index beyond the surface over the index on the side the light is on; beyond a
  /// factor of 3 the values of 3 are returned.
  GlassAlbedo(const Grain& grain, double eta);

  /// Of even facets; `mu` in [0, 1], the cosine to the normal.
  double at(double mu) const;
  /// `facets` are those of the grain; v.z in [0, 1].
  double at(const Ggx& facets, Vec3d v) const {
    return is_even_ ? at(v.z) : 1.0 - grained_.at(facets, v);
  }
  /// 1/pi times the integral of at(v) v.z over the half sphere, interpolated likewise.
  double average() const { return average_; }

 private:
  double alpha_;
  TablePlace index_, roughness_;
  double average_;
  bool is_even_;
  GrainAlbedo grained_;
};

/// From 0 for eta = 1/3 to 1 for eta = 3, closest around eta = 1, where a small step matters most.
inline double index_coordinate(double eta) {
  const double r = (eta - 1.0) / (eta + 1.0);
  return 0.5 + 0.5 * std::copysign(std::sqrt(2.0 * std::abs(r)), r);
}

/// Evenly spaced in `index_coordinate`, `roughness_coordinate` and `cosine_coordinate`.
inline constexpr std::size_t glass_albedo_indices = 17;
inline constexpr std::size_t glass_albedo_size = 16;
using GlassAlbedoRow = std::array<float, glass_albedo_size>;
extern const std::array<std::array<GlassAlbedoRow, glass_albedo_size>, glass_albedo_indices>
    glass_albedo_table;
/// Averages by index and roughness.
extern const std::array<GlassAlbedoRow, glass_albedo_indices> glass_average_albedo_table;

}  // namespace lapidary::bsdf
