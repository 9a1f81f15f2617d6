#include "bsdf/rough_diffuse.h"

#include <algorithm>
#include <cmath>

#include "sampling/warp.h"

namespace lapidary::bsdf {
namespace {

// What the grooves' second term adds to the flux of their first: the directional one over the
// roughness is this, its mean over diffuse light `mean_of_slopes`. Both follow by integration of
// Fujii's formula.
double slopes(double mu) {
  const double sine = std::sqrt(std::max(1.0 - mu * mu, 0.0));
  const double beyond = mu * (1.0 + sine + sine * sine) / (1.0 + sine);  // (1 - sine^3) / mu
  const double g = sine * (std::acos(mu) - sine * mu) + 2.0 / 3.0 * sine * (beyond - 1.0);
  return g * inv_pi;
}
constexpr double mean_of_slopes = 2.0 / 3.0 - 28.0 / 15.0 * inv_pi;

// sin sin cos(phi) over the larger cosine where it is positive: walls that face the viewer are
// lit from there.
double facing(Vec3d wo, Vec3d wi) {
  const double s = wo.x * wi.x + wo.y * wi.y;
  return s > 0.0 ? s / std::max(wo.z, wi.z) : s;
}

}  // namespace

// The series of bounces is that of Conductor, with the walls' colour for Fresnel's share.
RoughDiffuse::RoughDiffuse(SampledSpectrum color, double roughness)
    : color_(color),
      roughness_(roughness),
      flat_(1.0 / (1.0 + (0.5 - 2.0 / 3.0 * inv_pi) * roughness)) {
  const double escaping = average_single_bounce();
  const auto e = static_cast<float>(escaping);
  const SampledSpectrum bounces = color * color * e / (SampledSpectrum(1.0f) - color * (1.0f - e));
  white_later_ = escaping < 1.0 ? 1.0 / (1.0 - escaping) : 0.0;
  later_ = bounces * static_cast<float>(inv_pi * white_later_);
}

// Over the azimuths where walls face the viewer cos(phi) has a mean of 1 / pi of all, over the
// others of minus that.
RoughDiffuse::Zones RoughDiffuse::zones(double mu_o, double mu_i) {
  const double sines = std::sqrt((1.0 - mu_o * mu_o) * (1.0 - mu_i * mu_i));
  return {inv_pi * sines * (1.0 / std::max(mu_o, mu_i) - 1.0), slopes(mu_o), slopes(mu_i)};
}

double RoughDiffuse::single_bounce(double mu) const {
  return flat_ * (1.0 + roughness_ * slopes(mu));
}

double RoughDiffuse::average_single_bounce() const {
  return flat_ * (1.0 + roughness_ * mean_of_slopes);
}

SampledSpectrum RoughDiffuse::albedo() const {
  const double escaping = average_single_bounce();
  return color_ * static_cast<float>(escaping) +
         later_ * static_cast<float>((1.0 - escaping) * (1.0 - escaping) * pi);
}

// Towards grazing views single bounces gather around the way back, by up to 1 / cos more than a
// cosine would find; a uniform quarter sphere bounds the weights.
double RoughDiffuse::share_towards_viewer(Vec3d wo) const {
  return 0.6 * roughness_ * (1.0 - wo.z);
}

BsdfValue RoughDiffuse::evaluate_with_pdf(Vec3d wo, Vec3d wi) const {
  if (!(wo.z > 0.0 && wi.z > 0.0)) return {};
  const double single = flat_ * (1.0 + roughness_ * facing(wo, wi)) * inv_pi * wi.z;
  const double lost = (1.0 - single_bounce(wo.z)) * (1.0 - single_bounce(wi.z));
  const double towards_viewer = wo.x * wi.x + wo.y * wi.y > 0.0 ? inv_pi : 0.0;
  const double share = share_towards_viewer(wo);
  return {color_ * static_cast<float>(single) + later_ * static_cast<float>(lost * wi.z),
          (1.0 - share) * pdf_cosine_hemisphere(wi.z) + share * towards_viewer};
}

std::optional<BsdfSample> RoughDiffuse::sample(Vec3d wo, double u_lobe, Vec2d u) const {
  if (!(wo.z > 0.0)) return {};
  Vec3d wi;
  if (u_lobe < share_towards_viewer(wo)) {
    wi = sample_uniform_hemisphere(u);
    if (wo.x * wi.x + wo.y * wi.y < 0.0) wi = {-wi.x, -wi.y, wi.z};
  } else {
    wi = sample_cosine_hemisphere(u);
  }
  const BsdfValue value = evaluate_with_pdf(wo, wi);
  if (!(value.pdf > 0.0)) return {};
  const auto inverse_pdf = static_cast<float>(1.0 / value.pdf);
  return BsdfSample{wi, value.f_cos * inverse_pdf, value.pdf, Lobe::diffuse};
}

}  // namespace lapidary::bsdf
