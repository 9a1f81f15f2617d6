#include <gmock/gmock.h>

#include "scene_file.h"

namespace lapidary::lua {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Determinism : public SceneFile {};

TEST_F(Determinism, PairsGoByNumbersThenNames) {
  EXPECT_THAT(output_of(R"(
    local t = { zebra = 1, apple = 2, [10] = 3, [-1] = 4, [2.5] = 5, "first", "second", [true] = 6 }
    local keys = {}
    for k in pairs(t) do keys[#keys + 1] = tostring(k) end
    print(table.concat(keys, " ")))"),
              ElementsAre("-1 1 2 2.5 10 apple zebra true"));
}

TEST_F(Determinism, PairsAllowsAssigningToWhatIsThere) {
  EXPECT_THAT(output_of(R"(
    local t = { a = 1, b = 2, c = 3 }
    local seen = {}
    for k, v in pairs(t) do seen[#seen + 1] = k .. v  t.b = nil  t.c = 9 end
    print(table.concat(seen, " "), next(t), next(t, "a"), next({}))
    for k, v in pairs(setmetatable({}, { __pairs = function() return next, { x = 1 } end })) do
      print(k, v)
    end)"),
              ElementsAre("a1 c9\ta\tc\tnil", "x\t1"));
}

TEST_F(Determinism, NextWalksLikePairs) {
  EXPECT_THAT(output_of(R"(
    local t = { b = 1, a = 2, [1] = 3 }
    local k, v = next(t)
    while k do print(k, v)  k, v = next(t, k) end)"),
              ElementsAre("1\t3", "a\t2", "b\t1"));
}

TEST_F(Determinism, KeysWithoutOrderAreRefused) {
  EXPECT_THAT(error_of("for k in pairs { [sphere {}] = 1, [{}] = 2 } do end"),
              HasSubstr("pairs cannot put keys of type"));
}

TEST_F(Determinism, RandomNumbersAreTheSameEveryTime) {
  const auto first = output_of("print(math.random(), math.random(1000), math.random(1000))");
  EXPECT_EQ(first, output_of("print(math.random(), math.random(1000), math.random(1000))"));
  EXPECT_EQ(output_of("math.randomseed()  print(math.random())"),
            output_of("math.randomseed()  print(math.random())"));
  EXPECT_EQ(output_of("math.randomseed(5)  print(math.random())"),
            output_of("math.randomseed(5)  print(math.random())"));
  EXPECT_NE(output_of("math.randomseed(5)  print(math.random())"),
            output_of("math.randomseed(6)  print(math.random())"));
}

TEST_F(Determinism, TextShowsNoAddresses) {
  EXPECT_THAT(
      output_of(R"(
    print({}, print, coroutine.create(print), tostring {}, function() end)
    print(string.format("%s %10s|%-6s", {}, print, sphere {}), ("%s"):format(nil)))"),
      ElementsAre("table\tfunction\tthread\ttable\tfunction", "table   function|sphere\tnil"));
  EXPECT_THAT(error_of("return string.format('%p', {})"), HasSubstr("format has no %p"));
  EXPECT_THAT(error_of("return string.format('%% %5p', {})"), HasSubstr("format has no %p"));
}

TEST_F(Determinism, MetamethodsStillDecideTheText) {
  EXPECT_THAT(output_of("print(setmetatable({}, { __tostring = function() return 'me' end }))"),
              ElementsAre("me"));
}

}  // namespace
}  // namespace lapidary::lua
