#include <algorithm>
#include <cstdio>
#include <random>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

// After <cstdio>, which jpeglib.h needs and does not include.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <jpeglib.h>

#include "files.h"
#include "image/image_io.h"
#include "image/srgb.h"
#include "png_maker.h"

namespace lapidary::image {
namespace {

using namespace test;
using namespace std::string_literals;
using ::testing::HasSubstr;
using ::testing::StartsWith;

float light_of_code(int code) {
  return linear_from_srgb(static_cast<float>(code) / 255.0f);
}

/// The image in a file of these bytes; the name does not say what it is.
Image image_of(const std::string& bytes, const ReadOptions& options = {}) {
  const Folder folder;
  put_bytes(folder / "picture", bytes);
  return read_image(folder / "picture", options);
}

std::string refusal_of(const std::string& bytes) {
  return error_of([&] { image_of(bytes); });
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
    const float light = linear_from_srgb(1.0f / static_cast<float>(largest));
    EXPECT_NEAR(image.rgb(1, 0).g, light, 1e-6) << int{depth};
  }
}

TEST(ReadPng, SixteenBits) {
  const std::string bytes =
      png::file({2, 1, 16, png::rgb}, "", {"\x12\x34\x56\x78\x9A\xBC\0\0\0\1\xFF\xFF"s});
  const Image image = image_of(bytes);
  EXPECT_NEAR(image.rgb(0, 0).r, linear_from_srgb(0x1234 / 65535.0f), 1e-7);
  EXPECT_NEAR(image.rgb(0, 0).b, linear_from_srgb(0x9ABC / 65535.0f), 1e-6);
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

/// A JPEG of one colour, in the colour space of the components given.
std::string jpeg_bytes(J_COLOR_SPACE space, std::vector<JSAMPLE> color, bool progressive) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr handler{};
  jpeg.err = jpeg_std_error(&handler);
  jpeg_create_compress(&jpeg);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &buffer, &size);
  jpeg.image_width = jpeg.image_height = 24;
  jpeg.input_components = static_cast<int>(color.size());
  jpeg.in_color_space = space;
  jpeg_set_defaults(&jpeg);
  if (progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<JSAMPLE> row;
  for (int x = 0; x < 24; ++x) row.insert(row.end(), color.begin(), color.end());
  JSAMPROW pointer = row.data();
  for (int y = 0; y < 24; ++y) jpeg_write_scanlines(&jpeg, &pointer, 1);
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string bytes(reinterpret_cast<const char*>(buffer), size);
  std::free(buffer);
  return bytes;
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

std::string radiance(const std::string& resolution, const std::string& pixels) {
  return "#?RADIANCE\n# comment\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n" + resolution + "\n" +
         pixels;
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

/// Channels with value 100 c + 10 y + x in a part of an OpenEXR file, c counting from 1.
struct ExrPart {
  std::vector<std::string> names;
  Imath::Box2i window{{0, 0}, {7, 5}};
  Imf::Compression compression = Imf::ZIP_COMPRESSION;
};

class ExrValues {
 public:
  explicit ExrValues(const ExrPart& part) : part_(part) {
    const auto size = part.window.size() + Imath::V2i(1, 1);
    for (std::size_t c = 0; c < part.names.size(); ++c) {
      auto& plane = planes_.emplace_back();
      for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
          plane.push_back(100.0f * static_cast<float>(c + 1) + 10.0f * static_cast<float>(y) +
                          static_cast<float>(x));
        }
      }
    }
  }

  Imf::Header header() const {
    Imf::Header header(part_.window, part_.window);
    header.compression() = part_.compression;
    for (const auto& name : part_.names) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    return header;
  }

  Imf::FrameBuffer frame() {
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < planes_.size(); ++c) {
      frame.insert(part_.names[c], Imf::Slice::Make(Imf::FLOAT, planes_[c].data(), part_.window));
    }
    return frame;
  }

 private:
  ExrPart part_;
  std::vector<std::vector<float>> planes_;
};

void write_scan_lines(const std::string& path, const ExrPart& part) {
  ExrValues values(part);
  const int rows = part.window.size().y + 1;
  Imf::OutputFile out(path.c_str(), values.header(), 0);
  out.setFrameBuffer(values.frame());
  out.writePixels(rows);
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
  ExrValues values({{"R", "G", "B"}, {{0, 0}, {99, 149}}});
  Imf::Header header = values.header();
  header.setTileDescription(Imf::TileDescription(32, 16));
  {
    Imf::TiledOutputFile out((folder / "a.exr").c_str(), header, 0);
    out.setFrameBuffer(values.frame());
    out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
  }
  const Image image = read_image(folder / "a.exr");
  ASSERT_EQ(image.height, 150);
  EXPECT_EQ(image.rgb(71, 133), (Rgb{1501, 1601, 1701}));
}

void write_parts(const std::string& path, const std::vector<ExrPart>& parts) {
  std::vector<ExrValues> values;
  std::vector<Imf::Header> headers;
  for (const ExrPart& part : parts) {
    values.emplace_back(part);
    headers.push_back(values.back().header());
    headers.back().setName("part" + std::to_string(headers.size()));
    headers.back().setType(Imf::SCANLINEIMAGE);
  }
  Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Imf::OutputPart out(file, static_cast<int>(i));
    out.setFrameBuffer(values[i].frame());
    out.writePixels(parts[i].window.size().y + 1);
  }
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

TEST(BadFile, WhatIsNoPicture) {
  const Folder folder;
  EXPECT_THAT(error_of([&] { read_image(folder / "none.png"); }),
              StartsWith((folder / "none.png") + ": cannot be opened: No such file"));
  EXPECT_THAT(error_of([&] { read_image(folder.path()); }), HasSubstr("is a folder"));
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(error_of([&] { read_image(folder / "pipe"); }), HasSubstr("not a regular file"));
  EXPECT_THAT(refusal_of(""), HasSubstr("is empty"));
  EXPECT_THAT(refusal_of("a text file"), HasSubstr("PNG, JPEG, Radiance (.hdr) and OpenEXR"));
  write_image(folder / "a.png", Image(3, 3));
  EXPECT_THAT(error_of([&] { read_layers(folder / "a.png"); }), HasSubstr("no layers"));
}

TEST(BadFile, TheContentSaysTheFormat) {
  const Folder folder;
  write_image(folder / "a.png", Image(3, 5));
  fs::rename(folder / "a.png", folder / "a.jpg");
  EXPECT_EQ(read_image(folder / "a.jpg").height, 5);
}

/// An OpenEXR file with another data window written over its own.
std::string exr_claiming(int width, int height) {
  const Folder folder;
  write_image(folder / "a.exr", Image(4, 4));
  std::string bytes = bytes_of(folder / "a.exr");
  const std::size_t at = bytes.find("dataWindow\0box2i\0"s) + 17 + 4 + 8;
  const std::int32_t corner[2] = {width - 1, height - 1};
  return bytes.replace(at, 8, std::string(reinterpret_cast<const char*>(corner), 8));
}

TEST(BadFile, GiganticClaimsAreRefusedAtOnce) {
  const std::string jpeg = [] {
    std::string bytes = jpeg_bytes(JCS_RGB, {1, 2, 3}, false);
    const std::size_t frame = bytes.find("\xFF\xC0");
    return bytes.replace(frame + 5, 4, "\xFF\x00\xFF\x00"s);
  }();
  for (const std::string& bytes :
       {png::file({0x7FFFFFFF, 0x7FFFFFFF, 8, png::rgb}, "", {"abc"}),
        png::file({1 << 20, 1 << 20, 8, png::grey}, "", {"abc"}), jpeg,
        radiance("-Y 100000 +X 100000", "abcd"), radiance("-Y 4294967295 +X 4294967295", "abcd"),
        exr_claiming(1 << 20, 1 << 20), exr_claiming(0x7FFFFFFF, 2), exr_claiming(2, 0x7FFFFFFF),
        exr_claiming(1, (1 << 20) + 1)}) {
    EXPECT_THAT(refusal_of(bytes), HasSubstr("the limit is 268 million"));
  }
  EXPECT_THAT(refusal_of(exr_claiming(-5, 4)), HasSubstr("without pixels"));
}

/// An OpenEXR file with a text that says it is 1.9 GB long.
std::string exr_with_long_text() {
  const Folder folder;
  write_image(folder / "a.exr", Image(4, 4), {.metadata = {{"scene", std::string("s")}}});
  std::string bytes = bytes_of(folder / "a.exr");
  return bytes.replace(bytes.find("scene\0string\0"s) + 13 + 3, 1, "\x70");
}

/// The most memory this process ever used.
long peak_kilobytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(BadFile, LargeClaimsWithoutDataTakeNoMemory) {
  // 12000 x 12000 pixels are 1.7 GB, and so are the texts.
  const long before = peak_kilobytes();
  for (const std::string& bytes :
       {png::file({12000, 12000, 8, png::rgb}, "", {"abc"}),
        png::file({1, 1, 8, png::rgb}, "\x70\0\0\0tEXt"s, {"abc"}), exr_with_long_text(),
        radiance("-Y 12000 +X 12000", "abcd"), exr_claiming(12000, 12000)}) {
    EXPECT_THAT(refusal_of(bytes), HasSubstr("is a broken"));
  }
  EXPECT_LT(peak_kilobytes() - before, 500'000);
}

/// One good file of every format, small, with something in it.
std::vector<std::string> good_files() {
  const Folder folder;
  const Image image = random_image(19, 13);
  std::vector<std::string> files;
  for (const char* name : {"a.png", "a.jpg", "a.hdr", "a.exr"}) {
    write_image(folder / name, image, {.metadata = {{"scene", std::string("s")}}});
    files.push_back(bytes_of(folder / name));
  }
  files.push_back(jpeg_bytes(JCS_RGB, {9, 99, 199}, true));
  files.push_back(
      png::file({2, 2, 8, png::palette, 1}, png::chunk("PLTE", "abcdef"), {"\1"s, "\0"s, "\0\1"s}));
  ExrValues values({{"R", "G", "B"}, {{0, 0}, {19, 12}}, Imf::PIZ_COMPRESSION});
  Imf::Header header = values.header();
  header.setTileDescription(Imf::TileDescription(8, 8));
  {
    Imf::TiledOutputFile out((folder / "t.exr").c_str(), header, 0);
    out.setFrameBuffer(values.frame());
    out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
  }
  files.push_back(bytes_of(folder / "t.exr"));
  write_parts(folder / "m.exr", {{{"Y"}}, {{"R", "G", "B"}}});
  files.push_back(bytes_of(folder / "m.exr"));
  return files;
}

TEST(BadFile, TruncatedFilesAreErrorsWhereverTheyEnd) {
  const Folder folder;
  for (const std::string& good : good_files()) {
    const std::size_t step = std::max<std::size_t>(1, good.size() / 150);
    for (std::size_t length = 0; length < good.size(); length += step) {
      put_bytes(folder / "a", good.substr(0, length));
      EXPECT_THROW(read_image(folder / "a"), Error) << good.substr(0, 4) << " " << length;
    }
    put_bytes(folder / "a", good.substr(0, good.size() - 1));
    EXPECT_THROW(read_image(folder / "a"), Error) << good.substr(0, 4);
  }
}

TEST(BadFile, FlippedBytesGiveAPictureOrAnError) {
  const Folder folder;
  std::mt19937 random(11);
  int refused = 0;
  for (const std::string& good : good_files()) {
    for (int i = 0; i < 150; ++i) {
      std::string bad = good;
      for (int flips = 1 + i % 3; flips > 0; --flips) {
        // Headers deserve more than their share of the damage.
        const std::size_t end = i % 2 ? std::min<std::size_t>(400, bad.size()) : bad.size();
        bad[random() % end] = static_cast<char>(random());
      }
      put_bytes(folder / "a", bad);
      try {
        const Image image = read_image(folder / "a");
        EXPECT_EQ(image.pixels.size(),
                  static_cast<std::size_t>(image.width) * image.height * image.channels);
      } catch (const Error& error) {
        EXPECT_THAT(error.what(), StartsWith(folder / "a"));
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 100);
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
