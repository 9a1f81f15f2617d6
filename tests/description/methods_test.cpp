#include "description/methods.h"

#include <cmath>

#include <gmock/gmock.h>

#include "construct.h"

namespace lapidary::description {
namespace {

using testing::HasSubstr;

class MethodTest : public testing::Test {
 protected:
  Vec3d moved_point(std::string_view method, std::string_view literal, Vec3d p) {
    return make_.call(*ball_, method, literal)->parent_from_object().point(p);
  }
  void expect_near(Vec3d a, Vec3d b) { EXPECT_LT(length(a - b), 1e-12) << a.x << a.y << a.z; }

  Constructor make_;
  ObjectPtr ball_ = make_.object("sphere", "{}");
};

TEST_F(MethodTest, MoveAsTheySay) {
  EXPECT_EQ(moved_point("translate", "{1, 2, 3}", {1, 1, 1}), Vec3d(2, 3, 4));
  EXPECT_EQ(moved_point("translate", "{z = 3}", {1, 1, 1}), Vec3d(1, 1, 4));
  EXPECT_EQ(moved_point("scale", "2", {1, 2, 3}), Vec3d(2, 4, 6));
  EXPECT_EQ(moved_point("scale", "{y = 2}", {1, 2, 3}), Vec3d(1, 4, 3));
  EXPECT_EQ(moved_point("mirror", "{x = 1}", {1, 2, 3}), Vec3d(-1, 2, 3));
  EXPECT_EQ(moved_point("transform", "{{1, 0, 0, 5}, {0, 2, 0, 6}, {0, 0, 3, 7}}", {1, 1, 1}),
            Vec3d(6, 8, 10));
}

TEST_F(MethodTest, QuarterTurnsAreExact) {
  EXPECT_EQ(moved_point("rotate", "{x = 90}", {1, 2, 3}), Vec3d(1, -3, 2));
  EXPECT_EQ(moved_point("rotate", "{y = 90}", {1, 2, 3}), Vec3d(3, 2, -1));
  EXPECT_EQ(moved_point("rotate", "{z = 90}", {1, 2, 3}), Vec3d(-2, 1, 3));
  EXPECT_EQ(moved_point("rotate", "{z = 180}", {1, 2, 3}), Vec3d(-1, -2, 3));
  EXPECT_EQ(moved_point("rotate", "{z = -90}", {1, 2, 3}), Vec3d(2, -1, 3));
  EXPECT_EQ(moved_point("rotate", "{z = 360090}", {1, 2, 3}), Vec3d(-2, 1, 3));
}

TEST_F(MethodTest, RotateTurnsAboutXThenYThenZ) {
  const double c = std::cos(0.5), s = std::sin(0.5), degrees = 0.5 * 180 / std::acos(-1.0);
  const std::string angle = std::to_string(degrees);
  const Vec3d turned = moved_point("rotate", "{x = 90, y = 90, z = " + angle + "}", {0, 0, 1});
  // (0, 0, 1) goes by x to (0, -1, 0), stays there by y, and is turned by z.
  EXPECT_NEAR(turned.x, s, 1e-6);
  EXPECT_NEAR(turned.y, -c, 1e-6);
  expect_near(moved_point("rotate", "{axis = {0, 0, 2}, angle = 90}", {1, 0, 0}), {0, 1, 0});
}

TEST_F(MethodTest, LaterMotionsComeAfterEarlierOnes) {
  const auto once = make_.call(*ball_, "translate", "{1, 0, 0}");
  const auto twice = make_.call(*once, "rotate", "{z = 90}");
  EXPECT_EQ(twice->parent_from_object().point({0, 0, 0}), Vec3d(0, 1, 0));
  EXPECT_EQ(once->parent_from_object().point({0, 0, 0}), Vec3d(1, 0, 0)) << "the original moved";
  EXPECT_TRUE(ball_->parent_from_object().is_identity());
}

TEST_F(MethodTest, SingularMapsAreRefused) {
  EXPECT_THAT(make_.call_error(*ball_, "scale", "0"), HasSubstr("scale must not be 0"));
  EXPECT_THAT(make_.call_error(*ball_, "scale", "{x = 0}"), HasSubstr("scale must not be 0"));
  EXPECT_THAT(make_.call_error(*ball_, "mirror", "{0, 0, 0}"), HasSubstr("not zero"));
  EXPECT_THAT(make_.call_error(*ball_, "transform", "{{1,0,0,0}, {2,0,0,0}, {0,0,1,0}}"),
              HasSubstr("has no inverse"));
  EXPECT_THAT(make_.call_error(*ball_, "transform", "{{1,0,0,0}, {0,1,0,0}}"),
              HasSubstr("three rows of four numbers"));
  EXPECT_THAT(make_.call_error(*ball_, "transform", "{{1,0,0,0}, {0,1,0,0}, {0,0,1,0}, {0,0,1,1}}"),
              HasSubstr("value [4] of transform must be {0, 0, 0, 1}"));
  const auto tiny = make_.call(*ball_, "scale", "1e-200");
  EXPECT_THAT(make_.call_error(*tiny, "scale", "1e-200"), HasSubstr("leaves nothing"));
}

TEST_F(MethodTest, MotionsAreReadAndCarriedAlong) {
  const auto there = make_.call(*ball_, "translate", "{1, 2, 3}");
  const auto moving = make_.call(*there, "motion", "{translate = {z = 4}, rotate = {z = 720}}");
  ASSERT_TRUE(moving->motion);
  EXPECT_EQ(moving->parent_from_object().point({}), Vec3d(1, 2, 3));
  const geometry::Motion& m = moving->motion->motion;
  EXPECT_EQ(m.center, Vec3d(1, 2, 3));
  EXPECT_EQ(m.travel, Vec3d(0, 0, 4));
  EXPECT_EQ(m.turn.axis, Vec3d(0, 0, 1));
  EXPECT_NEAR(m.turn.angle, 4 * std::acos(-1.0), 1e-14) << "twice around";
  EXPECT_EQ(m.scale, Vec3d(1, 1, 1));

  const auto tilted = make_.call(*ball_, "motion", "{rotate = {x = 90, y = 90}, scale = {z = 2}}");
  EXPECT_NEAR(tilted->motion->motion.turn.angle, 2 * std::acos(-1.0) / 3, 1e-14) << "the least";
  EXPECT_EQ(tilted->motion->motion.scale, Vec3d(1, 1, 2));
  const auto given = make_.call(*ball_, "motion", "{rotate = {axis = {0, 3, 0}, angle = 400}}");
  EXPECT_EQ(given->motion->motion.turn.axis, Vec3d(0, 1, 0));
  EXPECT_NEAR(given->motion->motion.turn.angle, 400 * std::acos(-1.0) / 180, 1e-14);

  EXPECT_THAT(make_.call_error(*moving, "motion", "{}"), HasSubstr("what moves already"));
  EXPECT_THAT(make_.call_error(*ball_, "motion", "{scale = 0}"), HasSubstr("from 0.001 to 1000"));
  EXPECT_THAT(make_.call_error(*ball_, "motion", "{turn = {z = 3}}"),
              HasSubstr("unknown parameter 'turn' of motion"));
}

TEST_F(MethodTest, WrongArgumentsAreNamed) {
  EXPECT_THAT(make_.call_error(*ball_, "translate", "5"),
              HasSubstr("scene.lua:7: translate must be {x, y, z}, not 5"));
  EXPECT_THAT(make_.call_error(*ball_, "rotate", "{x = 'a'}"),
              HasSubstr("x of rotate must be a number"));
  EXPECT_THAT(make_.call_error(*ball_, "rotate", "{axis = {0, 0, 1}}"),
              HasSubstr("needs its parameter 'angle'"));
  EXPECT_THAT(make_.call_error(*ball_, "material", "'red'"),
              HasSubstr("material must be a material, not the string 'red'"));
}

}  // namespace
}  // namespace lapidary::description
