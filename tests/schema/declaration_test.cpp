#include "schema/declaration.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "schema/help.h"
#include "schema/literal.h"
#include "schema/node_kind.h"

namespace lapidary::schema {

enum class Finish { dull, shiny };
template <>
struct EnumNames<Finish> {
  static constexpr std::array<std::pair<std::string_view, Finish>, 2> names{
      {{"dull", Finish::dull}, {"shiny", Finish::shiny}}};
};

namespace {

using testing::HasSubstr;

struct Pebble {
  Vec3d center;
  double radius = 1;
  int sides = 3;
  bool hollow = false;
  Finish finish = Finish::dull;
  std::string label;
  std::optional<double> age;
  std::vector<double> weights;
};

Declaration<Pebble> pebble() {
  return Declaration<Pebble>({.name = "pebble", .doc = "A stone.", .section = "solids"})
      .parameter("center", &Pebble::center, {.doc = "Middle.", .unit = Unit::length})
      .parameter("radius", &Pebble::radius,
                 {.doc = "Half the width.", .unit = Unit::length, .range = positive})
      .parameter("sides", &Pebble::sides, {.doc = "How many.", .range = {.min = 3, .max = 100}})
      .parameter("hollow", &Pebble::hollow, {.doc = "Nothing inside."})
      .parameter("finish", &Pebble::finish, {.doc = "Surface."})
      .parameter("label", &Pebble::label, {.doc = "A name.", .shorthand = Shorthand::yes})
      .parameter("age", &Pebble::age, {.doc = "Unknown when left out.", .unit = Unit::seconds})
      .parameter("weights", &Pebble::weights, {.doc = "Some numbers.", .range = non_negative});
}

class DeclarationTest : public testing::Test {
 protected:
  Pebble read(std::string_view literal) {
    const auto value = parse_literal(literal, arena_);
    EXPECT_TRUE(value.has_value()) << literal;
    return declaration_.read(*value, Context(call_));
  }
  std::string error_of(std::string_view literal) {
    try {
      read(literal);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  ValueArena arena_;
  Declaration<Pebble> declaration_ = pebble();
  Call call_{"pebble", CallSite(std::make_shared<const std::string>("scene.lua"), 7)};
};

TEST_F(DeclarationTest, ReadsWhatIsGivenAndKeepsDefaultsOfTheRest) {
  const Pebble p = read(R"({center = {1, 2, 3}, sides = 5, hollow = true, finish = "shiny",
                           age = 4, weights = {1, 2}})");
  EXPECT_EQ(p.center, Vec3d(1, 2, 3));
  EXPECT_EQ(p.radius, 1);
  EXPECT_EQ(p.sides, 5);
  EXPECT_TRUE(p.hollow);
  EXPECT_EQ(p.finish, Finish::shiny);
  EXPECT_EQ(p.age, 4);
  EXPECT_EQ(p.weights, (std::vector<double>{1, 2}));
  EXPECT_FALSE(read("{}").age.has_value());
}

TEST_F(DeclarationTest, TakesTheShorthandParameterAlone) {
  EXPECT_EQ(read("'flint'").label, "flint");
  EXPECT_EQ(read("{'flint'}").label, "flint");
  const Pebble both = read("{'flint', radius = 2}");
  EXPECT_EQ(both.label, "flint");
  EXPECT_EQ(both.radius, 2);
  EXPECT_THAT(error_of("{'flint', label = 'agate'}"), HasSubstr("label twice"));
  EXPECT_THAT(error_of("{'a', 'b', radius = 1}"), HasSubstr("mixes a list"));
}

TEST_F(DeclarationTest, NamesAreOptionalInsideVectors) {
  EXPECT_EQ(read("{center = {z = 2}}").center, Vec3d(0, 0, 2));
  EXPECT_THAT(error_of("{center = {w = 2}}"), HasSubstr("center of pebble must be one of x, y, z"));
  EXPECT_THAT(error_of("{center = {1, 2}}"), HasSubstr("three numbers {x, y, z}, not a list of 2"));
  EXPECT_THAT(error_of("{center = {1, 2, 'a'}}"),
              HasSubstr("center.z of pebble must be a number, not the string 'a'"));
}

TEST_F(DeclarationTest, RefusesWhatItDoesNotKnowWithASuggestion) {
  EXPECT_EQ(error_of("{raduis = 1}"),
            "scene.lua:7: unknown parameter 'raduis' of pebble (did you mean 'radius'?)");
  EXPECT_THAT(error_of("{xyzzy = 1}"), HasSubstr("it has center, radius, sides"));
  EXPECT_THAT(error_of("{finish = 'shiney'}"),
              HasSubstr("must be one of dull, shiny, not the string 'shiney' (did you mean "
                        "'shiny'?)"));
}

TEST_F(DeclarationTest, RefusesWrongTypes) {
  EXPECT_EQ(error_of("{radius = 'big'}"),
            "scene.lua:7: radius of pebble must be a number, not the string 'big'");
  EXPECT_THAT(error_of("{radius = {}}"), HasSubstr("not an empty table"));
  EXPECT_THAT(error_of("{hollow = 1}"), HasSubstr("hollow of pebble must be true or false, not 1"));
  EXPECT_THAT(error_of("{label = 3}"), HasSubstr("label of pebble must be a string, not 3"));
  EXPECT_THAT(error_of("{weights = {1, true}}"),
              HasSubstr("weights[2] of pebble must be a number, not true"));
  EXPECT_THAT(error_of("{sides = 3.5}"), HasSubstr("sides of pebble must be a whole number"));
}

TEST_F(DeclarationTest, RefusesWhatIsOutOfRange) {
  EXPECT_EQ(error_of("{radius = 0}"),
            "scene.lua:7: radius of pebble must be greater than 0, not 0");
  EXPECT_THAT(error_of("{sides = 2}"), HasSubstr("must be from 3 to 100, not 2"));
  EXPECT_THAT(error_of("{weights = {1, -1}}"),
              HasSubstr("weights[2] of pebble must be at least 0"));
}

TEST_F(DeclarationTest, RefusesNumbersThatAreNotFinite) {
  for (const double bad : {std::nan(""), infinity, -infinity}) {
    const Field field{"radius", Value(bad)};
    try {
      declaration_.read(arena_.table({}, {&field, 1}), Context(call_));
      FAIL() << bad;
    } catch (const Error& error) {
      EXPECT_THAT(error.problem(), HasSubstr("radius of pebble must be a finite number"));
      EXPECT_EQ(error.where().parameter, "radius");
      EXPECT_EQ(error.where().line, 7);
    }
  }
}

TEST_F(DeclarationTest, MissingRequiredParametersAreNamed) {
  const auto strict =
      Declaration<Pebble>({.name = "stone", .doc = "."})
          .parameter("radius", &Pebble::radius, {.doc = "Half the width.", .need = Need::required});
  call_.node = "stone";
  try {
    strict.read(Value(), Context(call_));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.problem(), "stone needs its parameter 'radius'");
  }
  EXPECT_THROW(strict.read(Value(2.0), Context(call_)), Error);  // and has no shorthand
}

TEST_F(DeclarationTest, HelpShowsTypesUnitsRangesAndDefaults) {
  const std::string help = help_text(declaration_.info());
  EXPECT_THAT(help, HasSubstr("pebble { ... }   or   pebble LABEL   or   pebble { LABEL, ... }\n"
                              "  A stone.\n"));
  EXPECT_THAT(help, HasSubstr("center   {x, y, z}, scene units; default {0, 0, 0}\n"));
  EXPECT_THAT(help, HasSubstr("radius   number, scene units, greater than 0; default 1\n"));
  EXPECT_THAT(help, HasSubstr("finish   \"dull\" or \"shiny\"; default \"dull\"\n"));
  EXPECT_THAT(help, HasSubstr("age      number, s\n"));
  EXPECT_THAT(help, HasSubstr("weights  list of numbers, at least 0\n"));
}

TEST_F(DeclarationTest, HelpBreaksLinesBetweenWords) {
  const NodeInfo info{.name = "a",
                      .doc = "one two three four",
                      .section = "s",
                      .examples = {"a { 1, 2, 3, 4, 5, 6, 7 }"}};
  EXPECT_EQ(help_text(info, 14),
            "a { ... }\n"
            "  one two\n"
            "  three four\n"
            "\n"
            "  for example\n"
            "    a { 1, 2, 3, 4, 5, 6, 7 }\n");
  EXPECT_EQ(help_index({&info, 1}, 14), "s\n  a  one two\n     three\n     four\n");
}

TEST(Range, IsShownShort) {
  EXPECT_EQ((Range{.min = 1e-12, .max = 1e12}.text()), "from 1e-12 to 1e12");
  EXPECT_EQ((Range{.min = 0, .max = 1e30}.text()), "from 0 to 1e30");
  EXPECT_EQ((Range{.max = 1 << 24}.text()), "at most 16777216");
  EXPECT_EQ((Range{.max = 100000}.text()), "at most 100000");
}

TEST(Words, InLists) {
  const std::array<std::string_view, 3> words = {"a", "b", "c"};
  EXPECT_EQ(join_or_quoted(words), "\"a\", \"b\" or \"c\"");
  EXPECT_EQ(plural("number"), "numbers");
  EXPECT_EQ(plural("{x, y, z}"), "{x, y, z}");
  EXPECT_EQ(plural("list of numbers"), "lists of numbers");
}

TEST_F(DeclarationTest, NodeKindsConstructSharedNodes) {
  const NodeKind kind = node_kind(pebble(), [](Pebble&& p, const Context& context) {
    if (p.hollow && p.radius > 5) context.fail("is too large to be hollow");
    return Node::of("pebble", std::make_shared<const Pebble>(std::move(p)), sizeof(Pebble));
  });
  const Node node = kind.construct(*parse_literal("{radius = 2}", arena_), call_);
  ASSERT_NE(node.as<Pebble>(), nullptr);
  EXPECT_EQ(node.as<Pebble>()->radius, 2);
  EXPECT_EQ(node.as<int>(), nullptr);
  try {
    kind.construct(*parse_literal("{radius = 6, hollow = true}", arena_), call_);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "scene.lua:7: pebble is too large to be hollow");
  }
}

TEST(Value, DescribesItselfOnOneLine) {
  EXPECT_EQ(Value(std::string_view("a\nb")).describe(), "the string 'a b'");
  EXPECT_EQ(Value(std::string_view(std::string(1000, 'x'))).describe().size(), 56u);
  EXPECT_EQ(Value().describe(), "nil");
  EXPECT_EQ(Value::other("a function").describe(), "a function");
}

}  // namespace
}  // namespace lapidary::schema
