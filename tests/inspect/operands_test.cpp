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

/// The planes of a cube of side 2, and `more` of them.
ObjectPtr cube_of_half_spaces(const std::vector<geometry::HalfSpace>& more) {
  ObjectPtr whole;
  const auto add = [&](const geometry::HalfSpace& half_space) {
    const auto part = make_object(half_space);
    whole = whole ? combined(SetOperation::intersect, whole, part, {}) : part;
  };
  for (std::size_t i = 0; i < 6; ++i) {
    Vec3d n;
    n[i % 3] = i < 3 ? 1 : -1;
    add({n, n});
  }
  for (const auto& half_space : more) add(half_space);
  return whole;
}

// Lines meet them as one polyhedron; who wrote them wrote half-spaces.
TEST(Operands, HalfSpacesThatAreFusedCountEach) {
  const OperandReport cube = report_on(cube_of_half_spaces({}));
  EXPECT_EQ(cube.stated, 6u);
  EXPECT_EQ(cube.live, 6u);
  EXPECT_EQ(cube.examined, 6u);
  EXPECT_TRUE(cube.idle.empty());
  const Vec3d beside{2, 0, 0}, chamfer{0.9, 0.9, 0};
  const OperandReport cut = report_on(cube_of_half_spaces({{beside, beside}, {chamfer, chamfer}}));
  EXPECT_EQ(cut.stated, 8u);
  EXPECT_EQ(cut.live, 8u);
  ASSERT_EQ(cut.idle.size(), 1u);
  EXPECT_EQ(cut.idle[0].number, 6u);
  EXPECT_EQ(cut.idle[0].kind, "half-space");
}

TEST(Operands, CountsLinesAlongWhichRoundingIsAsCoarseAsTheModel) {
  // A stack of plates each as thick as the gap to the next.
  const auto stack = [](double step, const Transform& place) {
    ObjectPtr whole;
    for (int i = 0; i < 200; ++i) {
      const double z = 2 * i * step, half = 200 * step;
      const auto plate = make_object(geometry::Box{{-half, -half, z}, {half, half, z + step}});
      whole = whole ? combined(SetOperation::unite, whole, plate, {}) : plate;
    }
    return moved(*whole, place);
  };
  const double unit = 0x1p-32;  // in the last place of 2^20
  const Transform turn = Transform::rotation({1, 2, 3}, 0.7);
  const Transform far = Transform::translation({0x1p20, 0x1p20, 0x1p20}) * turn;
  const OperandReport lost = report_on(stack(unit, far));
  EXPECT_GT(lost.cut_lines, 0u);
  EXPECT_LE(lost.cut_lines, lost.lines_followed);
  EXPECT_EQ(report_on(stack(unit, turn)).cut_lines, 0u);
  EXPECT_EQ(report_on(stack(1e6 * unit, far)).cut_lines, 0u);
}

}  // namespace
}  // namespace lapidary::inspect
