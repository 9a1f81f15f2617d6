#include "inspect/operands.h"

#include <gtest/gtest.h>

#include "inspect/lone_body.h"
#include "objects.h"

namespace lapidary::inspect {
namespace {

using description::ObjectPtr;
using description::SetOperation;

ObjectPtr box(double half, const Transform& place = {}) {
  return make_object(geometry::Box{{-half, -half, -half}, {half, half, half}}, place);
}

ObjectPtr subtract(const ObjectPtr& a, const ObjectPtr& b) {
  return combined(SetOperation::subtract, a, b, {});
}

OperandReport report_on(const ObjectPtr& object) {
  OperandReport report;
  description::for_each_leaf({&object, 1}, [&](const description::Leaf& leaf) {
    const geometry::SolidScene body = lone_body(leaf);
    report = examine_operands(body);
    EXPECT_EQ(report.empty, seems_empty(body));
  });
  return report;
}

TEST(Operands, FindsWhatIsClippedAndWhatIsIdle) {
  const auto ball = make_object(geometry::Sphere{{}, 0.5});           // deep inside of the cube
  const auto away = make_object(geometry::Sphere{{9, 0, 0}, 1});      // cuts nothing
  const auto corner = make_object(geometry::Sphere{{1, 1, 1}, 0.2});  // cuts a corner off
  auto whole = combined(SetOperation::unite, box(1), ball, {});
  whole = subtract(subtract(whole, away), corner);
  const OperandReport report = report_on(whole);
  EXPECT_EQ(report.stated, 4u);
  EXPECT_EQ(report.live, 3u);
  ASSERT_EQ(report.idle.size(), 1u);
  EXPECT_EQ(report.idle[0].number, 1u);
  EXPECT_EQ(report.idle[0].kind, "sphere");
  EXPECT_FALSE(report.empty);
}

TEST(Operands, NothingIsLeft) {
  const Transform aside = Transform::translation({3, 0, 0});
  EXPECT_TRUE(report_on(subtract(box(1), box(1))).empty);
  EXPECT_TRUE(report_on(subtract(box(1), box(2))).empty);
  EXPECT_TRUE(report_on(combined(SetOperation::intersect, box(1), box(1, aside), {})).empty);
  const auto ground = make_object(geometry::HalfSpace{});
  EXPECT_TRUE(report_on(subtract(ground, ground)).empty);
}

TEST(Operands, SomethingIsLeft) {
  // Two specks a long way apart, a thin shell, and what has no bounds.
  const auto speck = box(1e-3);
  EXPECT_FALSE(report_on(combined(SetOperation::unite, speck,
                                  moved(*speck, Transform::translation({1e4, 0, 0})), {}))
                   .empty);
  EXPECT_FALSE(report_on(subtract(box(1), box(1 - 1e-6))).empty);
  EXPECT_FALSE(report_on(complemented(box(1), {})).empty);
  EXPECT_FALSE(report_on(subtract(make_object(geometry::HalfSpace{}), box(1))).empty);
}

}  // namespace
}  // namespace lapidary::inspect
