#include "schema/suggest.h"

#include <array>

#include <gtest/gtest.h>

namespace lapidary::schema {
namespace {

constexpr std::array<std::string_view, 5> words{"sphere", "box", "cylinder", "radius", "at"};

TEST(Nearest, FindsMisspellings) {
  EXPECT_EQ(nearest("spere", words), "sphere");
  EXPECT_EQ(nearest("Sphere", words), "sphere");
  EXPECT_EQ(nearest("raduis", words), "radius");
  EXPECT_EQ(nearest("boxx", words), "box");
  EXPECT_EQ(nearest("cilynder", words), "cylinder");
}

TEST(Nearest, DoesNotGuessWildly) {
  EXPECT_EQ(nearest("torus", words), "");
  EXPECT_EQ(nearest("up", words), "");
  EXPECT_EQ(nearest("", words), "");
  EXPECT_EQ(nearest(std::string(10000, 'a'), words), "");
  EXPECT_EQ(nearest("sphere", {}), "");
}

TEST(DidYouMean, IsAHint) {
  EXPECT_EQ(did_you_mean("spere", words), "did you mean 'sphere'?");
  EXPECT_EQ(did_you_mean("quux", words), "");
}

}  // namespace
}  // namespace lapidary::schema
