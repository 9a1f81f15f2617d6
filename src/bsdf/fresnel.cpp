#include "bsdf/fresnel.h"

namespace lapidary::bsdf {
namespace {

using Vector = SampledSpectrum::Vector;

Vector square_root(Vector v) {
  for (int i = 0; i < 4; ++i) v[i] = std::sqrt(v[i]);
  return v;
}

}  // namespace

ConductorFresnel ConductorFresnel::from_index(SampledSpectrum n, SampledSpectrum k) {
  return {Form::index, n, k};
}

ConductorFresnel ConductorFresnel::from_normal_incidence(SampledSpectrum reflectance) {
  return {Form::normal_incidence, reflectance, SampledSpectrum()};
}

ConductorFresnel ConductorFresnel::from_edge_tint(SampledSpectrum reflectance,
                                                  SampledSpectrum tint) {
  constexpr float cosine = 1.0f / 7.0f, m = 1.0f - cosine, m6 = m * m * m * m * m * m;
  const SampledSpectrum plain = from_normal_incidence(reflectance).schlick(cosine);
  const SampledSpectrum dip = plain * (SampledSpectrum(1.0f) - tint) / (cosine * m6);
  return {Form::normal_incidence, reflectance, dip};
}

// With a + i b = sqrt((n + i k)^2 - sin^2), the refracted wave's normal component: Fresnel's
// equations (Born & Wolf 1999, chapter 14) written without complex numbers. 2 a^2 = |a + i b|^2 +
// (n^2 - k^2 - sin^2).
SampledSpectrum ConductorFresnel::exact(float cosine) const {
  const float cos2 = cosine * cosine, sin2 = 1.0f - cos2;
  const Vector n2 = a_.vector() * a_.vector(), k2 = b_.vector() * b_.vector();
  const Vector real = n2 - k2 - sin2;
  const Vector norm = square_root(real * real + 4.0f * n2 * k2);
  Vector a2 = 0.5f * (norm + real);
  for (int i = 0; i < 4; ++i) a2[i] = std::max(a2[i], 0.0f);
  const Vector s_even = norm + cos2, s_odd = 2.0f * cosine * square_root(a2);
  const Vector p_even = cos2 * norm + sin2 * sin2, p_odd = s_odd * sin2;
  const Vector s = (s_even - s_odd) / (s_even + s_odd);
  // Parallel to the surface both even parts are the whole: p is s times one.
  const Vector p = s * (p_even - p_odd) / (p_even + p_odd);
  return SampledSpectrum(0.5f * (s + p));
}

SampledSpectrum ConductorFresnel::average() const {
  const bool index = form_ == Form::index;
  const SampledSpectrum f0 = index ? exact(1.0f) : a_, dip = index ? SampledSpectrum() : b_;
  return f0 + (SampledSpectrum(1.0f) - f0) * (1.0f / 21.0f) - dip * (1.0f / 126.0f);
}

}  // namespace lapidary::bsdf
