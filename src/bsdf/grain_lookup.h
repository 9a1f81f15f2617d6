#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "bsdf/ggx.h"
#include "bsdf/table_lookup.h"

namespace lapidary::bsdf {

/// Shares of light by roughness, anisotropy, azimuth and cosine, as `GrainCoordinates` has them.
/// Unit: `grain_unit`.
template <std::size_t Roughnesses, std::size_t Anisotropies, std::size_t Azimuths,
          std::size_t Cosines>
using GrainTable =
    std::array<std::array<std::array<std::array<std::uint16_t, Cosines>, Azimuths>, Anisotropies>,
               Roughnesses>;
/// Averages over all directions.
template <std::size_t Roughnesses, std::size_t Anisotropies>
using GrainAverages = std::array<std::array<std::uint16_t, Anisotropies>, Roughnesses>;
inline constexpr double grain_unit = 1e-4;

/// Where facets that have a grain stand in tables, each coordinate in [0, 1]: roughness as for even
/// facets; anisotropy closer the higher it is; the angle from the rougher direction; the cosine as
/// for even facets of that roughness.
class GrainCoordinates {
 public:
  /// Of even facets, which are common, nothing but that they are.
  explicit GrainCoordinates(const Grain& grain) : is_even_(grain.is_even()) {
    if (is_even_) return;
    alpha_ = grain.alpha;
    roughness_ = roughness_coordinate(grain.alpha);
    anisotropy_ = anisotropy_coordinate(grain.anisotropy);
    narrow2_ = grain.narrow() * grain.narrow();
    range2_ = grain.wide() * grain.wide() - narrow2_;
  }

  bool is_even() const { return is_even_; }
  std::array<double, 2> of_facets() const { return {roughness_, anisotropy_}; }
  /// With a direction; v.z in [0, 1].
  std::array<double, 4> of(const Ggx& facets, Vec3d v) const {
    const double sin2 = v.x * v.x + v.y * v.y;
    const double alpha2 = sin2 > 0.0 ? facets.stretched_sin2(v) / sin2 : narrow2_;
    const double along2 = range2_ > 0.0 ? std::clamp((alpha2 - narrow2_) / range2_, 0.0, 1.0) : 0.0;
    return {roughness_, anisotropy_, 2.0 * inv_pi * std::acos(std::sqrt(along2)),
            cosine_coordinate(v.z, alpha_)};
  }

  static double anisotropy_coordinate(double anisotropy) {
    return 1.0 - std::sqrt(1.0 - std::min(anisotropy / (1.0 - Grain::least_ratio), 1.0));
  }

 private:
  double alpha_ = 0, roughness_ = 0, anisotropy_ = 0;
  double narrow2_ = 0, range2_ = 0;  ///< squares of alpha: the least, and what the most has more
  bool is_even_;
};

/// What a table has at `x`, one coordinate for each of its dimensions, linear in each of them.
template <typename Entry>
double interpolated(const Entry& entry, const double* x) {
  if constexpr (std::is_arithmetic_v<Entry>) {
    return entry;
  } else {
    const TablePlace place = table_place(*x, entry.size());
    return between(interpolated(entry[place.index], x + 1),
                   interpolated(entry[place.index + 1], x + 1), place.fraction);
  }
}

}  // namespace lapidary::bsdf
