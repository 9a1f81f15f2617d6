#include "lua/pattern.h"

#include <memory>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "lua/lua_api.h"
#include "scene_file.h"

namespace lapidary::lua {
namespace {

/// Lua as it comes, for comparison.
class StockLua {
 public:
  StockLua() : L_(luaL_newstate(), lua_close) { luaL_openlibs(L_.get()); }

  /// What the function in `text` gives for subject and pattern, as one line; "error" when it fails.
  std::string call(const std::string& text, const std::string& subject,
                   const std::string& pattern) {
    lua_State* L = L_.get();
    lua_settop(L, 0);
    if (luaL_dostring(L, text.c_str()) != LUA_OK) throw std::logic_error(lua_tostring(L, -1));
    lua_pushlstring(L, subject.data(), subject.size());
    lua_pushlstring(L, pattern.data(), pattern.size());
    if (lua_pcall(L, 2, 1, 0) != LUA_OK) return "error";
    return lua_tostring(L, -1);
  }

 private:
  std::unique_ptr<lua_State, decltype(&lua_close)> L_;
};

/// Four ways to use a pattern, each printed as one line.
constexpr const char* probes[] = {
    "return function(s, p) return table.concat({tostring(s:find(p)), select(2, s:find(p)) or ''}, "
    "' ') end",
    "return function(s, p) local t = {s:match(p)} for i = 1, #t do t[i] = tostring(t[i]) end "
    "return table.concat(t, '|') end",
    "return function(s, p) local r = {} for a, b in s:gmatch(p) do "
    "r[#r + 1] = tostring(a) .. tostring(b) end return table.concat(r, '|') end",
    "return function(s, p) local r, n = s:gsub(p, '<%0>') return r .. n end",
};

class PatternTest : public SceneFile {
 protected:
  /// What the sandbox gives for many (subject, pattern) at once.
  std::vector<std::string> sandbox(const std::string& probe,
                                   const std::vector<std::string>& subjects,
                                   const std::vector<std::string>& patterns) {
    std::string text = "local f = (function() " + probe + " end)()\nlocal data = {\n";
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      text += "{'" + subjects[i] + "', '" + patterns[i] + "'},\n";
    }
    text +=
        "}\nfor _, d in ipairs(data) do\n"
        "local ok, r = pcall(f, d[1], d[2])  print(ok and r or 'error') end";
    return output_of(text);
  }
};

TEST_F(PatternTest, AgreesWithLuaOnRandomPatterns) {
  std::mt19937 random(7);
  const std::string parts[] = {"a",  "b",     ".",  "%a",  "%d",   "[ab]",  "[^a]",   "[a-c]",
                               "(",  ")",     "()", "*",   "+",    "-",     "?",      "^",
                               "$",  "%1",    "1",  " ",   "%b()", "%f[a]", "%f[%s]", "%s",
                               "%S", "[%w_]", "%.", "[]]", "%x",   "[a-]",  "%W",     "%2"};
  const std::string letters = "aabbc1 ().x-";
  StockLua stock;
  for (const char* probe : probes) {
    std::vector<std::string> subjects, patterns;
    for (int i = 0; i < 4000; ++i) {
      std::string subject, pattern;
      for (unsigned n = random() % 14; n > 0; --n) subject += letters[random() % letters.size()];
      for (unsigned n = 1 + random() % 7; n > 0; --n) {
        pattern += parts[random() % std::size(parts)];
      }
      subjects.push_back(subject);
      patterns.push_back(pattern);
    }
    const auto ours = sandbox(probe, subjects, patterns);
    ASSERT_EQ(ours.size(), subjects.size());
    int matched = 0, failed = 0;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      const std::string theirs = stock.call(probe, subjects[i], patterns[i]);
      // A malformed end is noticed here at once, by Lua only when matching gets there.
      if (ours[i] == "error") {
        ++failed;
        continue;
      }
      matched += theirs != "nil " && !theirs.empty();
      EXPECT_EQ(ours[i], theirs) << "'" << subjects[i] << "' '" << patterns[i] << "' " << probe;
    }
    EXPECT_GT(matched, 400);
    EXPECT_LT(failed, 3000);
  }
}

TEST_F(PatternTest, MalformedOnesAreErrors) {
  for (const char* bad : {"%", "[a", "[", "[^", "(a", "a)", "%b", "%bx", "%f", "%fa", "%1", "(%1)",
                          "[%", "()%2", "%0"}) {
    EXPECT_THROW(Pattern{bad}, Error) << bad;
  }
  EXPECT_THROW(Pattern(std::string(33, '(') + std::string(33, ')')), Error);
}

TEST_F(PatternTest, WellFormedOnesOfLuaAreNot) {
  StockLua stock;
  for (const char* good : {"", "^", "$", "^$", "[]]", "[^]]", "a-", "-", "*a", "%%", "%]", "[%]]",
                           "(a)(b)%2%1", "%b()", "%f[%w]%w+", "()()", "[a-]", "[-a]", "[%a-z]"}) {
    EXPECT_NO_THROW(Pattern{good}) << good;
    EXPECT_NE(stock.call(probes[0], "some text", good), "error") << good;
  }
}

TEST_F(PatternTest, Replacements) {
  const std::string main = (folder_ / "scene/main.lua").string();
  const std::vector<std::string> expected{
      "hell0 world\t1",
      "-h-e-l-l-o-\t6",
      "aabbcc\t3",
      "bac\t1",
      "Ann is 5\t2",
      "AbC\t3",
      "a%c\t1",
      "false\t" + main + ":9: gsub's replacement uses %2, which the pattern lacks",
      "false\t" + main +
          ":10: gsub's replacement has a % that is followed by neither a digit nor %",
      "2\t3\tnil",
      "k\t2\t3"};
  EXPECT_EQ(output_of(R"lua(
    print(("hello world"):gsub("o", "0", 1))
    print(("hello"):gsub("", "-"))
    print(("abc"):gsub("%w", "%0%0"))
    print(("abc"):gsub("(%w)(%w)", "%2%1"))
    print(("$name is $age"):gsub("%$(%w+)", { name = "Ann", age = 5 }))
    print(("abc"):gsub("%w", function(c) if c == "b" then return false end return c:upper() end))
    print(("abc"):gsub("b", "%%"))
    print(pcall(string.gsub, "abc", "b", "%2"))
    print(pcall(string.gsub, "abc", "b", "%x"))
    print(("a.b"):find(".", 1, true), ("a.b"):find("b", -1), ("abc"):find("b", 10))
    print(("k = v"):match("^(%w+)%s*=%s*(%w+)$"), ("xyz"):match("()y()")))lua"),
            expected);
}

}  // namespace
}  // namespace lapidary::lua
