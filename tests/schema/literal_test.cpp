#include "schema/literal.h"

#include <random>
#include <string>

#include <gtest/gtest.h>

namespace lapidary::schema {
namespace {

TEST(Literal, ReadsScalars) {
  ValueArena arena;
  EXPECT_EQ(parse_literal("12", arena)->number(), 12);
  EXPECT_EQ(parse_literal(" -1.5e3 ", arena)->number(), -1500);
  EXPECT_EQ(parse_literal(".5", arena)->number(), 0.5);
  EXPECT_TRUE(parse_literal("true", arena)->boolean());
  EXPECT_TRUE(parse_literal("nil", arena)->is_nil());
  EXPECT_EQ(parse_literal(R"("a\"b\n")", arena)->string(), "a\"b\n");
  EXPECT_EQ(parse_literal("'it'", arena)->string(), "it");
}

TEST(Literal, ReadsTables) {
  ValueArena arena;
  const auto value = parse_literal("{1, {2, 3}; z = 'last', a = true,}", arena);
  ASSERT_TRUE(value && value->kind() == ValueKind::table);
  const auto [items, fields] = value->table();
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(items[1].table().items[1].number(), 3);
  ASSERT_EQ(fields.size(), 2u);
  EXPECT_EQ(fields[0].key, "a");
  EXPECT_EQ(fields[1].value.string(), "last");
}

TEST(Literal, LeavesEverythingElseAlone) {
  ValueArena arena;
  for (const char* text :
       {"", " ", "abc", "2024-01-05", "960x540", "1 2", "{", "{1", "{a=}", "'open", "inf", "nan",
        "-", "--1", "1e", "print()", "{print}", "'\\", "1e999"}) {
    EXPECT_FALSE(parse_literal(text, arena)) << text;
  }
  EXPECT_FALSE(parse_literal(std::string(100000, '{'), arena));
}

TEST(Literal, SurvivesNoise) {
  std::mt19937 random(1);
  const std::string letters = "{}=,;'\"\\ a1.-e_tn";
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (unsigned n = random() % 20; n > 0; --n) text += letters[random() % letters.size()];
    ValueArena arena;
    parse_literal(text, arena);
  }
}

}  // namespace
}  // namespace lapidary::schema
