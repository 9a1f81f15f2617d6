#include "description/light.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "construct.h"
#include "spectrum/cie_functions.h"
#include "spectrum/color.h"

namespace lapidary::description {
namespace {

using testing::HasSubstr;

class LightTest : public testing::Test {
 protected:
  Emission emission_of_object(const Object& object) {
    return std::get<Emissive>(object.material->model).emission;
  }
  Emission emission_of(const schema::Node& node) {
    if (const auto object = node.as<Object>()) return emission_of_object(*object);
    const auto light = node.as<Light>();
    if (const auto* point = std::get_if<PointLight>(&light->model)) return point->emission;
    if (const auto* spot = std::get_if<SpotLight>(&light->model)) return spot->emission;
    return std::get<DistantLight>(light->model).emission;
  }
  Constructor make_;
};

TEST_F(LightTest, PowerIsTheIntegralOfTheSpectrum) {
  for (const char* literal :
       {"{power = 40}", "{power = 40, color = 'orange'}", "{power = 40, color = {3, 2, 1}}",
        "{power = 40, temperature = 2700}"}) {
    const auto light = make_.object("sphere_light", literal);
    const Emission emission = emission_of_object(*light);
    EXPECT_EQ(emission.quantity, Quantity::power);
    EXPECT_NEAR(emission.spectrum.integral(), 40, 40 * 1e-5) << literal;
  }
}

TEST_F(LightTest, RadianceShowsAsItsColor) {
  const auto light = make_.object("sphere_light", "{radiance = {3, 2, 1}}");
  const Emission emission = emission_of_object(*light);
  EXPECT_EQ(emission.quantity, Quantity::radiance);
  const Rgb rgb = rgb_of(emission.spectrum);
  EXPECT_NEAR(rgb.r, 3, 1e-3);
  EXPECT_NEAR(rgb.g, 2, 1e-3);
  EXPECT_NEAR(rgb.b, 1, 1e-3);
}

TEST_F(LightTest, RadianceAsANumberIsTheTotal) {
  const auto plain = emission_of_object(*make_.object("sphere_light", "{radiance = 5}"));
  EXPECT_NEAR(plain.spectrum.integral(), 5, 1e-4);
  const auto warm =
      emission_of_object(*make_.object("sphere_light", "{radiance = 5, temperature = 2700}"));
  EXPECT_NEAR(warm.spectrum.integral(), 5, 1e-4);
  EXPECT_GT(warm.spectrum.at(700.0), 2 * warm.spectrum.at(450.0));
}

TEST_F(LightTest, StrengthIsGivenExactlyOnce) {
  EXPECT_THAT(make_.error_of("sphere_light", "{}"),
              HasSubstr("sphere_light needs 'power', 'radiance', 'lumens' or 'nits'"));
  EXPECT_THAT(make_.error_of("sphere_light", "{power = 1, radiance = 1}"),
              HasSubstr("takes either 'power' or 'radiance', not both"));
  EXPECT_THAT(make_.error_of("sphere_light", "{power = 1, lumens = 1}"),
              HasSubstr("takes either 'power' or 'lumens', not both"));
  EXPECT_THAT(make_.error_of("sphere_light", "{power = 1, nits = 1, lumens = 1}"),
              HasSubstr("takes either 'power', 'lumens' or 'nits', not several of them"));
  EXPECT_THAT(make_.error_of("sphere_light", "{candela = 1}"),
              HasSubstr("unknown parameter 'candela' of sphere_light"));
  EXPECT_THAT(make_.error_of("point_light", "{}"),
              HasSubstr("needs 'power', 'intensity', 'lumens' or 'candela'"));
  EXPECT_THAT(make_.error_of("point_light", "{radiance = 1}"),
              HasSubstr("unknown parameter 'radiance' of point_light"));
  EXPECT_THAT(make_.error_of("sun", "{}"), HasSubstr("sun needs 'irradiance' or 'lux'"));
  EXPECT_THAT(make_.error_of("sphere_light", "{power = 1, color = 'red', temperature = 3000}"),
              HasSubstr("either 'color' or 'temperature'"));
  EXPECT_THAT(make_.error_of("sphere_light", "{power = 1, color = 'black'}"),
              HasSubstr("color of sphere_light must not be black"));
  EXPECT_THAT(make_.error_of("sphere_light", "{power = -1}"), HasSubstr("must be at least 0"));
  EXPECT_THAT(make_.error_of("sphere_light", "{power = 1, radius = 0}"),
              HasSubstr("radius of sphere_light must be greater than 0"));
}

TEST_F(LightTest, PhotometricStrengthsAreWeighedByTheEye) {
  struct Case {
    const char* node;
    const char* name;
    Quantity quantity;
  };
  for (const auto& [node, name, quantity] : {Case{"sphere_light", "lumens", Quantity::power},
                                             Case{"sphere_light", "nits", Quantity::radiance},
                                             Case{"point_light", "lumens", Quantity::power},
                                             Case{"point_light", "candela", Quantity::intensity},
                                             Case{"spot_light", "candela", Quantity::intensity},
                                             Case{"sun", "lux", Quantity::irradiance}}) {
    for (const char* color : {"", ", color = 'orange'", ", temperature = 2700"}) {
      const std::string literal = fmt::format("{{{} = 500{}}}", name, color);
      const schema::Node made = make_.node(node, literal);
      const Emission emission = emission_of(made);
      EXPECT_EQ(emission.quantity, quantity) << node << literal;
      // Lumens by the definition: 683 lm/W times the integral against the luminosity function.
      double lumens = 0;
      for (double nm = 360.5; nm < 830; nm += 1) {
        lumens += 683.0 * emission.spectrum.at(nm) * observer_at(nm)[1];
      }
      EXPECT_NEAR(lumens, 500, 1) << node << literal;
    }
  }
}

TEST_F(LightTest, ALumenOfDaylightTakesTheWattsThatStandardsSay) {
  // D65 within 360-830 nm has about 184 lm/W, and green light of 555 nm has 683.
  const auto day = emission_of_object(*make_.object("sphere_light", "{lumens = 1840}"));
  EXPECT_NEAR(day.spectrum.integral(), 10, 0.1);
  EXPECT_NEAR(emission_of_object(*make_.object("sphere_light", "{nits = 184}")).spectrum.integral(),
              1, 0.01);
}

TEST_F(LightTest, LightThatNobodySeesHasNoLumens) {
  const auto infrared = make_.node("spectrum", "{from = 810, step = 5, values = {0, 1}}");
  const schema::Field fields[] = {{"color", schema::Value(infrared)},
                                  {"lumens", schema::Value(100.0)}};
  const schema::Value argument = make_.arena().table({}, fields);
  EXPECT_THAT(make_.message_of([&] { make_.node("sphere_light", argument); }),
              HasSubstr("sphere_light gives no light that can be seen, so 'lumens' cannot say"));
  const schema::Field watts[] = {{"color", schema::Value(infrared)},
                                 {"power", schema::Value(100.0)}};
  EXPECT_NO_THROW(make_.node("sphere_light", make_.arena().table({}, watts)));
}

TEST_F(LightTest, LightsWithASurfaceAreObjects) {
  const auto disk = make_.object("disk_light", "{center = {0, 0, 5}, at = {0, 0, 0}, power = 1}");
  const auto& sheet = std::get<geometry::Sheet>(disk->content);
  EXPECT_EQ(std::get<geometry::Disk>(sheet).normal, Vec3d(0, 0, -1));
  EXPECT_EQ(disk->where.location().line, 7);

  const auto panel =
      make_.object("rectangle_light", "{size = {4, 2}, normal = {0, -1, 0}, power = 1}");
  const auto& r = std::get<geometry::Rectangle>(std::get<geometry::Sheet>(panel->content));
  EXPECT_EQ(r.edge_u, Vec3d(4, 0, 0));
  EXPECT_EQ(r.edge_v, Vec3d(0, 0, 2));
  EXPECT_EQ(r.corner, Vec3d(-2, 0, -1));
}

TEST_F(LightTest, MeshLightDressesEveryPart) {
  const auto red = make_.make<Material>("matte", "'red'");
  const auto dressed = with_material(*make_.object("sphere", "{}"), red);
  const auto group = make_group({dressed, make_.object("box", "{size = {1, 1, 1}}")}, {});
  const schema::Node shape = schema::Node::of<Object>("group", group, 0);
  const schema::Field fields[] = {{"power", schema::Value(5.0)}, {"shape", schema::Value(shape)}};
  const auto light = make_.node("mesh_light", make_.arena().table({}, fields)).as<Object>();
  ASSERT_TRUE(light);
  for (const auto& child : std::get<std::shared_ptr<const Group>>(light->content)->children) {
    EXPECT_EQ(emission_of_object(*child).quantity, Quantity::power);
  }
  EXPECT_TRUE(std::holds_alternative<Matte>(dressed->material->model)) << "the original is changed";
}

TEST_F(LightTest, SpotAndSunCheckTheirDirections) {
  const auto sun = make_.model<DistantLight, Light>("sun", "{from = {1, 2, 3}, irradiance = 1}");
  EXPECT_EQ(sun.direction, Vec3d(-1, -2, -3));
  EXPECT_EQ((make_.model<DistantLight, Light>("sun", "{irradiance = 1}").direction),
            Vec3d(0, 0, -1));
  EXPECT_THAT(make_.error_of("sun", "{from = {0, 0, 0}, irradiance = 1}"),
              HasSubstr("from of sun must not be zero"));
  EXPECT_THAT(make_.error_of("sun", "{from = {0, 0, 1}, direction = {0, 0, 1}, irradiance = 1}"),
              HasSubstr("either 'from' or 'direction'"));
  EXPECT_THAT(make_.error_of("spot_light", "{from = {1, 1, 1}, at = {1, 1, 1}, power = 1}"),
              HasSubstr("at of spot_light must differ from 'from'"));
  EXPECT_THAT(make_.error_of("spot_light", "{angle = 200, power = 1}"),
              HasSubstr("greater than 0 and at most 180"));
}

TEST_F(LightTest, ProfilesAreAimedAndOthersAreNot) {
  EXPECT_THAT(make_.error_of("point_light", "{at = {0, 0, 0}, power = 1}"),
              HasSubstr("at of point_light aims a profile, and there is none"));
  EXPECT_THAT(make_.error_of("point_light", "{up = {0, 0, 1}, power = 1}"),
              HasSubstr("up of point_light aims a profile"));
  EXPECT_THAT(make_.error_of("point_light", "{profile = 'lamp.ies'}"),
              HasSubstr("no file can be read here"));
}

TEST_F(LightTest, SkiesKnowWhereTheirSunIs) {
  const auto to_sun = [this](const char* literal) {
    const Vec3d d = make_.model<Sky, Light>("sky", literal).to_sun;
    return std::vector<double>{d.x, d.y, d.z};
  };
  const auto near = [](double x, double y, double z) {
    return testing::ElementsAre(testing::DoubleNear(x, 1e-12), testing::DoubleNear(y, 1e-12),
                                testing::DoubleNear(z, 1e-12));
  };
  const double half = std::sqrt(0.5);
  EXPECT_THAT(to_sun("{}"), near(0, half, half));
  EXPECT_THAT(to_sun("{elevation = 0, azimuth = 90}"), near(1, 0, 0));
  EXPECT_THAT(to_sun("{sun_direction = {1, 2, 3}}"), near(1, 2, 3));
  EXPECT_THAT(make_.error_of("sky", "{elevation = -20}"), HasSubstr("must be from -10 to 90"));
  EXPECT_THAT(make_.error_of("sky", "{sun_direction = {1, 0, -1}}"),
              HasSubstr("more than 10 degrees below the horizon"));
  EXPECT_THAT(make_.error_of("sky", "{sun_direction = {0, 0, 0}}"), HasSubstr("must not be zero"));
  EXPECT_THAT(make_.error_of("sky", "{sun_direction = {0, 0, 1}, elevation = 3}"),
              HasSubstr("either 'sun_direction' or 'elevation'"));
}

TEST_F(LightTest, EnvironmentIsAColorOrAFile) {
  const auto sky = make_.model<ConstantEnvironment, Light>("environment", "{color = 2, scale = 3}");
  EXPECT_NEAR(sky.radiance.integral(), 6, 1e-4);
  EXPECT_THAT(make_.error_of("environment", "{file = 'sky.exr', color = 1}"),
              HasSubstr("no file can be read here"));
}

}  // namespace
}  // namespace lapidary::description
