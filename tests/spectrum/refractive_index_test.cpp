#include "spectrum/refractive_index.h"

#include <cmath>

#include <gtest/gtest.h>

#include "spectrum/color.h"

namespace lapidary {
namespace {

// Fraunhofer lines [nm].
constexpr double line_d = 587.5618, line_f = 486.1327, line_c = 656.2725;

struct GlassCase {
  const char* name;
  double nd, nd_tolerance;
  double abbe, abbe_tolerance;
};

class Glass : public testing::TestWithParam<GlassCase> {};

// SCHOTT data sheets; Malitson 1965 (fused silica); handbook values as good as their spread for the
// crystals. For water the index alone: Hale & Querry give three digits, and with them an Abbe
// number of 73 where later measurements have 55.8.
TEST_P(Glass, HasThePublishedIndexAndAbbeNumber) {
  const GlassCase& expected = GetParam();
  const auto glass = find_glass(expected.name);
  ASSERT_TRUE(glass);
  const double nd = glass->at(line_d);
  EXPECT_NEAR(nd, expected.nd, expected.nd_tolerance);
  EXPECT_NEAR((nd - 1) / (glass->at(line_f) - glass->at(line_c)), expected.abbe,
              expected.abbe_tolerance);
  EXPECT_TRUE(glass->dispersive());
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Glass,
                         testing::Values(GlassCase{"N-BK7", 1.51680, 5e-6, 64.17, 0.01},
                                         GlassCase{"N-SF11", 1.78472, 5e-6, 25.68, 0.01},
                                         GlassCase{"fused silica", 1.45846, 1e-5, 67.82, 0.02},
                                         GlassCase{"diamond", 2.4175, 1e-3, 55.3, 0.5},
                                         GlassCase{"sapphire", 1.7682, 2e-4, 72.3, 0.3},
                                         GlassCase{"water", 1.3330, 1e-3, 73.0, 1.0}));

TEST(Glass, IndexFallsWithWavelength) {
  for (const std::string& name : glass_names()) {
    const auto glass = find_glass(name);
    ASSERT_TRUE(glass) << name;
    for (double nm = lambda_min; nm < lambda_max; nm += 1.0) {
      ASSERT_GE(glass->at(nm), glass->at(nm + 1.0)) << name << " at " << nm;
    }
  }
}

TEST(Glass, NamesAreForgiving) {
  for (const char* name : {"n-bk7", "N-BK7", "nbk7", "BK7", "N BK 7"}) {
    ASSERT_TRUE(find_glass(name)) << name;
    EXPECT_EQ(find_glass(name)->at(500.0), find_glass("N-BK7")->at(500.0));
  }
  for (const char* name : {"Fused Silica", "fused_silica", "FUSED-SILICA", "silica"}) {
    EXPECT_TRUE(find_glass(name)) << name;
  }
  for (const char* name : {"", " ", "-", "glass", "sf11", "diamonds", "bk", "\xc3\xa9"}) {
    EXPECT_FALSE(find_glass(name)) << name;
  }
}

TEST(RefractiveIndex, ConstantDoesNotDisperse) {
  const auto glass = RefractiveIndex::constant(1.5);
  EXPECT_FALSE(glass.dispersive());
  EXPECT_EQ(glass.at(400.0), 1.5);
  EXPECT_EQ(glass.at(Wavelengths::sample(0.3)), (std::array<double, 4>{1.5, 1.5, 1.5, 1.5}));
}

TEST(RefractiveIndex, DispersiveMeansThatValuesDiffer) {
  EXPECT_FALSE(RefractiveIndex::sellmeier({0.5, {0.75, 0, 0}, {0, 1, 2}}).dispersive());
  EXPECT_EQ(RefractiveIndex::sellmeier({0.5, {0.75, 0, 0}, {0, 1, 2}}).at(500.0), 1.5);
  EXPECT_TRUE(RefractiveIndex::sellmeier({0, {1, 0, 0}, {0.01, 0, 0}}).dispersive());
  EXPECT_FALSE(RefractiveIndex::table({400, 10, {1.5f, 1.5f}}).dispersive());
  EXPECT_TRUE(RefractiveIndex::table({400, 10, {1.5f, 1.25f}}).dispersive());
  EXPECT_EQ(RefractiveIndex::table({400, 10, {1.5f, 1.25f}}).at(405.0), 1.375);
}

TEST(RefractiveIndex, HeroWavelengthsSeeTheSameValues) {
  for (const std::string& name : glass_names()) {
    const auto glass = find_glass(name);
    for (const double u : {0.0, 0.4, 0.77}) {
      const Wavelengths wavelengths = Wavelengths::sample(u);
      const auto n = glass->at(wavelengths);
      for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(n[i], glass->at(wavelengths.lambda(i)));
    }
  }
}

/// Reflectance at normal incidence in air.
double reflectance(const ConductorIndex& metal, double nm) {
  const double n = metal.n.at(nm), k = metal.k.at(nm);
  return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
}

/// Colour of D65 reflected at normal incidence.
Rgb colour(const ConductorIndex& metal) {
  const Spectrum d65 = Spectrum::illuminant({1, 1, 1});
  SpectrumTable reflected{lambda_min, 1.0, {}};
  for (double nm = lambda_min; nm <= lambda_max; nm += 1.0) {
    reflected.values.push_back(static_cast<float>(reflectance(metal, nm) * d65.at(nm)));
  }
  return rgb_of(Spectrum::table(reflected));
}

TEST(Metal, ColoursAreThoseOfTheMetals) {
  const Rgb gold = colour(*find_metal("gold"));
  EXPECT_GT(gold.r, gold.g + 0.15f);
  EXPECT_GT(gold.g, gold.b + 0.3f);
  EXPECT_GT(gold.r, 0.95f);
  const Rgb copper = colour(*find_metal("copper"));
  EXPECT_GT(copper.r, copper.g + 0.25f);
  EXPECT_GT(copper.g, copper.b + 0.05f);
  const Rgb silver = colour(*find_metal("silver"));
  EXPECT_GT(std::min({silver.r, silver.g, silver.b}), 0.94f);
  EXPECT_GE(silver.r, silver.b);
  const Rgb aluminium = colour(*find_metal("aluminium"));
  EXPECT_NEAR(aluminium.g, 0.915f, 0.01f);
  EXPECT_NEAR(aluminium.r, aluminium.b, 0.015f);
}

TEST(Metal, TablesMeetTheirSources) {
  // Babar & Weaver at 563.6 nm (2.2 eV), Johnson & Christy at 548.6 nm, Rakic at 563.57 nm; a grid
  // of 5 nm rounds corners off.
  EXPECT_NEAR(find_metal("Au")->n.at(563.6), 0.2452, 0.005);
  EXPECT_NEAR(find_metal("Au")->k.at(563.6), 2.569, 0.01);
  EXPECT_NEAR(find_metal("Ag")->n.at(563.6), 0.05009, 0.001);
  EXPECT_NEAR(find_metal("Cu")->k.at(548.6), 2.577, 0.02);
  EXPECT_NEAR(find_metal("Al")->n.at(563.57), 1.0728, 0.002);
  EXPECT_NEAR(find_metal("Al")->k.at(563.57), 6.7839, 0.01);
  // Fresnel's formula on rows of the sources.
  EXPECT_NEAR(reflectance(*find_metal("gold"), 688.8), 0.979, 0.002);
  EXPECT_NEAR(reflectance(*find_metal("silver"), 619.9), 0.9896, 0.002);
}

TEST(Metal, AbsorbsEverywhere) {
  for (const std::string& name : metal_names()) {
    const auto metal = find_metal(name);
    ASSERT_TRUE(metal) << name;
    for (double nm = lambda_min; nm <= lambda_max; nm += 1.0) {
      EXPECT_GT(metal->n.at(nm), 0.0) << name;
      EXPECT_GT(metal->k.at(nm), 1.5) << name;
      EXPECT_LT(reflectance(*metal, nm), 1.0) << name;
    }
  }
}

TEST(Metal, NamesAreForgiving) {
  for (const char* name :
       {"Gold", "AU", "au", "silver", "Ag", "Copper", "cu", "Aluminum", "ALUMINIUM", "al"}) {
    EXPECT_TRUE(find_metal(name)) << name;
  }
  for (const char* name : {"", " ", "iron", "a", "golden"}) EXPECT_FALSE(find_metal(name)) << name;
}

}  // namespace
}  // namespace lapidary
