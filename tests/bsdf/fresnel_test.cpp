#include "bsdf/fresnel.h"

#include <complex>

#include <gtest/gtest.h>

#include "math/constants.h"
#include "support/random.h"

namespace lapidary::bsdf {
namespace {

TEST(Refract, KnowsTextbookValues) {
  EXPECT_NEAR(refract(1.0, 1.5).reflectance, 0.04, 1e-15);
  EXPECT_NEAR(refract(1.0, 1.0 / 1.5).reflectance, 0.04, 1e-15);
  EXPECT_NEAR(refract(1.0, 2.4).reflectance, 0.169550173, 1e-9);
  EXPECT_NEAR(refract(1e-9, 1.5).reflectance, 1.0, 1e-7);
  // 45 degrees onto glass of 1.5: R_s = 0.0920, R_p = R_s^2 (a property of 45 degrees).
  const double s = 0.092013361;
  EXPECT_NEAR(refract(std::cos(radians(45)), 1.5).reflectance, 0.5 * (s + s * s), 1e-8);
}

TEST(Refract, ReflectsHalfOfOnePolarisationAtBrewstersAngle) {
  // There R_p = 0 and R_s = ((1 - n^2) / (1 + n^2))^2.
  for (const double n : {1.1, 1.5, 2.4, 0.7}) {
    const double cosine = 1.0 / std::sqrt(1.0 + n * n);
    const double r = (1.0 - n * n) / (1.0 + n * n);
    EXPECT_NEAR(refract(cosine, n).reflectance, 0.5 * r * r, 1e-14);
  }
}

TEST(Refract, ReflectsTotallyBeyondTheCriticalAngle) {
  const double eta = 1.0 / 1.5;
  const double critical = std::sqrt(1.0 - eta * eta);
  EXPECT_EQ(refract(critical * (1.0 - 1e-9), eta).reflectance, 1.0);
  EXPECT_LT(refract(critical * (1.0 + 1e-6), eta).reflectance, 1.0);
}

TEST(Refract, GivesTheSameReflectanceFromBothSides) {
  test::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double eta = random.uniform(1.0, 3.0), cosine = random.uniform();
    const Refraction out = refract(cosine, eta);
    const Refraction back = refract(out.cos_refracted, 1.0 / eta);
    EXPECT_NEAR(back.reflectance, out.reflectance, 1e-10);
    EXPECT_NEAR(back.cos_refracted, cosine, 1e-7);
  }
}

TEST(Refract, PassesStraightThroughEqualIndices) {
  const Refraction same = refract(0.3, 1.0);
  EXPECT_NEAR(same.reflectance, 0.0, 1e-30);
  EXPECT_NEAR(same.cos_refracted, 0.3, 1e-15);
}

double conductor_by_complex_numbers(std::complex<double> index, double cosine) {
  const double sin2 = 1.0 - cosine * cosine;
  const std::complex<double> refracted = std::sqrt(index * index - sin2);
  const std::complex<double> s = (cosine - refracted) / (cosine + refracted);
  const std::complex<double> p =
      (index * index * cosine - refracted) / (index * index * cosine + refracted);
  return 0.5 * (std::norm(s) + std::norm(p));
}

TEST(ConductorFresnel, AgreesWithComplexArithmetic) {
  test::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const auto n = static_cast<float>(random.uniform(0.04, 4.0));
    const auto k = static_cast<float>(random.uniform(0.0, 9.0));
    const double cosine = random.uniform(0.001, 1.0);
    const float got =
        ConductorFresnel::from_index(SampledSpectrum(n), SampledSpectrum(k)).at(cosine)[2];
    EXPECT_NEAR(got, conductor_by_complex_numbers({n, k}, cosine), 2e-5)
        << n << " " << k << " " << cosine;
    EXPECT_LE(got, 1.00001f);
  }
}

TEST(ConductorFresnel, IsADielectricWithoutAbsorption) {
  const auto fresnel = ConductorFresnel::from_index(SampledSpectrum(1.5f), SampledSpectrum(0.0f));
  for (const double cosine : {1.0, 0.7, 0.2, 0.01})
    EXPECT_NEAR(fresnel.at(cosine)[0], refract(cosine, 1.5).reflectance, 1e-5);
}

TEST(ConductorFresnel, RisesFromNormalToGrazing) {
  const auto fresnel = ConductorFresnel::from_normal_incidence({0.1f, 0.5f, 0.9f, 1.0f});
  EXPECT_EQ(fresnel.at(1.0)[0], 0.1f);
  EXPECT_EQ(fresnel.at(0.0)[0], 1.0f);
  EXPECT_EQ(fresnel.at(0.5)[3], 1.0f);
}

TEST(ConductorFresnel, AveragesOverDirections) {
  const SampledSpectrum n(0.2f, 1.2f, 0.05f, 0.9f), k(3.5f, 2.5f, 4.0f, 6.5f);
  for (const auto& fresnel :
       {ConductorFresnel::from_index(n, k), ConductorFresnel::from_normal_incidence(k * 0.1f)}) {
    SampledSpectrum sum;
    constexpr int points = 1000;
    for (int i = 0; i < points; ++i) {
      const double mu = (i + 0.5) / points;
      sum += fresnel.at(mu) * static_cast<float>(2.0 * mu / points);
    }
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(fresnel.average()[i], sum[i], 0.02);
  }
}

}  // namespace
}  // namespace lapidary::bsdf
