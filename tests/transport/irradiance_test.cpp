#include <gtest/gtest.h>

#include "transport/probe.h"

namespace lapidary::test {
namespace {

// A matte ground of albedo 1 shows its irradiance over pi. Light sampling and chance hits are both
// at work, weighted against each other.

constexpr Vec3d up{0, 0, 1};

/// What a camera sees of `spot` on the ground, from aside.
RunningMean seen_at(const scene::Scene& scene, Vec3d spot, const Probe& probe = {}) {
  return radiance(scene, ray_to(spot + Vec3d{-1, -2, 1.5}, spot), probe);
}

TEST(Irradiance, UnderASphereLightFallsWithTheSquareAndTheCosine) {
  const double L = 3.0, r = 0.5;
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, matte(1.0)).add(geometry::Sphere{{0, 0, 2}, r}, lamp(L));
  const scene::Scene scene = tiny.build();
  // Below it E = pi L (r/d)^2, elsewhere times the cosine.
  for (const double x : {0.0, 1.0, 4.0}) {
    const double d2 = x * x + 4.0;
    expect_radiance(seen_at(scene, {x, 0, 0}), L * r * r / d2 * (2.0 / std::sqrt(d2)));
  }
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

/// A rectangle over the ground, its front down.
const geometry::Rectangle ceiling{{-1, -0.5, 1.5}, {0, 1.5, 0}, {2, 0, 0}};

std::vector<Vec3d> corners_of(const geometry::Rectangle& r) {
  return {r.corner, r.corner + r.edge_u, r.corner + r.edge_u + r.edge_v, r.corner + r.edge_v};
}

TEST(Irradiance, UnderARectangleLightIsLamberts) {
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, matte(1.0)).add(ceiling, lamp(2.0));
  const scene::Scene scene = tiny.build();
  for (const Vec3d p : {Vec3d{0, 0, 0}, Vec3d{0.9, 0.8, 0}, Vec3d{3, -2, 0}}) {
    expect_radiance(seen_at(scene, p), 2.0 * polygon_irradiance(corners_of(ceiling), p, up) / pi);
  }
}

// Rays leave each kind of surface, and stop before each kind of flat light, in their own way.
TEST(Irradiance, OnEveryKindOfSurfaceIsTheSame) {
  const Vec3d p{0.4, 0.8, 0};
  const double expected =
      polygon_irradiance({{-1, -1, 1.5}, {1, -1, 1.5}, {1, 1, 1.5}, {-1, 1, 1.5}}, p, up) / pi;
  const Transform above = Transform::translation({0, 0, 1.5}) * Transform::rotation({1, 0, 0}, pi);
  const geometry::Rectangle square{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
  const auto check = [&](auto add_ground) {
    TinyScene under_mesh, under_sheet;
    under_mesh.add_mesh(square_mesh(1), lamp(1.0), above);
    under_sheet.add(square, lamp(1.0), above);
    for (TinyScene* tiny : {&under_mesh, &under_sheet}) {
      add_ground(*tiny);
      expect_radiance(seen_at(tiny->build(), p), expected);
    }
  };
  const geometry::Rectangle sheet{{-9, -9, 0}, {18, 0, 0}, {0, 18, 0}};
  check([&](TinyScene& s) { s.add(sheet, matte(1)); });
  check([](TinyScene& s) { s.add(geometry::Box{{-9, -9, -1}, {9, 9, 0}}, matte(1)); });
  check([](TinyScene& s) { s.add_mesh(square_mesh(9), matte(1)); });
}

// The light's own triangles must not shade what they light, however large the scene whose floats
// they share; turned, so that no coordinate is a float by chance.
TEST(Irradiance, UnderAMeshLightInAHugeSceneIsLamberts) {
  const Transform above = Transform::translation({0, 0, 1.5}) * Transform::rotation({1, 0, 0}, pi);
  const Transform turned = Transform::rotation({1, 2, 3}, 0.7);
  const double expected =
      polygon_irradiance({{-1, -1, 1.5}, {1, -1, 1.5}, {1, 1, 1.5}, {-1, 1, 1.5}}, {}, up) / pi;
  for (const double half : {10.0, 100.0, 1000.0}) {
    for (const double off_center : {0.0, 0.9 * half}) {
      TinyScene tiny;
      const Vec3d spot{off_center, 0, 0};
      tiny.add_mesh(square_mesh(1), lamp(1.0), turned * Transform::translation(spot) * above);
      tiny.add_mesh(square_mesh(half), matte(1), turned);
      const auto seen = ray_to(turned.point(spot + Vec3d{-1, -2, 1.5}), turned.point(spot));
      SCOPED_TRACE(half);
      SCOPED_TRACE(off_center);
      // Places are floats: 1000 apart, of a height of 1.5 four digits are sure.
      expect_radiance(radiance(tiny.build(), seen), expected, 1e-4);
    }
  }
}

TEST(Irradiance, UnderAConstantSkyIsPiL) {
  for (const double albedo : {1.0, 0.5}) {
    TinyScene tiny;
    tiny.add(geometry::HalfSpace{}, matte(albedo)).sky(0.7);
    expect_radiance(seen_at(tiny.build(), {}), 0.7 * albedo);
  }
}

// Lights chosen one at a time must sum to all of them.
TEST(Irradiance, UnderSeveralLightsIsTheirSum) {
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, matte(1.0)).add(ceiling, lamp(2.0));
  tiny.add(geometry::Sphere{{3, 0, 2}, 0.5}, lamp(30.0)).sky(0.5);
  tiny.light(description::PointLight{{1.2, -3, 3}, {description::Quantity::intensity, grey(10)}});
  tiny.light(
      description::DistantLight{{0, 1, -1}, 0.0, {description::Quantity::irradiance, grey(1)}});
  // At a spot behind the rectangle's rim the sky is seen but for what the two lights hide of it.
  const Vec3d p{1.2, 0, 0};
  const double rectangle = polygon_irradiance(corners_of(ceiling), p, up);
  const double d2 = 1.8 * 1.8 + 4.0;
  const double sphere = pi * 0.25 / d2 * (2.0 / std::sqrt(d2));
  const double to_point2 = 9.0 + 9.0;
  const double point = 10.0 / to_point2 * (3.0 / std::sqrt(to_point2));
  const double sun = 1.0 / std::sqrt(2.0);
  const double E = 2.0 * rectangle + 30.0 * sphere + 0.5 * (pi - rectangle - sphere) + point + sun;
  Probe probe;
  probe.samples = 256;
  expect_radiance(seen_at(tiny.build(), p, probe), E / pi);
}

// The first scattering is all that the direct integrator adds to what is seen directly.
TEST(DirectIntegrator, OfMatteSurfacesIsTheFirstScattering) {
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, matte(0.8)).add(geometry::Sphere{{0, 0, 1}, 1}, matte(0.5));
  tiny.add(geometry::Sphere{{2, 0, 2}, 0.5}, lamp(5.0)).sky(0.2);
  const scene::Scene scene = tiny.build();
  const auto run = [&](int depth, transport::Interreflection interreflection, Vec3d to) {
    const Probe probe{{depth, interreflection}, 8, 16};
    return radiance(scene, ray_to({0, -5, 2}, to), probe).mean();
  };
  using transport::Interreflection;
  for (const Vec3d to : {Vec3d{0, 0, 1}, Vec3d{-1, 0, 0}, Vec3d{1.5, -1, 0}}) {
    const double once = run(1, Interreflection::full, to);
    EXPECT_EQ(run(16, Interreflection::none, to), once);
    EXPECT_GT(run(16, Interreflection::full, to), once);
  }
}

}  // namespace
}  // namespace lapidary::test
