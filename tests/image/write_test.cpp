#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "files.h"
#include "image/image_io.h"
#include "spectrum/color.h"

namespace lapidary::image {
namespace {

using namespace test;

const Display plain{.tone = Tone::none};
const char* const all_names[] = {"a.png", "a.jpg", "a.jpeg", "a.hdr", "a.exr", "A.PNG"};

TEST(RoundTrip, PngIsExactInEightBits) {
  const Folder folder;
  Image image(37, 23);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = srgb_decode(static_cast<float>(i * 7 % 256) / 255.0f);
  }
  write_image(folder / "a.png", image, {.display = plain});
  EXPECT_EQ(read_image(folder / "a.png"), image);
}

TEST(RoundTrip, ExrIsExactInFloat) {
  const Folder folder;
  for (const int channels : {3, 4}) {
    const Image image = random_image(33, 50, channels);
    write_image(folder / "a.exr", image, {.precision = Precision::full});
    EXPECT_EQ(read_image(folder / "a.exr", {.alpha = channels == 4 ? Alpha::keep : Alpha::drop}),
              image);
  }
}

TEST(RoundTrip, ExrHalfIsTheNearestOfElevenBits) {
  const Folder folder;
  const Image image = random_image(40, 40);
  write_image(folder / "a.exr", image);
  const Image back = read_image(folder / "a.exr");
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    EXPECT_NEAR(back.pixels[i], image.pixels[i], std::ldexp(image.pixels[i], -11));
  }
}

TEST(RoundTrip, HalfKeepsFiniteFiniteAndTheRestAsItIs) {
  const Folder folder;
  Image image(2, 1);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  image.pixels = {1e9f, -1e9f, 65519.9f, infinity, -infinity, std::nanf("")};
  write_image(folder / "a.exr", image);
  const Image back = read_image(folder / "a.exr");
  EXPECT_EQ(back.pixels[0], 65504);
  EXPECT_EQ(back.pixels[1], -65504);
  EXPECT_EQ(back.pixels[2], 65504);
  EXPECT_EQ(back.pixels[3], infinity);
  EXPECT_EQ(back.pixels[4], -infinity);
  EXPECT_TRUE(std::isnan(back.pixels[5]));
  EXPECT_EQ(count_non_finite(back), 1u);
}

TEST(RoundTrip, GreyImageBecomesGreyPicture) {
  const Folder folder;
  const Image grey = random_image(20, 10, 1);
  for (const char* name : {"a.exr", "a.hdr", "a.png"}) {
    write_image(folder / name, grey, {.display = plain, .precision = Precision::full});
    const Image back = read_image(folder / name);
    for (int x = 0; x < 20; ++x) {
      const Rgb c = back.rgb(x, 7);
      EXPECT_EQ(c.r, c.g);
      EXPECT_EQ(c.r, c.b);
      const float expected =
          name[2] == 'p' ? std::min(grey.pixel(x, 7)[0], 1.0f) : grey.pixel(x, 7)[0];
      EXPECT_NEAR(c.r, expected, 0.01f * expected + 1e-3f);
    }
  }
}

TEST(RoundTrip, RadianceIsWithinHalfAStepOfTheBrightestComponent) {
  const Folder folder;
  // Widths below 8 and above 32767 are stored flat.
  for (const int width : {1, 7, 8, 129, 32767, 32768}) {
    const Image image = random_image(width, width > 1000 ? 1 : 9);
    write_image(folder / "a.hdr", image);
    const Image back = read_image(folder / "a.hdr");
    ASSERT_EQ(back.pixels.size(), image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
      const float peak = *std::max_element(&image.pixels[i], &image.pixels[i] + 3);
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_NEAR(back.pixels[i + c], image.pixels[i + c], peak / 256);
      }
    }
    // What the format can hold comes back exactly.
    write_image(folder / "b.hdr", back);
    EXPECT_EQ(read_image(folder / "b.hdr"), back);
  }
}

TEST(RoundTrip, RadianceRunsOfEveryLength) {
  const Folder folder;
  Image image(700, 1);
  int x = 0;
  for (int run = 1; x < 700; ++run) {
    for (int i = 0; i < run * 9 % 140 + 1 && x < 700; ++i, ++x) {
      image.pixel(x, 0)[1] = static_cast<float>(run % 5 + 1);
      image.pixel(x, 0)[0] = static_cast<float>(x % 3);
    }
  }
  write_image(folder / "a.hdr", image);
  EXPECT_EQ(read_image(folder / "a.hdr"), image);
}

TEST(RoundTrip, RadianceExtremes) {
  const Folder folder;
  Image image(3, 2);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  image.pixels = {0,     0, 0, 255.9f,   0, 0, 1e-40f,        0,  0,
                  1e38f, 1, 0, infinity, 0, 0, std::nanf(""), -3, 1};
  write_image(folder / "a.hdr", image);
  const Image back = read_image(folder / "a.hdr");
  EXPECT_EQ(back.rgb(0, 0), Rgb{});
  EXPECT_EQ(back.rgb(1, 0), (Rgb{256, 0, 0}));
  EXPECT_EQ(back.rgb(2, 0), Rgb{});
  EXPECT_NEAR(back.rgb(0, 1).r, 1e38f, 1e36f);
  EXPECT_TRUE(std::isfinite(back.rgb(1, 1).r));
  EXPECT_GT(back.rgb(1, 1).r, 1e38f);
  EXPECT_EQ(back.rgb(2, 1), (Rgb{0, 0, 1}));
}

TEST(RoundTrip, JpegIsClose) {
  const Folder folder;
  Image image(64, 48);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const float across = static_cast<float>(x) / 63, down = static_cast<float>(y) / 47;
      std::ranges::copy(std::array{across, down, 1 - across}, image.pixel(x, y).begin());
    }
  }
  write_image(folder / "a.jpg", image, {.display = plain});
  const Image back = read_image(folder / "a.jpg");
  ASSERT_EQ(back.width, 64);
  double sum = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float error = std::abs(srgb_encode(back.pixels[i]) - srgb_encode(image.pixels[i]));
    EXPECT_LT(error, 12 / 255.0);  // at the dark ends, where the signal is steep
    sum += error;
  }
  EXPECT_LT(sum / static_cast<double>(image.pixels.size()), 1.5 / 255);
}

LayeredImage layered(int width, int height) {
  const auto pixels = static_cast<std::size_t>(width) * height;
  LayeredImage image{width, height, {}, {}};
  unsigned seed = 0;
  for (const char* name : {"B", "G", "R", "albedo.R", "depth.Z", "normal.X", "variance.R"}) {
    image.channels.push_back({name, random_image(width, height, 1, ++seed).pixels});
  }
  std::vector<std::uint32_t> ids(pixels);
  for (std::size_t i = 0; i < pixels; ++i) ids[i] = 0xFFFFFFFFu - static_cast<std::uint32_t>(i);
  image.channels.insert(image.channels.begin() + 5, Channel{"id.object", ids});
  image.metadata = {{"samples", 64.0},
                    {"scene", std::string("cornell \"box\" \xC3\xA9")},
                    {"seconds", 0.1},
                    {"seed", std::string("18446744073709551615")}};
  return image;
}

TEST(Layers, ComeBackWithTypesAndMetadata) {
  const Folder folder;
  for (const int height : {1, 16, 17, 130}) {
    const LayeredImage image = layered(21, height);
    write_image(folder / "a.exr", image);
    EXPECT_EQ(read_layers(folder / "a.exr"), image);
  }
}

TEST(Layers, HalfChannelsAreMarkedAsSuch) {
  const Folder folder;
  LayeredImage image = layered(5, 4);
  image.channels[3].precision = Precision::half;
  image.channels[3].samples = std::vector<float>(20, 0.5f);
  write_image(folder / "a.exr", image);
  EXPECT_EQ(read_layers(folder / "a.exr"), image);
}

TEST(Layers, OneLayerCanBeReadAsAnImage) {
  const Folder folder;
  LayeredImage image = layered(5, 4);
  image.channels.push_back({"albedo.G", std::vector<float>(20, 0.25f)});
  image.channels.push_back({"albedo.B", std::vector<float>(20, 0.75f)});
  write_image(folder / "a.exr", image);
  const Image albedo = read_image(folder / "a.exr", {.layer = "albedo"});
  EXPECT_EQ(albedo.rgb(3, 2).r, std::get<0>(image.find("albedo.R")->samples)[13]);
  EXPECT_EQ(albedo.rgb(3, 2).b, 0.75f);
  EXPECT_THAT(error_of([&] { read_image(folder / "a.exr", {.layer = "nothing"}); }),
              ::testing::HasSubstr("albedo.B"));
}

TEST(Layers, BeautyGoesToOtherFormats) {
  const Folder folder;
  LayeredImage image = layered(12, 9);
  Image beauty(12, 9);
  for (std::size_t i = 0; i < 12 * 9; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      beauty.pixels[3 * i + c] = std::get<0>(image.channels[2 - c].samples)[i];
    }
  }
  image.metadata.clear();
  for (const char* extension : {".png", ".jpg", ".hdr"}) {
    write_image(folder / (std::string("layered") + extension), image);
    write_image(folder / (std::string("flat") + extension), beauty);
    EXPECT_EQ(bytes_of(folder / (std::string("layered") + extension)),
              bytes_of(folder / (std::string("flat") + extension)));
  }
  image.channels[1].samples = std::vector<std::uint32_t>(12 * 9);
  EXPECT_THAT(error_of([&] { write_image(folder / "b.png", image); }),
              ::testing::HasSubstr("no float channel G"));
}

TEST(Layers, MistakesAreNamed) {
  const Folder folder;
  LayeredImage image = layered(5, 4);
  image.channels[4].samples = std::vector<float>(19);
  EXPECT_THAT(error_of([&] { write_image(folder / "a.exr", image); }),
              ::testing::HasSubstr("depth.Z has 19 samples, the picture has 20"));
  image = layered(5, 4);
  image.channels[4].name = "R";
  EXPECT_THAT(error_of([&] { write_image(folder / "a.exr", image); }), ::testing::HasSubstr("'R'"));
  for (const char* name : {"", "version", "dataWindow", "two words"}) {
    image = layered(5, 4);
    image.metadata.push_back({name, 1.0});
    EXPECT_THAT(error_of([&] { write_image(folder / "a.exr", image); }),
                ::testing::HasSubstr(std::string("'") + name + "'"));
  }
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(Metadata, NumbersAreShort) {
  EXPECT_EQ(to_text({"a", 64.0}), "64");
  EXPECT_EQ(to_text({"a", 0.1}), "0.1");
  EXPECT_EQ(to_text({"a", std::string("text")}), "text");
}

TEST(Metadata, PngSaysWhatItIsAndThatItIsSrgb) {
  const Folder folder;
  const Metadata metadata = {
      {"scene", std::string("a.lua")}, {"samples", 64.0}, {"author", std::string("Ren\xC3\xA9")}};
  write_image(folder / "a.png", Image(3, 3), {.metadata = metadata});
  const std::string bytes = bytes_of(folder / "a.png");
  using namespace std::string_literals;
  EXPECT_NE(bytes.find("tEXtscene\0a.lua"s), std::string::npos);
  EXPECT_NE(bytes.find("tEXtsamples\00064"s), std::string::npos);
  EXPECT_NE(bytes.find("iTXtauthor\0\0\0\0\0Ren\xC3\xA9"s), std::string::npos);
  EXPECT_NE(bytes.find("sRGB\0"s), std::string::npos);
}

TEST(Output, EveryFormatLeavesOneFileWithTheUsualPermissions) {
  for (const char* name : all_names) {
    const Folder folder;
    write_image(folder / name, Image(4, 4));
    EXPECT_EQ(folder.entries(), 1u);
    EXPECT_EQ(read_image(folder / name).width, 4);
    put_bytes(folder / "reference", "");
    EXPECT_EQ(fs::status(folder / name).permissions(),
              fs::status(folder / "reference").permissions());
  }
}

TEST(Output, SameImageSameBytes) {
  const Folder folder;
  const Image image = random_image(50, 30);
  for (const char* name : all_names) {
    write_image(folder / name, image);
    const std::string first = bytes_of(folder / name);
    write_image(folder / name, image);
    EXPECT_EQ(bytes_of(folder / name), first);
  }
}

TEST(Output, UnknownExtensionListsTheKnown) {
  const Folder folder;
  for (const char* name : {"a.tiff", "a", ".png", "a.png.txt", ""}) {
    for (const std::string& message : {error_of([&] { write_image(folder / name, Image(2, 2)); }),
                                       error_of([&] { check_writable(folder / name); })}) {
      EXPECT_THAT(message, ::testing::HasSubstr(".png, .jpg and .jpeg, .hdr (Radiance), .exr"));
    }
  }
  EXPECT_EQ(folder.entries(), 0u);
}

/// Both the check before and the write itself refuse `path` and say `reason`.
void expect_refused(const std::string& path, const std::string& reason) {
  for (const std::string& message : {error_of([&] { check_writable(path); }),
                                     error_of([&] { write_image(path, Image(2, 2)); })}) {
    EXPECT_THAT(message,
                ::testing::AllOf(::testing::StartsWith(path), ::testing::HasSubstr(reason)));
  }
}

TEST(Output, FoldersThatCannotBeWrittenAreNamed) {
  const Folder folder;
  put_bytes(folder / "file", "x");
  fs::create_directory(folder / "b.png");
  expect_refused(folder / "none/a.png", "there is no folder '" + (folder / "none") + "'");
  expect_refused(folder / "file/a.png", "is not a folder");
  expect_refused(folder / "b.png", "is a folder, not a file");
  expect_refused("/proc/a.png", "cannot write in the folder '/proc'");
  EXPECT_EQ(folder.entries(), 2u);
}

TEST(Output, WriteProtectionIsRespected) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const Folder folder;
  put_bytes(folder / "a.png", "precious");
  fs::permissions(folder / "a.png", fs::perms::owner_read);
  expect_refused(folder / "a.png", "write-protected");
  EXPECT_EQ(bytes_of(folder / "a.png"), "precious");
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  expect_refused(folder / "b.png", "Permission denied");
  fs::permissions(folder.path(), fs::perms::owner_all);
}

TEST(Output, DevicesAreNotReplaced) {
  const Folder folder;
  ASSERT_EQ(::mkfifo((folder / "a.png").c_str(), 0600), 0);
  expect_refused(folder / "a.png", "not a regular file");
  EXPECT_TRUE(fs::is_fifo(folder / "a.png"));
}

TEST(Output, CheckLeavesNoTrace) {
  const Folder folder;
  put_bytes(folder / "a.png", "precious");
  check_writable(folder / "a.png");
  check_writable(folder / "b.exr");
  EXPECT_EQ(folder.entries(), 1u);
  EXPECT_EQ(bytes_of(folder / "a.png"), "precious");
}

TEST(Output, LinksAreFollowed) {
  const Folder folder;
  fs::create_directory(folder / "elsewhere");
  put_bytes(folder / "elsewhere/real.png", "old");
  fs::create_symlink("elsewhere/real.png", folder / "a.png");
  write_image(folder / "a.png", Image(4, 4));
  EXPECT_TRUE(fs::is_symlink(folder / "a.png"));
  EXPECT_EQ(read_image(folder / "elsewhere/real.png").width, 4);
}

TEST(Output, LongNamesWork) {
  const Folder folder;
  const std::string name = std::string(251, 'n') + ".png";
  write_image(folder / name, Image(4, 4));
  EXPECT_EQ(read_image(folder / name).width, 4);
}

/// No file of this process grows beyond `bytes`: what a full disk does, without one.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(Output, FullDiskLeavesTheOldFileAndNoPartOfTheNew) {
  const Folder folder;
  const Image image = random_image(200, 200);
  for (const char* name : all_names) {
    write_image(folder / name, image);
    const auto size = static_cast<rlim_t>(fs::file_size(folder / name));
    put_bytes(folder / name, "precious");
    for (const rlim_t limit : {rlim_t{0}, rlim_t{1}, rlim_t{400}, size / 2, size - 1}) {
      std::string message;
      {
        const FileSizeLimit full(limit);
        message = error_of([&] { write_image(folder / name, image); });
      }
      EXPECT_THAT(message, ::testing::HasSubstr("could not be written: File too large"))
          << name << " " << limit;
      EXPECT_EQ(bytes_of(folder / name), "precious");
      EXPECT_EQ(folder.entries(), 1u);
    }
    fs::remove(folder / name);
  }
}

TEST(Output, ImagesThatMakeNoPictureAreRefused) {
  const Folder folder;
  Image wrong(4, 4);
  wrong.pixels.pop_back();
  for (const char* name : all_names) {
    EXPECT_THROW(write_image(folder / name, Image()), Error);
    EXPECT_THROW(write_image(folder / name, Image(4, 4, 2)), Error);
    EXPECT_THROW(write_image(folder / name, wrong), Error);
    EXPECT_THROW(write_image(folder / name, LayeredImage{}), Error);
  }
  EXPECT_THAT(error_of([&] { write_image(folder / "a.jpg", Image(65501, 1)); }),
              ::testing::HasSubstr("65500"));
  EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace lapidary::image
