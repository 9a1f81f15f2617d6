#pragma once

#include <array>
#include <cstddef>

#include "bsdf/grain_albedo.h"

namespace lapidary::bsdf {

/// Directional albedo of one reflection by GGX facets that absorb nothing, at one roughness: the
/// share of light from direction mu that leaves after a single bounce. The rest bounces again.
/// Accuracy: 0.001 for mu >= 0.05, 0.006 below, by linear interpolation in a table made by
/// tools/ggx_albedo.cpp; with a grain that of grain_albedo.h.
class GgxAlbedo {
 public:
  explicit GgxAlbedo(const Grain& grain);

  /// Of even facets; `mu` in [0, 1], the cosine to the normal.
  double at(double mu) const;
  /// `facets` are those of the grain; v.z in [0, 1].
  double at(const Ggx& facets, Vec3d v) const {
    return is_even_ ? at(v.z) : 1.0 - grained_.at(facets, v);
  }
  double alpha() const { return alpha_; }  ///< of the grain
  /// 1/pi times the integral of at(v) v.z over the half sphere; of even facets within 1e-4.
  double average() const { return average_; }

 private:
  double alpha_;
  std::size_t row_ = 0;
  double fraction_ = 0;  ///< of the way from row_ to the next
  double average_;
  bool is_even_;
  GrainAlbedo grained_;
};

/// Rows follow `roughness_coordinate`, columns `cosine_coordinate`, evenly from 0 to 1.
inline constexpr std::size_t ggx_albedo_size = 32;
using GgxAlbedoTable = std::array<std::array<float, ggx_albedo_size>, ggx_albedo_size>;
extern const GgxAlbedoTable ggx_albedo_table;
extern const std::array<float, ggx_albedo_size> ggx_average_albedo_table;  ///< one per row

}  // namespace lapidary::bsdf
