#include "bsdf/pane.h"

#include <algorithm>
#include <cmath>

#include "bsdf/fresnel.h"

namespace lapidary::bsdf {

Pane::Pane(const std::array<double, 4>& index, SampledSpectrum color) : index_(index) {
  // Black glass is as dark as floats can say.
  for (std::size_t i = 0; i < 4; ++i)
    optical_depth_.set(i, -std::log(std::clamp(color[i], 1e-30f, 1.0f)));
}

// With r the reflectance of an interface and a what is left after one crossing, the light inside is
// mirrored back and forth in a geometric series of ratio r^2 a^2.
Pane::Shares Pane::shares(double mu) const {
  Shares shares;
  for (std::size_t i = 0; i < 4; ++i) {
    const Refraction interface = refract(mu, index_[i]);
    const double r = interface.reflectance, t = 1.0 - r;
    const double a =
        interface.cos_refracted > 0.0
            ? std::exp(-static_cast<double>(optical_depth_[i]) / interface.cos_refracted)
            : 0.0;
    // At grazing angles, where r is 1, nothing gets in.
    const double inside = t > 0.0 ? t * t * a / (1.0 - r * r * a * a) : 0.0;
    shares.reflected.set(i, static_cast<float>(r + inside * r * a));
    shares.transmitted.set(i, static_cast<float>(inside));
  }
  return shares;
}

SampledSpectrum Pane::straight_through(Vec3d wo) const {
  return wo.z == 0.0 ? SampledSpectrum() : shares(std::min(std::abs(wo.z), 1.0)).transmitted;
}

std::optional<BsdfSample> Pane::sample(Vec3d wo, double u_lobe) const {
  if (wo.z == 0.0) return {};
  const Shares s = shares(std::min(std::abs(wo.z), 1.0));
  const double r = s.reflected.average(), t = s.transmitted.average();
  const double q = r / (r + t);
  if (u_lobe < q) {
    return BsdfSample{
        {-wo.x, -wo.y, wo.z}, s.reflected * static_cast<float>(1.0 / q), 0.0, Lobe::specular};
  }
  return BsdfSample{-wo, s.transmitted * static_cast<float>(1.0 / (1.0 - q)), 0.0, Lobe::specular,
                    Side::straight};
}

}  // namespace lapidary::bsdf
