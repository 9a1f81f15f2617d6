#include "film/develop.h"

#include <variant>

#include <gtest/gtest.h>

namespace lapidary::film {
namespace {

/// Two pixels, of which the left one sees object 3.
Film exposed_film(Layers layers) {
  Film film({.width = 2, .height = 1, .layers = layers});
  SampleFaults faults;
  PixelSums left, right;
  film.add({.beauty = {1, 2, 3},
            .albedo = {0.5f, 0.25f, 0},
            .normal = {0, 0, 1},
            .depth = 7,
            .object = 3},
           left, faults);
  film.add({.beauty = {4, 5, 6}}, right, faults);
  film.add_block({0, 1}, 0, 0, left);
  film.add_block({0, 1}, 1, 0, right);
  film.finish_block({0, 1});
  return film;
}

float value(const image::LayeredImage& picture, const char* channel, std::size_t pixel) {
  return std::get<std::vector<float>>(picture.find(channel)->samples).at(pixel);
}

TEST(Develop, TheBeautyAloneIsThreeChannels) {
  const image::LayeredImage picture = develop(exposed_film(Layers::beauty));
  EXPECT_EQ(picture.width, 2);
  EXPECT_EQ(picture.height, 1);
  ASSERT_EQ(picture.channels.size(), 3u);
  EXPECT_EQ(value(picture, "R", 0), 1);
  EXPECT_EQ(value(picture, "G", 0), 2);
  EXPECT_EQ(value(picture, "B", 1), 6);
}

TEST(Develop, AllLayersAreThere) {
  const image::LayeredImage picture = develop(exposed_film(Layers::all));
  EXPECT_EQ(picture.channels.size(), 14u);
  EXPECT_EQ(value(picture, "albedo.R", 0), 0.5f);
  EXPECT_EQ(value(picture, "normal.Z", 0), 1);
  EXPECT_EQ(value(picture, "depth.Z", 0), 7);
  EXPECT_EQ(value(picture, "depth.Z", 1), 0);
  EXPECT_EQ(value(picture, "variance.G", 0), 0);
  const auto& ids = std::get<std::vector<std::uint32_t>>(picture.find("id.object")->samples);
  EXPECT_EQ(ids, (std::vector<std::uint32_t>{3, 0}));
}

}  // namespace
}  // namespace lapidary::film
