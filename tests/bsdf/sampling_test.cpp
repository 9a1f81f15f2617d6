#include <gtest/gtest.h>

#include "bsdf/surfaces.h"
#include "support/chi_squared.h"

namespace lapidary::bsdf {
namespace {

using lapidary::test::Random;
using test::direction;

// 130 views of surfaces share a false-alarm rate of 1.25e-4.
TEST(Sampling, FollowsItsDensity) {
  for (const auto& [name, surface] : test::rough_surfaces()) {
    if (name.starts_with("white") || name.starts_with("glass")) continue;  // nothing of their own
    const Bsdf& bsdf = surface;
    const int min_depth = name.ends_with("0.050000") ? 3 : 1;
    for (const double view : test::views(bsdf)) {
      // Off the axis a little: quadrature would miss a narrow lobe in the corner of its cells.
      const Vec3d wo = direction(0.95 * view);
      const auto result = lapidary::test::test_directions(
          [&](Random& random) -> std::optional<Vec3d> {
            const double u_lobe = random.uniform();
            const auto s = sample(bsdf, wo, u_lobe, random.uniform2(), Mode::radiance);
            if (!s || s->lobe == Lobe::specular) return std::nullopt;
            return s->wi;
          },
          [&](Vec3d wi) { return pdf(bsdf, wo, wi); },
          {.samples = 20000, .tests = 104, .min_depth = min_depth, .max_depth = 8},
          lapidary::test::sphere_grid(20, 20));
      EXPECT_TRUE(result.accepted) << name << " from " << view << ": " << result.message;
    }
  }
}

TEST(Sampling, WeighsByValueOverDensity) {
  Random random(3);
  for (const auto& [name, bsdf] : test::rough_surfaces()) {
    for (const double view : test::views(bsdf)) {
      for (const Mode mode : {Mode::radiance, Mode::importance}) {
        for (int i = 0; i < 200; ++i) {
          const Vec3d wo = direction(view, random.uniform(0.0, 6.0));
          const double u_lobe = random.uniform();
          const auto s = sample(bsdf, wo, u_lobe, random.uniform2(), mode);
          if (!s) continue;
          EXPECT_NEAR(length(s->wi), 1.0, 1e-9);
          EXPECT_EQ(s->side != Side::reflected, s->wi.z * wo.z < 0.0);
          EXPECT_EQ(s->side == Side::straight, s->wi == -wo);
          if (s->lobe == Lobe::specular) {
            EXPECT_EQ(s->pdf, 0.0);
            continue;
          }
          const BsdfValue value = evaluate_with_pdf(bsdf, wo, s->wi, mode);
          ASSERT_NEAR(value.pdf / s->pdf, 1.0, 1e-6) << name << " from " << view;
          for (std::size_t k = 0; k < 4; ++k) {
            const double expected = value.f_cos[k] / value.pdf;
            ASSERT_NEAR(s->weight[k], expected, 1e-5 * expected + 1e-12) << name << " " << view;
          }
        }
      }
    }
  }
}

TEST(Sampling, SurvivesHostileDirectionsAndNumbers) {
  auto surfaces = test::rough_surfaces();
  surfaces.push_back({"mirror", Mirror{ConductorFresnel::from_normal_incidence({})}});
  surfaces.push_back({"smooth glass", test::dispersive_glass(0.0)});
  surfaces.push_back({"pane", test::pane(1.5, {0.0f, 0.5f, 1.0f, 1.0f})});
  surfaces.push_back(
      {"coated mirror", test::coated({.index = 1.5}, Mirror{ConductorFresnel::from_normal_incidence(
                                                         SampledSpectrum(1.0f))})});
  surfaces.push_back({"black varnish", test::coated({.index = 1.0, .color = {}}, Black{})});
  surfaces.push_back({"narrow fuzz", test::fuzzy({.tilt = smallest_tilt}, Black{})});
  surfaces.push_back({"narrow phong", PhongLobes({}, SampledSpectrum(1.0f), 1e6)});
  surfaces.push_back({"narrow metal", test::white_metal(9e-4)});
  surfaces.push_back({"narrow glass", test::dispersive_glass(9e-4)});
  surfaces.push_back({"black", Black{}});
  const double below_one = 1.0 - 0x1p-53;
  for (const auto& [name, bsdf] : surfaces) {
    for (const double z : {1.0, 1e-3, 1e-8, 1e-16, 1e-300, 0.0, -0.0, -1e-300, -1e-8, -1.0}) {
      const Vec3d wo(std::sqrt(1.0 - z * z), 0.0, z);
      for (const double a : {0.0, 0.5, below_one}) {
        for (const Vec2d u :
             {Vec2d{0, 0}, Vec2d{0.5, 0.5}, Vec2d{below_one, 0}, Vec2d{below_one, below_one}}) {
          const auto s = sample(bsdf, wo, a, u, Mode::importance);
          if (!s) continue;
          EXPECT_TRUE(is_finite(s->wi)) << name << " " << z;
          EXPECT_TRUE(std::isfinite(s->pdf) && s->pdf >= 0.0) << name << " " << z;
          EXPECT_TRUE(std::isfinite(s->weight.sum()) && s->weight.sum() >= 0.0f) << name << z;
          EXPECT_LT(s->weight.max(), 16.0f) << name << " " << z;
        }
      }
      for (const Vec3d wi : {wo, -wo, Vec3d(wo.x, 0.0, -z), Vec3d(0, 0, 1), Vec3d(0, 0, -1)}) {
        const BsdfValue value = evaluate_with_pdf(bsdf, wo, wi, Mode::radiance);
        EXPECT_TRUE(std::isfinite(value.pdf) && value.pdf >= 0.0) << name << " " << z;
        EXPECT_TRUE(std::isfinite(value.f_cos.sum()) && value.f_cos.sum() >= 0.0f) << name << z;
      }
    }
  }
}

TEST(Sampling, SaysWhatIsSpecular) {
  const auto wavelengths = Wavelengths::sample(0.3);
  const RefractiveIndex air = RefractiveIndex::constant(1.0);
  const RefractiveIndex water = RefractiveIndex::constant(1.33);
  const texture::Lookup anywhere;
  const Place place{anywhere, wavelengths};
  const texture::Color grey = Spectrum::constant(0.5f);
  const auto metal = [&](double roughness) { return Metal{grey, roughness}; };
  const auto glass = [&](const RefractiveIndex& n, double roughness) {
    return make_bsdf(Glass{n, roughness}, air, place, Carried::all);
  };
  EXPECT_FALSE(is_specular(make_bsdf(Matte{grey}, place)));
  EXPECT_TRUE(is_specular(make_bsdf(metal(0.0), place)));
  EXPECT_FALSE(is_specular(make_bsdf(metal(0.1), place)));
  EXPECT_TRUE(is_specular(glass(water, 0.0)));
  EXPECT_FALSE(is_specular(glass(water, 0.2)));
  // Facets between equal media bend nothing.
  EXPECT_TRUE(is_specular(glass(air, 0.2)));
  EXPECT_TRUE(is_specular(Black{}));
  EXPECT_TRUE(is_specular(test::pane(1.5)));
  // One lobe that is not is enough for next-event estimation.
  const Bsdf diffuse = Diffuse{SampledSpectrum(0.5f)};
  EXPECT_FALSE(is_specular(test::coated({}, diffuse)));
  EXPECT_TRUE(is_specular(test::coated({}, make_bsdf(metal(0.0), place))));
  EXPECT_FALSE(is_specular(test::coated({.alpha = 0.1}, make_bsdf(metal(0.0), place))));
  EXPECT_FALSE(is_specular(test::mixture(test::pane(1.5), diffuse, 0.1)));
  EXPECT_TRUE(is_specular(test::mixture(test::pane(1.5), Black{}, 0.1)));
}

}  // namespace
}  // namespace lapidary::bsdf
