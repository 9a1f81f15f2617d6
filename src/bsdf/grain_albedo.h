#pragma once

#include <array>
#include <cstdint>

#include "bsdf/grain_directions.h"

namespace lapidary::bsdf {

/// What facet_albedo.h knows of facets with a grain, by linear interpolation in tables: fast enough
/// to be asked for several times at every surface, and with averages.
///
/// There are too many tables to store, or to make beforehand. Each, of the facets of one grain and
/// index, is made when it is first asked for, in a millisecond, and kept: four for a metal, sixteen
/// for glass, and more where textures vary the grain. Threads that ask at once make the same table;
/// one of them is kept, and none waits for another.
///
/// Accuracy for roughnesses from 0.03 to 1 and indices from 1.2 to 2.4, for 99 % of directions and
/// at the worst: of metal 0.006 and 0.01, of a coat 0.004 and 0.01, of glass 0.007 and 0.013.
class GrainAlbedo {
 public:
  /// What part of light: `loss_of_white_facets`, `reflected_by_facets` over what a smooth surface
  /// reflects, or `loss_of_facets`.
  enum class Part { lost_by_metal, reflected_by_coat, lost_by_glass };

  /// Of even facets, of which nothing may be asked.
  GrainAlbedo() = default;
  /// `eta` as for facet_albedo.h, 1 for metal; indices beyond a factor of 3 have the values of 3.
  GrainAlbedo(Part part, const Grain& grain, double eta);

  /// `facets` are those of the grain; v.z in [0, 1].
  double at(const Ggx& facets, Vec3d v) const;
  /// 1/pi times the integral of the part times v.z over the half sphere; of what a coat reflects
  /// without regard to smooth ones.
  double average() const { return average_; }

  class Tables;

 private:
  const Tables* tables_ = nullptr;
  std::array<std::uint16_t, 3> cell_{};  ///< index, roughness, anisotropy of the tables before
  std::array<float, 3> fraction_{};      ///< of the way to the next
  GrainDirections directions_;
  double average_ = 0;
};

}  // namespace lapidary::bsdf
