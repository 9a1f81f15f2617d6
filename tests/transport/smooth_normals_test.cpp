#include <gtest/gtest.h>

#include "transport/probe.h"

namespace lapidary::test {
namespace {

/// A flat square at z = 0 whose vertices all claim `normal`.
geometry::TriangleMesh square_with_normal(Vec3d normal) {
  geometry::TriangleMesh mesh = square_mesh(1);
  mesh.normals.assign(mesh.positions.size(), Vec3f(normalize(normal)));
  return mesh;
}

// Smooth normals turn the light, not the surface: what stands behind the surface stays there, for
// light sampling as for chance.
TEST(SmoothNormals, LetNoLightThroughOpaqueSurfaces) {
  for (const auto& worn : {matte(0.8), metal(0.8, 0.5), metal(0.8)}) {
    TinyScene tiny;
    tiny.add_mesh(square_with_normal({1, 0, 0.3}), worn);
    tiny.add(geometry::Sphere{{3, 0, -1}, 0.8},
             lamp(10.0));  // before the normal, behind the square
    const scene::Scene scene = tiny.build();
    for (const Vec3d eye : {Vec3d{1, 0, 2}, Vec3d{0, 1, 0.5}, Vec3d{-1, 0.2, 1}}) {
      EXPECT_EQ(radiance(scene, ray_to(eye, {0.1, 0.1, 0})).mean(), 0.0);
    }
  }
}

// From where only the surface is seen and not the side that its normal claims, the surface is
// still lit.
TEST(SmoothNormals, LeaveNoBlackPatches) {
  const scene::Scene scene =
      TinyScene().add_mesh(square_with_normal({1, 0, 0.3}), matte(0.8)).sky(1.0).build();
  expect_radiance(radiance(scene, ray_to({-3, 0, 0.5}, {0, 0, 0})), 0.8);
  // And from below.
  expect_radiance(radiance(scene, ray_to({3, 0, -0.5}, {0, 0, 0})), 0.8);
}

// A coarse ball of 128 triangles is shaded as the ball that it stands for: irradiance of the sun
// times the cosine to the ball's own normal, over pi. Flat triangles would be far off.
TEST(SmoothNormals, ShadeAsTheSurfaceTheyStandFor) {
  geometry::TriangleMesh mesh = ball_mesh(2);
  mesh.normals = mesh.positions;
  const Vec3d towards_sun = normalize(Vec3d{0.3, -1, 0.5});
  const scene::Scene scene =
      TinyScene()
          .add_mesh(mesh, matte(1.0))
          .light(description::DistantLight{
              -towards_sun, 0.0, {description::Quantity::irradiance, grey(pi)}})
          .build();
  double flat_error = 0.0;
  for (int i = 0; i < 40; ++i) {
    const geometry::Ray seen = ray_to({0, -4, 0}, {0.3 * std::cos(i), 0, 0.3 * std::sin(i)});
    const geometry::Hit hit = scene.world().nearest(seen);
    const geometry::Surface surface = scene.world().surface(seen, hit);
    const double expected = dot(normalize(surface.p), towards_sun);
    EXPECT_NEAR(radiance(scene, seen, {{1}, 1, 1}).mean(), expected, 0.02);
    flat_error =
        std::max(flat_error, std::abs(dot(surface.geometric_normal, towards_sun) - expected));
  }
  EXPECT_GT(flat_error, 0.08);
}

// Glass with smooth normals loses some light where the two normals disagree, but gains none.
TEST(SmoothNormals, OfGlassGainNothing) {
  geometry::TriangleMesh mesh = ball_mesh(3);
  mesh.normals = mesh.positions;
  const scene::Scene scene = TinyScene().add_mesh(mesh, glass(1.5)).sky(1.0).build();
  for (const Vec3d to : {Vec3d{0, 0, 0}, Vec3d{0.4, 0, 0.2}, Vec3d{0.8, 0, 0}, Vec3d{0, 0, 0.98}}) {
    const RunningMean L = radiance(scene, ray_to({0, -4, 0}, to), {{200}, 64, 16});
    EXPECT_LE(L.mean(), 1.0 + 3.0 * L.standard_error() + 1e-5);
    EXPECT_GT(L.mean(), 0.9);
  }
}

}  // namespace
}  // namespace lapidary::test
