#include <gtest/gtest.h>

#include "bsdf/surfaces.h"
#include "spectrum/refractive_index.h"
#include "support/random.h"

namespace lapidary::bsdf {
namespace {

using lapidary::test::Random;
using test::direction;

// Large enough never to reflect at a smooth surface that refracts at all.
constexpr double refract_always = 1.0 - 0x1p-53;

TEST(SmoothGlass, FollowsSnellFromBothSides) {
  Random random(1);
  const Bsdf bsdf = test::glass(1.5, 0.0);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d wo = random.direction();
    const auto s = sample(bsdf, wo, refract_always, {}, Mode::radiance);
    ASSERT_TRUE(s);
    const double eta = wo.z > 0.0 ? 1.5 : 1.0 / 1.5;
    const double sine = std::hypot(wo.x, wo.y);
    if (sine > eta) {
      EXPECT_EQ(s->side, Side::reflected);
      EXPECT_FLOAT_EQ(s->weight[0], 1.0f);
      continue;
    }
    EXPECT_EQ(s->side, Side::transmitted);
    EXPECT_EQ(s->relative_index, eta);
    EXPECT_NEAR(length(s->wi), 1.0, 1e-12);
    EXPECT_NEAR(std::hypot(s->wi.x, s->wi.y) * eta, sine, 1e-12);
    EXPECT_LT(s->wi.z * wo.z, 0.0);
    EXPECT_NEAR(wo.x * s->wi.y - wo.y * s->wi.x, 0.0, 1e-12);  // one plane
    EXPECT_LE(wo.x * s->wi.x + wo.y * s->wi.y, 0.0);
  }
}

TEST(SmoothGlass, ScalesRadianceByTheIndexSquaredAndImportanceNot) {
  const Bsdf bsdf = test::glass(1.5, 0.0);
  const Vec3d wo = direction(0.8);
  EXPECT_FLOAT_EQ(sample(bsdf, wo, refract_always, {}, Mode::radiance)->weight[1], 1.0f / 2.25f);
  EXPECT_FLOAT_EQ(sample(bsdf, -wo, refract_always, {}, Mode::radiance)->weight[1], 2.25f);
  EXPECT_FLOAT_EQ(sample(bsdf, wo, refract_always, {}, Mode::importance)->weight[1], 1.0f);
}

TEST(SmoothGlass, ReflectsAsOftenAsFresnelSays) {
  const Bsdf bsdf = test::glass(1.5, 0.0);
  const auto side = [&](double u) { return sample(bsdf, {0, 0, 1}, u, {}, Mode::radiance)->side; };
  EXPECT_EQ(side(0.04 - 1e-9), Side::reflected);
  EXPECT_EQ(side(0.04 + 1e-9), Side::transmitted);
}

TEST(SmoothGlass, IsInvisibleBetweenEqualMedia) {
  const Vec3d wo = direction(0.4);
  const auto s = sample(make_glass({{1.3, 1.3, 1.3, 1.3}, {1.3, 1.3, 1.3, 1.3}}, 0.4, Carried::all),
                        wo, 0.0, {}, Mode::radiance);
  ASSERT_TRUE(s);
  EXPECT_NEAR(length(s->wi + wo), 0.0, 1e-15);
  EXPECT_EQ(s->weight[3], 1.0f);
}

TEST(DispersiveGlass, RefractsTheHeroAndReflectsAll) {
  const Vec3d wo = direction(0.3);
  for (std::size_t hero = 0; hero < 4; ++hero) {
    const Bsdf bsdf = test::dispersive_glass(0.0, hero);
    const auto reflected = sample(bsdf, wo, 0.0, {}, Mode::radiance);
    EXPECT_EQ(reflected->carried, Carried::all);
    const auto refracted = sample(bsdf, wo, refract_always, {}, Mode::radiance);
    EXPECT_EQ(refracted->carried, Carried::hero);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(refracted->weight[i] > 0.0f, i == hero);

    // Weights times chances: F_i, and four times the hero's transmittance.
    const auto split = std::get<SmoothDielectric>(bsdf).index.split(wo.z, wo.z);
    const double q = split.chance_to_reflect;
    for (std::size_t i = 0; i < 4; ++i) {
      const double f = refract(wo.z, test::dispersive_indices[i]).reflectance;
      EXPECT_NEAR(reflected->weight[i] * q, f, 1e-6);
    }
    const double n = test::dispersive_indices[hero];
    const double passed = 4.0 * (1.0 - split.reflectance[hero]);
    EXPECT_NEAR(refracted->weight[hero] * (1 - q) * n * n, passed, 1e-5);
    EXPECT_NEAR(std::hypot(refracted->wi.x, refracted->wi.y) * n, std::hypot(wo.x, wo.y), 1e-12);
  }
}

TEST(DispersiveGlass, OfAHeroPathBehavesLikePlainGlass) {
  for (const double roughness : {0.0, 0.5}) {
    for (std::size_t hero = 0; hero < 4; ++hero) {
      const InterfaceIndices indices{{1, 1, 1, 1}, test::dispersive_indices, hero};
      const Bsdf bsdf = make_glass(indices, roughness, Carried::hero);
      const auto s = sample(bsdf, direction(0.9), refract_always, {0.4, 0.3}, Mode::importance);
      ASSERT_TRUE(s);
      EXPECT_EQ(s->side, Side::transmitted);
      EXPECT_EQ(s->carried, Carried::all);  // nothing is left to drop
      EXPECT_EQ(s->relative_index, test::dispersive_indices[hero]);
      EXPECT_NEAR(s->weight[0], s->weight[3], 1e-6);
      EXPECT_LE(s->weight[0], 1.1f);
    }
  }
}

TEST(DispersiveGlass, SaysHowFarItSpreadsColors) {
  const RelativeIndex index({{1, 1, 1, 1}, test::dispersive_indices, 2});
  Random random(8);
  for (int i = 0; i < 1000; ++i) {
    const double z = random.uniform(-1.0, 1.0), sine = std::sqrt(1.0 - z * z);
    const Spread spread = spread_of_refraction(index, z);
    double least = pi, most = 0.0;
    bool all_refracted = true;
    for (std::size_t j = 0; j < 4; ++j) {
      const double n = z > 0.0 ? test::dispersive_indices[j] : 1.0 / test::dispersive_indices[j];
      all_refracted = all_refracted && sine / n < 1.0;
      least = std::min(least, std::asin(std::min(sine / n, 1.0)));
      most = std::max(most, std::asin(std::min(sine / n, 1.0)));
      EXPECT_NEAR(spread.transmittance[j], 1.0 - refract(std::abs(z), n).reflectance, 1e-6);
    }
    EXPECT_EQ(spread.divergence < infinity, all_refracted);
    if (!all_refracted) continue;
    // A bound, and close where light does not graze.
    EXPECT_GE(spread.divergence, most - least - 1e-15);
    if (most < 1.2) {
      EXPECT_LE(spread.divergence, 1.4 * (most - least) + 1e-15);
    }
  }
}

TEST(DispersiveGlass, WeighsReflectionAndRefractionAlike) {
  Random random(6);
  const Bsdf bsdf = test::dispersive_glass(0.0);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d wo = random.direction();
    const auto a = sample(bsdf, wo, 0.0, {}, Mode::importance);
    const auto b = sample(bsdf, wo, refract_always, {}, Mode::importance);
    EXPECT_NEAR(a->weight.average(), b->weight.average(), 1e-5);
    EXPECT_LE(a->weight.max(), 7.0f);
  }
}

TEST(RoughGlass, RefractsNarrowLobesLikeSmoothGlass) {
  const Bsdf rough = test::glass(1.5, 0.001), smooth = test::glass(1.5, 0.0);
  for (const double view : {0.9, 0.4, -0.9, -0.8}) {
    const Vec3d wo = direction(view);
    const auto a = sample(rough, wo, refract_always, {0.5, 0.4}, Mode::radiance);
    const auto b = sample(smooth, wo, refract_always, {}, Mode::radiance);
    ASSERT_TRUE(a && b);
    EXPECT_LT(length(a->wi - b->wi), 0.01);
    EXPECT_NEAR(a->weight[0], b->weight[0], 0.01);
  }
}

TEST(Metals, HaveTheirColours) {
  // Luminance-weighted bands: gold absorbs blue, copper blue and green, silver hardly anything.
  const auto reflectance = [](std::string_view name, double nm) {
    const auto metal = find_metal(name);
    const ConductorFresnel fresnel =
        ConductorFresnel::from_index(SampledSpectrum(static_cast<float>(metal->n.at(nm))),
                                     SampledSpectrum(static_cast<float>(metal->k.at(nm))));
    return fresnel.at(1.0)[0];
  };
  EXPECT_GT(reflectance("gold", 650), 0.9f);
  EXPECT_LT(reflectance("gold", 450), 0.5f);
  EXPECT_GT(reflectance("copper", 650), 0.9f);
  EXPECT_LT(reflectance("copper", 500), 0.7f);
  EXPECT_GT(reflectance("silver", 450), 0.9f);
  EXPECT_NEAR(reflectance("aluminium", 550), 0.91f, 0.03f);
}

}  // namespace
}  // namespace lapidary::bsdf
