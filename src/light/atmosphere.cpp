#include "light/atmosphere.h"

#include <algorithm>
#include <cmath>

#include "math/constants.h"

namespace lapidary::light {
namespace {

constexpr double earth_radius = 6371.0;
constexpr double top_radius = earth_radius + 80.0;
constexpr double eye_radius = earth_radius + 0.002;

constexpr double air_height = 8.0;  // of the exponential, with the optical depths below
constexpr double haze_height = 1.2;
constexpr double ozone_middle = 25.0, ozone_half_width = 15.0;

/// Optical depth of the air over sea level. Source: Hansen & Travis 1974, equation 2.30.
double air_depth(double nm) {
  const double um2 = nm * nm * 1e-6, inv2 = 1.0 / um2;
  return 0.008569 * inv2 * inv2 * (1.0 + 0.0113 * inv2 + 0.00013 * inv2 * inv2);
}

/// Of the haze. Source: Ångström 1929, with the coefficient by Preetham et al. 1999, appendix 1.
double haze_depth(double nm, double turbidity) {
  const double coefficient = std::max(0.04608 * turbidity - 0.04586, 0.0);
  return coefficient * std::pow(nm * 1e-3, -1.3);
}

/// What haze scatters of what it takes.
constexpr double haze_albedo = 0.95;

/// Molecules in a column of 300 Dobson units [1/m2].
constexpr double ozone_column = 300.0 * 2.687e20;

double air_phase(double cosine) {
  return 3.0 / (16.0 * pi) * (1.0 + cosine * cosine);
}

/// Source: Cornette & Shanks 1992, equation 8.
double haze_phase(double cosine) {
  constexpr double g = 0.76;
  const double base = 1.0 + g * g - 2.0 * g * cosine;
  return 3.0 / (8.0 * pi) * (1.0 - g * g) / (2.0 + g * g) * (1.0 + cosine * cosine) /
         (base * std::sqrt(base));
}

bool meets_earth(double radius, double sine) {
  const double passes2 = radius * radius * (1.0 - sine * sine);
  return sine < 0.0 && passes2 < earth_radius * earth_radius;
}

double distance_to(double sphere, double radius, double sine) {
  const double passes2 = radius * radius * (1.0 - sine * sine);
  const double half_chord = std::sqrt(std::max(0.0, sphere * sphere - passes2));
  return sphere < radius ? -radius * sine - half_chord : -radius * sine + half_chord;
}

double radius_after(double t, double radius, double sine) {
  return std::sqrt(radius * radius + t * t + 2.0 * radius * t * sine);
}

/// A grid over [0, 1] with `count` points: the one below x, and how far x is from there to the
/// next.
struct GridPlace {
  GridPlace(double x, std::size_t count) {
    const double place = std::clamp(x, 0.0, 1.0) * static_cast<double>(count - 1);
    index = std::min(static_cast<std::size_t>(place), count - 2);
    fraction = place - static_cast<double>(index);
  }
  std::size_t index;
  double fraction;
};

template <typename F>
void bilinear(const GridPlace& x, const GridPlace& y, std::size_t width, const F& add) {
  for (const std::size_t dy : {0u, 1u}) {
    for (const std::size_t dx : {0u, 1u}) {
      const double weight =
          (dx == 1 ? x.fraction : 1.0 - x.fraction) * (dy == 1 ? y.fraction : 1.0 - y.fraction);
      add((y.index + dy) * width + x.index + dx, weight);
    }
  }
}

// Places and directions of the table of columns as in Bruneton & Neyret 2008, section 4: the
// distances to the top of the atmosphere, and to the horizon, vary evenly.
constexpr std::size_t column_sines = 128, column_heights = 32;
const double horizon_from_top = std::sqrt(top_radius * top_radius - earth_radius * earth_radius);

double horizon_distance(double radius) {
  return std::sqrt(std::max(0.0, radius * radius - earth_radius * earth_radius));
}

// Of multiple scattering: heights lie closer near the ground, as air is denser there.
constexpr std::size_t multiple_sines = 28, multiple_heights = 10;
constexpr double lowest_sun_sine = -0.35;

}  // namespace

Atmosphere::Atmosphere(const Settings& settings) : ground_albedo_(settings.ground_albedo) {
  for (std::size_t i = 0; i < band_count; ++i) {
    air_[i] = air_depth(band_nm(i)) / air_height;
    haze_[i] = haze_depth(band_nm(i), settings.turbidity) / haze_height;
    haze_scatters_[i] = haze_albedo * haze_[i];
    ozone_[i] = ozone_cross_section[i] * ozone_column / ozone_half_width;
  }
  tabulate_columns();
  tabulate_multiple_scattering();
}

Atmosphere::Columns Atmosphere::density(double height) {
  const double h = std::max(height, 0.0);
  return {std::exp(-h / air_height), std::exp(-h / haze_height),
          std::max(0.0, 1.0 - std::abs(h - ozone_middle) / ozone_half_width)};
}

double Atmosphere::attenuation(std::size_t band, const Columns& c) const {
  return std::exp(-(air_[band] * c.air + haze_[band] * c.haze + ozone_[band] * c.ozone));
}

template <typename Visit>
Atmosphere::Columns Atmosphere::march(const Ray& ray, int steps, const Visit& visit) {
  Columns passed;
  for (int i = 0; i < steps; ++i) {
    // Closer together near the start, where most of the air is.
    const double t0 = ray.length * i * i / (steps * steps);
    const double t1 = ray.length * (i + 1) * (i + 1) / (steps * steps);
    Step step{.t = 0.5 * (t0 + t1), .width = t1 - t0};
    step.radius = radius_after(step.t, ray.radius, ray.sine);
    step.here = density(step.radius - earth_radius);
    step.passed = passed.plus(step.here, 0.5 * step.width);
    passed = passed.plus(step.here, step.width);
    visit(step);
  }
  return passed;
}

void Atmosphere::tabulate_columns() {
  for (std::size_t y = 0; y < column_heights; ++y) {
    const double rho = horizon_from_top * static_cast<double>(y) / (column_heights - 1);
    const double radius = std::sqrt(rho * rho + earth_radius * earth_radius);
    const double shortest = top_radius - radius, longest = rho + horizon_from_top;
    for (std::size_t x = 0; x < column_sines; ++x) {
      const double share = static_cast<double>(x) / (column_sines - 1);
      const double d = shortest + share * (longest - shortest);
      const double sine =
          d > 0.0 ? (top_radius * top_radius - radius * radius - d * d) / (2.0 * radius * d) : 1.0;
      columns_.push_back(march({radius, std::clamp(sine, -1.0, 1.0), d}, 120, [](const Step&) {}));
    }
  }
}

std::optional<Atmosphere::Columns> Atmosphere::to_space(double radius, double sine) const {
  if (meets_earth(radius, sine)) return std::nullopt;
  const double rho = horizon_distance(radius);
  const double shortest = top_radius - radius, longest = rho + horizon_from_top;
  const double d = distance_to(top_radius, radius, sine);
  const double share = longest > shortest ? (d - shortest) / (longest - shortest) : 0.0;
  Columns sum;
  bilinear(GridPlace(share, column_sines), GridPlace(rho / horizon_from_top, column_heights),
           column_sines, [&](std::size_t index, double weight) {
             const Columns& c = columns_[index];
             sum.air += weight * c.air;
             sum.haze += weight * c.haze;
             sum.ozone += weight * c.ozone;
           });
  return sum;
}

double Atmosphere::air_mass(double sine) const {
  return to_space(earth_radius, sine)->air / to_space(earth_radius, 1.0)->air;
}

Bands Atmosphere::sunlight(double sine) const {
  Bands irradiance{};
  const auto columns = to_space(eye_radius, sine);
  if (!columns) return irradiance;
  for (std::size_t i = 0; i < band_count; ++i) {
    irradiance[i] = solar_irradiance[i] * attenuation(i, *columns);
  }
  return irradiance;
}

void Atmosphere::tabulate_multiple_scattering() {
  for (std::size_t y = 0; y < multiple_heights; ++y) {
    const double share = static_cast<double>(y) / (multiple_heights - 1);
    const double radius = earth_radius + 0.01 + share * share * 60.0;
    for (std::size_t x = 0; x < multiple_sines; ++x) {
      const double place = static_cast<double>(x) / (multiple_sines - 1);
      const double sine = lowest_sun_sine + place * (1.0 - lowest_sun_sine);
      multiple_.push_back(integrate_multiple_scattering(radius, sine));
    }
  }
}

Bands Atmosphere::multiple_scattering(double radius, double sun_sine) const {
  const double height = std::sqrt(std::max(0.0, radius - earth_radius - 0.01) / 60.0);
  const double place = (sun_sine - lowest_sun_sine) / (1.0 - lowest_sun_sine);
  Bands sum{};
  bilinear(GridPlace(place, multiple_sines), GridPlace(height, multiple_heights), multiple_sines,
           [&](std::size_t index, double weight) {
             for (std::size_t i = 0; i < band_count; ++i) sum[i] += weight * multiple_[index][i];
           });
  return sum;
}

// Hillaire 2020, equations 5 to 10: light of the second order, and what part of light that is the
// same in all directions is scattered once more; the orders make a geometric series.
Bands Atmosphere::integrate_multiple_scattering(double radius, double sun_sine) const {
  constexpr int elevations = 8, azimuths = 4;
  const double sun_cosine = std::sqrt(std::max(0.0, 1.0 - sun_sine * sun_sine));
  Orders mean{};
  for (int e = 0; e < elevations; ++e) {
    const double sine = -1.0 + (2.0 * e + 1.0) / elevations;
    const double cosine = std::sqrt(1.0 - sine * sine);
    for (int a = 0; a < azimuths; ++a) {
      // By symmetry half of the circle will do.
      const double phi = pi * (a + 0.5) / azimuths;
      const double along_sun = sine * sun_sine + cosine * sun_cosine * std::cos(phi);
      add_orders(mean, {.radius = radius, .sine = sine}, {sun_sine, along_sun});
    }
  }
  constexpr double directions = elevations * azimuths;
  Bands all{};
  for (std::size_t i = 0; i < band_count; ++i) {
    // The series of a column that loses nothing would not end.
    all[i] = mean.second[i] / directions / (1.0 - std::min(mean.again[i] / directions, 0.95));
  }
  return all;
}

void Atmosphere::add_orders(Orders& sum, Ray ray, const Sun& seen) const {
  const bool ends_on_earth = meets_earth(ray.radius, ray.sine);
  ray.length = distance_to(ends_on_earth ? earth_radius : top_radius, ray.radius, ray.sine);
  const auto sun_sine_at = [&](double t, double r) {
    return (ray.radius * seen.sine + t * seen.along_ray) / r;
  };
  const Columns passed = march(ray, 20, [&](const Step& step) {
    const auto sun = to_space(step.radius, sun_sine_at(step.t, step.radius));
    for (std::size_t i = 0; i < band_count; ++i) {
      const double scatters = air_[i] * step.here.air + haze_scatters_[i] * step.here.haze;
      const double reaches = scatters * step.width * attenuation(i, step.passed);
      sum.again[i] += reaches;
      if (sun) sum.second[i] += reaches * attenuation(i, *sun) / (4.0 * pi);
    }
  });
  if (!ends_on_earth) return;
  const double sine = sun_sine_at(ray.length, earth_radius);
  const auto sun = to_space(earth_radius, sine);
  if (!sun || sine <= 0.0) return;
  for (std::size_t i = 0; i < band_count; ++i) {
    const double ground = attenuation(i, *sun) * sine * ground_albedo_ * inv_pi;
    sum.second[i] += attenuation(i, passed) * ground;
  }
}

Bands Atmosphere::radiance(const View& view) const {
  const double air = air_phase(view.cosine), haze = haze_phase(view.cosine);
  Bands L{};
  const Ray ray{eye_radius, view.sine, distance_to(top_radius, eye_radius, view.sine)};
  march(ray, 32, [&](const Step& step) {
    const double sun_sine = (eye_radius * view.sun_sine + step.t * view.cosine) / step.radius;
    const auto sun = to_space(step.radius, sun_sine);
    const Bands more = multiple_scattering(step.radius, sun_sine);
    for (std::size_t i = 0; i < band_count; ++i) {
      const double by_air = air_[i] * step.here.air;
      const double by_haze = haze_scatters_[i] * step.here.haze;
      const double once = sun ? (by_air * air + by_haze * haze) * attenuation(i, *sun) : 0.0;
      L[i] += (once + (by_air + by_haze) * more[i]) * step.width * attenuation(i, step.passed);
    }
  });
  for (std::size_t i = 0; i < band_count; ++i) L[i] *= solar_irradiance[i];
  return L;
}

}  // namespace lapidary::light
