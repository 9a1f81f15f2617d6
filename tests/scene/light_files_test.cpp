#include <gmock/gmock.h>

#include "import/temp_folder.h"
#include "scene/prepare_light.h"
#include "scene/tiny_scene.h"

namespace lapidary::test {
namespace {

using description::Quantity;

/// Half of all directions have 100 cd: 628 lm.
constexpr std::string_view lamp_of_628_lumens =
    "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n100 100\n";

light::Light prepared(const description::ProfileLight& profile, double metres) {
  return scene::prepare_lights({profile, {}}, {metres}).front();
}

TEST(ProfileLights, GiveTheCandelaOfTheirFileOrThePowerSaid) {
  const import::TempFolder folder;
  description::ProfileLight profile{.file = folder.write("lamp.ies", lamp_of_628_lumens)};
  profile.emission = {Quantity::intensity, grey(0.01)};  // of one candela
  EXPECT_NEAR(light::power(prepared(profile, 1.0), 1.0), 470 * 0.01 * 100 * 2 * pi, 1e-2);
  profile.emission = {Quantity::power, grey(0.01)};
  EXPECT_NEAR(light::power(prepared(profile, 1.0), 1.0), 4.7, 1e-5);
  // In millimetres the same power crosses a sphere of a million times the area.
  EXPECT_NEAR(light::power(prepared(profile, 0.001), 1.0), 4.7e6, 10);
}

TEST(ProfileLights, OfBadFilesAreRefused) {
  const import::TempFolder folder;
  const description::ProfileLight profile{.file = folder.write("lamp.ies", "not a lamp\n")};
  try {
    prepared(profile, 1.0);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("lamp.ies:1: the file has no line TILT="));
  }
  EXPECT_THROW(prepared({.file = folder.path() / "none.ies"}, 1.0), Error);
  EXPECT_THROW(prepared({.file = folder.path()}, 1.0), Error);
}

TEST(Skies, BringTheirSunUnlessItIsDownOrLeftOut) {
  const auto lights = [](Vec3d to_sun, description::Sky::Sun sun) {
    return scene::prepare_lights({description::Sky{.to_sun = to_sun, .sun = sun}, {}}, {}).size();
  };
  EXPECT_EQ(lights({1, 1, 1}, description::Sky::Sun::shines), 2u);
  EXPECT_EQ(lights({1, 1, 1}, description::Sky::Sun::left_out), 1u);
  EXPECT_EQ(lights({1, 1, -0.1}, description::Sky::Sun::shines), 1u);
}

TEST(LightChoice, IsWhatTheSettingsSay) {
  TinyScene tiny;
  tiny.light(description::PointLight{{0, 0, 1}, {Quantity::power, grey(1)}});
  tiny.light(description::PointLight{{0, 0, 100}, {Quantity::power, grey(3)}});
  ThreadPool pool(1);
  WarningLog warnings;
  scene::BuildOptions options{tiny.description.render.size, pool, warnings};
  const light::LitPoint near_the_first{{0, 0, 0}};
  EXPECT_GT(
      scene::build(tiny.description, options).light_selector()->probability(near_the_first, 0),
      0.99);
  options.light_choice = description::LightChoice::power;
  EXPECT_NEAR(
      scene::build(tiny.description, options).light_selector()->probability(near_the_first, 0),
      0.25, 1e-6);
}

}  // namespace
}  // namespace lapidary::test
