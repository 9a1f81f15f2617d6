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
// squared.
RunningMean albedo(const Bsdf& bsdf, Vec3d wo, int samples) {
  Random random(7);
  RunningMean mean;
  for (int i = 0; i < samples; ++i) {
    // Stratified: the lobes' shares are most of the variance.
    const double u_lobe = (i + random.uniform()) / samples;
    const auto s = sample(bsdf, wo, u_lobe, random.uniform2(), Mode::importance);
    mean.add(s ? s->weight.average() : 0.0);
  }
  return mean;
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
    for (const double view : test::views(bsdf)) {
      const RunningMean mean = albedo(bsdf, direction(view), 20000);
      EXPECT_LT(mean.mean(), 1.0 + 0.006 + 4.0 * mean.standard_error()) << name << " " << view;
    }
  }
}

TEST(Energy, OfAWhiteFurnaceComesBackFromMetal) {
  for (const double alpha : {0.0009, 0.01, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1.0}) {
    for (const double view : {1.0, 0.9, 0.6, 0.3, 0.1, 0.03}) {
      const RunningMean mean = albedo(test::white_metal(alpha), direction(view), 40000);
      // 5 standard errors: 60 tests, a false-alarm rate of 4e-5.
      EXPECT_NEAR(mean.mean(), 1.0, 0.002 + 5.0 * mean.standard_error()) << alpha << " " << view;
      EXPECT_LT(mean.standard_error(), 0.003);
    }
  }
}

TEST(Energy, OfAWhiteFurnaceComesBackFromMatteAndMirror) {
  const Bsdf matte = Diffuse{SampledSpectrum(1.0f)};
  const Bsdf mirror = Mirror{ConductorFresnel::from_normal_incidence(SampledSpectrum(1.0f))};
  for (const double view : {1.0, 0.3, 0.01}) {
    EXPECT_FLOAT_EQ(albedo(matte, direction(view), 10).mean(), 1.0f);
    EXPECT_FLOAT_EQ(albedo(mirror, direction(view), 10).mean(), 1.0f);
  }
}

TEST(Energy, OfAWhiteFurnaceComesBackFromSmoothGlass) {
  for (const double view : {1.0, 0.5, 0.1, -0.1, -0.7, -0.745, -0.76, -0.9}) {
    const Vec3d wo = direction(view);
    EXPECT_NEAR(albedo(test::glass(1.5, 0.0), wo, 1000).mean(), 1.0, 1e-6);
    // Dispersion adds noise, not light: wavelengths change places between paths, so the mean is
    // that of "reflect all, refract the hero", m + 1 - F_0, the same for every sample.
    const auto& dispersive = std::get<SmoothDielectric>(test::dispersive_glass(0.0));
    const auto split = dispersive.index.split(std::abs(view), view);
    EXPECT_NEAR(albedo(dispersive, wo, 1000).mean(),
                split.reflectance.average() + split.transmittance, 1e-6);
  }
}

TEST(Energy, AgreesBetweenSamplesAndValues) {
  for (const auto& [name, bsdf] : test::rough_surfaces()) {
    if (name.find("0.05") != std::string::npos) continue;  // too narrow for uniform directions
    for (const double view : test::views(bsdf)) {
      const Vec3d wo = direction(view);
      const RunningMean a = albedo(bsdf, wo, 20000), b = albedo_by_values(bsdf, wo, 40000);
      // 5 standard errors: 45 tests, a false-alarm rate of 3e-5; skewed, so a little more.
      const double error = std::hypot(a.standard_error(), b.standard_error());
      EXPECT_NEAR(a.mean(), b.mean(), 5.0 * error + 1e-3) << name << " " << view;
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
    const RelativeIndex& index = std::get<RoughDielectric>(bsdf).index;
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
  EXPECT_GT(lit, 500);
}

TEST(Energy, OfRoughGlassIsLostAsStated) {
  for (const double n : {1.33, 1.5, 2.4}) {
    for (const double alpha : {0.01, 0.04, 0.09, 0.16, 0.25, 0.36, 0.5, 0.7, 1.0}) {
      std::printf("%.2f %.3f:", n, alpha);
      for (const double view : {1.0, 0.7, 0.3, 0.1, -0.1, -0.3, -0.7, -1.0})
        std::printf(" %.4f", albedo(test::glass(n, alpha), direction(view), 100000).mean());
      std::printf("\n");
    }
  }
}

}  // namespace
}  // namespace lapidary::bsdf
