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

}  // namespace
}  // namespace lapidary::lua
