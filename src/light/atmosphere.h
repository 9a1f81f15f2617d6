#pragma once

#include <optional>
#include <vector>

#include "light/atmosphere_data.h"

namespace lapidary::light {

/// The clear air around the earth, lit by the sun. Lengths are in kilometres.
///
/// Air scatters by Rayleigh's law, haze by the phase function of Cornette & Shanks 1992 and its
/// extinction falls with the wavelength by Ångström's law, ozone absorbs. Air and haze thin out
/// exponentially upwards, ozone is a layer about 25 km. Light that is scattered once is followed
/// exactly, more of it as if it were the same in all directions (Hillaire 2020).
class Atmosphere {
 public:
  struct Settings {
    double turbidity = 2.5;      ///< 1: no haze at all; 2: very clear; 6: hazy; 1 to 10
    double ground_albedo = 0.2;  ///< of all wavelengths alike, in [0, 1]
  };
  explicit Atmosphere(const Settings& settings);

  /// Of the sun, on a plane on the ground that faces it [W/(m2 nm)]; `sine` is of its elevation.
  /// All zero below the horizon.
  Bands sunlight(double sine) const;

  /// Where one looks from the ground, and where the sun is.
  struct View {
    double sine = 1;      ///< of the elevation, >= 0
    double sun_sine = 1;  ///< of the sun's elevation
    double cosine = 1;    ///< of the angle between the two
  };
  /// The radiance of the sky [W/(m2 sr nm)].
  Bands radiance(const View& view) const;

  /// Air along a way from the ground to space over that straight up.
  double air_mass(double sine) const;

 private:
  /// What a way leads through: the lengths of air, haze and ozone as dense as each is at its
  /// densest.
  struct Columns {
    double air = 0, haze = 0, ozone = 0;

    Columns plus(const Columns& density, double length) const {
      return {air + density.air * length, haze + density.haze * length,
              ozone + density.ozone * length};
    }
  };
  static Columns density(double height);

  /// A way through the air, from a place at a distance from the earth's centre.
  struct Ray {
    double radius = 0;
    double sine = 0;  ///< of its elevation there
    double length = 0;
  };
  struct Step {
    double t = 0, width = 0;  ///< of its middle
    double radius = 0;
    Columns here, passed;  ///< densities, and what lies before the step's middle
  };
  /// Walks along it; returns what it leads through.
  template <typename Visit>
  static Columns march(const Ray& ray, int steps, const Visit& visit);

  double attenuation(std::size_t band, const Columns& columns) const;
  void tabulate_columns();
  /// From a place to space; nothing when the earth is in the way.
  std::optional<Columns> to_space(double radius, double sine) const;

  void tabulate_multiple_scattering();
  /// Of all orders but the first, per unit of scattering and irradiance of the sun.
  Bands multiple_scattering(double radius, double sun_sine) const;
  Bands integrate_multiple_scattering(double radius, double sun_sine) const;
  /// Sums over directions of light of the second order, and of what light that is 1 everywhere
  /// would be scattered once more.
  struct Orders {
    Bands second{}, again{};
  };
  struct Sun {
    double sine = 0;       ///< of its elevation at the start of a ray
    double along_ray = 0;  ///< the cosine between the two
  };
  void add_orders(Orders& sum, Ray ray, const Sun& seen) const;

  Bands air_{}, haze_{}, haze_scatters_{}, ozone_{};  // coefficients at the densest [1/km]
  double ground_albedo_;
  std::vector<Columns> columns_;
  std::vector<Bands> multiple_;
};

}  // namespace lapidary::light
