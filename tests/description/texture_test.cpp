#include <gmock/gmock.h>

#include "construct.h"
#include "description/texture_readers.h"

namespace lapidary::description {
namespace {

using testing::HasSubstr;
using texture::Checker;
using texture::Projection;
using texture::Texture;

class TextureTest : public testing::Test {
 protected:
  template <typename Kind>
  Kind kind(std::string_view name, std::string_view literal) {
    return std::get<Kind>(make_.make<Texture>(name, literal)->kind);
  }
  /// What the parameter `thing` of a node reads, of which numbers are from 0 to 1.
  template <typename Reader>
  auto read(const schema::Value& value) {
    const schema::Call call{"tester", {}};
    return Reader::read(value, schema::Context(call).at("thing", schema::unit_interval));
  }
  template <typename Reader>
  std::string read_error(const schema::Value& value) {
    return Constructor::message_of([&] { read<Reader>(value); });
  }
  Constructor make_;
};

TEST_F(TextureTest, MayStandForAColor) {
  const schema::Node checker = make_.node("checker", "{}"), ball = make_.node("sphere", "{}");
  EXPECT_EQ(read<ColorReader>(schema::Value(0.5)),
            texture::Color(Spectrum::reflectance({0.5f, 0.5f, 0.5f})));
  EXPECT_EQ(read<ColorReader>(schema::Value(checker)), texture::Color(checker.as<Texture>()));
  EXPECT_THAT(read_error<ColorReader>(schema::Value(ball)), HasSubstr("must be a color, not a sp"));
  EXPECT_THAT(read_error<ColorReader>(schema::Value(1.5)), HasSubstr("must be from 0 to 1"));
}

TEST_F(TextureTest, MayStandForANumber) {
  const schema::Node checker = make_.node("checker", "{}"), ball = make_.node("sphere", "{}");
  EXPECT_EQ(read<NumberReader>(schema::Value(0.5)), texture::Number(0.5));
  EXPECT_EQ(read<NumberReader>(schema::Value(checker)), texture::Number(checker.as<Texture>()));
  EXPECT_THAT(read_error<NumberReader>(schema::Value(ball)),
              HasSubstr("must be a number or a texture, not a sphere"));
  EXPECT_THAT(read_error<NumberReader>(schema::Value(1.5)), HasSubstr("must be from 0 to 1"));
  EXPECT_EQ(NumberReader::text(0.25), "0.25");
}

TEST_F(TextureTest, RepeatWhereTheyLieFlat) {
  const auto tiles = kind<Checker>("checker",
                                   "{mapping = 'spherical', repeats = {6, 3}, shift = "
                                   "{0.5, 0}}")
                         .mapping;
  EXPECT_EQ(tiles.repeats, (Vec2d{6, 3}));
  EXPECT_EQ(tiles.shift, (Vec2d{0.5, 0}));
  EXPECT_THAT(make_.error_of("checker", "{repeats = {2, 2}}"),
              HasSubstr("repeats of checker needs a mapping that lays the pattern flat"));
  EXPECT_THAT(make_.error_of("checker", "{shift = {0, 2}}"), HasSubstr("shift of checker needs"));
  EXPECT_THAT(make_.error_of("checker", "{mapping = 'uv', repeats = {2, 0}}"),
              HasSubstr("repeats of checker must not be zero"));
}

TEST_F(TextureTest, CheckersHaveTwoColors) {
  const auto board = kind<Checker>("checker", "{'red', 0.5}");
  EXPECT_EQ(board.colors[0], texture::Color(Spectrum::reflectance({1, 0, 0})));
  EXPECT_EQ(board.colors[1], texture::Color(Spectrum::reflectance({0.5f, 0.5f, 0.5f})));
  EXPECT_EQ(board.mapping.projection, Projection::object);
  EXPECT_EQ(kind<Checker>("checker", "{mapping = 'uv'}").mapping.projection, Projection::uv);
  EXPECT_THAT(make_.error_of("checker", "{'red'}"),
              HasSubstr("colors of checker must be a list of two colors, not the string 'red'"));
  EXPECT_THAT(make_.error_of("checker", "{'red', 'blu'}"), HasSubstr("colors[2] of checker names"));
  EXPECT_THAT(make_.error_of("checker", "{mapping = 'vu'}"), HasSubstr("must be one of"));
}

}  // namespace
}  // namespace lapidary::description
