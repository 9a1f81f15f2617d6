#include "math/transform.h"

#include <gtest/gtest.h>

namespace lapidary {
namespace {

void expect_near(Vec3d a, Vec3d b, double tolerance = 1e-14) {
  EXPECT_NEAR(length(a - b), 0.0, tolerance) << a.x << " " << a.y << " " << a.z;
}

TEST(Transform, RotatesAboutXThenYThenZ) {
  expect_near(Transform::rotation_xyz({0, 0, radians(90)}).point({1, 0, 0}), {0, 1, 0});
  expect_near(Transform::rotation_xyz({radians(90), 0, radians(90)}).point({0, 1, 0}), {0, 0, 1});
  expect_near(Transform::rotation_xyz({radians(90), radians(90), 0}).point({0, 1, 0}), {1, 0, 0});
}

TEST(Transform, ComposesRightToLeftAndInverts) {
  const Transform t = Transform::translation({1, 2, 3}) * Transform::scaling({2, -3, 0.5}) *
                      Transform::rotation({1, 1, 0}, 0.7);
  const Vec3d p{0.3, -0.8, 2.0};
  expect_near(t.inverse().point(t.point(p)), p);
  EXPECT_EQ(t.inverse().inverse(), t);
  EXPECT_TRUE(t.mirrors());
}

TEST(Transform, NormalsStayPerpendicularAndOutward) {
  const Transform t = Transform::scaling({1, 1, -4}) * Transform::rotation({1, 0, 0}, 0.5);
  const Vec3d normal = t.normal({0, 0, 1});
  EXPECT_NEAR(dot(normal, t.vector({1, 0, 0})), 0.0, 1e-15);
  EXPECT_NEAR(dot(normal, t.vector({0, 1, 0})), 0.0, 1e-15);
  EXPECT_GT(dot(normal, t.vector({0, 0, 1})), 0.0);
}

TEST(Transform, RefusesSingularAndNonFiniteMatrices) {
  const Mat3 flat{{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{1, 1, 0}}};
  EXPECT_FALSE(Transform::affine(flat, {}));
  const Mat3 nearly{{Vec3d{0.1, 0.2, 0.3}, Vec3d{0.4, 0.5, 0.6}, Vec3d{0.7, 0.8, 0.9}}};
  EXPECT_FALSE(Transform::affine(nearly, {}));
  EXPECT_FALSE(Transform::affine(Mat3::identity(), {std::nan(""), 0, 0}));
  Mat3 tiny;
  for (auto& row : tiny.row) row *= 1e-100;
  EXPECT_TRUE(Transform::affine(tiny, {}));
}

TEST(Transform, BoxesBoundTheImageAndKeepInfinities) {
  const Box3d box{{-1, -1, -1}, {1, 1, 1}};
  const Transform t = Transform::rotation({0, 0, 1}, radians(45));
  const Box3d image = t.box(box);
  EXPECT_NEAR(image.max.x, std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(image.max.z, 1.0, 1e-15);
  Box3d slab = Box3d::all();
  slab.max.z = 0.0;
  const Box3d moved = Transform::translation({0, 0, 5}).box(slab);
  EXPECT_EQ(moved.max.z, 5.0);
  EXPECT_EQ(moved.min.x, -infinity);
}

TEST(Transform, RecognisesSimilarities) {
  const Transform t = Transform::rotation({1, 2, 3}, 0.3) * Transform::scaling({2, 2, -2});
  ASSERT_TRUE(t.similarity());
  EXPECT_NEAR(*t.similarity(), 2.0, 1e-14);
  EXPECT_FALSE(Transform::scaling({1, 1, 1.001}).similarity());
}

}  // namespace
}  // namespace lapidary
