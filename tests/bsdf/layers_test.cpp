#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bsdf/surfaces.h"
#include "support/random.h"

namespace lapidary::bsdf {
namespace {

using test::coated;
using test::direction;
using test::fuzzy;
using test::mixture;

const SampledSpectrum white(1.0f);

Bsdf white_mirror() {
  return Mirror{ConductorFresnel::from_normal_incidence(white)};
}

std::string numbers(double a, double b) {
  return std::to_string(a) + " " + std::to_string(b);
}

/// The share of light that comes back at one wavelength, over an additive lattice of samples.
double albedo(const Bsdf& bsdf, Vec3d wo, std::size_t wavelength = 0) {
  constexpr int samples = 10000;
  const auto coordinate = [](int i, double step) { return std::fmod(0.5 + i * step, 1.0); };
  double sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    const Vec2d u{coordinate(i, 0.8191725133961645), coordinate(i, 0.6710436067037893)};
    const auto s = sample(bsdf, wo, coordinate(i, 0.5497004779019703), u, Mode::importance);
    if (s) sum += s->weight[wavelength];
  }
  return sum / samples;
}

void expect_furnace(const Bsdf& bsdf, double least, double most, const std::string& name,
                    const std::vector<double>& views = {1.0, 0.7, 0.4, 0.2, 0.1, 0.03}) {
  for (const double view : views) {
    const double a = albedo(bsdf, direction(view));
    EXPECT_GT(a, least) << name << " from " << view;
    EXPECT_LT(a, most) << name << " from " << view;
  }
}

TEST(Coat, GivesBackAWhiteFurnaceFromWhiteBases) {
  for (const double alpha : {0.0, 0.1, 1.0}) {
    for (const double index : {1.3, 1.5, 2.2}) {
      const Coat::Look look{.index = index, .alpha = alpha};
      const std::string name = numbers(alpha, index);
      expect_furnace(coated(look, Diffuse{white}), 0.995, 1.006, name + " on diffuse");
      expect_furnace(coated(look, white_mirror()), 0.996, 1.005, name + " on a mirror");
    }
  }
}

TEST(Coat, GivesBackAWhiteFurnaceFromGlossyMetal) {
  for (const double index : {1.3, 1.5, 2.2}) {
    for (const double alpha : {0.002, 0.03, 0.1, 0.3, 1.0}) {
      const std::string name = numbers(index, alpha);
      expect_furnace(coated({.index = index}, test::white_metal(alpha)), 0.99, 1.008, name);
      expect_furnace(coated({.index = index, .alpha = 0.3}, test::white_metal(alpha)), 0.99, 1.008,
                     name + " rough");
    }
  }
}

// Grooves send grazing light back the way it came, where layers take a little more.
TEST(Layers, GiveBackAWhiteFurnaceFromRoughMatte) {
  for (const double roughness : {0.3, 1.0}) {
    const Bsdf base = RoughDiffuse(white, roughness);
    const std::string name = " on roughness " + std::to_string(roughness);
    for (const double index : {1.3, 1.5, 2.2}) {
      expect_furnace(coated({.index = index}, base), 0.996, 1.004, numbers(index, 0.0) + name);
      expect_furnace(coated({.index = index, .alpha = 0.1}, base), 0.995, 1.004,
                     numbers(index, 0.1) + name);
    }
    for (const double tilt : {0.1, 0.6, 1.0})
      expect_furnace(fuzzy({.tilt = tilt}, base), 0.994, 1.003, numbers(tilt, 0.0) + name);
  }
}

// What a layer lets through depends on the direction as what the other one does, so that each of
// the lobes below has its own share.
TEST(Layers, GiveBackAWhiteFurnaceThroughEachOther) {
  const std::vector<Layered::Layer> layers{Coat({.index = 1.3}), Coat({.index = 1.4, .alpha = 0.1}),
                                           Coat({.index = 2.2, .alpha = 1.0}), Fuzz({.tilt = 0.1}),
                                           Fuzz({.tilt = 1.0})};
  const std::vector<NestedPtr> bases{nested(Diffuse{white}), nested(RoughDiffuse(white, 1.0)),
                                     nested(test::white_metal(0.1))};
  for (std::size_t below = 0; below < layers.size(); ++below) {
    for (std::size_t base = 0; base < bases.size(); ++base) {
      const NestedPtr inner = nested(Layered(layers[below], bases[base]));
      for (std::size_t above = 0; above < layers.size(); ++above) {
        const std::string name =
            std::to_string(above) + " on " + std::to_string(below) + " on " + std::to_string(base);
        expect_furnace(Layered(layers[above], inner), 0.99, 1.011, name, {1.0, 0.5, 0.15, 0.03});
      }
    }
  }
}

// What `principled` makes of all its layers, and the worst of others.
TEST(Layers, OfThreeLoseLittle) {
  const Bsdf plastic = coated({.index = 1.5, .alpha = 0.1}, RoughDiffuse(white, 0.5));
  for (const double tilt : {0.1, 0.6}) {
    expect_furnace(fuzzy({.tilt = tilt}, coated({.index = 1.6}, plastic)), 0.99, 1.006,
                   numbers(tilt, 0.0) + " on varnish");
  }
  const Bsdf felt = fuzzy({.tilt = 0.6}, fuzzy({.tilt = 1.0}, Diffuse{white}));
  expect_furnace(coated({.index = 1.3, .alpha = 0.3}, felt), 0.99, 1.021, "felt");
  const Bsdf pile = fuzzy({.tilt = 0.1}, fuzzy({.tilt = 0.1}, plastic));
  expect_furnace(pile, 0.982, 1.004, "pile");
}

TEST(Fuzz, GivesBackAWhiteFurnaceFromWhiteBases) {
  for (const double tilt : {0.1, 0.3, 0.6, 1.0}) {
    const std::string name = numbers(tilt, 0.0);
    expect_furnace(fuzzy({.tilt = tilt}, Diffuse{white}), 0.996, 1.004, name + " on diffuse");
    expect_furnace(fuzzy({.tilt = tilt}, white_mirror()), 0.99, 1.004, name + " on a mirror");
    for (const double alpha : {0.01, 0.05, 0.1, 0.3, 1.0})
      expect_furnace(fuzzy({.tilt = tilt}, test::white_metal(alpha)), 0.99, 1.006, name + " metal");
    expect_furnace(fuzzy({.tilt = tilt}, coated({}, Diffuse{white})), 0.996, 1.004, name);
    expect_furnace(fuzzy({.tilt = tilt}, coated({.alpha = 0.2}, Diffuse{white})), 0.996, 1.005,
                   name + " satin");
  }
}

TEST(Mixture, GivesBackAWhiteFurnace) {
  expect_furnace(mixture(white_mirror(), Diffuse{white}, 0.3), 0.999, 1.001, "half mirror");
  expect_furnace(mixture(test::pane(1.5), Diffuse{white}, 0.3), 0.999, 1.001, "dirty pane");
  expect_furnace(fuzzy({.weight = 0.4}, coated({.weight = 0.3}, Diffuse{white})), 0.996, 1.004,
                 "layers with holes");
}

// Between the layer and a diffuse base light bounces with the layer's inner reflectance r and the
// base's albedo: T1 rho (1 - r) (1 + r rho + (r rho)^2 + ...), of which the furnace shows T1 where
// rho is one.
TEST(Coat, DarkensColouredBasesByWhatItsInsideMirrors) {
  const double index = 1.5;
  const SampledSpectrum color(0.05f, 0.3f, 0.7f, 1.0f);
  const Bsdf bsdf = coated({.index = index}, Diffuse{color});
  // Fresnel's average for diffuse light from outside, by quadrature, and from inside by
  // reciprocity.
  double outside = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double mu = (i + 0.5) / 10000;
    outside += 2.0 * mu * refract(mu, index).reflectance / 10000;
  }
  const double inside = 1.0 - (1.0 - outside) / (index * index);
  EXPECT_NEAR(outside, 0.0918, 1e-3);  // textbook value of diffuse reflectance at n = 1.5
  EXPECT_NEAR(inside, 0.596, 1e-3);
  const double view = 0.8, first = refract(view, index).reflectance;
  for (std::size_t k = 0; k < 4; ++k) {
    double expected = first, on_the_way = (1.0 - first) * color[k];
    for (int bounce = 0; bounce < 200; ++bounce) {
      expected += on_the_way * (1.0 - inside);
      on_the_way *= inside * color[k];
    }
    EXPECT_NEAR(albedo(bsdf, direction(view), k), expected, 2e-3) << k;
  }
}

TEST(Coat, TintsByItsColourHeadOnAndMoreAtAnAngle) {
  const SampledSpectrum color(0.25f, 0.5f, 1.0f, 0.0f);
  const double index = 1.5;
  const auto through = [&](double mu, std::size_t k) {
    const Vec3d wo = direction(mu), wi = direction(mu, 2.0);
    const auto tinted =
        evaluate(coated({.index = index, .color = color, .darkens = false}, Diffuse{white}), wo, wi,
                 Mode::radiance);
    const auto clear = evaluate(coated({.index = index, .darkens = false}, Diffuse{white}), wo, wi,
                                Mode::radiance);
    return tinted[k] / clear[k];
  };
  for (const std::size_t k : {0, 1, 2, 3}) EXPECT_NEAR(through(1.0, k), color[k], 1e-5);
  // Snell: 60 degrees outside are asin(sin 60 / 1.5) inside.
  const double inside = std::cos(std::asin(std::sqrt(0.75) / index));
  EXPECT_NEAR(through(0.5, 0), std::pow(0.25, 1.0 / inside), 1e-5);
}

TEST(Coat, OfNoWeightIsNotThere) {
  const Bsdf base = test::white_metal(0.3);
  const Bsdf bsdf = coated({.index = 1.5, .alpha = 0.2, .weight = 0.0, .color = {}}, base);
  const Vec3d wo = direction(0.4), wi = direction(0.7, 2.0);
  const float expected = evaluate(base, wo, wi, Mode::radiance)[0];
  EXPECT_NEAR(evaluate(bsdf, wo, wi, Mode::radiance)[0], expected, 1e-5 * expected);
}

// The table against the mean over visible normals by plain random numbers.
TEST(Coat, KnowsWhatItsFacetsReflect) {
  lapidary::test::Random random(2);
  double worst = 0.0;
  for (int i = 0; i < 300; ++i) {
    const double alpha = random.uniform(0.02, 1.0), eta = random.uniform(1.05, 2.8);
    const double mu = random.uniform(0.1, 1.0);
    const Ggx facets{alpha};
    const Vec3d wo = direction(mu);
    double sum = 0.0;
    constexpr int samples = 2000;
    for (int j = 0; j < samples; ++j) {
      const Vec2d u{(j + 0.5) / samples, std::fmod(j * 0.6180339887498949, 1.0)};
      const Vec3d h = facets.sample_visible(wo, u);
      const Vec3d wi = 2.0 * dot(wo, h) * h - wo;
      if (wi.z <= 0.0) continue;
      sum += refract(std::min(dot(wo, h), 1.0), eta).reflectance * 2.0 * (wo.z + facets.slant(wo)) *
             facets.reflection_share(wo, wi);
    }
    worst = std::max(worst, std::abs(CoatAlbedo(alpha, eta).at(mu) - sum / samples));
  }
  EXPECT_LT(worst, 0.005);
}

TEST(Fuzz, KnowsWhatItsFibresReflect) {
  lapidary::test::Random random(3);
  double worst = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double tilt = random.uniform(smallest_tilt, 1.0), mu = random.uniform();
    const Fibers fibers{tilt};
    const Vec3d wo = direction(mu);
    double sum = 0.0;
    constexpr int samples = 20000;
    for (int j = 0; j < samples; ++j) {
      const Vec2d u{(j + 0.5) / samples, std::fmod(j * 0.6180339887498949, 1.0)};
      const Vec3d wi = fibers.sample(wo, u);
      if (wi.z > 0.0) sum += fibers.reflection(wo, wi) / fibers.pdf(wo, wi);
    }
    worst = std::max(worst, std::abs(FuzzAlbedo(tilt).at(mu) - sum / samples));
  }
  EXPECT_LT(worst, 0.002);
}

// Flakes that point anywhere scatter evenly, and Chandrasekhar's half space has 1 / (4 pi) mu_i /
// (mu_o + mu_i) for a single scattering.
TEST(Fuzz, OfFlakesInAllDirectionsIsChandrasekharsHalfSpace) {
  const Fibers fibers{1.0};
  lapidary::test::Random random(4);
  for (int i = 0; i < 100; ++i) {
    const Vec3d a = abs(random.direction()), b = abs(random.direction());
    EXPECT_NEAR(fibers.reflection(a, b), 0.25 * inv_pi * b.z / (a.z + b.z), 1e-12);
  }
  const double expected = 0.5 * (1.0 - std::log(2.0));
  EXPECT_NEAR(FuzzAlbedo(1.0).at(1.0), expected, 1e-4);
}

TEST(Fuzz, GlowsWhereTheSurfaceTurnsAway) {
  for (const double tilt : {0.1, 0.5, 1.0}) {
    EXPECT_LT(FuzzAlbedo(tilt).at(1.0), 0.16);
    EXPECT_NEAR(FuzzAlbedo(tilt).at(0.0), 0.5, 1e-4);  // half of what it scatters goes down
  }
  EXPECT_LT(FuzzAlbedo(0.1).at(1.0), 0.001);
}

// Pass by pass through both faces, as far as floats go.
TEST(Pane, SumsTheReflectionsInside) {
  const SampledSpectrum color(1.0f, 0.8f, 0.3f, 0.0f);
  for (const double index : {1.1, 1.5, 2.4}) {
    for (const double mu : {1.0, 0.5, 0.1, 0.01}) {
      const auto shares = Pane({index, index, index, index}, color).shares(mu);
      const Refraction face = refract(mu, index);
      for (std::size_t k = 0; k < 4; ++k) {
        const double once = std::pow(color[k], 1.0 / face.cos_refracted);
        double reflected = face.reflectance, transmitted = 0.0;
        double inside = (1.0 - face.reflectance) * once;
        for (int pass = 0; pass < 4000; ++pass) {
          (pass % 2 == 0 ? transmitted : reflected) += inside * (1.0 - face.reflectance);
          inside *= face.reflectance * once;
        }
        EXPECT_NEAR(shares.reflected[k], reflected, 1e-6);
        EXPECT_NEAR(shares.transmitted[k], transmitted, 1e-6);
      }
    }
  }
}

TEST(Pane, LetsLightStraightThroughFromBothSides) {
  const Bsdf bsdf = test::pane(1.5);
  for (const double z : {0.8, -0.8}) {
    const Vec3d wo = direction(z);
    const auto through = sample(bsdf, wo, 0.9, {}, Mode::radiance);
    EXPECT_EQ(through->wi, -wo);
    EXPECT_EQ(through->side, Side::straight);
    EXPECT_EQ(through->relative_index, 1.0);
    EXPECT_FLOAT_EQ(through->weight[0], 1.0f);
    const auto back = sample(bsdf, wo, 0.01, {}, Mode::importance);
    EXPECT_EQ(back->wi, Vec3d(-wo.x, -wo.y, wo.z));
    EXPECT_EQ(back->side, Side::reflected);
  }
}

// What light sampling takes for passing through is the mean of what samples do.
TEST(Pane, PassesLightOnAsItsSamplesDo) {
  const SampledSpectrum color(1.0f, 0.8f, 0.3f, 0.0f);
  const Bsdf dirty = mixture(test::pane(1.5, color), Diffuse{white}, 0.4);
  for (const Bsdf& bsdf : {test::pane(1.5, color), dirty}) {
    const Vec3d wo = direction(-0.4);
    constexpr int samples = 10000;
    SampledSpectrum sum;
    for (int i = 0; i < samples; ++i) {
      const auto s = sample(bsdf, wo, (i + 0.5) / samples, {0.3, 0.6}, Mode::radiance);
      if (s && s->side == Side::straight) sum += s->weight;
    }
    const SampledSpectrum through = straight_through(bsdf, wo);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(sum[k] / samples, through[k], 1e-3);
  }
  EXPECT_TRUE(straight_through(test::glass(1.5, 0.0), direction(0.5)).is_zero());
  EXPECT_TRUE(straight_through(Diffuse{white}, direction(0.5)).is_zero());
}

// The mean number of each lobe's samples is its share: nothing of a specular lobe may be lost or
// counted twice beside others.
TEST(Mixture, ShowsSpecularLobesBesideOthers) {
  const Bsdf bsdf = mixture(white_mirror(), Diffuse{white}, 0.25);
  const Vec3d wo = direction(0.6);
  const auto mirrored = sample(bsdf, wo, 0.74, {0.2, 0.3}, Mode::radiance);
  EXPECT_EQ(mirrored->lobe, Lobe::specular);
  EXPECT_FLOAT_EQ(mirrored->weight[0], 1.0f);
  const auto diffuse = sample(bsdf, wo, 0.76, {0.2, 0.3}, Mode::radiance);
  EXPECT_EQ(diffuse->lobe, Lobe::diffuse);
  EXPECT_NEAR(diffuse->pdf, 0.25 * pdf_cosine_hemisphere(diffuse->wi.z), 1e-12);
  EXPECT_FLOAT_EQ(evaluate(bsdf, wo, wo, Mode::radiance)[0],
                  static_cast<float>(0.25 * 0.6 * inv_pi));
}

TEST(Mixture, ShowsItsOpaquePartToTheInside) {
  const Bsdf bsdf = mixture(test::pane(1.5), Diffuse{white}, 0.5);
  const Vec3d wo = direction(-0.6), wi = direction(-0.3, 2.0);
  EXPECT_GT(evaluate(bsdf, wo, wi, Mode::radiance)[0], 0.0f);
  EXPECT_EQ(evaluate(bsdf, wo, -wi, Mode::radiance)[0], 0.0f);
  const Bsdf opaque = mixture(Diffuse{white}, white_mirror(), 0.5);
  EXPECT_EQ(evaluate(opaque, wo, wi, Mode::radiance)[0], 0.0f);
  EXPECT_FALSE(sample(opaque, wo, 0.1, {0.5, 0.5}, Mode::radiance));
}

}  // namespace
}  // namespace lapidary::bsdf
