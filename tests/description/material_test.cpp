#include <gmock/gmock.h>

#include "construct.h"

namespace lapidary::description {
namespace {

using testing::HasSubstr;

class MaterialTest : public testing::Test {
 protected:
  schema::Node node(std::string_view name, std::vector<schema::Field> fields) {
    return make_.node(name, make_.arena().table({}, fields));
  }
  std::string error_of(std::string_view name, std::vector<schema::Field> fields) {
    return Constructor::message_of([&] { node(name, fields); });
  }
  schema::Node blend(const schema::Node& a, const schema::Node& b) {
    const schema::Value items[] = {schema::Value(a), schema::Value(b)};
    return node("blend", {{"materials", make_.arena().table(items, {})}});
  }
  static MaterialPtr material(const schema::Node& node) { return node.as<Material>(); }

  Constructor make_;
  schema::Node checker_ = make_.node("checker", "{}");
  schema::Node matte_ = make_.node("matte", "{}"), glass_ = make_.node("glass", "1.7");
  schema::Node pane_ = make_.node("thin_glass", "{}");
};

TEST_F(MaterialTest, TakeTexturesWhereTheyHaveNumbersAndColors) {
  const schema::Value checker(checker_), base(matte_);
  EXPECT_TRUE(is_textured(*material(node("matte", {{"roughness", checker}}))));
  EXPECT_TRUE(is_textured(*material(node("phong", {{"exponent", checker}}))));
  EXPECT_TRUE(is_textured(*material(node("thin_glass", {{"color", checker}}))));
  EXPECT_TRUE(is_textured(*material(node("velvet", {{"color", checker}}))));
  EXPECT_TRUE(is_textured(*material(node("principled", {{"coat_roughness", checker}}))));
  EXPECT_TRUE(is_textured(*material(node("coated", {{"base", base}, {"roughness", checker}}))));
  EXPECT_FALSE(is_textured(*material(node("coated", {{"base", base}}))));
  // Also deep inside.
  const schema::Node spotted = node("matte", {{"color", checker}});
  const schema::Node varnished = node("coated", {{"base", schema::Value(spotted)}});
  EXPECT_TRUE(is_textured(*material(blend(matte_, varnished))));
}

TEST_F(MaterialTest, FillBodiesWithTheGlassThatTheyAre) {
  EXPECT_EQ(as_glass(*material(matte_)), nullptr);
  EXPECT_EQ(as_glass(*material(blend(matte_, glass_)))->index.at(500.0), 1.7);
  EXPECT_EQ(as_glass(*material(blend(glass_, pane_)))->index.at(500.0), 1.7);
  EXPECT_EQ(as_glass(*material(pane_))->index.at(500.0), 1.0);  // hollow
  EXPECT_EQ(as_glass(*make_.make<Material>("principled", "{}")), nullptr);
  const auto clear = make_.make<Material>(
      "principled",
      "{transmission = 0.5, ior = 1.4, transmission_color = 'red', transmission_depth = 3}");
  ASSERT_NE(as_glass(*clear), nullptr);
  EXPECT_EQ(as_glass(*clear)->index.at(500.0), 1.4);
  EXPECT_EQ(as_glass(*clear)->absorption->distance, 3.0);
}

TEST_F(MaterialTest, RefuseWhatTheyCannotBeMadeOf) {
  const schema::Node lamp = make_.node("emissive", "{radiance = 1}");
  const schema::Node net = make_.node("matte", "{opacity = 0.5}");
  EXPECT_THAT(error_of("coated", {}), HasSubstr("base"));
  EXPECT_THAT(error_of("coated", {{"base", schema::Value(glass_)}}), HasSubstr("an opaque base"));
  EXPECT_THAT(error_of("coated", {{"base", schema::Value(pane_)}}), HasSubstr("an opaque base"));
  EXPECT_THAT(error_of("velvet", {{"base", schema::Value(lamp)}}), HasSubstr("gives light"));
  EXPECT_THAT(error_of("coated", {{"base", schema::Value(net)}}), HasSubstr("'opacity'"));
  EXPECT_THAT(Constructor::message_of([&] { blend(glass_, glass_); }), HasSubstr("two kinds of"));
  EXPECT_THAT(make_.error_of("principled", "{transmission_color = 'red'}"),
              HasSubstr("needs both 'transmission_color' and"));
  EXPECT_THAT(make_.error_of("principled", "{thin_film = 1}"), HasSubstr("unknown parameter"));
}

// All of them are looked at for every point of a picture.
TEST_F(MaterialTest, AreMadeOfAFiniteNumberOfOthers) {
  schema::Node many = matte_;
  for (int i = 0; i < 8; ++i) many = blend(many, many);
  EXPECT_EQ(material(many)->parts, 511);
  EXPECT_THAT(Constructor::message_of([&] { blend(many, many); }),
              HasSubstr("more than 1000 others"));
}

TEST_F(MaterialTest, PrincipledSurfacesMayGlow) {
  EXPECT_EQ(emission_of(*make_.make<Material>("principled", "{}")), nullptr);
  const auto glowing = make_.make<Material>("principled", "{emission = 2}");
  ASSERT_NE(emission_of(*glowing), nullptr);
  EXPECT_EQ(emission_of(*glowing)->quantity, Quantity::radiance);
}

}  // namespace
}  // namespace lapidary::description
