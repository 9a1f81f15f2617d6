#pragma once

#include <array>
#include <cstddef>

namespace lapidary::bsdf {

/// Directional albedo of one reflection by GGX facets that absorb nothing, at one roughness: the
/// share of light from direction mu that leaves after a single bounce. The rest bounces again.
/// Accuracy: 0.001 for mu >= 0.05, 0.006 below, by linear interpolation in a table made by
/// tools/ggx_albedo.cpp.
class GgxAlbedo {
 public:
  /// `alpha` in (0, 1].
  explicit GgxAlbedo(double alpha);

  /// `mu` in [0, 1], the cosine to the normal.
  double at(double mu) const;
  /// 2 times the integral of at(mu) mu over mu, within 1e-4.
  double average() const { return average_; }

 private:
  double alpha_;
  std::size_t row_ = 0;
  double fraction_ = 0;  ///< of the way from row_ to the next
  double average_;
};

/// Rows follow `roughness_coordinate`, columns `cosine_coordinate`, evenly from 0 to 1.
inline constexpr std::size_t ggx_albedo_size = 32;
using GgxAlbedoTable = std::array<std::array<float, ggx_albedo_size>, ggx_albedo_size>;
extern const GgxAlbedoTable ggx_albedo_table;
extern const std::array<float, ggx_albedo_size> ggx_average_albedo_table;  ///< one per row

}  // namespace lapidary::bsdf
