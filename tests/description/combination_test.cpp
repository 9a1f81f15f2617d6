#include "description/combination.h"

#include <gmock/gmock.h>

#include "construct.h"
#include "description/combine.h"
#include "description/fold.h"
#include "description/leaves.h"
#include "description/solids.h"

namespace lapidary::description {
namespace {

using testing::HasSubstr;

class CombinationTest : public testing::Test {
 protected:
  static ObjectPtr difference(const ObjectPtr& a, const ObjectPtr& b) {
    return combined(SetOperation::subtract, a, b, {});
  }
  static ObjectPtr sum(const ObjectPtr& a, const ObjectPtr& b) {
    return combined(SetOperation::unite, a, b, {});
  }
  static std::size_t operands(const ObjectPtr& object) {
    return object->combination()->operands().size();
  }
  ObjectPtr ball() { return make_.object("sphere", "{}"); }

  Constructor make_;
  MaterialPtr red_ = make_.make<Material>("matte", "'red'");
  MaterialPtr blue_ = make_.make<Material>("matte", "'blue'");
  MaterialPtr water_ = make_.make<Material>("glass", "'water'");
};

TEST_F(CombinationTest, ChainsAreOneListThatVersionsShare) {
  const auto first = difference(ball(), ball());
  const auto second = difference(first, ball());
  const auto third = difference(second, ball());
  EXPECT_EQ(operands(first), 2u);
  EXPECT_EQ(operands(second), 3u);
  EXPECT_EQ(operands(third), 4u);
  EXPECT_EQ(first->combination()->list(), third->combination()->list());
  EXPECT_EQ(first->combination()->operands()[1], third->combination()->operands()[1]);
}

TEST_F(CombinationTest, TheSecondToGoOnFromAVersionNestsIt) {
  const auto base = difference(ball(), ball());
  const auto one = difference(base, ball()), other = difference(base, ball());
  EXPECT_EQ(operands(one), 3u);
  EXPECT_EQ(operands(other), 2u);
  EXPECT_EQ(other->combination()->operands()[0], base);
  EXPECT_EQ(operands(base), 2u);
}

TEST_F(CombinationTest, WhatIsTellableApartIsNested) {
  const auto chain = difference(ball(), ball());
  EXPECT_EQ(operands(sum(chain, ball())), 2u) << "another operation";
  EXPECT_EQ(operands(difference(with_material(*chain, red_), ball())), 2u);
  EXPECT_EQ(operands(difference(with_name(*chain, "x"), ball())), 2u);
  EXPECT_EQ(operands(difference(moved(*chain, Transform::translation({1, 0, 0})), ball())), 2u);
  EXPECT_EQ(operands(difference(ball(), chain)), 2u) << "a - (b - c)";
  EXPECT_EQ(operands(difference(chain, ball())), 3u) << "and the chain is as it was";
}

// A list that held a version of itself would never be freed.
TEST_F(CombinationTest, NoListHoldsItself) {
  const auto leaf = ball();
  const std::weak_ptr<const Object> watched = leaf;
  {
    auto pair = sum(leaf, ball());
    const auto beside = moved(*pair, Transform::translation({1, 0, 0}));
    const auto four = sum(pair, beside);
    EXPECT_NE(four->combination()->list(), pair->combination()->list());
    const auto hidden = sum(pair, difference(ball(), make_group({beside}, {})));
    EXPECT_NE(hidden->combination()->list(), pair->combination()->list());
    EXPECT_EQ(operands(sum(pair, difference(ball(), ball()))), 3u) << "others may be appended";
  }
  EXPECT_EQ(watched.use_count(), 1);
}

TEST_F(CombinationTest, TowersOfAnyHeightComeDown) {
  constexpr int height = 100'000;
  auto ground = ball();
  const std::weak_ptr<const Object> watched = ground;
  ObjectPtr tower = std::move(ground);
  const ObjectPtr brick = ball();
  for (int i = 0; i < height; ++i) {
    tower = i % 2 ? sum(tower, brick) : difference(tower, brick);
    if (i % 3 == 0) tower = with_material(*tower, red_);
    if (i % 5 == 0) tower = moved(*tower, Transform::translation({1, 0, 0}));
    if (i % 7 == 0) tower = with_section(tower, brick);
    if (i % 11 == 0) tower = complemented(tower, {});
    if (i % 13 == 0) tower = make_combination(SetOperation::unite, {make_group({tower}, {})}, {});
  }
  EXPECT_GT(operand_count(*tower), std::size_t{height});
  bounds(*tower->combination());
  EXPECT_FALSE(gives_light({&tower, 1}));
  EXPECT_FALSE(watched.expired());
  tower = nullptr;
  EXPECT_TRUE(watched.expired());
}

TEST_F(CombinationTest, SharedPartsAreLookedAtOnce) {
  ObjectPtr object = ball();
  int looks = 0;
  for (int i = 0; i < 90; ++i) {
    object = sum(object, moved(*object, Transform::translation({0, 0, 1})));
  }
  const auto count = [&](const Object&) { return ++looks, 1.0; };
  const double leaves = fold<double>(*object, count, [](const Object&, auto parts) {
    double total = 0;
    for (const double part : parts) total += part;
    return total;
  });
  EXPECT_EQ(leaves, std::ldexp(1.0, 90));
  EXPECT_LT(looks, 10);
  EXPECT_EQ(operand_count(*object), operand_count_limit);
}

TEST_F(CombinationTest, BoundsAreThoseOfTheOperation) {
  const auto box_at = [this](double x) {
    return moved(*make_.object("box", "{size = {2, 2, 2}}"), Transform::translation({x, 0, 0}));
  };
  const auto bounds_of = [](const ObjectPtr& object) { return bounds(*object->combination()); };
  EXPECT_NEAR(bounds_of(sum(box_at(0), box_at(5))).max.x, 6, 1e-12);
  const Box3d common = bounds_of(combined(SetOperation::intersect, box_at(0), box_at(1), {}));
  EXPECT_NEAR(common.min.x, 0, 1e-12);
  EXPECT_NEAR(common.max.x, 1, 1e-12);
  EXPECT_NEAR(bounds_of(difference(box_at(0), box_at(1))).max.x, 1, 1e-12);
  EXPECT_FALSE(bounds_of(complemented(box_at(0), {})).bounded());
  const auto inside_out =
      combined(SetOperation::intersect, box_at(0), complemented(box_at(1), {}), {});
  EXPECT_TRUE(bounds_of(inside_out).bounded());
  EXPECT_TRUE(bounds_of(make_combination(SetOperation::unite, {}, {})).empty());
  const auto pair =
      moved(*make_group({box_at(0), box_at(5)}, {}), Transform::translation({0, 7, 0}));
  EXPECT_NEAR(bounds_of(make_combination(SetOperation::unite, {pair}, {})).max.y, 8, 1e-12);
}

class OperatorTest : public CombinationTest {
 protected:
  std::string error_of(SetOperation operation, const schema::Value& a, const schema::Value& b) {
    const schema::CallSite where(std::make_shared<const std::string>("scene.lua"), 3);
    return Constructor::message_of([&] { combine(operation, a, b, where); });
  }
  schema::Node ball_ = make_.node("sphere", "{}"), plate_ = make_.node("rectangle", "{}"),
               shade_ = make_.node("disk", "{}"), paint_ = make_.node("matte", "{}");
};

TEST_F(OperatorTest, NameBothOperandsWhenTheyFail) {
  const schema::Value ball(ball_), plate(plate_), shade(shade_), paint(paint_);
  EXPECT_EQ(
      error_of(SetOperation::subtract, plate, ball),
      "scene.lua:3: cannot cut a sphere out of a rectangle (a rectangle encloses nothing: use "
      "a thin box)");
  EXPECT_EQ(error_of(SetOperation::unite, ball, shade),
            "scene.lua:3: cannot join a sphere and a disk (a disk encloses nothing: use a flat "
            "cylinder)");
  EXPECT_EQ(error_of(SetOperation::intersect, ball, paint),
            "scene.lua:3: cannot intersect a sphere and a matte (a solid wears it so: "
            "solid:material(...))");
  EXPECT_THAT(error_of(SetOperation::subtract, schema::Value(5.0), ball),
              HasSubstr("cannot cut a sphere out of 5"));
  EXPECT_THAT(error_of(SetOperation::subtract, ball, schema::Value()),
              HasSubstr("cannot cut nil out of a sphere (does a name have a slip"));
  EXPECT_THAT(error_of(SetOperation::unite, ball, make_.arena().table({}, {})),
              HasSubstr("cannot join a sphere and an empty table (union { ... } makes one solid"));
  EXPECT_THAT(error_of(SetOperation::unite, schema::Value(std::string_view("x")), ball),
              HasSubstr("cannot join the string 'x' and a sphere"));
  EXPECT_THAT(Constructor::message_of([&] { complement(shade, {}); }),
              HasSubstr("there is no complement of a disk"));
}

TEST_F(OperatorTest, TakeGroupsOfSolids) {
  const schema::Node lamp = make_.node("point_light", "{power = 1}");
  const auto group_of = [this](std::initializer_list<schema::Value> members) {
    const std::vector<schema::Value> list(members);
    return make_.node("group", make_.arena().table(list, {}));
  };
  const schema::Node balls = group_of({schema::Value(ball_), schema::Value(ball_)});
  const schema::Node mixed = group_of({schema::Value(ball_), schema::Value(plate_)});
  const schema::Node nested = group_of({schema::Value(mixed)});
  EXPECT_EQ(combine(SetOperation::subtract, schema::Value(balls), schema::Value(ball_), {}).kind,
            "difference");
  EXPECT_THAT(error_of(SetOperation::subtract, schema::Value(ball_), schema::Value(nested)),
              HasSubstr("cannot cut a group out of a sphere (a group holds something that "
                        "encloses nothing)"));
  EXPECT_THAT(error_of(SetOperation::unite, schema::Value(ball_), schema::Value(lamp)),
              HasSubstr("a point_light is light without a body"));
}

class CombinationNodeTest : public OperatorTest {
 protected:
  schema::Value list(std::initializer_list<schema::Value> items) {
    const auto kept = make_.arena().array<schema::Value>(items.size());
    std::copy(items.begin(), items.end(), kept.begin());
    return make_.arena().table(kept, {});
  }
  ObjectPtr made(std::string_view name, const schema::Value& argument) {
    return make_.node(name, argument).as<Object>();
  }
};

TEST_F(CombinationNodeTest, FlattenLists) {
  const schema::Value ball(ball_), plate(plate_);
  const auto all = made("union", list({ball, list({ball, list({ball})}), ball}));
  EXPECT_EQ(operands(all), 4u);
  EXPECT_EQ(all->combination()->operation(), SetOperation::unite);
  EXPECT_EQ(operands(made("intersection", list({ball, list({ball})}))), 2u);
  EXPECT_EQ(operands(made("union", list({}))), 0u);
  EXPECT_THAT(Constructor::message_of([&] {
                made("union", list({ball, list({plate})}));
              }),
              HasSubstr("solids[2][1] of union must be a solid, not a rectangle (a rectangle "
                        "encloses nothing"));
  EXPECT_THAT(Constructor::message_of([&] { made("difference", list({})); }),
              HasSubstr("difference needs a solid"));
  EXPECT_THAT(Constructor::message_of([&] { made("intersection", list({})); }),
              HasSubstr("intersection needs a solid"));
}

TEST_F(CombinationNodeTest, AListInFrontIsCutAsAWhole) {
  const schema::Value ball(ball_), plate(plate_);
  const auto plain = made("difference", list({ball, list({ball, ball}), ball}));
  EXPECT_EQ(operands(plain), 4u);
  const auto whole = made("difference", list({list({ball, ball}), ball}));
  ASSERT_EQ(operands(whole), 2u);
  EXPECT_EQ(operands(whole->combination()->operands()[0]), 2u);
  EXPECT_THAT(Constructor::message_of([&] {
                made("difference", list({list({ball}), ball, plate}));
              }),
              HasSubstr("solids[3] of difference must be a solid"));
}

TEST_F(CombinationNodeTest, AttributesAreParametersAndMethods) {
  const schema::Node water = make_.node("glass", "'water'");
  const schema::Field fields[] = {{"cut", schema::Value(std::string_view("inherit"))},
                                  {"interior", schema::Value(water)},
                                  {"priority", schema::Value(3.0)}};
  const auto drop = made("sphere", make_.arena().table({}, fields));
  ASSERT_TRUE(drop->attributes);
  EXPECT_EQ(drop->attributes->interior, water.as<Material>());
  EXPECT_EQ(drop->attributes->priority, 3);
  EXPECT_EQ(drop->attributes->cut->rule, Cut::Rule::inherit);
  const auto other = make_.call(*drop, "priority", "-2");
  EXPECT_EQ(other->attributes->priority, -2);
  EXPECT_EQ(other->attributes->interior, water.as<Material>()) << "the rest stays";
  EXPECT_EQ(make_.call(*drop, "cut", "'cutter'")->attributes->cut->rule, Cut::Rule::cutter);
  EXPECT_FALSE(ball()->attributes);

  EXPECT_THAT(make_.error_of("sphere", "{priority = 1.5}"), HasSubstr("a whole number"));
  EXPECT_THAT(make_.error_of("sphere", "{cut = 'cuter'}"), HasSubstr("did you mean 'cutter'?"));
  EXPECT_THAT(make_.error_of("sphere", "{interior = 1.5}"), HasSubstr("must be a glass, not 1.5"));
  EXPECT_THAT(make_.error_of("sphere", "{section = 1}"), HasSubstr("must be a solid, not 1"));
  EXPECT_THAT(make_.error_of("rectangle", "{priority = 1}"), HasSubstr("unknown parameter"));
  EXPECT_THAT(make_.call_error(*plate_.as<Object>(), "priority", "1"),
              HasSubstr("priority is for solids: a sheet encloses nothing"));
}

TEST_F(CombinationNodeTest, SectionsCutWhatTheyAreGiven) {
  const auto knife = ball();
  const auto shown = with_section(ball(), knife);
  const auto moved_both = moved(*shown, Transform::translation({0, 0, 4}));
  const auto dressed = with_material(*with_name(*moved_both, "half"), red_);
  int leaves = 0;
  for_each_leaf({&dressed, 1}, [&](const Leaf& leaf) {
    ++leaves;
    EXPECT_TRUE(std::holds_alternative<geometry::Solid>(leaf.object.content));
    EXPECT_EQ(leaf.name, "half");
    EXPECT_EQ(leaf.material, red_);
    EXPECT_EQ(leaf.world_from_object.point({0, 0, 0}), Vec3d(0, 0, 4));
    ASSERT_EQ(leaf.removed.size(), 1u);
    EXPECT_EQ(leaf.removed[0].solid, knife);
    EXPECT_EQ(leaf.removed[0].world_from_parent.point({0, 0, 0}), Vec3d(0, 0, 4));
  });
  EXPECT_EQ(leaves, 1);
  EXPECT_EQ(dressed->combination()->operands()[0]->material, red_) << "the solid itself wears it";
}

TEST_F(CombinationNodeTest, LeavesInheritWhatTheyWereNotTold) {
  const auto plain = ball(), told = with_attributes(*ball(), {.priority = 1});
  auto group = make_group({plain, told, plate_.as<Object>()}, {});
  group = with_attributes(*group, {.interior = water_, .priority = 7, .cut = Cut{}});
  group = with_section(group, plain);
  const ObjectPtr objects[] = {group, plain};
  std::vector<int> priorities;
  std::vector<std::size_t> removed;
  std::vector<bool> filled;
  for_each_leaf(objects, [&](const Leaf& leaf) {
    priorities.push_back(leaf.priority);
    removed.push_back(leaf.removed.size());
    filled.push_back(leaf.interior == water_ && leaf.cut != nullptr);
  });
  EXPECT_THAT(priorities, testing::ElementsAre(7, 1, 7, 0));
  EXPECT_THAT(removed, testing::ElementsAre(1, 1, 1, 0));
  EXPECT_THAT(filled, testing::ElementsAre(true, true, true, false));
}

TEST_F(CombinationNodeTest, GlassHasAColorAfterADistance) {
  EXPECT_FALSE((make_.model<Glass, Material>("glass", "{}").absorption));
  const auto wine = make_.model<Glass, Material>("glass", "{1.34, color = {0.5, 0, 0.1}}");
  ASSERT_TRUE(wine.absorption);
  EXPECT_EQ(wine.absorption->distance, 1);
  EXPECT_EQ(
      (make_.model<Glass, Material>("glass", "{color = 'red', distance = 4}").absorption->distance),
      4);
  EXPECT_THAT(make_.error_of("glass", "{distance = 4}"), HasSubstr("only with a 'color'"));
  EXPECT_THAT(make_.error_of("glass", "{color = 'red', distance = 0}"),
              HasSubstr("greater than 0"));
}

}  // namespace
}  // namespace lapidary::description
