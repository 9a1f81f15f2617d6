#include <gtest/gtest.h>

#include "light/lights.h"
#include "support/random.h"
#include "support/statistics.h"

namespace lapidary::light {
namespace {

using lapidary::test::Random;
using lapidary::test::RunningMean;
using test::Box;
using test::Cylinder;
using test::PlacedSolid;
using test::TriangleMesh;
using test::white;

// On the ground at `p`, normal `n`, from a light of radiance 1 [W/(m2 nm)], by sampling.
RunningMean irradiance(const Light& light, Vec3d p, Vec3d n, int samples = 100000) {
  Random random(11);
  RunningMean mean;
  for (int i = 0; i < samples; ++i) {
    const double part = random.uniform();
    const auto s = sample_illumination(light, p, {part, random.uniform2()}, test::wavelengths());
    mean.add(s ? std::max(0.0, dot(s->wi, n)) * s->L[1] / s->pdf : 0.0);
  }
  return mean;
}

// 3 standard errors, as the closed forms are exact; a zero-variance estimator is held to rounding.
// About 20 tests of fixed seeds: a false-alarm rate of 5 % when first written, none since.
void expect_irradiance(const Light& light, Vec3d p, Vec3d n, double expected) {
  const auto result =
      lapidary::test::z_test(irradiance(light, p, n), expected, 3.0, 1e-5 * expected + 1e-12);
  EXPECT_TRUE(result.accepted) << result.message;
}

TEST(Irradiance, UnderASphereIsPiLSinSquared) {
  for (const double distance : {1.01, 2.0, 50.0}) {
    const Light light = SphereLight({0, 0, distance}, 1.0, white());
    expect_irradiance(light, {}, {0, 0, 1}, pi / (distance * distance));
  }
  // Tilted, all of it above the horizon.
  const Light light = SphereLight({3, 0, 4}, 1.0, white());
  expect_irradiance(light, {}, {0, 0, 1}, pi / 25.0 * 0.8);
}

// Lambert's formula: half the sum over edges of the angle they span, times the cosine between the
// ground's normal and the normal of the plane through the edge and the point.
double polygon_irradiance(const std::vector<Vec3d>& corners, Vec3d p, Vec3d n) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = normalize(corners[i] - p);
    const Vec3d b = normalize(corners[(i + 1) % corners.size()] - p);
    sum += std::acos(dot(a, b)) * dot(normalize(cross(a, b)), n);
  }
  return 0.5 * std::abs(sum);
}

TEST(Irradiance, UnderARectangleIsLamberts) {
  const Vec3d corner(-1, -2, 3), u(3, 0, 1), v(0, 2.5, 0), oblique(0.7, 2.5, 0);
  const Vec3d n = normalize(Vec3d(0.1, 0.2, 1));
  for (const Vec3d edge : {v, oblique}) {
    // The front is down.
    const Light light = RectangleLight({corner, edge, u}, white());
    for (const Vec3d p : {Vec3d(0, 0, 0), Vec3d(0.4, -0.7, 2.6), Vec3d(4, 3, -20)}) {
      const std::vector<Vec3d> corners{corner, corner + edge, corner + edge + u, corner + u};
      expect_irradiance(light, p, n, polygon_irradiance(corners, p, n));
    }
  }
}

TEST(Irradiance, UnderALeftHandedRectangleIsThatOfItsFront) {
  const Light light =
      RectangleLight({{-1, -1, 2}, {2, 0, 0}, {0, 2, 0}, geometry::Handedness::left}, white());
  const std::vector<Vec3d> corners{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}};
  expect_irradiance(light, {}, {0, 0, 1}, polygon_irradiance(corners, {}, {0, 0, 1}));
}

TEST(Irradiance, UnderADiskIsItsClosedForm) {
  // On the axis pi L sin^2; off it, parallel: pi L / 2 (1 - (h^2 + x^2 - r^2) / root).
  const double h = 1.5, r = 0.8;
  const Light light = DiskLight({{0, 0, h}, {0, 0, -1}, r}, white());
  expect_irradiance(light, {}, {0, 0, 1}, pi * r * r / (r * r + h * h));
  for (const double x : {0.5, 2.0}) {
    const double a = h * h + x * x - r * r, b = h * h + x * x + r * r;
    const double root = std::sqrt(b * b - 4 * r * r * x * x);
    EXPECT_NEAR(root, std::sqrt(a * a + 4 * r * r * h * h), 1e-12);
    expect_irradiance(light, {x, 0, 0}, {0, 0, 1}, 0.5 * pi * (1 - a / root));
  }
}

TEST(Irradiance, UnderAMeshIsThatOfItsTriangles) {
  const Transform over = Transform::translation({0, 0, 2}) * Transform::rotation({1, 0, 0}, pi);
  const std::vector<std::uint32_t> flat{0, 1};
  const std::vector<Vec3d> square{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}};
  const double expected = polygon_irradiance(square, {0.5, 0, 0}, {0, 0, 1});
  expect_irradiance(MeshLight(test::roof(), flat, over, white()), {0.5, 0, 0}, {0, 0, 1}, expected);
  // A mirror keeps fronts: mirrored in z the square's front looks down.
  const Transform mirrored = Transform::translation({0, 0, 2}) * Transform::scaling({1, 1, -1});
  expect_irradiance(MeshLight(test::roof(), flat, mirrored, white()), {0.5, 0, 0}, {0, 0, 1},
                    expected);
}

TEST(Irradiance, UnderSolidsIsThatOfTheirSilhouette) {
  // A box seen from below its middle is its lower face, however it is scaled.
  const Transform place = Transform::translation({0, 0, 3}) * Transform::scaling({2, 3, 2});
  const Light box = SolidLight(PlacedSolid(Box{}, place), white());
  const std::vector<Vec3d> face{{-1, -1.5, 2}, {1, -1.5, 2}, {1, 1.5, 2}, {-1, 1.5, 2}};
  expect_irradiance(box, {0.3, 0, 0}, {0, 0, 1}, polygon_irradiance(face, {0.3, 0, 0}, {0, 0, 1}));
  // A cylinder seen along its axis is its near cap.
  const Light cylinder =
      SolidLight(PlacedSolid(Cylinder{{0, 0, 2}, {0, 0, 9}, 0.5}, Transform()), white());
  expect_irradiance(cylinder, {}, {0, 0, 1}, pi * 0.25 / 4.25);
  // A solid sphere, sampled by area, is the sphere light.
  const Light ball =
      SolidLight(PlacedSolid(geometry::Sphere{{0, 0, 2}, 1.0}, Transform()), white());
  expect_irradiance(ball, {}, {0, 0, 1}, pi / 4.0);
}

TEST(Irradiance, UnderPointsFallsWithTheSquare) {
  const Vec3d n(0, 0, 1);
  expect_irradiance(PointLight{{3, 0, 4}, white(5.0f)}, {}, n, 5.0 / 25.0 * 0.8);
  const SpotLight::Cone cone{{0, 0, -2}, radians(10), radians(30)};
  const Light spot = SpotLight({0, 0, 2}, cone, white(6.0f));
  expect_irradiance(spot, {}, n, 6.0 / 4.0);
  const auto at_angle = [&](double degrees) {
    return irradiance(spot, {2.0 * std::tan(radians(degrees)), 0, 0}, n, 1).mean();
  };
  const double full = at_angle(9.9) / std::pow(std::cos(radians(9.9)), 3);
  EXPECT_NEAR(full, 1.5, 1e-6);
  EXPECT_EQ(at_angle(30.1), 0.0);
  // Half-way in cosine the smooth step is a half.
  const double half = std::acos(0.5 * (std::cos(radians(10)) + std::cos(radians(30))));
  EXPECT_NEAR(at_angle(degrees(half)) / std::pow(std::cos(half), 3), 0.75, 1e-6);
}

TEST(Irradiance, UnderASunIsAsStated) {
  const Vec3d towards = normalize(Vec3d(1, 2, 3));
  for (const double radius : {0.0, 1e-7, 0.00465, 0.4}) {
    const Light sun = DistantLight({towards, radius}, white(7.0f));
    expect_irradiance(sun, {1, 2, 3}, towards, 7.0);
    expect_irradiance(sun, {1, 2, 3}, {0, 0, 1}, 7.0 * towards.z);
    EXPECT_EQ(is_delta(sun), radius == 0.0);
  }
}

TEST(Irradiance, UnderAConstantSkyIsPiL) {
  expect_irradiance(ConstantEnvironment{white(2.0f)}, {}, normalize(Vec3d(1, 1, 1)), 2.0 * pi);
  const Light picture = ImageEnvironment({4, std::vector<Rgb>(8, Rgb{1, 1, 1}), 0.3});
  const double d65 = test::wavelengths().d65()[1];
  expect_irradiance(picture, {}, normalize(Vec3d(1, 1, 1)), pi * d65);
}

TEST(Irradiance, UnderAPictureIsThatOfUniformSampling) {
  const ImageEnvironment sky(test::sky());
  const Vec3d n = normalize(Vec3d(0.2, -0.5, 1));
  Random random(3);
  RunningMean uniform;
  for (int i = 0; i < 400000; ++i) {
    const Vec3d wi = random.direction();
    uniform.add(4 * pi * std::max(0.0, dot(wi, n)) * sky.emitted(wi, {}, test::wavelengths())[1]);
  }
  const RunningMean sampled = irradiance(sky, {}, n);
  const double error = std::hypot(uniform.standard_error(), sampled.standard_error());
  EXPECT_NEAR(sampled.mean(), uniform.mean(), 3.0 * error);
  EXPECT_LT(sampled.standard_error(), 0.5 * uniform.standard_error());
}

// Power is what a closed surface around the light receives.
TEST(Power, IsTheFluxThroughASphereAround) {
  const double radius = 6.0;
  const std::vector<Light> lights{SphereLight({0, 0, 0.5}, 0.7, white()),
                                  RectangleLight({{-1, -1, 0}, {2, 0, 0}, {0.3, 1, 0}}, white()),
                                  DiskLight({{1, 0, 0}, {1, 2, 0}, 1.3}, white()),
                                  MeshLight(TriangleMesh(), Transform(), white()),
                                  SolidLight(PlacedSolid(Cylinder{}, Transform()), white()),
                                  PointLight{{1, 1, 0}, white()},
                                  SpotLight({0, 0, 1}, {{1, 0, 1}, 0.3, 0.9}, white())};
  Random random(5);
  for (const Light& light : lights) {
    RunningMean flux;
    for (int i = 0; i < 100000; ++i) {
      const Vec3d out = random.direction();
      const double part = random.uniform();
      const auto s =
          sample_illumination(light, radius * out, {part, random.uniform2()}, test::wavelengths());
      const double cosine = s ? std::max(0.0, -dot(s->wi, out)) : 0.0;
      flux.add(s ? 4 * pi * radius * radius * cosine * s->L[0] / s->pdf : 0.0);
    }
    // White radiance is 1 per nm over 470 nm.
    EXPECT_NEAR(power(light, 1.0) / 470.0, flux.mean(), 3.5 * flux.standard_error() + 1e-9)
        << light.index();
  }
}

TEST(Power, OfInfiniteLightsIsWhatTheSceneCatches) {
  EXPECT_NEAR(power(ConstantEnvironment{white()}, 3.0), 470 * 4 * pi * pi * 9, 1e-6);
  EXPECT_NEAR(power(DistantLight({}, white()), 3.0), 470 * pi * 9, 1e-6);
  // A picture of white has D65's unit integral.
  const Light picture = ImageEnvironment({4, std::vector<Rgb>(8, Rgb{1, 1, 1}), 0.3});
  EXPECT_NEAR(power(picture, 3.0), 4 * pi * pi * 9, 1e-3);
}

}  // namespace
}  // namespace lapidary::light
