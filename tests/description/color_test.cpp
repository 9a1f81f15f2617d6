#include "spectrum/color.h"

#include <cmath>

#include <gmock/gmock.h>

#include "construct.h"
#include "description/named_colors.h"

namespace lapidary::description {
namespace {

using testing::HasSubstr;

class ColorTest : public testing::Test {
 protected:
  /// What a surface of that colour looks like in daylight: linear Rec. 709.
  Rgb matte_rgb(std::string_view literal) {
    const auto matte = make_.model<Matte, Material>("matte", literal);
    const Spectrum& color = matte.color.constant()->spectrum;
    const Spectrum light = Spectrum::illuminant({1, 1, 1});
    SpectrumTable table{360, 1, {}};
    for (int nm = 360; nm <= 830; ++nm) {
      table.values.push_back(static_cast<float>(color.at(nm) * light.at(nm)));
    }
    return rgb_of(Spectrum::table(table));
  }
  void expect_near(Rgb a, Rgb b, float tolerance = 2e-3f) {
    EXPECT_NEAR(a.r, b.r, tolerance);
    EXPECT_NEAR(a.g, b.g, tolerance);
    EXPECT_NEAR(a.b, b.b, tolerance);
  }
  /// IEC 61966-2-1, written out once more.
  static float linear(int eight_bit) {
    const double x = eight_bit / 255.0;
    return static_cast<float>(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
  }

  Constructor make_;
};

TEST_F(ColorTest, IsReadInEveryNotation) {
  const Rgb wanted{linear(0xC0), linear(0x80), linear(0x40)};
  expect_near(matte_rgb("'#c08040'"), wanted);
  expect_near(matte_rgb("'#C08040'"), wanted);
  expect_near(matte_rgb("{color = '#c08040'}"), wanted);
  expect_near(matte_rgb("'#fa0'"), {linear(0xFF), linear(0xAA), linear(0x00)});
  expect_near(matte_rgb("'peru'"), {linear(0xCD), linear(0x85), linear(0x3F)});
  expect_near(matte_rgb("'Peru'"), {linear(0xCD), linear(0x85), linear(0x3F)});
  expect_near(matte_rgb("{0.2, 0.4, 0.6}"), {0.2f, 0.4f, 0.6f});
  expect_near(matte_rgb("0.25"), {0.25f, 0.25f, 0.25f});
  expect_near(matte_rgb("{}"), {0.8f, 0.8f, 0.8f});
}

TEST_F(ColorTest, NamesAreSorted) {
  const auto names = named_colors();
  for (std::size_t i = 1; i < names.size(); ++i) EXPECT_LT(names[i - 1].name, names[i].name);
  EXPECT_EQ(find_named_color("rebeccapurple"), 0x663399u);
  EXPECT_FALSE(find_named_color("nocolor"));
}

TEST_F(ColorTest, RefusesWhatIsNone) {
  EXPECT_THAT(make_.error_of("matte", "'redd'"), HasSubstr("did you mean 'red'?"));
  EXPECT_THAT(make_.error_of("matte", "'#12345'"), HasSubstr("three or six hexadecimal digits"));
  EXPECT_THAT(make_.error_of("matte", "'#-1-1-1'"), HasSubstr("must be a color such as"));
  EXPECT_THAT(make_.error_of("matte", "{0.5, 0.5}"), HasSubstr("must be a color, not a list of 2"));
  EXPECT_THAT(make_.error_of("matte", "{0.5, 1.5, 0}"),
              HasSubstr("color.g of matte must be from 0 to 1, not 1.5"));
  EXPECT_THAT(make_.error_of("matte", "2"), HasSubstr("color of matte must be from 0 to 1, not 2"));
}

TEST_F(ColorTest, SpectraServeAsColors) {
  const schema::Node half = make_.node("spectrum", "{from = 400, step = 100, values = {0.5, 0.5}}");
  const auto material = make_.node("matte", schema::Value(half)).as<Material>();
  const Spectrum& color = std::get<Matte>(material->model).color.constant()->spectrum;
  EXPECT_FLOAT_EQ(static_cast<float>(color.at(555.0)), 0.5f);
  const schema::Node bright = make_.node("spectrum", "{1, 2}");
  EXPECT_THAT(Constructor::message_of([&] { make_.node("matte", schema::Value(bright)); }),
              HasSubstr("must reflect from 0 to 1"));
}

TEST_F(ColorTest, SpectraAreChecked) {
  EXPECT_THAT(make_.error_of("spectrum", "{}"), HasSubstr("needs its parameter 'values'"));
  EXPECT_THAT(make_.error_of("spectrum", "{values = {}}"), HasSubstr("must not be empty"));
  EXPECT_THAT(make_.error_of("spectrum", "{values = {-1}}"), HasSubstr("must be from 0"));
  EXPECT_THAT(make_.error_of("spectrum", "{values = {1}, step = 0}"),
              HasSubstr("step of spectrum"));
  EXPECT_THAT(make_.error_of("blackbody", "0"), HasSubstr("must be from 500 to 100000, not 0"));
}

}  // namespace
}  // namespace lapidary::description
