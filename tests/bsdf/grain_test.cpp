#include <gtest/gtest.h>

#include "bsdf/focus.h"
#include "bsdf/surfaces.h"
#include "support/random.h"

namespace lapidary::bsdf {
namespace {

using lapidary::test::Random;
using test::direction;

const Grain grains[] = {{0.01, 0.5, 0.3}, {0.1, 0.9, 1.0}, {0.25, 0.3, -2.0}, {0.36, 1.0, 0.0},
                        {0.6, 0.7, 4.0},  {1.0, 0.2, 0.7}, {1.0, 0.95, 1.5}};

std::string name_of(const Grain& grain) {
  return "alpha " + std::to_string(grain.alpha) + " anisotropy " + std::to_string(grain.anisotropy);
}

/// About z, by -`angle`: into axes that are turned by `angle`.
Vec3d into_axes(Vec3d v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x + s * v.y, c * v.y - s * v.x, v.z};
}

// The share of white light that comes back, over an additive lattice.
double albedo(const Bsdf& bsdf, Vec3d wo) {
  constexpr int samples = 10000;
  const auto coordinate = [](int i, double step) { return std::fmod(0.5 + i * step, 1.0); };
  double sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    const Vec2d u{coordinate(i, 0.8191725133961645), coordinate(i, 0.6710436067037893)};
    const auto s = sample(bsdf, wo, coordinate(i, 0.5497004779019703), u, Mode::importance);
    if (s) sum += s->weight.average();
  }
  return sum / samples;
}

// The reference code of OpenPBR: alpha_x = r^2 sqrt(2 / (1 + (1 - a)^2)), alpha_y = (1 - a)
// alpha_x.
TEST(Grain, HasTheAlphasOfOpenPbr) {
  const Grain grain(alpha_from_roughness(0.6), 0.75);
  EXPECT_NEAR(grain.wide(), 0.36 * std::sqrt(2.0 / (1.0 + 0.0625)), 1e-12);
  EXPECT_NEAR(grain.narrow(), 0.25 * grain.wide(), 1e-12);
  EXPECT_NEAR(grain.mean_alpha(), std::sqrt(grain.wide() * grain.narrow()), 1e-12);
  EXPECT_EQ(Grain(0.3).wide(), 0.3);
  EXPECT_EQ(Grain(0.3).narrow(), 0.3);
  EXPECT_EQ(Ggx(0.3).alpha, 0.3);
}

// The textbook forms in the facets' own axes: Heitz 2014, equations 85 and 86.
TEST(Grain, StretchesAndTurnsTheDistribution) {
  Random random(11);
  for (const Grain& grain : grains) {
    const Ggx facets(grain);
    for (int i = 0; i < 200; ++i) {
      const Vec3d v = abs(random.direction());
      const Vec3d own = into_axes(v, grain.rotation);
      const double x = own.x / grain.wide(), y = own.y / grain.narrow();
      const double width = x * x + y * y + v.z * v.z;
      const double expected = inv_pi / (grain.wide() * grain.narrow() * width * width);
      EXPECT_NEAR(facets.density(v), expected, 1e-9 * expected);
      const double along = grain.wide() * own.x, across = grain.narrow() * own.y;
      const double lambda =
          0.5 * (std::sqrt(1.0 + (along * along + across * across) / (v.z * v.z)) - 1.0);
      EXPECT_NEAR(facets.visible_share(v), 1.0 / (1.0 + lambda), 1e-9);
    }
  }
}

// What a view sees of all facets adds up to the surface that it sees; wo from azimuths of its own.
TEST(Grain, ShowsAsMuchAreaAsThereIs) {
  for (const Grain& grain : {Grain(0.3, 0.6, 0.8), Grain(0.8, 0.8, 2.0)}) {
    const Ggx facets(grain);
    for (const Vec3d wo : {direction(0.9, 0.3), direction(0.3, 2.0), direction(0.1, 4.0)}) {
      double sum = 0.0;
      constexpr int n = 700;
      // Slopes by tangents of even angles: dh = cos^3 dp dq of slopes p and q.
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const double p = std::tan(pi * ((i + 0.5) / n - 0.5));
          const double q = std::tan(pi * ((j + 0.5) / n - 0.5));
          const Vec3d h = normalize(Vec3d(p, q, 1.0));
          const double jacobian = (1.0 + p * p) * (1.0 + q * q) * h.z * h.z * h.z;
          sum += std::max(dot(wo, h), 0.0) * facets.density(h) * jacobian;
        }
      }
      const double seen = sum * pi * pi / (double(n) * n) * facets.visible_share(wo);
      EXPECT_NEAR(seen, wo.z, 2e-3) << name_of(grain);
    }
  }
}

TEST(Grain, TurnsWithItsRotation) {
  Random random(12);
  const Grain turned(0.3, 0.8, 0.9), straight(0.3, 0.8);
  const Bsdf metals[] = {test::white_metal(turned), test::white_metal(straight)};
  const Bsdf glasses[] = {test::glass(1.5, turned), test::glass(1.5, straight)};
  for (int i = 0; i < 300; ++i) {
    const Vec3d wo = random.direction(), wi = random.direction();
    const Vec3d own_o = into_axes(wo, 0.9), own_i = into_axes(wi, 0.9);
    for (const auto& pair : {metals, glasses}) {
      const BsdfValue a = evaluate_with_pdf(pair[0], wo, wi, Mode::radiance);
      const BsdfValue b = evaluate_with_pdf(pair[1], own_o, own_i, Mode::radiance);
      EXPECT_NEAR(a.f_cos[0], b.f_cos[0], 1e-5 * b.f_cos[0] + 1e-9);
      EXPECT_NEAR(a.pdf, b.pdf, 1e-6 * b.pdf + 1e-9);
    }
  }
}

// Facets with a grain and even ones have tables of their own, which say the same.
TEST(Grain, ThatIsAlmostNoneIsEven) {
  double metal = 0.0, coat = 0.0, glass = 0.0;
  Random random(13);
  for (int i = 0; i < 500; ++i) {
    const double alpha = random.uniform(0.001, 1.0), eta = random.uniform(1.2, 2.5);
    const Grain even(alpha), almost(alpha, 1e-7);
    const Ggx facets(almost);
    const Vec3d v = direction(random.uniform(0.05, 1.0), random.uniform(0.0, 6.0));
    metal = std::max(metal, std::abs(GgxAlbedo(even).at(v.z) - GgxAlbedo(almost).at(facets, v)));
    coat = std::max(
        coat, std::abs(CoatAlbedo(even, eta).at(v.z) - CoatAlbedo(almost, eta).at(facets, v)));
    const double index = i % 2 == 0 ? eta : 1.0 / eta;
    glass = std::max(glass, std::abs(GlassAlbedo(even, index).at(v.z) -
                                     GlassAlbedo(almost, index).at(facets, v)));
  }
  EXPECT_LT(metal, 0.006);
  EXPECT_LT(coat, 0.012);
  EXPECT_LT(glass, 0.03);
}

TEST(Grain, LosesNothingOfAWhiteFurnace) {
  for (const Grain& grain : grains) {
    const Bsdf metal = test::white_metal(grain);
    const Bsdf varnish = test::coated({.index = 1.5,
                                       .alpha = grain.alpha,
                                       .anisotropy = grain.anisotropy,
                                       .rotation = grain.rotation},
                                      Diffuse{SampledSpectrum(1.0f)});
    for (const double azimuth : {0.0, 0.5, 1.2, pi / 2}) {
      for (const double view : {1.0, 0.7, 0.3, 0.1}) {
        const Vec3d wo = direction(view, azimuth + grain.rotation);
        EXPECT_NEAR(albedo(metal, wo), 1.0, 0.01) << name_of(grain) << " from " << view;
        EXPECT_NEAR(albedo(varnish, wo), 1.0, 0.01) << name_of(grain) << " from " << view;
      }
    }
  }
}

// Of the worst a good part is the lattice's own error.
TEST(Grain, OfGlassLosesNothingOfAWhiteFurnace) {
  double worst = 0.0, sum = 0.0;
  int tests = 0;
  for (const Grain& grain : grains) {
    for (const double n : {1.33, 2.2}) {
      const Bsdf glass = test::glass(n, grain);
      for (const double azimuth : {0.2, 1.0, pi / 2}) {
        for (const double view : {1.0, 0.5, 0.1, -0.1, -0.5, -0.9}) {
          const double error = albedo(glass, direction(view, azimuth + grain.rotation)) - 1.0;
          worst = std::max(worst, std::abs(error));
          sum += std::abs(error), ++tests;
        }
      }
    }
  }
  EXPECT_LT(worst, 0.015);
  EXPECT_LT(sum / tests, 0.003);
}

// A lobe counts by its solid angle: a line as thin as a hair and as long as half the sky is narrow.
TEST(Grain, MakesLobesNarrowByBothAlphas) {
  EXPECT_FALSE(is_narrow(test::white_metal(0.2)));
  EXPECT_FALSE(is_narrow(test::white_metal({0.2, 0.3})));
  EXPECT_TRUE(is_narrow(test::white_metal({0.2, 0.9})));
  EXPECT_TRUE(is_narrow(test::glass(1.5, {0.2, 0.9})));
  const Metal even{Spectrum::constant(1.0f), std::sqrt(0.2)};
  EXPECT_EQ(focused_share(Finish{even}), 0.0);
  Metal brushed = even;
  brushed.brushing.anisotropy = 0.9;
  EXPECT_EQ(focused_share(Finish{brushed}), 1.0);
}

}  // namespace
}  // namespace lapidary::bsdf
