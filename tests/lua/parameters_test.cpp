#include <gmock/gmock.h>

#include "scene_file.h"

namespace lapidary::lua {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Settings : public SceneFile {};

TEST_F(Settings, DefaultsHoldUntilTheyAreSet) {
  constexpr auto text = "print(param('holes', 100), param('title', 'x'), param('glass', true))";
  EXPECT_THAT(output_of(text), ElementsAre("100\tx\ttrue"));
  options_.settings = {{"holes", "7"}, {"title", "12"}, {"glass", "false"}};
  EXPECT_THAT(output_of(text), ElementsAre("7\t12\tfalse"));
}

TEST_F(Settings, AreLiteralsElseStrings) {
  options_.settings = {{"a", "{1, {x = 'two'}}"}, {"b", "2024-01-05"}, {"c", "-1.5e3"},
                       {"d", "sphere {}"},        {"e", "'quoted'"},   {"f", "3"}};
  EXPECT_THAT(output_of(R"(
    local a = param "a"
    print(a[1], a[2].x, param "b", param "c", param "d", param "e", math.type(param "f")))"),
              ElementsAre("1\ttwo\t2024-01-05\t-1500\tsphere {}\tquoted\tinteger"));
}

TEST_F(Settings, TheLastOfEqualNamesCounts) {
  options_.settings = {{"n", "1"}, {"n", "2"}};
  EXPECT_THAT(output_of("print(param('n', 0))"), ElementsAre("2"));
}

TEST_F(Settings, UnknownNamesAreErrors) {
  options_.settings = {{"hole", "1"}};
  EXPECT_EQ(error_of("param('holes', 3)  return {}"),
            "--set hole=1: the scene has no parameter 'hole' (did you mean 'holes'?)");
  options_.settings = {{"zzz", "1"}};
  EXPECT_THAT(error_of("param('holes', 3)  param('size', 2)  return {}"),
              HasSubstr("(it has holes, size)"));
  EXPECT_THAT(error_of("return {}"), HasSubstr("(it has none)"));
}

TEST_F(Settings, TypesMustAgree) {
  options_.settings = {{"n", "many"}};
  EXPECT_EQ(error_of("\nparam('n', 3)"),
            "main.lua:2: --set n=many must be a number, like its default 3");
}

TEST_F(Settings, WithoutADefaultMustBeSet) {
  EXPECT_EQ(error_of("param 'n'"),
            "main.lua:1: the scene needs a value for 'n' (give it with --set n=...)");
}

TEST_F(Settings, AreListedWithTheScene) {
  options_.settings = {{"n", "5"}};
  const auto loaded = load("param('n', 3)  param('s', 'x')  param('n', 3)  return {}");
  ASSERT_EQ(loaded.parameters.size(), 2u);
  EXPECT_EQ(loaded.parameters[0].name, "n");
  EXPECT_EQ(loaded.parameters[0].default_text, "3");
  EXPECT_EQ(loaded.parameters[0].value_text, "5");
  EXPECT_EQ(loaded.parameters[1].value_text, "\"x\"");
}

}  // namespace
}  // namespace lapidary::lua
