#include <gmock/gmock.h>

#include "image/image_io.h"
#include "scene_file.h"
#include "texture/texture.h"

namespace lapidary::lua {
namespace {

using testing::HasSubstr;

class ImageNode : public SceneFile {
 protected:
  ImageNode() {
    std::filesystem::create_directories(folder_ / "scene");
    image::write_image(folder_ / "scene/wood.png", image::Image(2, 2));
  }
};

TEST_F(ImageNode, TakesAFile) {
  EXPECT_EQ(error_of("local t = image 'wood.png' return {}"), "no error");
  EXPECT_EQ(error_of("local t = image { 'wood.png', color_space = 'linear', wrap = 'clamp',\n"
                     "  filter = 'nearest', channel = 'red', mapping = 'box', blend = 0.5 }\n"
                     "return {}"),
            "no error");
}

TEST_F(ImageNode, NamesThePlaceOfWhatIsWrong) {
  write("scene/empty.png", "");
  write("scene/text.png", "this is text");
  EXPECT_THAT(error_of("\nlocal t = image 'empty.png' return {}"),
              testing::AllOf(HasSubstr("main.lua:2: "), HasSubstr("empty.png is empty")));
  EXPECT_THAT(error_of("local t = image 'text.png' return {}"),
              HasSubstr("text.png is not a picture in a known format (PNG, JPEG"));
  write("scene/giant.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2000000000 +X 2000000000\n");
  EXPECT_THAT(error_of("local t = image 'giant.hdr' return {}"),
              testing::AllOf(HasSubstr("main.lua:1: "), HasSubstr("claims 2000000000 x 2")));
  const auto wood = folder_ / "scene/wood.png";
  std::filesystem::resize_file(wood, std::filesystem::file_size(wood) / 2);
  EXPECT_THAT(error_of("local t = image 'wood.png' return {}"),
              testing::AllOf(HasSubstr("main.lua:1: "), HasSubstr("wood.png is a broken PNG file"),
                             HasSubstr("ends early")));
  EXPECT_THAT(error_of("local t = image 'woof.png' return {}"),
              HasSubstr("file of image names a file that does not exist: 'woof.png' (did you mean "
                        "'wood.png'?)"));
  EXPECT_THAT(error_of("local t = image '../wood.png' return {}"),
              HasSubstr("main.lua:1: file of"));
  EXPECT_THAT(error_of("local t = image {} return {}"),
              HasSubstr("image needs its parameter 'file'"));
  EXPECT_THAT(error_of("local t = image { 'wood.png', wrap = 'repeated' } return {}"),
              HasSubstr("(did you mean 'repeat'?)"));
  EXPECT_THAT(error_of("local t = image { 'wood.png', channel = 'r' } return {}"),
              HasSubstr("channel of image must be one of color, red"));
}

TEST_F(ImageNode, PaysForItsPixels) {
  image::write_image(folder_ / "scene/large.png", image::Image(2048, 2048));
  options_.limits.memory = std::size_t{4} << 20;
  EXPECT_THAT(error_of("local t = image 'large.png' return {}"),
              HasSubstr("main.lua:1: the scene needs more than 4 MB of memory"));
  // One picture, one channel: 4/3 of 4 MB, however often it is used.
  options_.limits.memory = std::size_t{7} << 20;
  EXPECT_EQ(error_of("local t = {}\nfor i = 1, 100 do t[i] = image 'large.png' end\nreturn {}"),
            "no error");
}

}  // namespace
}  // namespace lapidary::lua
