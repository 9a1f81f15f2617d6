#include <chrono>

#include <gmock/gmock.h>

#include "scene_file.h"

namespace lapidary::lua {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// Limits small enough to be reached at once; each scene here would run for ever, or nearly, or
/// take all memory.
class Limited : public SceneFile {
 protected:
  Limited() {
    options_.limits = {.steps = 3'000'000,
                       .memory = std::size_t{32} << 20,
                       .string_bytes = std::size_t{1} << 20,
                       .seconds = 20};
  }
  ~Limited() override {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
    // Generous: sanitizers and busy machines are slow; without limits it would be hours.
    EXPECT_LT(taken.count(), 60.0);
  }
  void expect_too_long(std::string_view text) {
    EXPECT_THAT(error_of(text),
                AllOf(HasSubstr("the scene takes more than"), HasSubstr("does a loop never end?")))
        << text;
  }
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

TEST_F(Limited, EndlessLoops) {
  EXPECT_EQ(error_of("\nwhile true do end"),
            "main.lua:2: the scene takes more than 3000000 steps to read (does a loop never end?)");
  expect_too_long("::again:: goto again");
  expect_too_long("local function f() return f() end  f()");
  expect_too_long(
      "local t = setmetatable({}, {__index = function(t, k) return t[k + 1] end})"
      "  while true do pcall(function() return t[1] end) end");
}

TEST_F(Limited, EndlessLoopsThatCatchErrors) {
  options_.limits.steps = 200'000;  // an error costs far more time than the steps to it
  expect_too_long("while true do pcall(function() while true do end end) end");
  expect_too_long("local function f() while true do pcall(f) end end  f()");
  expect_too_long("while true do xpcall(error, function() while true do end end) end");
}

TEST_F(Limited, EndlessCoroutines) {
  expect_too_long("coroutine.wrap(function() while true do end end)()");
  expect_too_long("while true do coroutine.wrap(function() coroutine.yield() end)() end");
  // A tree of them, each with too few instructions to be noticed by itself.
  expect_too_long(
      "local function f(n) if n == 0 then return end\n"
      "for _ = 1, 2 do coroutine.wrap(f)(n - 1) end end  f(60)");
}

TEST_F(Limited, EndlessLibraryCalls) {
  expect_too_long("table.move({}, 1, math.maxinteger - 1, 2)");
  expect_too_long("table.insert(setmetatable({}, {__len = function() return 1 << 53 end}), 1, 1)");
  expect_too_long("table.remove(setmetatable({}, {__len = function() return 1 << 53 end}), 1)");
  expect_too_long("table.concat(setmetatable({}, {__index = string}), '', 1, 1 << 53)");
  expect_too_long("table.sort(setmetatable({}, {__len = function() return 1 << 30 end}))");
  expect_too_long("local t = {}  for i = 1, 100000 do table.insert(t, 1, i) end");
  expect_too_long("local t = {}  for i = 1, 1e5 do t[i] = i end  while true do next(t) end");
}

TEST_F(Limited, PatternsThatExplode) {
  expect_too_long("return (('a'):rep(30000)):match('.-.-.-.-b')");
  expect_too_long("return (('a'):rep(30000)):find('a*a*a*a*b')");
  expect_too_long("return (('('):rep(1e6)):find('%b()')");
  expect_too_long(
      "for _ in (('a'):rep(30000)):gmatch('(a*)*b') do end"
      "  return (('a'):rep(30000)):gsub('.-.-.-b', '')");
}

TEST_F(Limited, ManyLongStrings) {
  expect_too_long("local s = ('x'):rep(1e6)  for i = 1, 1e6 do local t = s .. i end");
  expect_too_long("for i = 1, 1e9 do local s = ('x'):rep(1e6) end");
  expect_too_long("local s = ('x'):rep(1e6)  for i = 1, 1e9 do s:gsub('x', 'y') end");
  expect_too_long("for i = 1, 1e9 do print(('x'):rep(1e6)) end");
}

TEST_F(Limited, StringsThatAreTooLong) {
  EXPECT_EQ(error_of("\nreturn ('x'):rep(1e10)"),
            "main.lua:2: a string is longer than 1048576 bytes (does a loop make more than it "
            "should?)");
  EXPECT_THAT(error_of("\nlocal s = 'x'\nwhile true do s = s .. s end"),
              StartsWith("main.lua:3: a string is longer than 1048576 bytes"));
  EXPECT_THAT(error_of("return ('x'):rep(1000):gsub('x', ('y'):rep(10000))"),
              HasSubstr("a string is longer than"));
  EXPECT_THAT(error_of("return ('x'):rep(1e6):gsub('.*', ('%0'):rep(1000))"),
              HasSubstr("a string is longer than"));
  EXPECT_THAT(error_of("return ('x'):rep(1e18, ('y'):rep(1e6))"),
              HasSubstr("a string is longer than"));
}

TEST_F(Limited, Memory) {
  options_.limits.steps = 1'000'000'000;
  EXPECT_THAT(error_of("local t = {}\nfor i = 1, 1e9 do\nt[i] = {i} end"),
              StartsWith("main.lua:3: the scene needs more than 32 MB of memory"));
  EXPECT_THAT(error_of("local t = {}\nfor i = 1, 1e9 do\nt[i] = sphere {} end"),
              StartsWith("main.lua:3: the scene needs more than 32 MB of memory"));
  EXPECT_THAT(error_of("local t = {sphere {}}\nfor i = 1, 1e9 do\nt = {group(t), group(t)} end"),
              HasSubstr("groups are nested too deeply"));
}

TEST_F(Limited, GarbageIsNoReasonToStop) {
  options_.limits.steps = 1'000'000'000;
  EXPECT_EQ(error_of("local s  for i = 1, 200000 do s = sphere { radius = i } end  return s"),
            "no error");
  EXPECT_EQ(error_of("local t  for i = 1, 500000 do t = {i, i, i} end  return {}"), "no error");
}

TEST_F(Limited, DeepRecursion) {
  options_.limits = {};
  EXPECT_EQ(error_of("local function f() return 1 + f() end  f()"),
            "main.lua:1: functions are nested too deeply (stack overflow) (does a function call "
            "itself without end?)");
  EXPECT_THAT(error_of("local function f(n) return coroutine.wrap(f)(n + 1) end  f(0)"),
              HasSubstr("stack overflow"));
  EXPECT_THAT(error_of("local function f() return pcall(f) end  f()"), HasSubstr("no scene"));
  EXPECT_THAT(
      error_of("local s = ('('):rep(1e5) .. '1' .. (')'):rep(1e5)  assert(load('x = ' .. s))"),
      HasSubstr("overflow"));
  EXPECT_THAT(error_of("local t = {}  for i = 1, 1e5 do t = {t} end  return t"),
              HasSubstr("nested too deeply"));
  EXPECT_THAT(error_of("local t = sphere {}  for i = 1, 1e5 do t = group { t } end  return t"),
              HasSubstr("groups are nested too deeply"));
  EXPECT_THAT(error_of("local t = setmetatable({}, {})  getmetatable(t).__index = t  return t.x"),
              HasSubstr("loop"));
  EXPECT_THAT(error_of("return (('a'):rep(300)):find(('a?'):rep(300))"),
              HasSubstr("is too complex"));
}

TEST_F(Limited, TimeIsABackstop) {
  options_.limits = {.seconds = 0.05};
  EXPECT_THAT(error_of("local a, b = ('x'):rep(1e7), ('x'):rep(1e7)  while a == b do end"),
              HasSubstr("the scene takes more than 0.05 s to read"));
}

TEST_F(Limited, ManySolidsAreFine) {
  options_.limits = {};
  const auto loaded = load(R"(
    local t = {}
    for i = 1, 20000 do t[i] = sphere { center = {i, 2 * i, 3}, radius = 0.5 + i % 3 } end
    return scene { objects = t })");
  EXPECT_EQ(loaded.scene.objects.size(), 20000u);
}

}  // namespace
}  // namespace lapidary::lua
