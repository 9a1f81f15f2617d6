#include <gtest/gtest.h>

#include "math/frame.h"
#include "transport/probe.h"
#include "transport/vertex.h"

namespace lapidary::test {
namespace {

using transport::Interreflection;

// An integrating sphere: a matte cavity of radius 1 with a black light of radius r in its middle.
// The walls see the light with the share f = r^2 of their view and one another with the rest,
// uniformly, so after k scatterings their radiance is rho f L sum over i < k of (rho (1 - f))^i.
struct Cavity {
  double albedo = 0.9;
  double light_radius = 0.6;
  double L = 10.0;

  scene::Scene build() const {
    return TinyScene()
        .add_outside(geometry::Sphere{}, matte(albedo))
        .add(geometry::Sphere{{}, light_radius}, lamp(L))
        .build();
  }
  double wall(int scatterings) const {
    const double f = light_radius * light_radius, q = albedo * (1.0 - f);
    return albedo * f * L * (1.0 - std::pow(q, scatterings)) / (1.0 - q);
  }
};

const geometry::Ray past_the_light = ray({0, 0, -0.8}, {1, 0.2, 0.1});

TEST(Interreflection, InACavityIsTheGeometricSeries) {
  const Cavity cavity;
  const scene::Scene scene = cavity.build();
  for (const int depth : {1, 2, 3, 10}) {
    SCOPED_TRACE(depth);
    expect_radiance(radiance(scene, past_the_light, {{depth}, 256, 64}), cavity.wall(depth));
  }
}

// Roulette ends paths without ending their light: of a white cavity, where it never plays, of grey
// ones, and of one that is nearly black.
TEST(Interreflection, IsKeptByRoulette) {
  for (const double albedo : {1.0, 0.95, 0.5, 0.05}) {
    const Cavity cavity{albedo, 0.6, 1.0};
    SCOPED_TRACE(albedo);
    expect_radiance(radiance(cavity.build(), past_the_light, {{10000}, 256, 128}),
                    cavity.wall(10000));
  }
}

TEST(Interreflection, ShowsNothingButLightsAtDepthZero) {
  const Cavity cavity;
  const scene::Scene scene = cavity.build();
  EXPECT_EQ(radiance(scene, past_the_light, {{0}, 4, 4}).mean(), 0.0);
  EXPECT_EQ(radiance(scene, ray({0, 0, -0.8}, {0, 0, 1}), {{0}, 4, 4}).mean(), 10.0);
}

// The reflection of a rectangular light in metal, without any sampling: the BSDF's values summed
// over a fine grid on the light.
double reflected_light(const geometry::Rectangle& light, const bsdf::Bsdf& metal, Vec3d wo) {
  constexpr int steps = 250;
  const Vec3d area = cross(light.edge_u, light.edge_v) / static_cast<double>(steps * steps);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const Vec3d p =
          light.corner + light.edge_u * ((i + 0.5) / steps) + light.edge_v * ((j + 0.5) / steps);
      const double d2 = length_squared(p);
      const Vec3d wi = p / std::sqrt(d2);
      const double f_cos =
          static_cast<double>(evaluate(metal, wo, wi, bsdf::Mode::radiance).average());
      sum += f_cos * std::max(0.0, -dot(area, wi)) / d2;
    }
  }
  return sum;
}

// Light sampling is good at small lights on rough metal, chance at large ones on smooth metal;
// their weighted sum must be right for all. The metal mirrors the camera into the light's middle
// or past its rim.
TEST(MultipleImportance, OfALightInGlossyMetalIsTheIntegral) {
  const Vec3d eye{0, -2, 1.5};
  for (const double roughness : {0.15, 0.4, 0.8}) {
    for (const double half : {0.05, 0.5, 3.0}) {
      for (const double aside : {0.0, 0.6}) {
        const Vec3d middle{aside, 2, 1.5};
        const geometry::Rectangle light{
            middle + Vec3d{-half, 0, -half}, {2 * half, 0, 0}, {0, 0, 2 * half}};
        TinyScene tiny;
        tiny.add(geometry::HalfSpace{}, metal(0.8, roughness)).add(light, lamp(1.0));
        const scene::Scene scene = tiny.build();

        const auto wavelengths = Wavelengths::sample(0.3);
        const texture::Lookup anywhere;
        const bsdf::Metal metallic{texture::Color(grey(0.8)), roughness};
        const auto surface = bsdf::make_bsdf(metallic, {anywhere, wavelengths});
        // The part of the light below the ground's horizon shows nothing; its grid must not try.
        geometry::Rectangle above = light;
        const double bottom = std::max(light.corner.z, 0.0);
        above.edge_v.z -= bottom - above.corner.z;
        above.corner.z = bottom;
        const double expected = reflected_light(above, surface, normalize(eye));
        SCOPED_TRACE(testing::Message() << roughness << ' ' << half << ' ' << aside);
        const RunningMean seen = radiance(scene, ray_to(eye, {}), {{1}, 64, 128});
        const auto result = z_test(seen, expected, 3.0, 2e-3 * expected);
        EXPECT_TRUE(result.accepted) << result.message;
        EXPECT_LT(seen.standard_error(), 0.01 * expected);
      }
    }
  }
}

// What is seen by reflection in a mirror is as bright as directly, in both integrators.
TEST(DirectIntegrator, LooksIntoMirrorsAndThroughGlass) {
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, metal(1.0));
  tiny.add(geometry::Rectangle{{-5, 4, -5}, {10, 0, 0}, {0, 0, 10}}, matte(0.8)).sky(1.0);
  const scene::Scene scene = tiny.build();
  const Vec3d wall{0.5, 4, 1};
  for (const auto interreflection : {Interreflection::none, Interreflection::full}) {
    const Probe probe{{16, interreflection}, 64, 64};
    const RunningMean direct = radiance(scene, ray_to({0, 0, 1}, wall), probe);
    const RunningMean mirrored =
        radiance(scene, ray_to({0, 0, 1}, {wall.x, wall.y, -wall.z}), probe);
    EXPECT_NEAR(direct.mean(), mirrored.mean(),
                3.0 * std::hypot(direct.standard_error(), mirrored.standard_error()) + 1e-9);
  }
}

}  // namespace
}  // namespace lapidary::test
