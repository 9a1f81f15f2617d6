#include <gtest/gtest.h>

#include "bsdf/surfaces.h"
#include "support/random.h"
#include "support/statistics.h"

namespace lapidary::bsdf {
namespace {

using lapidary::test::Random;
using lapidary::test::RunningMean;
using test::direction;

// A surface in a white furnace: the share of importance that comes back, mean of four wavelengths.
// Importance, because radiance is not conserved across refraction, only radiance over index
// squared. On an additive lattice (Roberts 2018), so that 40000 points leave an error of about
// 1e-3.
double albedo(
    const Bsdf& bsdf, Vec3d wo, int samples = 20000,
    bool (*counts)(const BsdfSample&) = [](const BsdfSample&) { return true; }) {
  const auto coordinate = [](int i, double step) { return std::fmod(0.5 + i * step, 1.0); };
  double sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    const Vec2d u{coordinate(i, 0.8191725133961645), coordinate(i, 0.6710436067037893)};
    const auto s = sample(bsdf, wo, coordinate(i, 0.5497004779019703), u, Mode::importance);
    if (s && counts(*s)) sum += s->weight.average();
  }
  return sum / samples;
}

// Without specular lobes, which have no values.
double albedo_without_specular(const Bsdf& bsdf, Vec3d wo) {
  return albedo(bsdf, wo, 10000, [](const BsdfSample& s) { return s.lobe != Lobe::specular; });
}

// The same from values alone, so that no error of the sampler can hide: uniform directions.
RunningMean albedo_by_values(const Bsdf& bsdf, Vec3d wo, int samples) {
  Random random(8);
  RunningMean mean;
  for (int i = 0; i < samples; ++i) {
    const Vec3d wi = random.direction();
    mean.add(4.0 * pi * evaluate(bsdf, wo, wi, Mode::importance).average());
  }
  return mean;
}

TEST(Energy, NeverGrows) {
  for (const auto& [name, bsdf] : test::rough_surfaces()) {
    if (test::dispersive(bsdf)) continue;  // true only for the mean over which one is the hero
    for (const double view : test::views(bsdf))
      EXPECT_LT(albedo(bsdf, direction(view)), 1.01) << name << " from " << view;
  }
}

TEST(Energy, OfAWhiteFurnaceComesBackFromMetal) {
  for (const double alpha : {0.0009, 0.01, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1.0}) {
    for (const double view : {1.0, 0.9, 0.6, 0.3, 0.1, 0.03})
      EXPECT_NEAR(albedo(test::white_metal(alpha), direction(view)), 1.0, 0.007)
          << alpha << " from " << view;
  }
}

// Each bounce between facets reflects the average share F, and the share E of what is on its way
// escapes: over diffuse light, bounces after the first sum to the series over k > 1 of
// F^k E (1 - E)^(k - 1).
TEST(Energy, OfLaterBouncesDarkensColouredMetal) {
  const double alpha = 0.8;
  const auto fresnel = ConductorFresnel::from_normal_incidence({0.2f, 0.5f, 0.8f, 1.0f});
  const Conductor metal(fresnel, alpha);
  const Ggx facets{alpha};
  Random random(9);
  std::array<RunningMean, 4> later;
  for (int i = 0; i < 100000; ++i) {
    const Vec3d wo = sample_cosine_hemisphere(random.uniform2());
    const double u_lobe = random.uniform();
    const auto s = metal.sample(wo, u_lobe, random.uniform2());
    SampledSpectrum rest;
    if (s) {
      const Vec3d h = normalize(wo + s->wi);
      const double first = facets.density(h) * facets.reflection_share(wo, s->wi) / s->pdf;
      rest = s->weight - fresnel.at(dot(wo, h)) * static_cast<float>(first);
    }
    for (std::size_t k = 0; k < 4; ++k) later[k].add(rest[k]);
  }
  const double escaping = GgxAlbedo(alpha).average();
  for (std::size_t k = 0; k < 4; ++k) {
    const double f = fresnel.average()[k];
    double expected = 0.0, on_the_way = f * (1.0 - escaping);
    for (int bounce = 2; bounce < 100; ++bounce) {
      expected += on_the_way * f * escaping;
      on_the_way *= f * (1.0 - escaping);
    }
    // 4 standard errors, 4 tests: a false-alarm rate of 3e-4.
    EXPECT_NEAR(later[k].mean(), expected, 4.0 * later[k].standard_error() + 5e-4) << k;
  }
}

TEST(Energy, OfAWhiteFurnaceComesBackFromMatteAndMirror) {
  const Bsdf matte = Diffuse{SampledSpectrum(1.0f)};
  const Bsdf mirror = Mirror{ConductorFresnel::from_normal_incidence(SampledSpectrum(1.0f))};
  for (const double view : {1.0, 0.3, 0.01}) {
    EXPECT_NEAR(albedo(matte, direction(view)), 1.0, 1e-6);
    EXPECT_NEAR(albedo(mirror, direction(view)), 1.0, 1e-6);
  }
}

TEST(Energy, OfAWhiteFurnaceComesBackFromSmoothGlass) {
  for (const double view : {1.0, 0.5, 0.1, -0.1, -0.7, -0.745, -0.76, -0.9}) {
    const Vec3d wo = direction(view);
    EXPECT_NEAR(albedo(test::glass(1.5, 0.0), wo), 1.0, 1e-6);
    // Dispersion adds noise, not light: wavelengths change places between paths, so the mean is
    // that of "reflect all, refract the hero", m + 1 - F_0, the same for every sample.
    const auto dispersive = std::get<SmoothDielectric>(test::dispersive_glass(0.0));
    const auto split = dispersive.index.split(std::abs(view), view);
    EXPECT_NEAR(albedo(dispersive, wo), split.reflectance.average() + split.transmittance, 1e-6);
  }
}

TEST(Energy, AgreesBetweenSamplesAndValues) {
  for (const auto& [name, bsdf] : test::rough_surfaces()) {
    if (name.find("0.05") != std::string::npos) continue;  // too narrow for uniform directions
    for (const double view : test::views(bsdf)) {
      const Vec3d wo = direction(view);
      const double a = albedo_without_specular(bsdf, wo);
      const RunningMean b = albedo_by_values(bsdf, wo, 20000);
      // 5 standard errors: 138 tests, a false-alarm rate of 8e-5.
      EXPECT_NEAR(a, b.mean(), 5.0 * b.standard_error() + 3e-3) << name << " " << view;
    }
  }
}

TEST(Reciprocity, HoldsForOpaqueSurfaces) {
  Random random(4);
  for (const auto& [name, bsdf] : test::rough_surfaces()) {
    if (test::transparent(bsdf)) continue;
    for (int i = 0; i < 500; ++i) {
      const Vec3d a = abs(random.direction()), b = abs(random.direction());
      const auto ab = evaluate(bsdf, a, b, Mode::radiance),
                 ba = evaluate(bsdf, b, a, Mode::radiance);
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(ab[k] / b.z, ba[k] / a.z, 1e-5 * ab[k] / b.z + 1e-12) << name;
    }
  }
}

// Veach 1997, equation 5.14: f(wo, wi) / n_o^2 is symmetric for radiance; and the BSDF for
// importance is that for radiance with its directions exchanged.
TEST(Reciprocity, HoldsForGlassWithTheIndexSquared) {
  Random random(5);
  int lit = 0;
  for (const auto& [name, bsdf] : test::rough_surfaces()) {
    if (!std::holds_alternative<RoughDielectric>(bsdf)) continue;
    const RelativeIndex& index = std::get<RoughDielectric>(bsdf).index();
    for (int i = 0; i < 500; ++i) {
      const Vec3d a = random.direction(), b = random.direction();
      const auto ab = evaluate(bsdf, a, b, Mode::radiance) * static_cast<float>(std::abs(a.z));
      const auto ba = evaluate(bsdf, b, a, Mode::radiance) * static_cast<float>(std::abs(b.z));
      const auto adjoint =
          evaluate(bsdf, b, a, Mode::importance) * static_cast<float>(std::abs(b.z));
      const double eta = a.z * b.z < 0.0 ? index.hero(a.z) : 1.0;  // n_b / n_a
      lit += a.z * b.z < 0.0 && ab[0] > 0.0f;
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(ab[k] * eta * eta, ba[k], 1e-5 * ba[k] + 1e-12) << name;
        EXPECT_NEAR(ab[k], adjoint[k], 1e-5 * adjoint[k] + 1e-12) << name;
      }
    }
  }
  EXPECT_GT(lit, 300);
}

TEST(Energy, OfAWhiteFurnaceComesBackFromRoughGlass) {
  for (const double n : {1.2, 1.5, 2.4}) {
    for (const double alpha : {0.0009, 0.05, 0.2, 0.5, 1.0}) {
      for (const double view : {1.0, 0.5, 0.1, -0.1, -0.5, -0.9})
        EXPECT_NEAR(albedo(test::glass(n, alpha), direction(view)), 1.0, 0.01)
            << n << " " << alpha << " from " << view;
    }
  }
}

}  // namespace
}  // namespace lapidary::bsdf
