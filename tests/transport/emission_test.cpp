#include <gtest/gtest.h>

#include "transport/probe.h"

namespace lapidary::test {
namespace {

using description::Quantity;
using geometry::Disk;
using geometry::Rectangle;
using geometry::Sphere;

double seen(const TinyScene& tiny, const geometry::Ray& along, int max_depth = 16) {
  return radiance(tiny.build(), along, {{max_depth}, 4, 4}).mean();
}

TEST(Emission, IsSeenAsStated) {
  const Vec3d eye{0.2, -5, 0.1};
  const auto both_sides = [&](const TinyScene& tiny) {
    return std::pair{seen(tiny, ray_to(eye, {})), seen(tiny, ray_to(-eye, {}))};
  };
  using Sides = std::pair<double, double>;
  const Disk disk{{0, 0, 0}, {0, -1, 0}, 1};
  const Rectangle square{{-1, 0, -1}, {2, 0, 0}, {0, 0, 2}};  // the front looks to -y
  const Transform tip = Transform::rotation({1, 0, 0}, 0.5 * pi);
  const Transform mirror = Transform::mirror({0, 1, 0});
  const auto light = lamp(2.5);
  // Solids shine outward.
  EXPECT_EQ(both_sides(TinyScene().add(Sphere{}, light)), Sides(2.5, 2.5));
  EXPECT_EQ(both_sides(TinyScene().add(geometry::Box{}, light, tip)), Sides(2.5, 2.5));
  EXPECT_EQ(both_sides(TinyScene().add(geometry::Cylinder{}, light)), Sides(2.5, 2.5));
  // Sheets and meshes to their front, which a mirror turns with them.
  EXPECT_EQ(both_sides(TinyScene().add(disk, light)), Sides(2.5, 0.0));
  EXPECT_EQ(both_sides(TinyScene().add(square, light)), Sides(2.5, 0.0));
  EXPECT_EQ(both_sides(TinyScene().add_mesh(square_mesh(1), light, tip)), Sides(2.5, 0.0));
  EXPECT_EQ(both_sides(TinyScene().add(disk, light, mirror)), Sides(0.0, 2.5));
  EXPECT_EQ(both_sides(TinyScene().add(square, light, mirror)), Sides(0.0, 2.5));
  EXPECT_EQ(both_sides(TinyScene().add_mesh(square_mesh(1), light, mirror * tip)), Sides(0.0, 2.5));
  // The sky is behind everything; from inside a solid light there is nothing to see.
  EXPECT_EQ(both_sides(TinyScene().sky(0.75)), Sides(0.75, 0.75));
  EXPECT_EQ(seen(TinyScene().add(Sphere{}, light), ray({}, {0, 0, 1})), 0.0);
}

// A light's power is what leaves it: radiance x area x pi, the area in square metres.
TEST(Emission, OfPowerIsSpreadOverTheArea) {
  const double watts = 100.0;
  const auto light = material(description::Emissive{{Quantity::power, grey(watts)}});
  const Transform grown = Transform::scaling({2, 2, 2});
  const Transform tip = Transform::rotation({1, 0, 0}, 0.5 * pi);
  const Rectangle square{{-1, 0, -1}, {2, 0, 0}, {0, 0, 2}};
  for (const double metres : {1.0, 0.001}) {
    const auto expect = [&](TinyScene tiny, double area) {
      tiny.description.metres_per_unit = metres;
      const double expected = watts / (pi * area * metres * metres);
      EXPECT_NEAR(seen(tiny, ray_to({0.1, -5, 0.1}, {})), expected, 1e-6 * expected);
    };
    expect(TinyScene().add(Sphere{}, light), 4 * pi);
    expect(TinyScene().add(Sphere{}, light, grown), 16 * pi);
    expect(TinyScene().add(geometry::Box{}, light, Transform::scaling({1, 2, 3})), 2 * (2 + 3 + 6));
    expect(TinyScene().add(Disk{{}, {0, -1, 0}, 2}, light), 4 * pi);
    expect(TinyScene().add(square, light, grown), 16);
    expect(TinyScene().add_mesh(square_mesh(1), light, grown * tip), 16);
  }
}

// Two objects that wear the same power each have it.
TEST(Emission, OfPowerIsEachObjectsOwn) {
  const auto light = material(description::Emissive{{Quantity::power, grey(10.0)}});
  TinyScene tiny;
  tiny.add(Sphere{{-2, 0, 0}, 1}, light).add(Sphere{{2, 0, 0}, 0.5}, light);
  EXPECT_NEAR(seen(tiny, ray_to({-2, -5, 0}, {-2, 0, 0})), 10 / (4 * pi * pi), 1e-6);
  EXPECT_NEAR(seen(tiny, ray_to({2, -5, 0}, {2, 0, 0})), 10 / (pi * pi), 1e-6);
}

// Of a mesh with several materials only the triangles that shine count.
TEST(Emission, OfOnePartOfAMeshLeavesTheOthersDark) {
  description::Mesh mesh;
  geometry::TriangleMesh square = square_mesh(1);
  square.materials = {0, 1};
  mesh.triangles = std::make_shared<const geometry::TriangleMesh>(square);
  mesh.materials = {matte(1.0), material(description::Emissive{{Quantity::power, grey(10.0)}})};
  TinyScene tiny;
  tiny.add(mesh, matte(0.5));
  EXPECT_NEAR(seen(tiny, ray({-0.5, 0.5, 3}, {0, 0, -1})), 10 / (2 * pi), 1e-6);
  EXPECT_EQ(seen(tiny, ray({0.5, -0.5, 3}, {0, 0, -1})), 0.0);
}

// Lights without a surface: irradiance follows from distances in metres.
TEST(Emission, OfPointsFallsWithMetresSquared) {
  const Vec3d spot{1, 0, 0};
  const double cosine = 2.0 / std::sqrt(5.0);
  for (const double metres : {1.0, 0.001}) {
    const double d2 = 5.0 * metres * metres;
    const auto expect = [&](auto light, double intensity) {
      TinyScene tiny;
      tiny.description.metres_per_unit = metres;
      tiny.add(geometry::HalfSpace{}, matte(1.0)).light(light);
      const double expected = intensity * cosine / d2 / pi;
      EXPECT_NEAR(seen(tiny, ray_to({1, -2, 1}, spot)), expected, 1e-5 * expected);
    };
    expect(description::PointLight{{0, 0, 2}, {Quantity::power, grey(30)}}, 30 / (4 * pi));
    expect(description::PointLight{{0, 0, 2}, {Quantity::intensity, grey(30)}}, 30);
    description::SpotLight lamp{{0, 0, 2}, spot, 40, 0.5, {Quantity::intensity, grey(7)}};
    expect(lamp, 7);  // on its axis
    lamp.penumbra = 0;
    lamp.emission.quantity = Quantity::power;
    expect(lamp, 7 / (2 * pi * (1 - std::cos(radians(20)))));
  }
}

// Irradiance is stated on a surface that faces the sun, per square metre: no unit changes it.
TEST(Emission, OfTheSunIsItsIrradiance) {
  for (const double degrees : {0.0, 0.53, 20.0}) {
    TinyScene tiny;
    tiny.description.metres_per_unit = 0.001;
    tiny.add(geometry::HalfSpace{}, matte(1.0));
    tiny.light(description::DistantLight{{0, 1, -1}, degrees, {Quantity::irradiance, grey(3.0)}});
    const RunningMean L = radiance(tiny.build(), ray_to({1, 2, 1}, {}));
    expect_radiance(L, 3.0 / std::sqrt(2.0) / pi, 1e-5);
  }
}

// Fresnel's reflectance of glass of index 1.5 at right angles.
constexpr double F = 0.04;

// A pane passes T = (1 - F)^2 / (1 - F^2) with all reflections between its faces.
TEST(Emission, IsSeenThroughAPane) {
  TinyScene tiny;
  tiny.add(Rectangle{{-5, 1, -5}, {10, 0, 0}, {0, 0, 10}}, lamp(2.0));
  tiny.add(geometry::Box{{-9, -0.1, -9}, {9, 0.1, 9}}, glass(1.5));
  const RunningMean L = radiance(tiny.build(), ray({0, -2, 0}, {0, 1, 0}));
  expect_radiance(L, 2.0 * (1 - F) * (1 - F) / (1 - F * F));
}

// What shines inside glass is darker from outside by the index squared, as the same light fills
// a larger solid angle there.
TEST(Emission, IsSeenInsideGlass) {
  TinyScene tiny;
  tiny.add(Sphere{{}, 0.5}, lamp(2.0)).add(Sphere{}, glass(1.5));
  expect_radiance(radiance(tiny.build(), ray({0, -2, 0}, {0, 1, 0})), 2.0 * (1 - F) / 2.25);
}

/// The share of light that passes a smooth surface into glass of index n; Fresnel's formulas.
double passed(double sin_outside, double n) {
  const double cos_outside = std::sqrt(1 - sin_outside * sin_outside);
  const double cos_inside = std::sqrt(1 - sin_outside * sin_outside / (n * n));
  const double s = (cos_outside - n * cos_inside) / (cos_outside + n * cos_inside);
  const double p = (cos_inside - n * cos_outside) / (cos_inside + n * cos_outside);
  return 1 - 0.5 * (s * s + p * p);
}

// A lamp of radius a in a glass bulb of radius b and index n in the middle of a matte cavity of
// radius 1, lit by nothing but chance hits through the glass. Rays keep their distance p from the
// middle times the index, so those that come in at p < n a meet the lamp if they are let in, and
// all others come out again. With A the mean of what is let in over the disk of radius n a, times
// its area over pi, the lamp lights the walls by A L / n^2 and takes A of what they send.
TEST(Emission, OfALampInABulbLightsARoom) {
  const double a = 0.4, b = 0.8, n = 1.5, albedo = 0.5, L = 2.0;
  double A = 0.0;
  constexpr int rings = 2000;
  for (int i = 0; i < rings; ++i) {
    const double p = n * a * std::sqrt((i + 0.5) / rings);
    A += passed(p / b, n) * (n * a) * (n * a) / rings;
  }
  TinyScene tiny;
  tiny.add_outside(Sphere{{}, 1.0}, matte(albedo))
      .add(Sphere{{}, b}, glass(n))
      .add(Sphere{{}, a}, lamp(L));
  const RunningMean wall =
      radiance(tiny.build(), ray({0, 0, -0.9}, {1, 0, 0.05}), {{200}, 1024, 160});
  expect_radiance(wall, albedo * A * L / (n * n) / (1 - albedo * (1 - A)));
}

}  // namespace
}  // namespace lapidary::test
