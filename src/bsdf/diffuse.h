#pragma once

#include <optional>

#include "bsdf/scattering.h"
#include "sampling/warp.h"

namespace lapidary::bsdf {

/// Lambert's law: f = albedo / pi.
struct Diffuse {
  SampledSpectrum albedo;
};

inline BsdfValue evaluate_with_pdf(const Diffuse& bsdf, Vec3d wo, Vec3d wi, Mode) {
  if (!(wo.z > 0.0 && wi.z > 0.0)) return {};
  const double pdf = pdf_cosine_hemisphere(wi.z);
  return {bsdf.albedo * static_cast<float>(pdf), pdf};
}

inline std::optional<BsdfSample> sample(const Diffuse& bsdf, Vec3d wo, double, Vec2d u, Mode) {
  if (!(wo.z > 0.0)) return {};
  const Vec3d wi = sample_cosine_hemisphere(u);
  return BsdfSample{wi, bsdf.albedo, pdf_cosine_hemisphere(wi.z), Lobe::diffuse};
}

}  // namespace lapidary::bsdf
