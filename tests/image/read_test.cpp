#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exr_maker.h"
#include "files.h"
#include "image/image_io.h"
#include "jpeg_maker.h"
#include "png_maker.h"
#include "spectrum/color.h"

namespace lapidary::image {
namespace {

using namespace test;
using namespace std::string_literals;
using ::testing::HasSubstr;

float light_of_code(int code) {
  return srgb_decode(static_cast<float>(code) / 255.0f);
}

TEST(ReadPng, GreyOfEveryDepth) {
  for (const char depth : {'\1', '\2', '\4', '\x8'}) {
    // Two pixels: the largest code, then 1.
    const int largest = (1 << depth) - 1;
    std::string row(
        1, static_cast<char>(depth == 8 ? largest : largest << (8 - depth) | 1 << (8 - 2 * depth)));
    if (depth == 8) row += '\1';
    const Image image = image_of(png::file({2, 1, depth, png::grey}, "", {row}));
    EXPECT_EQ(image.rgb(0, 0), (Rgb{1, 1, 1}));
    const float light = srgb_decode(1.0f / static_cast<float>(largest));
    EXPECT_NEAR(image.rgb(1, 0).g, light, 1e-6) << int{depth};
  }
}

TEST(ReadPng, SixteenBits) {
  const std::string bytes =
      png::file({2, 1, 16, png::rgb}, "", {"\x12\x34\x56\x78\x9A\xBC\0\0\0\1\xFF\xFF"s});
  const Image image = image_of(bytes);
  EXPECT_NEAR(image.rgb(0, 0).r, srgb_decode(0x1234 / 65535.0f), 1e-7);
  EXPECT_NEAR(image.rgb(0, 0).b, srgb_decode(0x9ABC / 65535.0f), 1e-6);
  EXPECT_EQ(image.rgb(1, 0).b, 1);
  const Image linear = image_of(bytes, {.color_space = ColorSpace::linear});
  EXPECT_NEAR(linear.rgb(0, 0).g, 0x5678 / 65535.0, 1e-7);
  EXPECT_NEAR(linear.rgb(1, 0).g, 1 / 65535.0, 1e-9);
}

TEST(ReadPng, PaletteWithTransparency) {
  const std::string chunks =
      png::chunk("PLTE", "\x0A\x14\x1E\xC8\xD2\xDC"s) + png::chunk("tRNS", "\x33"s);
  const std::string bytes = png::file({3, 1, 8, png::palette}, chunks, {"\1\0\1"s});
  const Image image = image_of(bytes);
  EXPECT_EQ(image.channels, 3);
  EXPECT_EQ(image.rgb(0, 0), (Rgb{light_of_code(200), light_of_code(210), light_of_code(220)}));
  EXPECT_EQ(image.rgb(1, 0), (Rgb{light_of_code(10), light_of_code(20), light_of_code(30)}));
  const Image kept = image_of(bytes, {.alpha = Alpha::keep});
  ASSERT_EQ(kept.channels, 4);
  EXPECT_EQ(kept.pixel(0, 0)[3], 1);
  EXPECT_NEAR(kept.pixel(1, 0)[3], 0x33 / 255.0, 1e-7);
}

TEST(ReadPng, AlphaIsDroppedOrKept) {
  const std::string bytes = png::file({1, 2, 8, png::grey_alpha}, "", {"\x80\x40", "\xFF\xFF"});
  const Image dropped = image_of(bytes);
  EXPECT_EQ(dropped.channels, 3);
  EXPECT_EQ(dropped.rgb(0, 0).g, light_of_code(128));
  const Image kept = image_of(bytes, {.alpha = Alpha::keep});
  EXPECT_EQ(kept.channels, 4);
  EXPECT_EQ(kept.pixel(0, 0)[1], light_of_code(128));
  EXPECT_NEAR(kept.pixel(0, 0)[3], 64 / 255.0, 1e-7);  // alpha is no colour: never sRGB
  const Image opaque =
      image_of(png::file({1, 1, 8, png::rgb}, "", {"abc"}), {.alpha = Alpha::keep});
  EXPECT_EQ(opaque.pixel(0, 0)[3], 1);
}

TEST(ReadPng, Interlaced) {
  // 8 x 8 grey with code 8 y + x: the seven passes of Adam7.
  std::vector<std::string> rows;
  constexpr int passes[7][4] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  for (const auto& [x0, y0, dx, dy] : passes) {
    for (int y = y0; y < 8; y += dy) {
      rows.emplace_back();
      for (int x = x0; x < 8; x += dx) rows.back() += static_cast<char>(8 * y + x);
    }
  }
  const Image image = image_of(png::file({8, 8, 8, png::grey, 1}, "", rows));
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) EXPECT_EQ(image.rgb(x, y).r, light_of_code(8 * y + x));
  }
}

TEST(ReadJpeg, GreyAndProgressive) {
  for (const bool progressive : {false, true}) {
    const Image grey = image_of(jpeg_bytes(JCS_GRAYSCALE, {100}, progressive));
    EXPECT_EQ(grey.width, 24);
    EXPECT_NEAR(grey.rgb(23, 23).b, light_of_code(100), 0.003);
    const Image color = image_of(jpeg_bytes(JCS_RGB, {200, 100, 50}, progressive));
    EXPECT_NEAR(color.rgb(5, 5).r, light_of_code(200), 0.02);
    EXPECT_NEAR(color.rgb(5, 5).b, light_of_code(50), 0.005);
  }
  EXPECT_NEAR(image_of(jpeg_bytes(JCS_GRAYSCALE, {51}, false),
                       {.color_space = ColorSpace::linear, .alpha = Alpha::keep})
                  .pixel(3, 3)[0],
              0.2, 0.005);
}

TEST(ReadJpeg, CmykIsRefused) {
  EXPECT_THAT(refusal_of(jpeg_bytes(JCS_CMYK, {1, 2, 3, 4}, false)), HasSubstr("CMYK"));
}

TEST(ReadRadiance, FlatPixels) {
  // Mantissa 128 with exponent 129 is 128 * 2^(129 - 136) = 1.
  const Image image = image_of(radiance("-Y 1 +X 2", "\x80\x40\x00\x81\x80\x80\xFF\x80"s));
  EXPECT_EQ(image.rgb(0, 0), (Rgb{1, 0.5f, 0}));
  EXPECT_EQ(image.rgb(1, 0), (Rgb{0.5f, 0.5f, 255.0f / 256}));
}

TEST(ReadRadiance, OldRuns) {
  // One pixel, 2 more of it, then 0 * 256 + 1 * 256^1: marks in a row are digits, lowest first.
  const std::string pixel = "\x80\x40\x20\x81"s, other = "\x20\x40\x80\x81"s;
  const Image image =
      image_of(radiance("-Y 1 +X 260", pixel + "\1\1\1\2"s + other + "\1\1\1\0\1\1\1\1"s));
  EXPECT_EQ(image.rgb(2, 0), (Rgb{1, 0.5f, 0.25f}));
  EXPECT_EQ(image.rgb(3, 0), (Rgb{0.25f, 0.5f, 1}));
  EXPECT_EQ(image.rgb(259, 0), (Rgb{0.25f, 0.5f, 1}));
}

TEST(ReadRadiance, NewRuns) {
  const std::string row =
      "\2\2\0\x8"s + "\x88\x80"s + "\4\x10\x20\x30\x40\x84\x80"s + "\x88\x00"s + "\x88\x81"s;
  const Image image = image_of(radiance("-Y 2 +X 8", row + row));
  EXPECT_EQ(image.rgb(1, 1), (Rgb{1, 0.25f, 0}));
  EXPECT_EQ(image.rgb(7, 0), (Rgb{1, 1, 0}));
}

TEST(ReadRadiance, Orientations) {
  const std::string pixels = "\x80\0\0\x81\0\x80\0\x81\0\0\x80\x81\x80\x80\x80\x81"s;
  const Rgb red{1, 0, 0}, green{0, 1, 0};
  EXPECT_EQ(image_of(radiance("-Y 2 +X 2", pixels)).rgb(0, 0), red);
  EXPECT_EQ(image_of(radiance("-Y 2 -X 2", pixels)).rgb(0, 0), green);
  EXPECT_EQ(image_of(radiance("+Y 2 +X 2", pixels)).rgb(0, 1), red);
  EXPECT_THAT(refusal_of(radiance("+X 2 -Y 2", pixels)), HasSubstr("by columns"));
}

TEST(ReadRadiance, BrokenHeadersAndRuns) {
  for (const char* resolution :
       {"", "-Y 2", "-Y -2 +X 2", "-Y 2 +X two", "-Z 2 +X 2", "-Y 99999999999999999999 +X 1"}) {
    EXPECT_THAT(refusal_of(radiance(resolution, "abcd")), HasSubstr("broken Radiance"));
  }
  EXPECT_THAT(refusal_of(radiance("-Y 1 +X 0", "")), HasSubstr("without pixels"));
  EXPECT_THAT(refusal_of("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nabcd"),
              HasSubstr("32-bit_rle_xyze"));
  EXPECT_THAT(refusal_of("#?RADIANCE\nFORMAT=32-bit_rle_rgbe"), HasSubstr("header ends early"));
  for (const std::string& pixels :
       {"\1\1\1\1"s, "abcd\1\1\1\xFF"s, "abcd\1\1\1\0\1\1\1\0\1\1\1\0\1\1\1\0"s, "\2\2\0\x9"s,
        "\2\2\0\x8\xFF"s, "\2\2\0\x8\0"s, "\2\2\0\x8\x9"s}) {
    EXPECT_THAT(refusal_of(radiance("-Y 1 +X 8", pixels + std::string(40, 'z'))),
                HasSubstr("broken Radiance"));
  }
}

TEST(ReadExr, DataWindowIsThePicture) {
  const Folder folder;
  for (const auto compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                 Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
    // As tall as several blocks of rows and several units of compression.
    write_scan_lines(folder / "a.exr", {{"R", "G", "B", "A"}, {{-3, -100}, {4, 99}}, compression});
    const Image image = read_image(folder / "a.exr");
    ASSERT_EQ(image.width, 8);
    ASSERT_EQ(image.height, 200);
    EXPECT_EQ(image.rgb(5, 123), (Rgb{1335, 1435, 1535}));
    EXPECT_EQ(read_image(folder / "a.exr", {.alpha = Alpha::keep}).pixel(7, 199)[3], 2397);
  }
}

TEST(ReadExr, WithoutAlphaItIsOne) {
  const Folder folder;
  write_scan_lines(folder / "a.exr", {{"R", "G", "B"}});
  const Image image = read_image(folder / "a.exr", {.alpha = Alpha::keep});
  EXPECT_EQ(image.pixel(3, 3)[2], 333);
  EXPECT_EQ(image.pixel(3, 3)[3], 1);
}

TEST(ReadExr, LuminanceIsGrey) {
  const Folder folder;
  write_scan_lines(folder / "a.exr", {{"Y"}});
  EXPECT_EQ(read_image(folder / "a.exr").rgb(2, 1), (Rgb{112, 112, 112}));
}

TEST(ReadExr, NoColourIsRefusedWithWhatThereIs) {
  const Folder folder;
  write_scan_lines(folder / "a.exr", {{"R", "depth.Z"}});
  EXPECT_THAT(error_of([&] { read_image(folder / "a.exr"); }), HasSubstr("it has R, depth.Z"));
}

TEST(ReadExr, Tiles) {
  const Folder folder;
  write_tiles(folder / "a.exr", {{"R", "G", "B"}, {{0, 0}, {99, 149}}}, {32, 16});
  const Image image = read_image(folder / "a.exr");
  ASSERT_EQ(image.height, 150);
  EXPECT_EQ(image.rgb(71, 133), (Rgb{1501, 1601, 1701}));
}

TEST(ReadExr, FirstPartThatHasColour) {
  const Folder folder;
  write_parts(folder / "a.exr", {{{"Y"}}, {{"A", "R", "G", "B"}}, {{"R", "G", "B"}}});
  EXPECT_EQ(read_image(folder / "a.exr").rgb(1, 1), (Rgb{211, 311, 411}));
  const LayeredImage layers = read_layers(folder / "a.exr");
  ASSERT_EQ(layers.channels.size(), 1u);
  EXPECT_EQ(layers.channels[0].name, "Y");
}

TEST(ReadExr, SubsampledColourIsRefused) {
  const Folder folder;
  Imf::Header header(8, 8);
  header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
  header.channels().insert("RY", Imf::Channel(Imf::FLOAT, 2, 2));
  std::vector<float> values(64);
  {
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 32));
    frame.insert("RY", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 32, 2, 2));
    Imf::OutputFile out((folder / "a.exr").c_str(), header, 0);
    out.setFrameBuffer(frame);
    out.writePixels(8);
  }
  EXPECT_THAT(error_of([&] { read_image(folder / "a.exr"); }), HasSubstr("RY has fewer samples"));
  EXPECT_THAT(error_of([&] { read_layers(folder / "a.exr"); }), HasSubstr("RY has fewer samples"));
}

TEST(RealData, EnvironmentMaps) {
  const fs::path folder = fs::path(LAPIDARY_SHARED_DATA) / "hdr";
  if (!fs::exists(folder)) GTEST_SKIP() << "there is no " << folder.string();
  const auto expect_size = [&](const char* name, int width, int height, float brightest) {
    const Image image = read_image(folder / name);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    EXPECT_EQ(count_non_finite(image), 0u);
    EXPECT_NEAR(*std::ranges::max_element(image.pixels), brightest, 1e-3f * brightest);
  };
  expect_size("museum.exr", 512, 256, 19.28f);
  expect_size("studio.hdr", 1024, 512, 3568);
  expect_size("sunset.hdr", 1024, 512, 2176);
  expect_size("warehouse.hdr", 1024, 512, 430);
  const LayeredImage museum = read_layers(folder / "museum.exr");
  ASSERT_EQ(museum.channels.size(), 3u);
  EXPECT_EQ(museum.find("R")->precision, Precision::half);
}

}  // namespace
}  // namespace lapidary::image
