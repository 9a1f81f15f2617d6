#include <gmock/gmock.h>

#include "scene_file.h"

namespace lapidary::lua {
namespace {

using testing::HasSubstr;

/// Methods and operators of textures, as scenes use them.
class TextureValues : public SceneFile {
 protected:
  std::string error_with(const std::string& expression) {
    return error_of("local t = checker {}\nlocal result = " + expression + "\nreturn {}");
  }
};

TEST_F(TextureValues, HaveTheMotionsOfObjects) {
  for (const char* motion :
       {":translate { 1, 2, 3 }", ":rotate { z = 30 }", ":scale(2)", ":mirror { 1, 0, 0 }",
        ":scale(2):rotate { axis = { 1, 1, 0 }, angle = 5 }",
        ":transform { { 1, 0, 1, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } }"}) {
    EXPECT_EQ(error_with(std::string("t") + motion), "no error") << motion;
  }
  EXPECT_THAT(error_with("t:scale(0)"), HasSubstr("main.lua:2: scale must not be 0: it would"));
  EXPECT_THAT(error_with("t:skale(2)"),
              HasSubstr("textures have no method 'skale' (did you mean 'scale'?)"));
  EXPECT_THAT(error_with("t.scale(2)"), HasSubstr("scale must be called on a texture"));
  EXPECT_THAT(error_with("t:material(matte 'red')"), HasSubstr("textures have no method"));
  EXPECT_THAT(error_with("sphere {}.scale(t, 2)"), HasSubstr("scale must be called on an object"));
  EXPECT_THAT(error_with("t:scale(1e-200):scale(1e-200)"), HasSubstr("leaves nothing"));
}

TEST_F(TextureValues, CanBeReckonedWith) {
  for (const char* expression : {"t + t",
                                 "t - 1",
                                 "2 * t",
                                 "t / 3",
                                 "-t",
                                 "t ^ 2",
                                 "2 ^ t",
                                 "t + '#ff8800'",
                                 "{0.5, 0.2, 0.1} * t",
                                 "1 - t * 0.5",
                                 "t * spectrum { from = 500, step = 100, values = { 0, 0.9 } }",
                                 "mix(t, 'red', 0.3)",
                                 "mix { t, t, t }",
                                 "clamp(t * 3)",
                                 "clamp(t, 0.1, 0.3)",
                                 "min(t, 1)",
                                 "max(t, t)",
                                 "power(t, 2)",
                                 "invert(t)",
                                 "luminance(t)",
                                 "channel(t, 'red')",
                                 "ramp { t, colors = { {0, 'red'}, {0.5, 'blue'}, {1, t} } }",
                                 "ramp { t, from = 1, to = 0 }",
                                 "matte(t * 0.5)",
                                 "metal { color = t, roughness = t * 0.1 }"}) {
    EXPECT_EQ(error_with(expression), "no error") << expression;
  }
}

TEST_F(TextureValues, SayWhatCannotBeReckonedWith) {
  EXPECT_EQ(error_with("t * sphere {}"),
            "main.lua:2: cannot multiply a checker by a sphere (textures are reckoned with among "
            "themselves, and with numbers and colors)");
  EXPECT_THAT(error_with("sphere {} + t"), HasSubstr("cannot add a sphere and a checker"));
  EXPECT_THAT(error_with("nil - t"), HasSubstr("cannot subtract a checker from nil"));
  EXPECT_THAT(error_with("t / checker"), HasSubstr("cannot divide a checker by a function"));
  EXPECT_THAT(error_with("t * 'redd'"), HasSubstr("right side of texture names no color"));
  EXPECT_THAT(error_with("t / (1 / 0)"), HasSubstr("must be a finite number"));
  EXPECT_THAT(error_with("t | t"), HasSubstr("there is no '|' of textures"));
  EXPECT_THAT(error_with("t % 2"), HasSubstr("there is no '%' of textures"));
  EXPECT_THAT(error_with("~t"), HasSubstr("there is no '~' of textures"));
  EXPECT_THAT(error_with("-matte(0.5)"), HasSubstr("there is no '-' of solids"));
  EXPECT_THAT(error_with("mix(t, t)"), HasSubstr("mix takes two textures, numbers or colors, and"));
  EXPECT_THAT(error_with("mix(t, t, 2)"), HasSubstr("must be from 0 to 1"));
  EXPECT_THAT(error_with("clamp(t, 1, 0)"), HasSubstr("the lower number before"));
  EXPECT_THAT(error_with("channel(t, 'rde')"), HasSubstr("did you mean 'red'?"));
  EXPECT_THAT(error_with("ramp { t, from = 1 }"), HasSubstr("to of ramp must differ from 'from'"));
}

TEST_F(TextureValues, SayWhatIsWrongWithTheirColors) {
  EXPECT_THAT(error_with("fbm { 'red', 'blu' }"), HasSubstr("colors[2] of fbm names no color"));
  EXPECT_THAT(error_with("fbm { colors = 'red' }"), HasSubstr("must be a list of colors"));
  EXPECT_THAT(error_with("fbm { colors = { {0, 'red'}, 'blue' } }"),
              HasSubstr("colors[2] of fbm must have a position as all others"));
  EXPECT_THAT(error_with("fbm { colors = { {0.5, 'red'}, {0.2, 'blue'} } }"),
              HasSubstr("must not come before the one above"));
  EXPECT_THAT(error_with("fbm { colors = { {0.5, 'red'}, {2, 'blue'} } }"),
              HasSubstr("must be from 0 to 1, not 2"));
  EXPECT_THAT(error_with("bricks { joint = 0.3 }"), HasSubstr("leaves nothing of the bricks"));
  EXPECT_THAT(error_with("bricks { size = { 0, 1 } }"), HasSubstr("must be greater than 0"));
  EXPECT_THAT(error_with("gradient { axis = { 0, 0, 0 } }"), HasSubstr("must not be zero"));
}

// What is looked at for every point of a picture must come to an end.
TEST_F(TextureValues, AreMadeOfAFiniteNumberOfOthers) {
  EXPECT_THAT(error_with("t for i = 1, 100 do result = result + 1 end"),
              HasSubstr("textures of textures are nested more than 100 deep"));
  EXPECT_THAT(error_with("t for i = 1, 50 do result = result + result end"),
              HasSubstr("a texture is made of more than 10000 others"));
}

TEST_F(TextureValues, CannotContainThemselves) {
  EXPECT_THAT(error_with("checker {} result.colors = { result, result }"),
              HasSubstr("main.lua:2: a checker cannot be changed"));
  EXPECT_THAT(error_with("(function() local c = { 'red' } c[2] = c return checker(c) end)()"),
              HasSubstr("nested too deeply (does it contain itself?)"));
}

}  // namespace
}  // namespace lapidary::lua
