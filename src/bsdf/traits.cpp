#include <cmath>

#include "bsdf/bsdf.h"

namespace lapidary::bsdf {
namespace {

// How far GGX facets make light forget its angle: of alpha, its square and its square root the one
// that lets white metal under coats and fuzz lose least.
double spread_of(double alpha) {
  return alpha;
}

Traits of(const Diffuse& bsdf) {
  return {bsdf.albedo, 1.0};
}
Traits of(const RoughDiffuse& bsdf) {
  return {bsdf.albedo(), 1.0};
}
Traits of(const Mirror& bsdf) {
  return {bsdf.fresnel.average(), 0.0, true};
}
Traits of(const Conductor& bsdf) {
  return {bsdf.fresnel().average(), spread_of(bsdf.facets().alpha)};
}
Traits of(const PhongLobes& bsdf) {
  const SampledSpectrum all = bsdf.diffuse() + bsdf.specular();
  // The exponent of a lobe as wide as that of GGX facets: alpha^2 = 2 / (n + 2) (Walter et al.
  // 2007, section 5.2), for the mirrored direction instead of the facets' a quarter of the n.
  const double alpha2 = 2.0 / (0.25 * bsdf.exponent() + 2.0);
  const double sharp = all.average() > 0.0f ? bsdf.specular().average() / all.average() : 0.0;
  return {all, std::lerp(1.0, spread_of(std::sqrt(alpha2)), sharp)};
}
Traits of(const Pane&) {
  return {SampledSpectrum(1.0f), 0.0, true, true};
}
Traits of(const SmoothDielectric&) {
  return {SampledSpectrum(1.0f), 0.0, true, true};
}
Traits of(const RoughDielectric&) {
  return {SampledSpectrum(1.0f), 0.0, false, true};
}
Traits of(const Layered& bsdf) {
  return bsdf.traits();
}
Traits of(const Mixture& bsdf) {
  return bsdf.traits();
}
Traits of(const Black&) {
  return {{}, 0.0, true};
}

}  // namespace

Traits traits_of(const Bsdf& bsdf) {
  return std::visit([](const auto& kind) { return of(kind); }, bsdf);
}

}  // namespace lapidary::bsdf
