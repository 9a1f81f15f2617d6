#include <gmock/gmock.h>

#include "scene_file.h"
#include "schema/help.h"

namespace lapidary::lua {
namespace {

using description::Object;
using description::ObjectPtr;
using description::SetOperation;
using testing::HasSubstr;

/// The operators and functions that combine solids, as scenes use them.
class Operators : public SceneFile {
 protected:
  /// How the solid that `expression` of a, b, c and d makes is built, with its names.
  std::string structure_of(const std::string& expression) {
    const auto loaded = load(R"(
      local function named(n) return sphere { name = n } end
      local a, b, c, d = named "a", named "b", named "c", named "d"
      return )" + expression);
    return text(*loaded.scene.objects.at(0));
  }

  std::string error_with(const std::string& expression) {
    return error_of("local ball, plate = sphere {}, rectangle {}\nreturn " + expression);
  }

 private:
  static std::string text(const Object& object) {
    if (!object.combination() && parts_of(object).objects.empty()) return object.name();
    constexpr std::string_view signs[] = {"+", "&", "-", "~", "/"};
    std::string inside(object.combination()
                           ? signs[static_cast<std::size_t>(object.combination()->operation())]
                           : "group");
    for (const ObjectPtr& part : parts_of(object).objects) inside += " " + text(*part);
    return "(" + inside + ")";
  }
};

TEST_F(Operators, MakeValues) {
  EXPECT_EQ(structure_of("a + b"), "(+ a b)");
  EXPECT_EQ(structure_of("a | b"), "(+ a b)");
  EXPECT_EQ(structure_of("a - b"), "(- a b)");
  EXPECT_EQ(structure_of("a & b"), "(& a b)");
  EXPECT_EQ(structure_of("~a"), "(~ a)");
  EXPECT_EQ(structure_of("(a - b):translate(1, 2, 3) - c"), "(- (- a b) c)");
  EXPECT_EQ(structure_of("group { a, b } - c"), "(- (group a b) c)");
  EXPECT_EQ(structure_of("a:section(b)"), "(/ a b)");
}

TEST_F(Operators, BindAsLuaSays) {
  EXPECT_EQ(structure_of("a - b & c"), "(& (- a b) c)");
  EXPECT_EQ(structure_of("a & b - c"), "(& a (- b c))");
  EXPECT_EQ(structure_of("a + b - c"), "(- (+ a b) c)");
  EXPECT_EQ(structure_of("a - b + c"), "(+ (- a b) c)");
  EXPECT_EQ(structure_of("a | b & c"), "(+ a (& b c))");
  EXPECT_EQ(structure_of("a - ~b"), "(- a (~ b))");
  EXPECT_EQ(structure_of("a - b - c - d"), "(- a b c d)");
  EXPECT_EQ(structure_of("a - (b - c)"), "(- a (- b c))");
}

TEST_F(Operators, HaveFunctionsForLists) {
  EXPECT_EQ(structure_of("union { a, { b, { c } }, d }"), "(+ a b c d)");
  EXPECT_EQ(structure_of("intersection { a, b, c }"), "(& a b c)");
  EXPECT_EQ(structure_of("difference { a, b, c }"), "(- a b c)");
  EXPECT_EQ(structure_of("difference { a, { b, c } }"), "(- a b c)");
  EXPECT_EQ(structure_of("difference { { a, b }, c }"), "(- (+ a b) c)");
  EXPECT_EQ(structure_of("union(a, b)"), "(+ a b)");
  EXPECT_EQ(structure_of("union(a)"), "(+ a)");
  EXPECT_EQ(structure_of("union { solids = { a, b }, material = matte 'red' } - c"),
            "(- (+ a b) c)");
}

TEST_F(Operators, LeaveTheirOperandsAsTheyAre) {
  EXPECT_EQ(structure_of("(function() local p = a - b  local q = p - c  return p end)()"),
            "(- a b)");
  EXPECT_EQ(structure_of("(function() local p = a - b  local q = p - c  return p - d end)()"),
            "(- (- a b) d)");
}

TEST_F(Operators, SayWhatCannotBeCombined) {
  EXPECT_EQ(error_with("plate - ball"),
            "main.lua:2: cannot cut a sphere out of a rectangle (a rectangle encloses nothing: use "
            "a thin box)");
  EXPECT_THAT(error_with("ball - 5"), HasSubstr("cannot cut 5 out of a sphere"));
  EXPECT_THAT(error_with("5 - ball"), HasSubstr("cannot cut a sphere out of 5"));
  EXPECT_THAT(error_with("'x' + ball"), HasSubstr("cannot join the string 'x' and a sphere"));
  EXPECT_THAT(error_with("ball & 'x'"), HasSubstr("cannot intersect a sphere and the string 'x'"));
  EXPECT_THAT(error_with("'x' & ball"), HasSubstr("cannot intersect the string 'x' and a sphere"));
  EXPECT_THAT(error_with("ball - nil"), HasSubstr("cannot cut nil out of a sphere (does a name"));
  EXPECT_THAT(error_with("nil | ball"), HasSubstr("cannot join nil and a sphere"));
  EXPECT_THAT(error_with("ball + { ball }"),
              HasSubstr("cannot join a sphere and a list of 1 (union { ... } makes one solid"));
  EXPECT_THAT(error_with("ball + glass(1.5)"), HasSubstr("cannot join a sphere and a glass"));
  EXPECT_THAT(error_with("glass(1.5) + glass(1.5)"), HasSubstr("cannot join a glass and a glass"));
  EXPECT_THAT(error_with("ball - sphere"),
              HasSubstr("cannot cut a function out of a sphere (call it: name { ... })"));
  EXPECT_THAT(error_with("ball + point_light { power = 1 }"),
              HasSubstr("a point_light is light without a body"));
  EXPECT_THAT(error_with("~plate"), HasSubstr("there is no complement of a rectangle"));
  EXPECT_THAT(error_with("(ball - ball) + plate"),
              HasSubstr("cannot join a difference and a rectangle"));
  EXPECT_THAT(error_with("(ball & ball) + plate"), HasSubstr("cannot join an intersection and"));
  EXPECT_THAT(error_with("ball * 2"), HasSubstr("there is no '*' of solids"));
  EXPECT_THAT(error_with("-ball"), HasSubstr("there is no '-' of solids"));
}

TEST_F(Operators, TakeAttributes) {
  const auto loaded = load(R"(
    local wine = glass { 1.34, color = {0.5, 0, 0.1}, distance = 3 }
    local cup = (sphere {} - sphere { radius = 0.9 }):material(glass(1.5)):priority(2)
    return scene {
      objects = { cup, sphere { radius = 0.91, interior = wine, cut = matte 'red' } },
      section = half_space { normal = {0, 1, 0} },
    })");
  ASSERT_EQ(loaded.scene.objects.size(), 2u);
  EXPECT_EQ(loaded.scene.objects[0]->attributes->priority, 2);
  const auto& drink = *loaded.scene.objects[1]->attributes;
  EXPECT_EQ(description::as_glass(*drink.interior)->absorption->distance, 3);
  EXPECT_EQ(drink.cut->rule, description::Cut::Rule::material);
  EXPECT_TRUE(loaded.scene.section);
  EXPECT_THAT(error_of("return scene { section = rectangle {} }"),
              HasSubstr("section of scene must be a solid, not a rectangle (a rectangle encloses"));
}

TEST_F(Operators, GrowALoopsSolidInPlace) {
  const auto loaded = load(R"(
    local p = box { size = {9, 9, 9} }
    for i = 1, 20000 do p = p - sphere { radius = i } end
    return p)");
  EXPECT_EQ(loaded.scene.objects.at(0)->combination()->operands().size(), 20001u);
}

TEST_F(Operators, NestWithoutEnd) {
  const auto loaded = load(R"(
    local p, b = sphere {}, sphere {}
    for i = 1, 100000 do
      p = (i % 2 == 0 and p + b or p - b)
      if i % 3 == 0 then p = p:material(glass(1.5)) end
      if i % 4 == 0 then p = p:translate(0, 0, 1) end
    end
    return p)");
  EXPECT_TRUE(loaded.scene.objects.at(0)->combination());
}

TEST_F(Operators, LeaveNoGarbageBehind) {
  options_.limits.memory = std::size_t{16} << 20;
  EXPECT_EQ(error_of(R"(
    local a, b = sphere {}, box { size = {1, 1, 1} }
    for i = 1, 100000 do local c = (a - b) + ~a end
    return a)"),
            "no error");
}

// Lua knows nothing of the solids that a solid is made of and would let them be forgotten.
TEST_F(Operators, PayForAllThatTheyHold) {
  options_.limits.memory = std::size_t{16} << 20;
  EXPECT_THAT(error_of("local p = sphere {}\nwhile true do p = p - sphere {} end"),
              HasSubstr("main.lua:2: the scene needs more than 16 MB of memory"));
  EXPECT_THAT(error_of("local p, s = sphere {}, sphere {}\n"
                       "while true do p = (p - s):translate(1, 0, 0) end"),
              HasSubstr("main.lua:2: the scene needs more than 16 MB of memory"));
}

TEST_F(Operators, AreInTheIndexOfHelp) {
  const std::string index = schema::help_index(node_infos());
  const std::size_t section = index.find("\ncombining solids\n");
  ASSERT_NE(section, std::string::npos);
  const std::string lines = index.substr(section, index.find("\n\n", section) - section);
  for (const char* entry :
       {"union ", "difference ", "intersection ", "a + b", "a - b", "a & b", "~a"}) {
    EXPECT_THAT(lines, HasSubstr(std::string("\n  ") + entry));
  }
}

}  // namespace
}  // namespace lapidary::lua
