#include <memory>

#include <gtest/gtest.h>

#include "texture/texture.h"

namespace lapidary::texture {
namespace {

constexpr Rgb red{0.8f, 0.1f, 0.1f}, blue{0.1f, 0.1f, 0.7f};

TexturePtr checker(Projection projection) {
  return std::make_shared<const Texture>(
      Texture{Checker{{Spectrum::reflectance(red), Spectrum::reflectance(blue)}, {projection}}});
}

TEST(Checker, TurnsAtWholeNumbersAlsoBelowZero) {
  const Color color(checker(Projection::uv));
  const auto at = [&](double u, double v) { return color.rgb_at({.uv = {u, v}}); };
  EXPECT_EQ(at(0.5, 0.5), red);
  EXPECT_EQ(at(1.5, 0.5), blue);
  EXPECT_EQ(at(1.5, 1.5), red);
  EXPECT_EQ(at(-0.5, 0.5), blue);
  EXPECT_EQ(at(-0.5, -0.5), red);
  EXPECT_EQ(at(-1.5, -0.5), blue);
}

TEST(Checker, InSpaceIsOfCubes) {
  const Color color(checker(Projection::object));
  const auto at = [&](Vec3d p) { return color.rgb_at({.p = p}); };
  EXPECT_EQ(at({0.5, 0.5, 0.5}), red);
  EXPECT_EQ(at({0.5, 0.5, 1.5}), blue);
  EXPECT_EQ(at({-0.5, 0.5, 1.5}), red);
}

TEST(Checker, SpectraKeepTheirShape) {
  const Spectrum step = Spectrum::table({500, 100, {0.0f, 0.9f}});
  const Color color(std::make_shared<const Texture>(Texture{Checker{{step, step}}}));
  const Wavelengths w = Wavelengths::sample(0.3);
  const SampledSpectrum expected = step.at(w), found = color.at({}, w);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(found[i], expected[i]);
}

TEST(Checker, AsANumberIsItsLuminance) {
  const Number number(checker(Projection::uv));
  EXPECT_DOUBLE_EQ(number.at({}), static_cast<double>(luminance(red)));
}

}  // namespace
}  // namespace lapidary::texture
