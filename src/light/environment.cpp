#include "light/environment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sampling/warp.h"
#include "spectrum/color.h"

namespace lapidary::light {
namespace {

// Area of a disc of the scene's radius: what the scene catches from each direction.
double cross_section(double scene_radius) {
  return pi * scene_radius * scene_radius;
}

float non_negative(float x) {
  return std::max(x, 0.0f);
}

}  // namespace

std::optional<LightSample> ConstantEnvironment::sample_illumination(
    Vec3d, const LightNumbers& numbers, const Wavelengths& wavelengths) const {
  return LightSample{sample_uniform_sphere(numbers.u), infinity, radiance.at(wavelengths),
                     pdf_uniform_sphere()};
}

double ConstantEnvironment::pdf_illumination(Vec3d, Vec3d, const LightHit&) const {
  return pdf_uniform_sphere();
}

SampledSpectrum ConstantEnvironment::emitted(Vec3d, const LightHit&,
                                             const Wavelengths& wavelengths) const {
  return radiance.at(wavelengths);
}

double ConstantEnvironment::power(double scene_radius) const {
  return 4.0 * pi * cross_section(scene_radius) * radiance.integral();
}

Influence ConstantEnvironment::influence() const {
  return {.reach = Influence::Reach::everywhere, .strength = pi * radiance.integral()};
}

// Places on the picture are fractions of its width and height. Cells are as wide as a pixel, and
// within a cell directions are uniform in solid angle: a row spans equal steps of azimuth, and of
// cosine between its edges.
struct ImageEnvironment::Tables {
  explicit Tables(Picture picture);

  Vec2d place_of(Vec3d wi) const;
  Vec3d direction_at(double azimuth_place, double cosine) const;
  Rgb interpolated(Vec2d place) const;
  /// The integral of the interpolated picture over a pixel's cell, as if the cell were flat.
  float cell_luminance(std::size_t column, std::size_t row) const;
  double row_cosines(std::size_t row) const { return edge_cosines[row] - edge_cosines[row + 1]; }
  /// Solid-angle density over density on the picture.
  double density_scale(std::size_t row) const {
    return 1.0 / (2.0 * pi * static_cast<double>(height) * row_cosines(row));
  }
  Rgb pixel(std::ptrdiff_t column, std::ptrdiff_t row) const;

  std::size_t width, height;
  double rotation;
  std::vector<Rgb> pixels;
  std::vector<double> edge_cosines;  // of the height + 1 edges between rows, from 1 to -1
  std::optional<PiecewiseConstant2D> distribution;
  double power_per_area = 0;
};

ImageEnvironment::Tables::Tables(Picture picture)
    : width(picture.width),
      height(picture.pixels.size() / picture.width),
      rotation(picture.rotation),
      pixels(std::move(picture.pixels)) {
  for (Rgb& c : pixels) c = {non_negative(c.r), non_negative(c.g), non_negative(c.b)};
  for (std::size_t edge = 0; edge <= height; ++edge)
    edge_cosines.push_back(std::cos(pi * static_cast<double>(edge) / static_cast<double>(height)));

  std::vector<double> weights;
  weights.reserve(pixels.size());
  std::array<double, 3> sums{};  // of the pixels over the sphere
  const double cell_width = 2.0 * pi / static_cast<double>(width);
  for (std::size_t row = 0; row < height; ++row) {
    const double solid_angle = cell_width * row_cosines(row);
    for (std::size_t column = 0; column < width; ++column) {
      weights.push_back(cell_luminance(column, row) * solid_angle);
      const Rgb c = pixels[row * width + column];
      sums[0] += c.r * solid_angle;
      sums[1] += c.g * solid_angle;
      sums[2] += c.b * solid_angle;
    }
  }
  distribution.emplace(weights, width);
  power_per_area = sums[0] * Spectrum::illuminant({1, 0, 0}).integral() +
                   sums[1] * Spectrum::illuminant({0, 1, 0}).integral() +
                   sums[2] * Spectrum::illuminant({0, 0, 1}).integral();
}

// Wraps around in azimuth; the rows beyond the poles repeat the first and the last.
Rgb ImageEnvironment::Tables::pixel(std::ptrdiff_t column, std::ptrdiff_t row) const {
  const auto columns = static_cast<std::ptrdiff_t>(width),
             rows = static_cast<std::ptrdiff_t>(height);
  const std::ptrdiff_t x = (column % columns + columns) % columns;
  const std::ptrdiff_t y = std::clamp<std::ptrdiff_t>(row, 0, rows - 1);
  return pixels[static_cast<std::size_t>(y * columns + x)];
}

// A pixel's hat function lies 3/4 over its own cell and 1/8 over each neighbour, in either axis.
float ImageEnvironment::Tables::cell_luminance(std::size_t column, std::size_t row) const {
  constexpr float share[] = {0.125f, 0.75f, 0.125f};
  float sum = 0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      const Rgb c =
          pixel(static_cast<std::ptrdiff_t>(column) + x, static_cast<std::ptrdiff_t>(row) + y);
      sum += share[x + 1] * share[y + 1] * luminance(c);
    }
  }
  return sum;
}

Vec2d ImageEnvironment::Tables::place_of(Vec3d wi) const {
  const double clockwise = std::atan2(wi.x, wi.y) + rotation;  // from +y
  const double turns = 0.5 + clockwise / (2.0 * pi);
  const double polar = std::acos(std::clamp(wi.z, -1.0, 1.0));
  constexpr double below_one = 1.0 - 0x1p-53;
  return {std::min(turns - std::floor(turns), below_one), std::min(polar / pi, below_one)};
}

Vec3d ImageEnvironment::Tables::direction_at(double azimuth_place, double cosine) const {
  const double clockwise = 2.0 * pi * (azimuth_place - 0.5) - rotation;
  const double sine = std::sqrt(std::max(0.0, (1.0 - cosine) * (1.0 + cosine)));
  return {sine * std::sin(clockwise), sine * std::cos(clockwise), cosine};
}

Rgb ImageEnvironment::Tables::interpolated(Vec2d place) const {
  const double x = place.x * static_cast<double>(width) - 0.5;
  const double y = place.y * static_cast<double>(height) - 0.5;
  const auto column = static_cast<std::ptrdiff_t>(std::floor(x));
  const auto row = static_cast<std::ptrdiff_t>(std::floor(y));
  const auto s = static_cast<float>(x - std::floor(x)), t = static_cast<float>(y - std::floor(y));
  const Rgb above = pixel(column, row) * (1 - s) + pixel(column + 1, row) * s;
  const Rgb below = pixel(column, row + 1) * (1 - s) + pixel(column + 1, row + 1) * s;
  return above * (1 - t) + below * t;
}

ImageEnvironment::ImageEnvironment(Picture picture)
    : tables_(std::make_shared<const Tables>(std::move(picture))) {}

Rgb ImageEnvironment::color_towards(Vec3d wi) const {
  return tables_->interpolated(tables_->place_of(wi));
}

std::optional<LightSample> ImageEnvironment::sample_illumination(
    Vec3d, const LightNumbers& numbers, const Wavelengths& wavelengths) const {
  const Tables& tables = *tables_;
  const auto [place, density, column, row] = tables.distribution->sample(numbers.u);
  const double within_row = place.y * static_cast<double>(tables.height) - static_cast<double>(row);
  const double cosine =
      tables.edge_cosines[row] - std::clamp(within_row, 0.0, 1.0) * tables.row_cosines(row);
  const Vec3d wi = tables.direction_at(place.x, cosine);
  const Rgb color = tables.interpolated({place.x, std::acos(cosine) * inv_pi});
  return LightSample{wi, infinity, wavelengths.illuminant(color),
                     density * tables.density_scale(row)};
}

double ImageEnvironment::pdf_illumination(Vec3d, Vec3d wi, const LightHit&) const {
  const Vec2d place = tables_->place_of(wi);
  const auto row = static_cast<std::size_t>(place.y * static_cast<double>(tables_->height));
  return tables_->distribution->pdf(place) *
         tables_->density_scale(std::min(row, tables_->height - 1));
}

SampledSpectrum ImageEnvironment::emitted(Vec3d wi, const LightHit&,
                                          const Wavelengths& wavelengths) const {
  return wavelengths.illuminant(color_towards(wi));
}

double ImageEnvironment::power(double scene_radius) const {
  return cross_section(scene_radius) * tables_->power_per_area;
}

Influence ImageEnvironment::influence() const {
  // As if the picture's mean came from all around.
  return {.reach = Influence::Reach::everywhere, .strength = 0.25 * tables_->power_per_area};
}

}  // namespace lapidary::light
