#include <gtest/gtest.h>

#include "film/develop.h"
#include "image/tone.h"
#include "render/block.h"
#include "scene/tiny_scene.h"
#include "spectrum/color.h"

namespace lapidary::test {
namespace {

using description::PictureSize;

film::Film render_picture(TinyScene& tiny, PictureSize size, std::uint32_t passes,
                          film::Layers layers = film::Layers::beauty) {
  tiny.description.render.size = size;
  const scene::Scene scene = tiny.build();
  const render::SampleSettings settings{{.max_depth = 8}, FilterSampler(FilterKind::box, 0.5), 1};
  ThreadPool pool(2);
  const render::BlockRenderer renderer(scene, settings, {size.width, size.height}, pool);
  film::Film film({.width = size.width, .height = size.height, .layers = layers});
  const auto tally = renderer.render({0, passes}, film, pool);
  EXPECT_EQ(tally.faults.not_finite, 0u);
  EXPECT_EQ(tally.faults.saturated, 0u);
  EXPECT_GE(tally.counters.nearest_queries,
            static_cast<std::uint64_t>(size.width) * size.height * passes);
  return film;
}

Rgb mean_color(const film::Film& film) {
  Rgb sum;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) sum += film.beauty(x, y);
  }
  return sum * (1.0f / static_cast<float>(film.width() * film.height()));
}

// What a scene says in sRGB is what a picture shows: a matte surface of a colour under the whole
// of a white sky of radiance 1, by way of spectra, the film and the display's curves.
TEST(Picture, ShowsMatteColorsAsTheyWereGiven) {
  const std::array<std::uint8_t, 3> colors[] = {
      {0xc0, 0x80, 0x40}, {0x20, 0x60, 0xe0}, {0xff, 0, 0}, {0, 0xc0, 0x10}, {0x80, 0x80, 0x80}};
  for (const auto& code : colors) {
    const Rgb encoded{static_cast<float>(code[0]) / 255.0f, static_cast<float>(code[1]) / 255.0f,
                      static_cast<float>(code[2]) / 255.0f};
    const auto worn = material(description::Matte{Spectrum::reflectance(srgb_decode(encoded))});
    TinyScene tiny;
    tiny.add(geometry::HalfSpace{{}, {0, -1, 0}}, worn);
    tiny.light(description::ConstantEnvironment{});
    const film::Film film = render_picture(tiny, {64, 64}, 16, film::Layers::all);
    const auto shown = image::to_srgb8(mean_color(film), 0, 0, {.tone = image::Tone::none});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(shown[c], code[c], 1) << c;
    // The albedo layer says the same without any noise.
    const auto albedo = image::to_srgb8(film.albedo(3, 5), 0, 0, {.tone = image::Tone::none});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(albedo[c], code[c], 1) << c;
  }
}

// The default tone curve leaves what is not bright alone.
TEST(Picture, ShowsMatteColorsTheSameWithTheFilmicCurve) {
  const auto worn = material(description::Matte{
      Spectrum::reflectance(srgb_decode({192 / 255.0f, 128 / 255.0f, 64 / 255.0f}))});
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{{}, {0, -1, 0}}, worn);
  tiny.light(description::ConstantEnvironment{});
  const Rgb color = mean_color(render_picture(tiny, {64, 64}, 16));
  const auto shown = image::to_srgb8(color, 0, 0, {.dither = image::Dither::off});
  EXPECT_NEAR(shown[0], 0xc0, 1);
  EXPECT_NEAR(shown[1], 0x80, 1);
  EXPECT_NEAR(shown[2], 0x40, 1);
}

// A path through glass is left with one wavelength, but not all of a pass with the same: a white
// sky behind glass is white after few passes.
TEST(Picture, ShowsTheColorsOfGlassAfterFewPasses) {
  TinyScene tiny;
  tiny.add(geometry::Sphere{{}, 1.0}, material(description::Glass{*find_glass("N-SF11")}));
  tiny.light(description::ConstantEnvironment{});
  tiny.look({0, -3, 0}, {}, 30.0);
  const Rgb color = mean_color(render_picture(tiny, {64, 64}, 4));
  EXPECT_NEAR(color.r, 1.0, 0.02);
  EXPECT_NEAR(color.g, 1.0, 0.02);
  EXPECT_NEAR(color.b, 1.0, 0.02);
}

// Light of an RGB radiance shows as those numbers; the mean over a pass's wavelengths is theirs.
TEST(Picture, ShowsLightAsItWasGiven) {
  TinyScene tiny;
  tiny.light(description::ConstantEnvironment{Spectrum::illuminant({0.8f, 2.0f, 0.1f})});
  const film::Film film = render_picture(tiny, {2, 2}, 256);
  const Rgb seen = film.beauty(1, 1);
  EXPECT_NEAR(seen.r, 0.8, 1e-3);
  EXPECT_NEAR(seen.g, 2.0, 1e-3);
  EXPECT_NEAR(seen.b, 0.1, 1e-3);
}

TEST(Picture, LayersTellWhatIsSeenFirst) {
  TinyScene tiny;
  tiny.add(geometry::Sphere{{0, 0, 0}, 1}, matte(0.25))
      .add(geometry::HalfSpace{{0, 3, 0}, {0, -1, 0}}, metal(0.5));
  tiny.sky(1.0).look({0, -5, 0}, {0, 0, 0}, 60);
  const film::Film film = render_picture(tiny, {65, 65}, 4, film::Layers::all);
  EXPECT_EQ(film.object(32, 32), 1u);
  EXPECT_EQ(film.object(2, 2), 2u);
  EXPECT_NEAR(film.depth(32, 32), 4.0, 1e-3);
  EXPECT_NEAR(film.depth(2, 2), 8.0, 1e-6);  // along the view: the same over the whole wall
  EXPECT_NEAR(film.normal(32, 32).y, -1.0, 1e-3);
  EXPECT_NEAR(film.normal(2, 2).y, -1.0, 1e-6);
  EXPECT_NEAR(film.albedo(32, 32).g, 0.25, 1e-3);
  EXPECT_NEAR(film.albedo(2, 2).g, 0.5, 1e-3);
  // x grows to the right and y downwards.
  EXPECT_GT(film.normal(40, 32).x, 0.1f);
  EXPECT_LT(film.normal(32, 40).z, -0.1f);
}

TEST(Picture, LayersAreZeroWhereNothingIs) {
  TinyScene tiny;
  tiny.sky(1.0);
  const film::Film film = render_picture(tiny, {2, 2}, 4, film::Layers::all);
  EXPECT_EQ(film.object(0, 0), 0u);
  EXPECT_EQ(film.depth(0, 0), 0.0f);
  EXPECT_EQ(film.normal(0, 0), Vec3f());
  EXPECT_EQ(film.albedo(0, 0), Rgb());
}

// Pixels lie where they should to the last sample: an edge between two of them lights one fully
// and the other not at all.
TEST(Picture, HasItsPixelsInPlace) {
  TinyScene tiny;
  const auto light = material(description::Emissive{});
  // A wall that fills the upper right of the view but for one pixel at each side.
  tiny.add(geometry::Rectangle{{0, 5, 0}, {3, 0, 0}, {0, 0, 2}}, light);
  description::Orthographic camera;
  camera.view = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  camera.size = 6;  // of the shorter side: pixels are 1 wide
  tiny.description.camera = description::Camera{camera, {}};
  const film::Film film = render_picture(tiny, {8, 6}, 16);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) {
      const bool lit = x >= 4 && x < 7 && y >= 1 && y < 3;
      EXPECT_NEAR(film.beauty(x, y).g, lit ? 1.0 : 0.0, lit ? 2e-3 : 0.0) << x << ' ' << y;
    }
  }
}

/// A bright ball of radius e at distance d, seen through a lens of radius R that is sharp at f.
struct OutOfFocus {
  double d = 4, f = 2, R = 0.12, e = 0.02;
  static constexpr int size = 64;
  static constexpr double half_width = 0.05;  ///< of the picture, at distance 1

  film::Film render(std::uint32_t passes) const {
    TinyScene tiny;
    tiny.add(geometry::Sphere{{0, d, 0}, e}, material(description::Emissive{}));
    description::Perspective camera;
    camera.view = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    camera.fov = degrees(2 * std::atan(half_width));
    camera.aperture = 2 * R;
    camera.focus_distance = f;
    tiny.description.camera = description::Camera{camera, {}};
    return render_picture(tiny, {size, size}, passes);
  }
  static double pixels(double at_distance_1) { return at_distance_1 / half_width * 0.5 * size; }
  /// Of the circle of confusion: in the sharp plane R |d - f| / d.
  double blur() const { return pixels(R * std::abs(d - f) / d / f); }
  double sharp() const { return pixels(e / d); }
};

// A point out of focus becomes a disk of even brightness: no light beyond, the same at every
// radius, and together that of the point in focus.
TEST(Picture, OfAPointOutOfFocusIsTheCircleOfConfusion) {
  for (const OutOfFocus& lens : {OutOfFocus{4, 2, 0.12, 0.02}, OutOfFocus{1, 2, 0.06, 0.005}}) {
    constexpr std::uint32_t passes = 128;
    const film::Film film = lens.render(passes);
    const double blur = lens.blur(), sharp = lens.sharp();
    ASSERT_TRUE(blur > 15 && blur + sharp < 30 && sharp < 5);
    double total = 0, beyond = 0, squares = 0;
    double inner = 0, outer = 0, inner_pixels = 0, outer_pixels = 0;
    for (int y = 0; y < film.height(); ++y) {
      for (int x = 0; x < film.width(); ++x) {
        const double r = std::hypot(x + 0.5 - 32, y + 0.5 - 32);
        const double value = static_cast<double>(film.beauty(x, y).g);
        total += value, squares += value * r * r;
        if (r > blur + sharp + 0.8) beyond += value;
        if (r < 0.5 * blur) inner += value, inner_pixels += 1;
        if (r > 0.5 * blur && r < blur - sharp - 0.8) outer += value, outer_pixels += 1;
      }
    }
    EXPECT_EQ(beyond, 0.0);
    // The sum counts samples that meet the ball, Poisson distributed at the most: 4 standard
    // errors, a false-alarm rate of 6e-5 for each of the six tests here.
    const double hits = total * passes;
    const double error = 4.0 / std::sqrt(hits);
    EXPECT_LT(error, 0.065);
    EXPECT_NEAR(total, pi * sharp * sharp, error * total + 0.002 * total);
    const double ratio_error = error * std::sqrt(hits / (inner * passes) + hits / (outer * passes));
    EXPECT_NEAR((inner / inner_pixels) / (outer / outer_pixels), 1.0, ratio_error);
    // The mean square of the radius: of the disk, of the ball's image and of a pixel.
    const double expected = 0.5 * blur * blur + 0.5 * sharp * sharp + 1.0 / 6.0;
    EXPECT_NEAR(squares / total, expected, expected * error);
  }
}

TEST(Picture, IsBlackAroundAFisheyesCircle) {
  TinyScene tiny;
  tiny.sky(1.0);
  tiny.description.camera.emplace(description::Camera{description::Fisheye{}, {}});
  tiny.description.render.size = {32, 32};
  const scene::Scene scene = tiny.build();
  const render::SampleSettings settings{{.max_depth = 2}, FilterSampler(FilterKind::box, 0.5), 1};
  film::Film film({.width = 32, .height = 32, .layers = film::Layers::all});
  ThreadPool pool(2);
  render::BlockRenderer(scene, settings, {film.width(), film.height()}, pool)
      .render({0, 4}, film, pool);
  for (const auto& [x, y] : {std::pair{0, 0}, {31, 0}, {2, 3}}) {
    EXPECT_EQ(film.beauty(x, y).g, 0.0f);
    EXPECT_EQ(film.depth(x, y), 0.0f);
  }
  for (const auto& [x, y] : {std::pair{16, 16}, {16, 0}, {6, 6}})
    EXPECT_GT(film.beauty(x, y).g, 0.5f);
}

// A frame's worth of motion over the picture, seen for half of it: what moves covers its way
// evenly.
TEST(Picture, BlursWhatMovesOverTheWayOfTheShutter) {
  TinyScene tiny;
  tiny.add(geometry::Box{{-4, 0, -9}, {-3, 1, 9}}, lamp(1.0));
  auto& bar = tiny.description.objects.back();
  bar = description::with_motion(*bar, {{}, {}, {1, 1, 1}, {8, 0, 0}});
  description::Orthographic camera;
  camera.view = {{0, -5, 0}, {0, 0, 0}, {0, 0, 1}};
  camera.size = 8;
  tiny.description.camera.emplace(description::Camera{camera, {}});
  tiny.description.camera->shutter = {0.25, 0.75};
  tiny.description.render.size = {16, 16};  // two pixels a unit
  const scene::Scene scene = tiny.build();
  const render::SampleSettings settings{{.max_depth = 1}, FilterSampler(FilterKind::box, 0.5), 1};
  film::Film film({.width = 16, .height = 16, .layers = film::Layers::beauty});
  ThreadPool pool(2);
  render::BlockRenderer(scene, settings, {film.width(), film.height()}, pool)
      .render({0, 1024}, film, pool);
  // From -2 .. -1 to 2 .. 3, each place for a quarter of the time but those at the ends.
  const auto at = [&](int x) {
    double sum = 0;
    for (int y = 0; y < 16; ++y) sum += static_cast<double>(film.beauty(x, y).g) / 16;
    return sum;
  };
  const double full = 1.0 * at(8);
  EXPECT_GT(full, 0.0);
  for (int x = 6; x < 12; ++x) EXPECT_NEAR(at(x) / full, 1.0, 0.02) << x;
  EXPECT_NEAR(at(4) / full, 0.25, 0.02);
  EXPECT_NEAR(at(5) / full, 0.75, 0.02);
  EXPECT_NEAR(at(12) / full, 0.75, 0.02);
  EXPECT_NEAR(at(13) / full, 0.25, 0.02);
  EXPECT_EQ(at(3), 0.0);
  EXPECT_EQ(at(14), 0.0);
}

}  // namespace
}  // namespace lapidary::test
