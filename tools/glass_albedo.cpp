// Prints src/bsdf/glass_albedo_table.cpp: the directional albedo of rough glass after a single
// bounce. Run by hand when the distribution changes, from the root of the repository:
//
//   g++ -std=c++20 -O2 -Isrc tools/glass_albedo.cpp -o /tmp/glass_albedo && /tmp/glass_albedo

#include "bsdf/glass_albedo.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "bsdf/fresnel.h"
#include "bsdf/ggx.h"

namespace lapidary::bsdf {
namespace {

constexpr std::size_t size = glass_albedo_size;

double grid(std::size_t i) {
  return static_cast<double>(i) / (size - 1);
}

// Row 0 stands for the limit alpha -> 0, where the albedo is a function of mu / alpha.
double alpha_of_row(std::size_t row) {
  return std::max(grid(row) * grid(row), 1e-5);
}

// The inverse of cosine_coordinate.
double mu_of_column(double t, double alpha) {
  return t * alpha / (1.0 + alpha - t);
}

// The inverse of index_coordinate.
double eta_of_index(std::size_t i) {
  const double s = 2.0 * static_cast<double>(i) / (glass_albedo_indices - 1) - 1.0;
  const double r = 0.5 * s * std::abs(s);
  return (1.0 + r) / (1.0 - r);
}

// What leaves from one facet, as in src/bsdf/rough_dielectric.cpp.
double leaving(const Ggx& ggx, Vec3d wo, Vec3d h, double eta) {
  const double cos_o = std::min(dot(wo, h), 1.0);
  const Refraction at_facet = refract(cos_o, eta);
  double sum = 0.0;
  const Vec3d reflected = 2.0 * cos_o * h - wo;
  if (reflected.z > 0.0)
    sum +=
        at_facet.reflectance * 2.0 * (wo.z + ggx.slant(wo)) * ggx.reflection_share(wo, reflected);
  const Vec3d refracted = (cos_o / eta - at_facet.cos_refracted) * h - wo * (1.0 / eta);
  if (refracted.z < 0.0)
    sum +=
        (1.0 - at_facet.reflectance) * ggx.visible_share({refracted.x, refracted.y, -refracted.z});
  return sum;
}

// Over visible normals, on a Fibonacci lattice.
double albedo(double alpha, double mu, double eta) {
  constexpr int points = 75025, previous = 46368;
  const Ggx ggx{alpha};
  const Vec3d wo(std::sqrt(1.0 - mu * mu), 0.0, mu);
  double sum = 0.0;
  for (std::int64_t i = 0; i < points; ++i) {
    const Vec2d u{(static_cast<double>(i) + 0.5) / points,
                  static_cast<double>(i * previous % points) / points};
    sum += leaving(ggx, wo, ggx.sample_visible(wo, u), eta);
  }
  return sum / points;
}

// 2 times the integral over mu of the interpolated row times mu, by the midpoint rule over t.
double average(const GlassAlbedoRow& row, double alpha) {
  constexpr int points = 1000 * (size - 1);
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double low = i / static_cast<double>(points), high = (i + 1.0) / points;
    const double mu_low = mu_of_column(low, alpha), mu_high = mu_of_column(high, alpha);
    const double x = 0.5 * (low + high) * (size - 1);
    const auto column = static_cast<std::size_t>(x);
    const double value = std::lerp(row[column], row[column + 1], x - static_cast<double>(column));
    sum += value * (mu_high - mu_low) * (mu_high + mu_low);
  }
  return sum;
}

void print_row(const GlassAlbedoRow& row) {
  std::printf("{{");
  for (std::size_t i = 0; i < size; ++i)
    std::printf("%s%.5ff%s", i == 8 ? "\n      " : "", row[i], i + 1 < size ? ", " : "}},\n");
}

void print_tables() {
  std::printf("#include \"bsdf/glass_albedo.h\"\n\n// Made by tools/glass_albedo.cpp.\n");
  std::printf("// clang-format off\nnamespace lapidary::bsdf {\n\n");
  std::printf("const std::array<std::array<GlassAlbedoRow, glass_albedo_size>, ");
  std::printf("glass_albedo_indices>\n    glass_albedo_table = {{\n");
  std::array<GlassAlbedoRow, glass_albedo_indices> averages{};
  for (std::size_t i = 0; i < glass_albedo_indices; ++i) {
    std::printf("  {{  // eta = %.4f\n", eta_of_index(i));
    for (std::size_t r = 0; r < size; ++r) {
      const double alpha = alpha_of_row(r);
      GlassAlbedoRow row{};
      for (std::size_t c = 0; c < size; ++c) {
        const double mu = std::clamp(mu_of_column(grid(c), alpha), 1e-12, 1.0);
        row[c] = static_cast<float>(albedo(alpha, mu, eta_of_index(i)));
      }
      averages[i][r] = static_cast<float>(average(row, alpha));
      std::printf("    ");
      print_row(row);
    }
    std::printf("  }},\n");
  }
  std::printf("}};\n\nconst std::array<GlassAlbedoRow, glass_albedo_indices> ");
  std::printf("glass_average_albedo_table = {{\n");
  for (const GlassAlbedoRow& row : averages) {
    std::printf("    ");
    print_row(row);
  }
  std::printf("}};\n\n}  // namespace lapidary::bsdf\n// clang-format on\n");
}

}  // namespace
}  // namespace lapidary::bsdf

int main() {
  lapidary::bsdf::print_tables();
}
