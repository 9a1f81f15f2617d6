#include "math/axis_angle.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace lapidary {
namespace {

TEST(LeastTurn, IsWhatTheMatrixWasMadeOf) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d axis = random.direction();
    const double angle = i % 3 == 0 ? random.magnitude(-9, 0) : random.uniform(0, pi);
    const AxisAngle turn = least_turn(Transform::rotation(axis, angle).linear());
    EXPECT_NEAR(turn.angle, angle, 1e-14);
    EXPECT_LT(length(turn.axis - axis) * angle, 1e-14);
    EXPECT_NEAR(length(turn.axis), 1.0, 1e-15);
  }
}

TEST(LeastTurn, OfAHalfTurnAndMoreIsTheShortWay) {
  test::Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Vec3d axis = random.direction();
    const AxisAngle more = least_turn(Transform::rotation(axis, 4.0).linear());
    EXPECT_NEAR(more.angle, 2 * pi - 4.0, 1e-14);
    EXPECT_LT(length(more.axis + axis), 1e-14);
    const AxisAngle half = least_turn(Transform::rotation(axis, pi).linear());
    EXPECT_NEAR(half.angle, pi, 1e-14);
    EXPECT_NEAR(std::abs(dot(half.axis, axis)), 1.0, 1e-14);
  }
  EXPECT_EQ(least_turn(Mat3::identity()).angle, 0.0);
}

}  // namespace
}  // namespace lapidary
