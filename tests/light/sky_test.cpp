#include "light/sky.h"

#include <gtest/gtest.h>

#include "light/lights.h"
#include "spectrum/color.h"
#include "support/chi_squared.h"

namespace lapidary::light {
namespace {

Spectrum spectrum_of(const Bands& bands) {
  return Spectrum::table(
      {first_band_nm, band_width_nm, std::vector<float>(bands.begin(), bands.end())});
}

double lumens(const Bands& bands) {
  const Spectrum s = spectrum_of(bands);
  return luminous_efficacy(s) * s.integral();
}

double sine(double elevation) {
  return std::sin(radians(elevation));
}

/// Correlated colour temperature by McCamy 1992.
double temperature(const Bands& bands) {
  const auto [x, y] = chromaticity(xyz_of(spectrum_of(bands)));
  const double n = (x - 0.3320) / (0.1858 - y);
  return ((449.0 * n + 3525.0) * n + 6823.3) * n + 5520.33;
}

/// Illuminance of level ground by a picture of the sky: what {1, 1, 1} shows as has the luminance
/// of D65 of 1 W/(m2 sr).
double diffuse_lux(const Sky& sky) {
  const double nits = luminous_efficacy(Spectrum::illuminant({1, 1, 1}));
  const std::size_t width = sky.picture.width, height = sky.picture.pixels.size() / width;
  double sum = 0;
  for (std::size_t i = 0; i < sky.picture.pixels.size() / 2; ++i) {
    const double polar = pi * (static_cast<double>(i / width) + 0.5) / static_cast<double>(height);
    const double solid_angle =
        2 * pi / static_cast<double>(width) * std::sin(polar) * pi / static_cast<double>(height);
    sum += luminance(sky.picture.pixels[i]) * nits * std::cos(polar) * solid_angle;
  }
  return sum;
}

Vec3d at_elevation(double degrees) {
  return {0, -std::cos(radians(degrees)), std::sin(radians(degrees))};
}

// The illuminance outside of the atmosphere is 128 to 134 klx, and of its 1361 W/m2 the visible
// half, 360 to 830 nm, is about 54 %.
TEST(Atmosphere, StartsFromTheSolarConstant) {
  const double watts = spectrum_of(solar_irradiance).integral();
  EXPECT_NEAR(watts / 1361.0, 0.54, 0.02);
  EXPECT_NEAR(lumens(solar_irradiance), 131e3, 3e3);
  EXPECT_NEAR(temperature(solar_irradiance), 5900, 150);
}

// Kasten & Young 1989, table II: relative air mass by the sun's elevation; they refract the light,
// which shortens its way at the horizon.
TEST(Atmosphere, HasTheAirMassOfTheTables) {
  const Atmosphere air({});
  EXPECT_NEAR(air.air_mass(1.0), 1.0, 1e-3);
  EXPECT_NEAR(air.air_mass(sine(60)), 1.154, 0.01);
  EXPECT_NEAR(air.air_mass(sine(30)), 1.994, 0.02);
  EXPECT_NEAR(air.air_mass(sine(10)), 5.58, 0.1);
  EXPECT_NEAR(air.air_mass(sine(5)), 10.3, 0.4);
  EXPECT_NEAR(air.air_mass(0.0), 38, 4);
}

// Of clean air without haze: the optical depth by Bodhaine et al. 1999 is 0.3599 at 400 nm, 0.0973
// at 550 nm and 0.0431 at 670 nm; ozone takes some of 550 nm, as its Chappuis band does.
TEST(Atmosphere, LetsThroughWhatCleanAirDoes) {
  const Bands sun = Atmosphere({.turbidity = 1}).sunlight(1.0);
  const auto depth = [&](double nm) {
    return -std::log(spectrum_of(sun).at(nm) / spectrum_of(solar_irradiance).at(nm));
  };
  EXPECT_NEAR(depth(405), 0.342, 0.01);
  EXPECT_NEAR(depth(550), 0.097 + 0.028, 0.01);
  EXPECT_NEAR(depth(805), 0.0206, 0.005);
}

// Under a clear sky with the sun overhead the direct light is 100 to 120 klx, and lower suns are
// weaker and redder: about 1800 to 3300 K a few degrees above the horizon.
TEST(Atmosphere, DimsAndReddensTheSun) {
  const Atmosphere air({});
  EXPECT_NEAR(lumens(air.sunlight(1.0)), 105e3, 10e3);
  double last_lux = infinity, last_kelvin = infinity;
  for (const double elevation : {90.0, 45.0, 20.0, 10.0, 5.0, 2.0}) {
    const Bands sun = air.sunlight(sine(elevation));
    EXPECT_LT(lumens(sun), last_lux);
    EXPECT_LT(temperature(sun), last_kelvin);
    last_lux = lumens(sun), last_kelvin = temperature(sun);
  }
  EXPECT_NEAR(temperature(air.sunlight(1.0)), 5400, 300);
  EXPECT_NEAR(temperature(air.sunlight(sine(5))), 2700, 700);
  EXPECT_EQ(lumens(air.sunlight(sine(-1))), 0.0);
}

// The clear zenith has more than 10000 K; clear skies give level ground 10 to 20 klx, and very
// clear air has an optical depth of haze of 0.1.
TEST(Sky, IsBlueAndAsBrightAsItIs) {
  const Atmosphere air({});
  EXPECT_GT(temperature(air.radiance({1.0, sine(45), sine(45)})), 9000);
  const Sky sky = make_sky({.to_sun = at_elevation(60), .air = {.turbidity = 2}});
  RecordProperty("lux", static_cast<int>(diffuse_lux(sky)));
  EXPECT_GT(diffuse_lux(sky), 9e3);
  EXPECT_LT(diffuse_lux(sky), 21e3);
  const Rgb zenith = sky.picture.pixels[3];
  EXPECT_GT(zenith.b, 1.5f * zenith.r);
  // Haze scatters more of the sun's light, and whiter.
  EXPECT_GT(diffuse_lux(make_sky({.to_sun = at_elevation(60), .air = {.turbidity = 6}})),
            1.3 * diffuse_lux(sky));
}

// Illuminances of level ground, of the sky alone: 400 lx about sunset, 3.4 lx at the end of civil
// twilight (USNO), each within a factor that clear skies differ by.
TEST(Sky, FadesThroughDusk) {
  const double sunset = diffuse_lux(make_sky({.to_sun = at_elevation(0)}));
  const double dusk = diffuse_lux(make_sky({.to_sun = at_elevation(-6)}));
  EXPECT_GT(sunset, 250);
  EXPECT_LT(sunset, 1200);
  EXPECT_GT(dusk, 0.5);
  EXPECT_LT(dusk, 20);
}

// Energy: what comes down cannot exceed what the sun sends in, and of clean air over black ground
// about half of what is scattered comes down.
TEST(Sky, GivesNoMoreThanItGets) {
  for (const double elevation : {90.0, 30.0, 5.0}) {
    const Atmosphere air({.turbidity = 1, .ground_albedo = 0});
    const Bands sun = air.sunlight(sine(elevation));
    Bands down{};
    constexpr int rows = 40, columns = 40;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const double up = (row + 0.5) / rows, phi = 2 * pi * (column + 0.5) / columns;
        const double cosine = up * sine(elevation) +
                              std::sqrt(1 - up * up) * std::cos(radians(elevation)) * std::cos(phi);
        const Bands L = air.radiance({up, sine(elevation), cosine});
        for (std::size_t i = 0; i < band_count; ++i) down[i] += L[i] * up * 2 * pi / rows / columns;
      }
    }
    for (std::size_t i = 0; i < 12; ++i) {  // where ozone takes nothing
      const double lost = (solar_irradiance[i] - sun[i]) * sine(elevation);
      EXPECT_GT(down[i], 0.40 * lost) << i << " at " << elevation;
      EXPECT_LT(down[i], 0.62 * lost) << i << " at " << elevation;
    }
  }
}

TEST(Sky, HasItsSunWhereItIsSaid) {
  for (const Vec3d to_sun : {Vec3d(1, 2, 1), Vec3d(-3, 0.5, 2), Vec3d(0, -1, 0.3)}) {
    Sky sky = make_sky({.to_sun = to_sun, .air = {.turbidity = 5}});
    const ImageEnvironment picture(std::move(sky.picture));
    const Vec3d sun = normalize(to_sun), level = normalize(Vec3d(sun.x, sun.y, 0));
    const Vec3d turned(-level.x * std::sqrt(1 - sun.z * sun.z),
                       -level.y * std::sqrt(1 - sun.z * sun.z), sun.z);
    EXPECT_GT(luminance(picture.color_towards(sun)), 3 * luminance(picture.color_towards(turned)));
    const auto disc = sky.sun.sample_illumination({}, {0.5, {0.0, 0.0}}, test::wavelengths());
    ASSERT_TRUE(disc);
    EXPECT_GT(dot(disc->wi, sun), std::cos(radians(0.27)));
  }
}

// One test with a false-alarm rate of 1e-6.
TEST(Sky, IsSampledWithItsDensity) {
  Sky sky = make_sky({.to_sun = {0, 1, 0.5}});
  const ImageEnvironment picture(std::move(sky.picture));
  const auto result = lapidary::test::test_directions(
      [&](lapidary::test::Random& random) -> std::optional<Vec3d> {
        return picture.sample_illumination({}, {0, random.uniform2()}, test::wavelengths())->wi;
      },
      [&](Vec3d wi) { return picture.pdf_illumination({}, wi, {}); },
      {.samples = 50000, .significance = 1e-6, .min_depth = 4, .max_depth = 7});
  EXPECT_TRUE(result.accepted) << result.message;
}

}  // namespace
}  // namespace lapidary::light
