#include "light/sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "math/constants.h"
#include "spectrum/color.h"

namespace lapidary::light {
namespace {

// The picture has the sun in its middle, and its right half mirrors the left one.
constexpr std::size_t half_width = 128, half_height = 64;
constexpr double row_angle = 0.5 * pi / half_height, column_angle = pi / half_width;

/// The sun's mean diameter in the sky.
constexpr double sun_radius = radians(0.5 * 0.533);

Spectrum spectrum_of(const Bands& bands) {
  return Spectrum::table(
      {first_band_nm, band_width_nm, std::vector<float>(bands.begin(), bands.end())});
}

/// The colours of spectra, as sums over their bands.
class BandColors {
 public:
  BandColors() {
    for (std::size_t i = 0; i < band_count; ++i) {
      Bands one{};
      one[i] = 1.0;
      colors_[i] = rgb_of(spectrum_of(one));
    }
  }
  Rgb of(const Bands& bands) const {
    Rgb sum;
    for (std::size_t i = 0; i < band_count; ++i) sum += colors_[i] * static_cast<float>(bands[i]);
    return sum;
  }

 private:
  std::array<Rgb, band_count> colors_;
};

/// The sky, and what it gives level ground.
struct UpperHalf {
  std::vector<Rgb> pixels;  ///< rows of half the picture's width
  Bands irradiance{};
};

UpperHalf upper_half(const Atmosphere& air, double sun_sine) {
  const BandColors colors;
  const double sun_cosine = std::sqrt(std::max(0.0, 1.0 - sun_sine * sun_sine));
  UpperHalf half;
  for (std::size_t row = 0; row < half_height; ++row) {
    const double polar = (static_cast<double>(row) + 0.5) * row_angle;
    const double sine = std::cos(polar), cosine = std::sin(polar);
    const double solid_angle =
        column_angle * (std::cos(polar - 0.5 * row_angle) - std::cos(polar + 0.5 * row_angle));
    for (std::size_t column = 0; column < half_width; ++column) {
      const double azimuth = pi - (static_cast<double>(column) + 0.5) * column_angle;
      const double to_sun = sine * sun_sine + cosine * sun_cosine * std::cos(azimuth);
      const Bands L = air.radiance({sine, sun_sine, to_sun});
      half.pixels.push_back(colors.of(L));
      for (std::size_t i = 0; i < band_count; ++i) {
        half.irradiance[i] += 2.0 * L[i] * sine * solid_angle;
      }
    }
  }
  return half;
}

/// Light from level ground, the same in all directions.
Rgb ground_color(const Sky::Settings& settings, const Bands& sunlight, double sun_sine,
                 const Bands& skylight) {
  Bands L;
  for (std::size_t i = 0; i < band_count; ++i) {
    const double irradiance = sunlight[i] * std::max(sun_sine, 0.0) + skylight[i];
    L[i] = settings.air.ground_albedo * inv_pi * irradiance;
  }
  return BandColors().of(L);
}

}  // namespace

Sky make_sky(const Sky::Settings& settings) {
  const Vec3d to_sun = normalize(settings.to_sun);
  const Atmosphere air(settings.air);
  const Bands sunlight = air.sunlight(to_sun.z);
  const UpperHalf upper = upper_half(air, to_sun.z);
  const Rgb ground = ground_color(settings, sunlight, to_sun.z, upper.irradiance);
  const auto scale = static_cast<float>(settings.scale);

  ImageEnvironment::Picture picture;
  picture.width = 2 * half_width;
  picture.rotation = std::atan2(-to_sun.x, to_sun.y);
  for (std::size_t row = 0; row < half_height; ++row) {
    const auto begin = upper.pixels.begin() + static_cast<std::ptrdiff_t>(row * half_width);
    const std::vector<Rgb> left(begin, begin + half_width);
    for (const Rgb& c : left) picture.pixels.push_back(c * scale);
    for (auto c = left.rbegin(); c != left.rend(); ++c) picture.pixels.push_back(*c * scale);
  }
  picture.pixels.insert(picture.pixels.end(), picture.width * half_height, ground * scale);
  return {std::move(picture),
          DistantLight({to_sun, sun_radius}, spectrum_of(sunlight).scaled(scale))};
}

}  // namespace lapidary::light
