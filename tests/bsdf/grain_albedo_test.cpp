#include "bsdf/grain_albedo.h"

#include <algorithm>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "bsdf/facet_albedo.h"
#include "bsdf/fresnel.h"
#include "bsdf/surfaces.h"
#include "support/random.h"

namespace lapidary::bsdf {
namespace {

using lapidary::test::Random;
using test::direction;
using Part = GrainAlbedo::Part;

constexpr Part parts[] = {Part::lost_by_metal, Part::reflected_by_coat, Part::lost_by_glass};

/// One that is to be known, in what light.
struct Case {
  Part part;
  double eta;
};
Case random_case(Random& random) {
  const Part part = parts[random.index(3)];
  const double index = random.uniform(1.2, 2.4);
  const bool inside = part == Part::lost_by_glass && random.uniform() < 0.5;
  return {part, part == Part::lost_by_metal ? 1.0 : inside ? 1.0 / index : index};
}
Grain random_grain(Random& random) {
  const double roughness = random.uniform(0.03, 1.0);
  return {roughness * roughness, random.uniform(), random.uniform(-3.0, 3.0)};
}

double by_quadrature(const Case& c, const Ggx& facets, Vec3d v) {
  switch (c.part) {
    case Part::lost_by_metal:
      return loss_of_white_facets(facets, v);
    case Part::reflected_by_coat:
      return reflected_by_facets(facets, v, c.eta);
    case Part::lost_by_glass:
      break;
  }
  return loss_of_facets(facets, v, c.eta);
}
double by_table(const Case& c, const GrainAlbedo& albedo, const Ggx& facets, Vec3d v) {
  const double smooth = c.part == Part::reflected_by_coat ? refract(v.z, c.eta).reflectance : 1.0;
  return smooth * albedo.at(facets, v);
}

/// Of light from wo that reaches a facet with the normal h, the shares that are reflected, or
/// refracted, and leave.
Vec2d leaving(const Ggx& facets, Vec3d wo, Vec3d h, double eta) {
  const double cosine = std::min(dot(wo, h), 1.0);
  const Refraction facet = refract(cosine, eta);
  const Vec3d up = 2.0 * cosine * h - wo;
  const Vec3d down = (cosine / eta - facet.cos_refracted) * h - wo * (1.0 / eta);
  const double back =
      up.z > 0.0 ? 2.0 * (wo.z + facets.slant(wo)) * facets.reflection_share(wo, up) : 0.0;
  const double on = down.z < 0.0 ? facets.visible_share({down.x, down.y, -down.z}) : 0.0;
  return {back, (1.0 - facet.reflectance) * on + facet.reflectance * back};
}

/// The mean over visible normals, one by one, on a lattice.
double one_by_one(const Case& c, const Ggx& facets, Vec3d wo) {
  constexpr int points = 4181, previous = 2584;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const Vec2d u{(i + 0.5) / points, std::fmod((i + 0.5) * previous / points, 1.0)};
    const Vec3d h = facets.sample_visible(wo, u);
    const double eta = c.part == Part::lost_by_metal ? 1e9 : c.eta;
    const Vec2d shares = leaving(facets, wo, h, eta);
    switch (c.part) {
      case Part::lost_by_metal:
        sum += 1.0 - shares.x;
        break;
      case Part::reflected_by_coat:
        sum += refract(std::min(dot(wo, h), 1.0), eta).reflectance * shares.x;
        break;
      case Part::lost_by_glass:
        sum += 1.0 - shares.y;
        break;
    }
  }
  return sum / points;
}

TEST(FacetAlbedo, IsTheMeanOverVisibleFacets) {
  Random random(21);
  double worst = 0.0, sum = 0.0;
  constexpr int tests = 300;
  for (int i = 0; i < tests; ++i) {
    const Case c = random_case(random);
    const Ggx facets(random_grain(random));
    const Vec3d v = direction(random.magnitude(-2.0, 0.0), random.uniform(0.0, 6.0));
    const double error = std::abs(by_quadrature(c, facets, v) - one_by_one(c, facets, v));
    worst = std::max(worst, error);
    sum += error;
  }
  EXPECT_LT(worst, 0.012);
  EXPECT_LT(sum / tests, 0.001);
}

TEST(FacetAlbedo, IsContinuousDownToTheHorizonAndUpToTheNormal) {
  for (const Part part : parts) {
    const Case c{part, part == Part::lost_by_metal ? 1.0 : 0.7};
    for (const Grain& grain : {Grain(0.001, 0.5), Grain(0.3, 1.0, 0.4), Grain(1.0, 0.9)}) {
      const Ggx facets(grain);
      EXPECT_NEAR(by_quadrature(c, facets, direction(0.0)),
                  by_quadrature(c, facets, direction(1e-9)), 1e-4);
      EXPECT_NEAR(by_quadrature(c, facets, {0, 0, 1}),
                  by_quadrature(c, facets, direction(1.0 - 1e-12)), 0.006);
    }
  }
}

TEST(GrainDirections, FindDirectionsAgain) {
  Random random(22);
  for (int i = 0; i < 1000; ++i) {
    const double eta = i % 2 == 0 ? 1.0 : random.uniform(0.3, 0.99);
    const Grain grain(random.uniform(0.001, 1.0), random.uniform(0.01, 1.0));
    const GrainDirections directions(grain, eta);
    const Vec3d v = abs(random.direction());
    const auto place = directions.of(Ggx(grain), v);
    EXPECT_GE(place.across, 0.0);
    EXPECT_LE(place.across, 1.0);
    EXPECT_NEAR(length(directions.at(place) - v), 0.0, 1e-6);
  }
}

TEST(GrainAlbedo, KnowsWhatQuadratureFinds) {
  Random random(23);
  std::vector<double> errors;
  for (int i = 0; i < 60; ++i) {
    const Case c = random_case(random);
    const Grain grain = random_grain(random);
    const Ggx facets(grain);
    const GrainAlbedo albedo(c.part, grain, c.eta);
    for (int k = 0; k < 50; ++k) {
      const Vec3d v = direction(random.uniform(0.01, 1.0), random.uniform(0.0, 6.0));
      errors.push_back(std::abs(by_table(c, albedo, facets, v) - by_quadrature(c, facets, v)));
    }
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() * 99 / 100], 0.008);
  EXPECT_LT(errors.back(), 0.03);
}

// What bounces make up for goes by the average: it has to be that of what is said of directions,
// relative to itself, however little it is.
TEST(GrainAlbedo, HasTheAverageOfItsDirections) {
  Random random(24);
  for (int i = 0; i < 30; ++i) {
    const Case c = random_case(random);
    const Grain grain = random_grain(random);
    const Ggx facets(grain);
    const GrainAlbedo albedo(c.part, grain, c.eta);
    // Even steps of the logarithm of z; d(z^2) = 2 z^2 d(log z).
    double sum = 0.0;
    constexpr int steps = 400, turns = 40;
    const double range = std::log(1e5) / steps;
    for (int k = 0; k < steps; ++k) {
      const double z = std::exp(-(k + 0.5) * range);
      for (int t = 0; t < turns; ++t) {
        const Vec3d v = direction(z, 2.0 * pi * (t + 0.3) / turns);
        sum += 2.0 * z * z * range * by_table(c, albedo, facets, v) / turns;
      }
    }
    EXPECT_NEAR(albedo.average() / sum, 1.0, 0.06) << grain.alpha << " " << grain.anisotropy;
  }
}

// Threads that find a table missing make it at once, and go on with the one that is kept.
TEST(GrainAlbedo, IsTheSameForThreadsThatAskAtOnce) {
  const Grain grain(0.456, 0.321);
  const Ggx facets(grain);
  const Vec3d v = direction(0.3, 1.0);
  std::array<double, 4> values{};
  {
    std::vector<std::jthread> threads;
    for (double& value : values) {
      threads.emplace_back(
          [&] { value = GrainAlbedo(Part::lost_by_metal, grain, 1.0).at(facets, v); });
    }
  }
  for (const double value : values) EXPECT_EQ(value, values[0]);
  EXPECT_EQ(GrainAlbedo(Part::lost_by_metal, grain, 1.0).at(facets, v), values[0]);
}

}  // namespace
}  // namespace lapidary::bsdf
