#include "bsdf/phong_lobes.h"

#include <algorithm>
#include <cmath>

#include "math/frame.h"
#include "sampling/warp.h"

namespace lapidary::bsdf {

PhongLobes::PhongLobes(SampledSpectrum diffuse, SampledSpectrum specular, double exponent)
    : diffuse_(diffuse), specular_(specular), exponent_(exponent) {
  const double d = diffuse.average(), s = specular.average();
  chance_specular_ = d + s > 0.0 ? s / (d + s) : 0.0;
}

BsdfValue PhongLobes::evaluate_with_pdf(Vec3d wo, Vec3d wi) const {
  if (!(wo.z > 0.0 && wi.z > 0.0)) return {};
  const double cosine = std::min(wo.z * wi.z - wo.x * wi.x - wo.y * wi.y, 1.0);
  const double lobe = cosine > 0.0 ? 0.5 * inv_pi * std::pow(cosine, exponent_) : 0.0;
  const double even = pdf_cosine_hemisphere(wi.z);
  return {diffuse_ * static_cast<float>(even) +
              specular_ * static_cast<float>((exponent_ + 2.0) * lobe * wi.z),
          (1.0 - chance_specular_) * even + chance_specular_ * (exponent_ + 1.0) * lobe};
}

std::optional<BsdfSample> PhongLobes::sample(Vec3d wo, double u_lobe, Vec2d u) const {
  if (!(wo.z > 0.0)) return {};
  const bool specular = u_lobe < chance_specular_;
  Vec3d wi = sample_cosine_hemisphere(u);
  if (specular) {
    // cos^(n + 1) of the angle is uniform.
    const DiskPoint disk = concentric_disk(u);
    const double log_share = std::log(std::max(1.0 - disk.radius_squared, 0x1p-64));
    const double cosine = std::exp(log_share / (exponent_ + 1.0));
    const double sine2 = -std::expm1(2.0 * log_share / (exponent_ + 1.0));
    const double stretch = disk.radius_squared > 0.0 ? std::sqrt(sine2 / disk.radius_squared) : 0.0;
    const Frame mirrored = Frame::from_normal({-wo.x, -wo.y, wo.z});
    wi = normalize(
        mirrored.to_world({stretch * disk.position.x, stretch * disk.position.y, cosine}));
  }
  const BsdfValue value = evaluate_with_pdf(wo, wi);
  if (!(value.pdf > 0.0)) return {};
  return BsdfSample{wi, value.f_cos * static_cast<float>(1.0 / value.pdf), value.pdf,
                    specular ? Lobe::glossy : Lobe::diffuse};
}

}  // namespace lapidary::bsdf
