#include "inspect/measure.h"

#include <numbers>

#include <gtest/gtest.h>

#include "objects.h"

namespace lapidary::inspect {
namespace {

constexpr double pi = std::numbers::pi;

Measure measure_of(const description::ObjectPtr& object) {
  Measure result;
  description::for_each_leaf(std::span(&object, 1),
                             [&](const description::Leaf& leaf) { result = measure(leaf); });
  return result;
}

TEST(Measure, ClosedFormsOfSolids) {
  const Measure ball = measure_of(make_object(geometry::Sphere{{1, 2, 3}, 2}));
  EXPECT_NEAR(ball.area.value(), 16 * pi, 1e-9);
  EXPECT_NEAR(ball.volume.value(), 32 * pi / 3, 1e-9);
  EXPECT_NEAR(ball.bounds.max.z, 5, 1e-9);
  const Measure can = measure_of(make_object(geometry::Cylinder{{0, 0, 0}, {3, 4, 0}, 2}));
  EXPECT_NEAR(can.area.value(), 2 * pi * 4 + 2 * pi * 2 * 5, 1e-9);
  EXPECT_NEAR(can.volume.value(), pi * 4 * 5, 1e-9);
  const Measure cone = measure_of(make_object(geometry::Cone{{0, 0, 0}, {3, 4, 0}, 3, 0}));
  EXPECT_NEAR(cone.volume.value(), pi * 9 * 5 / 3, 1e-9);
  const Measure bucket = measure_of(make_object(geometry::Cone{{0, 0, 0}, {0, 0, 3}, 1, 2}));
  const Measure ring = measure_of(make_object(geometry::Torus{{}, {0, 0, 1}, 3, 1}));
  EXPECT_NEAR(ring.area.value(), 4 * pi * pi * 3, 1e-9);
  EXPECT_NEAR(ring.volume.value(), 2 * pi * pi * 3, 1e-9);
  // Two cones, tip to tip away from each other.
  const Measure top = measure_of(make_object(geometry::Superellipsoid{{}, {3, 3, 4}, 1, 2}));
  EXPECT_NEAR(top.area.value(), 2 * pi * 3 * 5, 1e-7);
  EXPECT_NEAR(top.volume.value(), 2 * pi * 9 * 4 / 3, 1e-9);
  EXPECT_NEAR(bucket.volume.value(), pi * (4 * 6 - 1 * 3) / 3,
              1e-9);  // the difference of two cones
}

TEST(Measure, FollowsTheTransform) {
  const Transform stretch = Transform::scaling({2, 3, -4});
  const Measure box = measure_of(make_object(geometry::Box{}, stretch));
  EXPECT_NEAR(box.volume.value(), 24, 1e-9);
  EXPECT_NEAR(box.area.value(), 2 * (6 + 8 + 12), 1e-9);
  const Measure mesh = measure_of(make_object(shared(cube_mesh()), stretch));
  EXPECT_NEAR(mesh.volume.value(), 24, 1e-9);
  EXPECT_NEAR(mesh.area.value(), 2 * (6 + 8 + 12), 1e-9);
  const Measure disk = measure_of(make_object(geometry::Disk{}, stretch));
  EXPECT_NEAR(disk.area.value(), 6 * pi, 1e-9);
  EXPECT_FALSE(disk.volume);
}

TEST(Measure, AMeshFarAwayKeepsItsVolume) {
  const Measure mesh =
      measure_of(make_object(shared(cube_mesh()), Transform::translation({1e6, -1e6, 1e6})));
  EXPECT_NEAR(mesh.volume.value(), 1, 1e-8);
}

TEST(Measure, AnInsideOutMeshHasNegativeVolume) {
  geometry::TriangleMesh mesh = cube_mesh();
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  EXPECT_NEAR(measure_of(make_object(shared(mesh))).volume.value(), -1, 1e-12);
}

TEST(Measure, QuadricsAreMeasuredWhereTheyAreEllipsoids) {
  const auto with = [](Vec3d squares) {
    return geometry::Quadric{
        std::make_shared<geometry::QuadraticForm>(squares, Vec3d{}, Vec3d{}, -1)};
  };
  const Measure lens = measure_of(make_object(with({1, 1, 4}), Transform::scaling({1, 1, 2})));
  EXPECT_NEAR(lens.volume.value(), 4 * pi / 3, 1e-9);
  EXPECT_NEAR(lens.area.value(), 4 * pi, 1e-9);
  const Measure pipe = measure_of(make_object(with({1, 1, 0})));
  EXPECT_FALSE(pipe.area);
  EXPECT_FALSE(pipe.volume);
  EXPECT_NEAR(pipe.bounds.max.x, 1, 1e-12);
  EXPECT_EQ(pipe.bounds.max.z, infinity);
}

TEST(Measure, HalfSpacesHaveNeitherAreaNorVolume) {
  const Measure ground = measure_of(make_object(geometry::HalfSpace{}));
  EXPECT_FALSE(ground.area);
  EXPECT_FALSE(ground.volume);
}

}  // namespace
}  // namespace lapidary::inspect
