#pragma once

#include <array>
#include <cstddef>

namespace lapidary::bsdf {

/// Directional albedo of `Fibers` that absorb nothing: the share of light from direction mu that
/// comes back after a single scattering. The rest goes on to what lies below.
/// Accuracy: 0.001, by linear interpolation in a table made by tools/fuzz_albedo.cpp.
class FuzzAlbedo {
 public:
  /// `tilt` in [smallest_tilt, 1].
  explicit FuzzAlbedo(double tilt);

  /// `mu` in [0, 1], the cosine to the normal.
  double at(double mu) const;
  /// 2 times the integral of at(mu) mu over mu.
  double average() const { return average_; }

 private:
  double tilt_;
  std::size_t row_ = 0;
  double fraction_ = 0;  ///< of the way from row_ to the next
  double average_;
};

/// Fibres that stand up any straighter glow within a few degrees of the silhouette only.
inline constexpr double smallest_tilt = 0.1;

/// Rows follow the tilt, evenly from `smallest_tilt` to 1, columns `cosine_coordinate`.
inline constexpr std::size_t fuzz_albedo_size = 24;
using FuzzAlbedoTable = std::array<std::array<float, fuzz_albedo_size>, fuzz_albedo_size>;
extern const FuzzAlbedoTable fuzz_albedo_table;
extern const std::array<float, fuzz_albedo_size> fuzz_average_albedo_table;  ///< one per row

}  // namespace lapidary::bsdf
