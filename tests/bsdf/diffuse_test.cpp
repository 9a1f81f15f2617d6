#include <gtest/gtest.h>

#include "bsdf/surfaces.h"
#include "support/random.h"

namespace lapidary::bsdf {
namespace {

using lapidary::test::Random;
using test::direction;

const SampledSpectrum white(1.0f);

// Flux over the half sphere by the midpoint rule, even in both angles: light at grazing angles
// counts as much as it should.
double flux(const Bsdf& bsdf, Vec3d wo, std::size_t wavelength) {
  constexpr int rings = 200, sectors = 120;
  double sum = 0.0;
  for (int i = 0; i < rings; ++i) {
    const double theta = 0.5 * pi * (i + 0.5) / rings;
    for (int j = 0; j < sectors; ++j) {
      const Vec3d wi = direction(std::cos(theta), 2.0 * pi * (j + 0.5) / sectors);
      sum += evaluate(bsdf, wo, wi, Mode::radiance)[wavelength] * std::sin(theta);
    }
  }
  return sum * (0.5 * pi / rings) * (2.0 * pi / sectors);
}

TEST(RoughDiffuse, IsLambertsLawWhenSmooth) {
  const SampledSpectrum color(0.1f, 0.4f, 0.9f, 1.0f);
  const RoughDiffuse bsdf(color, 0.0);
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Vec3d a = abs(random.direction()), b = abs(random.direction());
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(bsdf.evaluate_with_pdf(a, b).f_cos[k], color[k] * b.z * inv_pi, 1e-7);
  }
}

TEST(RoughDiffuse, GivesBackAllOfAWhiteFurnace) {
  for (const double roughness : {0.1, 0.5, 1.0}) {
    for (const double view : {1.0, 0.6, 0.2, 0.02}) {
      const RoughDiffuse bsdf(white, roughness);
      EXPECT_NEAR(flux(bsdf, direction(view), 0), 1.0, 2e-3) << roughness << " from " << view;
    }
  }
}

// Of dark walls only the first bounce is left: its closed form against the integral.
TEST(RoughDiffuse, KnowsTheAlbedoOfASingleBounce) {
  const float dark = 1e-4f;
  for (const double roughness : {0.3, 1.0}) {
    const RoughDiffuse bsdf(SampledSpectrum(dark), roughness);
    double average = 0.0;
    constexpr int views = 10;
    for (int i = 0; i < views; ++i) {
      const double mu = (i + 0.5) / views;
      const double single = flux(bsdf, direction(mu), 0) / dark;
      EXPECT_NEAR(bsdf.single_bounce(mu), single, 2e-3) << roughness << " from " << mu;
      average += 2.0 * mu * single / views;
    }
    EXPECT_NEAR(bsdf.average_single_bounce(), average, 1e-3) << roughness;
  }
}

// Mean over azimuths by the midpoint rule, and of that over the half sphere.
TEST(RoughDiffuse, KnowsItsMeanOverAzimuths) {
  for (const double roughness : {0.0, 0.4, 1.0}) {
    const RoughDiffuse bsdf(white, roughness);
    for (const double mu_o : {0.0, 0.02, 0.3, 0.8, 1.0}) {
      double average = 0.0;
      constexpr int rings = 500, sectors = 200;
      for (int i = 0; i < rings; ++i) {
        const double mu_i = (i + 0.5) / rings;
        const double zonal = bsdf.zonal(RoughDiffuse::zones(mu_o, mu_i));
        average += 2.0 * mu_i * zonal / rings;
        if (i % 25 != 0 || mu_o == 0.0) continue;
        double sum = 0.0;
        for (int j = 0; j < sectors; ++j) {
          const Vec3d wi = direction(mu_i, 2.0 * pi * (j + 0.5) / sectors);
          sum += bsdf.evaluate_with_pdf(direction(mu_o, 0.0), wi).f_cos[0] / mu_i;
        }
        EXPECT_NEAR(zonal, pi * sum / sectors, 5e-4 * zonal) << roughness << " " << mu_o << mu_i;
      }
      EXPECT_NEAR(average, 1.0, 2e-3) << roughness << " from " << mu_o;
    }
  }
}

TEST(RoughDiffuse, IsBrighterTowardsTheLightThanAwayFromIt) {
  const Vec3d wo = direction(0.3, 0.0);
  const auto towards = [&](double phi) {
    return evaluate(RoughDiffuse(white, 1.0), wo, direction(0.3, phi), Mode::radiance)[0];
  };
  EXPECT_GT(towards(0.0), 2.0f * towards(pi));
  EXPECT_NEAR(towards(0.5), towards(-0.5), 1e-6);
}

TEST(RoughDiffuse, StatesItsAlbedo) {
  const RoughDiffuse bsdf({0.2f, 0.5f, 0.8f, 1.0f}, 1.0);
  for (std::size_t k = 0; k < 4; ++k) {
    double average = 0.0;
    constexpr int views = 8;
    for (int i = 0; i < views; ++i) {
      const double mu = (i + 0.5) / views;
      average += 2.0 * mu * flux(bsdf, direction(mu), k) / views;
    }
    EXPECT_NEAR(bsdf.albedo()[k], average, 2e-3);
  }
  EXPECT_NEAR(bsdf.albedo()[3], 1.0, 1e-5);
  EXPECT_GT(bsdf.albedo()[1], 0.45f);
}

// Lafortune & Willems 1994: the lobe about a normal view carries (n + 2) / (2 pi) times the
// integral of cos^(n + 1), which is one.
TEST(Phong, GivesBackItsSharesUnderANormalView) {
  for (const double exponent : {0.0, 1.0, 10.0, 100.0}) {
    const PhongLobes bsdf({0.1f, 0.2f, 0.3f, 0.0f}, {0.5f, 0.4f, 0.0f, 1.0f}, exponent);
    const float expected[] = {0.6f, 0.6f, 0.3f, 1.0f};
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(flux(bsdf, {0, 0, 1}, k), expected[k], 2e-3) << exponent;
  }
}

TEST(Phong, LosesAtGrazingViewsWhatWouldGoBelow) {
  const PhongLobes bsdf({}, white, 50.0);
  EXPECT_NEAR(flux(bsdf, direction(0.7), 0), 0.7, 0.01);
  EXPECT_LT(flux(bsdf, direction(0.02), 0), 0.1);
}

TEST(Phong, TellsItsLobesApart) {
  const PhongLobes bsdf(SampledSpectrum(0.5f), SampledSpectrum(0.5f), 20.0);
  EXPECT_EQ(bsdf.sample({0, 0, 1}, 0.4, {0.3, 0.3})->lobe, Lobe::glossy);
  EXPECT_EQ(bsdf.sample({0, 0, 1}, 0.6, {0.3, 0.3})->lobe, Lobe::diffuse);
}

}  // namespace
}  // namespace lapidary::bsdf
