#include <algorithm>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "exr_maker.h"
#include "files.h"
#include "image/image_io.h"
#include "jpeg_maker.h"
#include "png_maker.h"

namespace lapidary::image {
namespace {

using namespace test;
using namespace std::string_literals;
using ::testing::HasSubstr;
using ::testing::StartsWith;

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
  write_tiles(folder / "t.exr", {{"R", "G", "B"}, {{0, 0}, {19, 12}}, Imf::PIZ_COMPRESSION},
              {8, 8});
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

}  // namespace
}  // namespace lapidary::image
