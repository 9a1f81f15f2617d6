#include "texture/arithmetic.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "support/random.h"
#include "texture/texture.h"

namespace lapidary::texture {
namespace {

using test::Random;
using Operation = Arithmetic::Operation;

TexturePtr texture_of(Texture::Kind kind) {
  return std::make_shared<const Texture>(std::move(kind));
}

/// x, as a number and a grey.
Color x_axis() {
  return texture_of(Gradient{});
}

double number(Texture::Kind kind, double x) {
  return Number(texture_of(std::move(kind))).at({.p = {x, 0, 0}});
}

Rgb rgb(Texture::Kind kind, double x) {
  return Color(texture_of(std::move(kind))).rgb_at({.p = {x, 0, 0}});
}

TEST(Arithmetic, ReckonsWithNumbers) {
  const auto with_x = [](Operation operation, double b) {
    return number(Arithmetic{operation, {x_axis(), b}}, 0.25);
  };
  EXPECT_DOUBLE_EQ(with_x(Operation::add, 2), 2.25);
  EXPECT_DOUBLE_EQ(with_x(Operation::subtract, 2), -1.75);
  EXPECT_DOUBLE_EQ(with_x(Operation::multiply, -3), -0.75);
  EXPECT_DOUBLE_EQ(with_x(Operation::divide, 2), 0.125);
  EXPECT_DOUBLE_EQ(with_x(Operation::divide, 0), 0);
  EXPECT_DOUBLE_EQ(with_x(Operation::power, 2), 0.0625);
  EXPECT_DOUBLE_EQ(with_x(Operation::minimum, 0.2), 0.2);
  EXPECT_DOUBLE_EQ(with_x(Operation::maximum, 0.2), 0.25);
  EXPECT_DOUBLE_EQ(number(Arithmetic{Operation::subtract, {1.0, x_axis()}}, 0.25), 0.75);
  EXPECT_DOUBLE_EQ(number(Arithmetic{Operation::power, {-2.0, x_axis()}}, 0.25), 0);
}

TEST(Arithmetic, ReckonsWithColors) {
  const Color orange(Spectrum::reflectance({0.75f, 0.5f, 0.25f}));
  const Rgb product = rgb(Arithmetic{Operation::multiply, {orange, x_axis()}}, 0.5);
  EXPECT_FLOAT_EQ(product.r, 0.375f);
  EXPECT_FLOAT_EQ(product.g, 0.25f);
  EXPECT_FLOAT_EQ(product.b, 0.125f);
  const Rgb sum = rgb(Arithmetic{Operation::add, {orange, 0.5}}, 0);
  EXPECT_FLOAT_EQ(sum.r, 1.25f);
  EXPECT_FLOAT_EQ(sum.b, 0.75f);
}

TEST(Arithmetic, GoesWavelengthByWavelength) {
  const Spectrum a = Spectrum::table({500, 100, {0.2f, 0.9f}});
  const Spectrum b = Spectrum::table({450, 200, {0.8f, 0.1f}});
  const Wavelengths w = Wavelengths::sample(0.4);
  const auto product = texture_of(Arithmetic{Operation::multiply, {Color(a), Color(b)}});
  const SampledSpectrum found = Color(product).at({}, w);
  const SampledSpectrum expected = a.at(w) * b.at(w);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_FLOAT_EQ(found[i], expected[i]);
}

TEST(Arithmetic, MixesByShare) {
  const Mix mix{{Color(Spectrum::reflectance({1, 0, 0})), Color(Spectrum::reflectance({0, 0, 1}))},
                texture_of(Gradient{})};
  EXPECT_EQ(rgb(mix, 0), (Rgb{1, 0, 0}));
  EXPECT_EQ(rgb(mix, 2), (Rgb{0, 0, 1}));
  EXPECT_EQ(rgb(mix, 0.25), (Rgb{0.75f, 0, 0.25f}));
  EXPECT_DOUBLE_EQ(number(Mix{{10.0, 20.0}, 0.3}, 0), 13);
}

TEST(Arithmetic, TakesChannels) {
  using Channel = ChannelOf::Channel;
  const Rgb c{0.75f, 0.5f, 0.25f};
  const Color orange(Spectrum::reflectance(c));
  EXPECT_NEAR(number(ChannelOf{orange, Channel::red}, 0), 0.75, 1e-6);
  EXPECT_NEAR(number(ChannelOf{orange, Channel::green}, 0), 0.5, 1e-6);
  EXPECT_NEAR(number(ChannelOf{orange, Channel::blue}, 0), 0.25, 1e-6);
  EXPECT_NEAR(number(ChannelOf{orange}, 0), luminance(c), 1e-6);
  EXPECT_NEAR(rgb(ChannelOf{orange, Channel::green}, 0).b, 0.5f, 1e-6f);
}

TEST(Arithmetic, RemapsToARamp) {
  const Remap spread{texture_of(Gradient{}), 0.2, 0.6};
  EXPECT_NEAR(number(spread, 0.3), 0.25, 1e-12);
  EXPECT_EQ(number(spread, 0.1), 0);
  EXPECT_EQ(number(spread, 0.7), 1);
  const Remap backwards{texture_of(Gradient{}), 1, 0, Ramp::usual({{1, 0, 0}, {0, 0, 1}})};
  EXPECT_EQ(rgb(backwards, 1), (Rgb{1, 0, 0}));
  EXPECT_EQ(rgb(backwards, 0.75), (Rgb{0.75f, 0, 0.25f}));
}

TEST(Arithmetic, StaysFinite) {
  Random random(1);
  const auto hostile = [&] {
    if (random.uniform() < 0.2) return 0.0;
    return (random.uniform() < 0.5 ? -1 : 1) * random.magnitude(-300, 300);
  };
  for (int i = 0; i < 20000; ++i) {
    const auto operation = static_cast<Operation>(random.index(7));
    const auto texture = texture_of(Arithmetic{operation, {hostile(), hostile()}});
    EXPECT_TRUE(std::isfinite(Number(texture).at({})));
  }
  for (int i = 0; i < 20000; ++i) {
    const auto operation = static_cast<Operation>(random.index(7));
    const auto texture = texture_of(
        Arithmetic{operation, {std::cbrt(std::cbrt(hostile())), std::cbrt(std::cbrt(hostile()))}});
    EXPECT_TRUE(Color(texture).at({}, Wavelengths::sample(0.2)).is_finite());
  }
}

TEST(Arithmetic, CountsWhatItIsMadeOf) {
  const auto leaf = texture_of(Gradient{});
  EXPECT_EQ(leaf->extent.depth, 1);
  EXPECT_EQ(leaf->extent.looks, 1);
  auto texture = leaf;
  for (int i = 0; i < 20; ++i) {
    texture = texture_of(Arithmetic{Operation::add, {Color(texture), Color(texture)}});
  }
  EXPECT_EQ(texture->extent.depth, 21);
  EXPECT_EQ(texture->extent.looks, std::exp2(21) - 1);
}

}  // namespace
}  // namespace lapidary::texture
