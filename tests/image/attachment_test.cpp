#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "files.h"
#include "image/image_io.h"

namespace lapidary::image {
namespace {

using namespace test;

constexpr int width = 33, height = 21;

/// Any bits at all.
std::uint32_t number(std::size_t channel, int x, int y) {
  return static_cast<std::uint32_t>(x + 1) * 0x9E3779B9u ^
         static_cast<std::uint32_t>(y + 3) * 0x85EBCA6Bu ^
         static_cast<std::uint32_t>(channel) * 0xC2B2AE35u;
}

Attachment numbers() {
  Attachment attachment{
      "numbers", width, height, {}, {{"what", "sums"}, {"long", "a = 1\nb = 2\n"}}};
  for (std::size_t c = 0; c < 3; ++c) {
    attachment.channels.push_back(
        {"n" + std::to_string(c), [c](int y, std::span<std::uint32_t> row) {
           for (int x = 0; x < width; ++x) {
             row[static_cast<std::size_t>(x)] = number(c, x, y);
           }
         }});
  }
  return attachment;
}

LayeredImage picture() {
  const Image image = random_image(width, height);
  LayeredImage layers{width, height, {}, {{"scene", "a.lua"}}};
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<float> samples;
    for (std::size_t i = c; i < image.pixels.size(); i += 3) samples.push_back(image.pixels[i]);
    layers.channels.push_back({std::string(1, "BGR"[c]), std::move(samples)});
  }
  return layers;
}

TEST(Attachment, TravelsWithThePicture) {
  const Folder folder;
  for (const Compression compression : {Compression::zip, Compression::none}) {
    write_image(folder / "a.exr", picture(), numbers(), {.compression = compression});
    EXPECT_EQ(read_layers(folder / "a.exr"), picture());
    const auto part = read_part(folder / "a.exr", "numbers");
    ASSERT_TRUE(part);
    EXPECT_EQ(part->width, width);
    ASSERT_EQ(part->channels.size(), 3u);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& samples = std::get<std::vector<std::uint32_t>>(part->channels[c].samples);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          ASSERT_EQ(samples[static_cast<std::size_t>(y * width + x)], number(c, x, y));
        }
      }
    }
    EXPECT_THAT(part->metadata, testing::Contains(Attribute{"long", "a = 1\nb = 2\n"}));
    EXPECT_FALSE(read_part(folder / "a.exr", "other"));
  }
  write_image(folder / "b.exr", picture());
  EXPECT_FALSE(read_part(folder / "b.exr", "numbers"));
}

// Programs that were written before there were files of several parts see the picture, and those
// that want RGBA alone.
TEST(Attachment, IsPassedOverByOtherPrograms) {
  const Folder folder;
  write_image(folder / "a.exr", picture(), numbers());
  Imf::InputFile old((folder / "a.exr").c_str());
  EXPECT_NE(old.header().channels().findChannel("R"), nullptr);
  EXPECT_EQ(old.header().channels().findChannel("n0"), nullptr);
  Imf::RgbaInputFile colors((folder / "a.exr").c_str());
  ASSERT_EQ(colors.dataWindow().max, Imath::V2i(width - 1, height - 1));
  std::vector<Imf::Rgba> pixels(width * height);
  colors.setFrameBuffer(pixels.data(), 1, width);
  colors.readPixels(0, height - 1);
  const Image expected = read_image(folder / "a.exr");
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    ASSERT_NEAR(pixels[i].r, expected.pixels[3 * i], 1e-3f * expected.pixels[3 * i]);
    ASSERT_NEAR(pixels[i].b, expected.pixels[3 * i + 2], 1e-3f * expected.pixels[3 * i + 2]);
  }
}

TEST(Attachment, OfAFileThatWasCutIsAnError) {
  const Folder folder;
  write_image(folder / "a.exr", picture(), numbers(), {.compression = Compression::none});
  const std::string bytes = bytes_of(folder / "a.exr");
  for (std::size_t size = 1; size < bytes.size(); size += bytes.size() / 40) {
    put_bytes(folder / "cut.exr", bytes.substr(0, size));
    EXPECT_THROW(read_part(folder / "cut.exr", "numbers"), Error) << size;
  }
  write_image(folder / "a.png", picture());
  EXPECT_THROW(read_part(folder / "a.png", "numbers"), Error);
  EXPECT_THROW(read_part(folder / "gone.exr", "numbers"), Error);
  EXPECT_THROW(write_image(folder / "a.png", picture(), numbers()), Error);
}

}  // namespace
}  // namespace lapidary::image
