#pragma once

#include <optional>

#include "bsdf/ggx.h"
#include "bsdf/smooth_dielectric.h"

namespace lapidary::bsdf {

/// The rough boundary of two transparent media: GGX facets that reflect and refract. Where the
/// index disperses, refraction belongs to the hero wavelength: in values as in samples.
///
/// Light that would meet more than one facet is lost: at most 2 % up to alpha = 0.09 (roughness
/// 0.3) off grazing, 8 % up to 0.16, a third and more from 0.5 on.
/// Source: Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces".
struct RoughDielectric {
  RelativeIndex index;
  Ggx facets;
};

BsdfValue evaluate_with_pdf(const RoughDielectric& bsdf, Vec3d wo, Vec3d wi, Mode mode);

std::optional<BsdfSample> sample(const RoughDielectric& bsdf, Vec3d wo, double u_lobe, Vec2d u,
                                 Mode mode);

}  // namespace lapidary::bsdf
