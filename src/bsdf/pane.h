#pragma once

#include <array>
#include <optional>

#include "bsdf/scattering.h"

namespace lapidary::bsdf {

/// A pane of glass as one surface: two parallel polished interfaces and what is between them. Light
/// goes straight through or is mirrored, each with the sum of all reflections inside; both are
/// specular. The same from both sides, and the same medium on both.
class Pane {
 public:
  /// `index` >= 1 relative to the medium around; `color` in [0, 1] is what the pane's thickness
  /// leaves of light that crosses it once along the normal, without the losses at the interfaces.
  Pane(const std::array<double, 4>& index, SampledSpectrum color);

  struct Shares {
    SampledSpectrum reflected, transmitted;
  };
  /// `mu` in [0, 1], the cosine to the normal. A clear pane's add up to one.
  Shares shares(double mu) const;

  /// What goes on to -wo.
  SampledSpectrum straight_through(Vec3d wo) const;
  std::optional<BsdfSample> sample(Vec3d wo, double u_lobe) const;

 private:
  std::array<double, 4> index_;
  SampledSpectrum optical_depth_;  ///< along the normal
};

inline BsdfValue evaluate_with_pdf(const Pane&, Vec3d, Vec3d, Mode) {
  return {};
}

inline std::optional<BsdfSample> sample(const Pane& bsdf, Vec3d wo, double u_lobe, Vec2d, Mode) {
  return bsdf.sample(wo, u_lobe);
}

}  // namespace lapidary::bsdf
