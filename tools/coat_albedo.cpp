// Prints src/bsdf/coat_albedo_table.cpp: what rough dielectric facets reflect, over what a smooth
// surface would. Run by hand when the distribution changes, from the root of the repository:
//
//   g++ -std=c++20 -O2 -Isrc tools/coat_albedo.cpp -o /tmp/coat_albedo && /tmp/coat_albedo

#include "bsdf/coat_albedo.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "bsdf/fresnel.h"
#include "bsdf/ggx.h"

namespace lapidary::bsdf {
namespace {

constexpr std::size_t size = coat_albedo_size;

double grid(std::size_t i) {
  return static_cast<double>(i) / (size - 1);
}

// Row 0 stands for the limit alpha -> 0, where the ratio is a function of mu / alpha.
double alpha_of_row(std::size_t row) {
  return std::max(grid(row) * grid(row), 1e-5);
}

// The inverse of cosine_coordinate.
double mu_of_column(double t, double alpha) {
  return std::clamp(t * alpha / (1.0 + alpha - t), 1e-12, 1.0);
}

// The inverse of coat_index_coordinate; index 1 stands for the limit of a vanishing step.
double eta_of_index(std::size_t i) {
  const double s = static_cast<double>(i) / (coat_albedo_indices - 1);
  const double r = std::max(0.5 * s * s, 5e-4);
  return (1.0 + r) / (1.0 - r);
}

// The mean over visible normals, on a Fibonacci lattice.
double albedo(double alpha, double mu, double eta) {
  constexpr int points = 196418, previous = 121393;
  const Ggx ggx{alpha};
  const Vec3d wo(std::sqrt(1.0 - mu * mu), 0.0, mu);
  double sum = 0.0;
  for (std::int64_t i = 0; i < points; ++i) {
    const Vec2d u{(static_cast<double>(i) + 0.5) / points,
                  static_cast<double>(i * previous % points) / points};
    const Vec3d h = ggx.sample_visible(wo, u);
    const double cos_o = std::min(dot(wo, h), 1.0);
    const Vec3d wi = 2.0 * cos_o * h - wo;
    if (wi.z <= 0.0) continue;
    sum +=
        refract(cos_o, eta).reflectance * 2.0 * (mu + ggx.slant(wo)) * ggx.reflection_share(wo, wi);
  }
  return sum / points;
}

void print_row(const CoatAlbedoRow& row) {
  std::printf("{{");
  for (std::size_t i = 0; i < size; ++i)
    std::printf("%s%.5ff%s", i == 8 ? "\n      " : "", row[i], i + 1 < size ? ", " : "}},\n");
}

// 2 times the integral over mu of E mu, E being the interpolated ratio times Fresnel's formula, by
// the midpoint rule over the square root of mu: both change fastest at grazing angles.
double average(const CoatAlbedoRow& row, double alpha, double eta) {
  constexpr int points = 100000;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double root = (i + 0.5) / points, mu = root * root;
    const TablePlace place = table_place(cosine_coordinate(mu, alpha), size);
    const double ratio = between(row[place.index], row[place.index + 1], place.fraction);
    sum += ratio * refract(mu, eta).reflectance * 4.0 * mu * root;
  }
  return sum / points;
}

void print_tables() {
  std::printf("#include \"bsdf/coat_albedo.h\"\n\n// Made by tools/coat_albedo.cpp.\n");
  std::printf("// clang-format off\nnamespace lapidary::bsdf {\n\n");
  std::printf("const std::array<std::array<CoatAlbedoRow, coat_albedo_size>, ");
  std::printf("coat_albedo_indices>\n    coat_albedo_table = {{\n");
  std::array<CoatAlbedoRow, coat_albedo_indices> averages{};
  for (std::size_t i = 0; i < coat_albedo_indices; ++i) {
    const double eta = eta_of_index(i);
    std::printf("  {{  // eta = %.4f\n", eta);
    for (std::size_t r = 0; r < size; ++r) {
      const double alpha = alpha_of_row(r);
      CoatAlbedoRow row{};
      for (std::size_t c = 0; c < size; ++c) {
        const double mu = mu_of_column(grid(c), alpha);
        row[c] = static_cast<float>(albedo(alpha, mu, eta) / refract(mu, eta).reflectance);
      }
      averages[i][r] = static_cast<float>(average(row, alpha, eta));
      std::printf("    ");
      print_row(row);
    }
    std::printf("  }},\n");
  }
  std::printf("}};\n\nconst std::array<CoatAlbedoRow, coat_albedo_indices> ");
  std::printf("coat_average_albedo_table = {{\n");
  for (const CoatAlbedoRow& row : averages) {
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
