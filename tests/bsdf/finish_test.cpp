#include <gtest/gtest.h>

#include "bsdf/surfaces.h"
#include "spectrum/color.h"

namespace lapidary::bsdf {
namespace {

using test::direction;

// Materials as scenes state them, made into BSDFs: what a parameter means.
class FinishTest : public testing::Test {
 protected:
  template <typename Kind>
  Bsdf make(Kind kind) const {
    return make_bsdf(Finish{std::move(kind)}, {anywhere_, wavelengths_}, {air_, glass_});
  }
  template <typename Kind>
  static FinishPtr part(Kind kind) {
    return std::make_shared<const Finish>(Finish{std::move(kind)});
  }
  /// The share of light that leaves, over an additive lattice of samples.
  static double albedo(const Bsdf& bsdf, double view) {
    constexpr int samples = 10000;
    const auto coordinate = [](int i, double step) { return std::fmod(0.5 + i * step, 1.0); };
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
      const Vec2d u{coordinate(i, 0.8191725133961645), coordinate(i, 0.6710436067037893)};
      const double u_lobe = coordinate(i, 0.5497004779019703);
      const auto s = sample(bsdf, direction(view), u_lobe, u, Mode::importance);
      if (s) sum += s->weight.average();
    }
    return sum / samples;
  }

  Wavelengths wavelengths_ = Wavelengths::sample(0.3);
  texture::Lookup anywhere_;
  RefractiveIndex air_ = RefractiveIndex::constant(1.0), glass_ = RefractiveIndex::constant(1.5);
  Spectrum white_ = Spectrum::constant(1.0f);
};

TEST_F(FinishTest, WhitePrincipledSurfacesLoseLittle) {
  Principled plain{.color = white_, .roughness = 0.0};
  Principled rough{.color = white_, .roughness = 0.5};
  Principled metal{.color = white_, .metalness = 1.0, .roughness = 0.4};
  Principled half{.color = white_, .metalness = 0.5, .roughness = 0.4};
  Principled clear{.color = white_, .roughness = 0.3, .transmission = 1.0};
  Principled milky{.color = white_, .roughness = 0.3, .transmission = 0.5};
  Principled coated{.color = white_, .roughness = 0.5, .coat = 1.0};
  Principled fuzzy{.color = white_, .roughness = 0.5, .fuzz = 1.0};
  Principled all{.color = white_, .metalness = 0.3, .roughness = 0.4, .coat = 0.5, .fuzz = 0.5};
  Principled chalk{.color = white_, .diffuse_roughness = 1.0, .roughness = 0.3, .coat = 1.0};
  Principled dusty = chalk;
  dusty.fuzz = 1.0;
  for (const Principled& p :
       {plain, rough, metal, half, clear, milky, coated, fuzzy, all, chalk, dusty}) {
    for (const double view : {1.0, 0.5, 0.2, 0.05}) {
      const double a = albedo(make(p), view);
      EXPECT_GT(a, 0.99) << view;
      EXPECT_LT(a, 1.008) << view;
    }
  }
}

TEST_F(FinishTest, PrincipledMetalHasItsColourHeadOnAndItsTintAtTheEdge) {
  const SampledSpectrum color(0.9f, 0.5f, 0.2f, 1.0f), tint(0.5f, 1.0f, 0.2f, 0.7f);
  const auto fresnel = ConductorFresnel::from_edge_tint(color, tint);
  const auto plain = ConductorFresnel::from_normal_incidence(color);
  double average[4] = {};
  for (int i = 0; i < 2000; ++i) {
    const double mu = (i + 0.5) / 2000;
    for (std::size_t k = 0; k < 4; ++k) average[k] += 2.0 * mu * fresnel.at(mu)[k] / 2000;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_FLOAT_EQ(fresnel.at(1.0)[k], color[k]);
    EXPECT_FLOAT_EQ(fresnel.at(0.0)[k], 1.0f);
    EXPECT_NEAR(fresnel.at(1.0 / 7.0)[k], tint[k] * plain.at(1.0 / 7.0)[k], 1e-6);
    EXPECT_NEAR(fresnel.average()[k], average[k], 1e-4);
  }
}

// specular_weight scales what a dielectric reflects head on.
TEST_F(FinishTest, PrincipledSpecularScalesTheReflectionHeadOn) {
  const auto head_on = [&](double weight) {
    Principled p{.color = Spectrum::constant(0.0f), .specular = weight, .roughness = 0.0};
    return albedo(make(p), 1.0);
  };
  EXPECT_NEAR(head_on(1.0), 0.04, 1e-5);
  EXPECT_NEAR(head_on(0.5), 0.02, 1e-5);
  EXPECT_NEAR(head_on(0.0), 0.0, 1e-6);
}

TEST_F(FinishTest, IsTransparentWhereAPartIs) {
  EXPECT_FALSE(is_transparent(make(Principled{})));
  EXPECT_TRUE(is_transparent(make(Principled{.transmission = 0.1})));
  EXPECT_TRUE(is_transparent(make(ThinGlass{})));
  EXPECT_TRUE(is_transparent(make(Blend{part(Glass{}), part(Matte{}), 0.5})));
  EXPECT_FALSE(is_transparent(make(Blend{part(Glass{}), part(Matte{}), 1.0})));
}

TEST_F(FinishTest, LayersCoverBothPartsOfABlend) {
  const Bsdf bsdf = make(Coated{part(Blend{part(Metal{white_}), part(Matte{white_}), 0.5})});
  ASSERT_TRUE(std::holds_alternative<Mixture>(bsdf));
  for (const double view : {1.0, 0.3, 0.1}) EXPECT_NEAR(albedo(bsdf, view), 1.0, 0.006);
}

TEST_F(FinishTest, VelvetHasAGroundOfItsColour) {
  const texture::Color red(Spectrum::reflectance({0.5f, 0.02f, 0.02f}));
  EXPECT_GT(albedo(make(Velvet{red}), 1.0),
            2.0 * albedo(make(Velvet{red, 0.3, part(Black{})}), 1.0));
  EXPECT_NEAR(albedo(make(Velvet{white_}), 0.3), 1.0, 0.005);
}

TEST_F(FinishTest, PhongKeepsToTheLight) {
  EXPECT_NEAR(albedo(make(Phong{white_, white_, 10.0}), 1.0), 1.0, 1e-3);
  EXPECT_NEAR(albedo(make(Phong{Spectrum::constant(0.25f), white_, 10.0}), 1.0), 1.0, 5e-3);
}

// What the Physically Based database (A. Berlin) makes of the same measurements of gold, silver and
// copper, linear Rec. 709; its aluminium is of another source.
TEST_F(FinishTest, MeasuredMetalsHaveThePublishedColours) {
  struct Published {
    const char* name;
    Rgb color;
    float share;  ///< that they may be off by
  };
  const Published published[] = {{"gold", {1.059f, 0.773f, 0.307f}, 0.005f},
                                 {"silver", {0.991f, 0.985f, 0.974f}, 0.005f},
                                 {"copper", {0.932f, 0.623f, 0.522f}, 0.005f},
                                 {"aluminium", {0.916f, 0.923f, 0.924f}, 0.015f}};
  for (const Published& metal : published) {
    const auto index = find_metal(metal.name);
    SpectrumTable table{lambda_min, 1.0, {}};
    for (double nm = lambda_min; nm <= lambda_max; ++nm) {
      const auto fresnel =
          ConductorFresnel::from_index(SampledSpectrum(static_cast<float>(index->n.at(nm))),
                                       SampledSpectrum(static_cast<float>(index->k.at(nm))));
      table.values.push_back(fresnel.at(1.0)[0]);
    }
    const Rgb c = reflected_daylight(Spectrum::table(std::move(table)));
    EXPECT_NEAR(c.r, metal.color.r, metal.share * metal.color.r) << metal.name;
    EXPECT_NEAR(c.g, metal.color.g, metal.share * metal.color.g) << metal.name;
    EXPECT_NEAR(c.b, metal.color.b, metal.share * metal.color.b) << metal.name;
  }
}

}  // namespace
}  // namespace lapidary::bsdf
