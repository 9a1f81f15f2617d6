#include "import/image_file.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "base/error.h"
#include "image/image_io.h"
#include "spectrum/color.h"
#include "temp_folder.h"

namespace lapidary::import {
namespace {

using image::Image;
using testing::HasSubstr;
using texture::Filter;
using texture::Wrap;

class ImageFileTest : public testing::Test {
 protected:
  /// A file with one pixel of these values.
  std::filesystem::path file(const std::string& name, std::initializer_list<float> pixel) {
    Image picture(1, 1, static_cast<int>(pixel.size()));
    picture.pixels = pixel;
    image::write_image(folder_.path() / name, picture);
    return folder_.path() / name;
  }
  Rgb color(const std::filesystem::path& file, PictureOptions options) {
    return files_.read(file, options)->mean({}, Wrap::repeat, Filter::smooth);
  }
  std::string error_of(const std::filesystem::path& file, PictureOptions options = {}) {
    try {
      files_.read(file, options);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  TempFolder folder_;
  ImageFiles files_;
};

TEST_F(ImageFileTest, SaysWhatNumbersMean) {
  const Rgb light = srgb_decode(Rgb{200 / 255.0f, 100 / 255.0f, 50 / 255.0f});
  const auto png = file("a.png", {light.r, light.g, light.b});
  EXPECT_EQ(color(png, {}), light);
  EXPECT_EQ(color(png, {.space = PictureSpace::srgb}), light);
  EXPECT_EQ(color(png, {.space = PictureSpace::linear}),
            (Rgb{200 / 255.0f, 100 / 255.0f, 50 / 255.0f}));
  const auto exr = file("a.exr", {0.5f, 0.25f, 0.125f});
  EXPECT_EQ(color(exr, {}), (Rgb{0.5f, 0.25f, 0.125f}));
  EXPECT_EQ(color(exr, {.space = PictureSpace::linear}), (Rgb{0.5f, 0.25f, 0.125f}));
  EXPECT_NEAR(color(exr, {.space = PictureSpace::srgb}).r, srgb_decode(0.5f), 2e-4f);
}

TEST_F(ImageFileTest, TakesOneChannelAsPlainNumbers) {
  const Rgb light = srgb_decode(Rgb{200 / 255.0f, 100 / 255.0f, 50 / 255.0f});
  const auto png = file("a.png", {light.r, light.g, light.b});
  const auto number = [&](PictureChannel channel) { return color(png, {.channel = channel}).g; };
  EXPECT_EQ(number(PictureChannel::red), 200 / 255.0f);
  EXPECT_EQ(number(PictureChannel::green), 100 / 255.0f);
  EXPECT_EQ(number(PictureChannel::blue), 50 / 255.0f);
  EXPECT_EQ(number(PictureChannel::alpha), 1.0f);
  const auto exr = file("a.exr", {0.5f, 0.25f, 0.125f, 0.75f});
  EXPECT_EQ(color(exr, {.channel = PictureChannel::alpha}).g, 0.75f);
  EXPECT_EQ(color(png, {.space = PictureSpace::srgb, .channel = PictureChannel::red}).g, light.r);
}

TEST_F(ImageFileTest, IsSharedByTheSameUses) {
  const auto png = file("a.png", {0.5f, 0.25f, 0.125f});
  const auto first = files_.read(png, {});
  const std::size_t bytes = files_.bytes();
  EXPECT_GE(bytes, first->bytes());
  EXPECT_EQ(files_.read(png, {}), first);
  EXPECT_EQ(files_.bytes(), bytes);
  EXPECT_NE(files_.read(png, {.channel = PictureChannel::red}), first);
  EXPECT_GT(files_.bytes(), bytes);
}

TEST_F(ImageFileTest, RefusesWhatIsNoWholePicture) {
  EXPECT_THAT(error_of(folder_.path() / "none.png"), HasSubstr("cannot be opened"));
  EXPECT_THAT(error_of(folder_.path()), HasSubstr("is a folder"));
  EXPECT_THAT(error_of(folder_.write("empty.png", "")), HasSubstr("is empty"));
  EXPECT_THAT(error_of(folder_.write("a.png", "#!/bin/sh")), HasSubstr("is not a picture"));
  EXPECT_THAT(error_of(folder_.write("short.png", "\x89PNG\r\n\x1a\n")), HasSubstr("short.png"));
  // 100000 x 100000 pixels in a header of Radiance.
  EXPECT_THAT(error_of(folder_.write("giant.hdr", "#?RADIANCE\n\n-Y 100000 +X 100000\n")),
              HasSubstr("giant.hdr"));
}

TEST_F(ImageFileTest, RefusesWhatIsNotFinite) {
  const float inf = std::numeric_limits<float>::infinity();
  EXPECT_THAT(error_of(file("inf.exr", {0.5f, inf, 0.5f})), HasSubstr("pixel (0, 0) is not a fin"));
  EXPECT_EQ(error_of(file("inf.exr", {0.5f, inf, 0.5f}), {.channel = PictureChannel::red}),
            "no error");
  EXPECT_THAT(error_of(file("nan.exr", {0.5f, 0.5f, std::nanf("")})), HasSubstr("is not a finite"));
}

}  // namespace
}  // namespace lapidary::import
