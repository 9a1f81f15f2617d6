// Prints src/bsdf/fuzz_albedo_table.cpp: the directional albedo of a pile of white fibres. Run by
// hand when their distribution changes, from the root of the repository:
//
//   g++ -std=c++20 -O2 -Isrc tools/fuzz_albedo.cpp -o /tmp/fuzz_albedo && /tmp/fuzz_albedo

#include "bsdf/fuzz_albedo.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "bsdf/fibers.h"

namespace lapidary::bsdf {
namespace {

constexpr std::size_t size = fuzz_albedo_size;

double grid(std::size_t i) {
  return static_cast<double>(i) / (size - 1);
}

double tilt_of_row(std::size_t row) {
  return smallest_tilt + (1.0 - smallest_tilt) * grid(row);
}

// The inverse of cosine_coordinate.
double mu_of_column(double t, double tilt) {
  return t * tilt / (1.0 + tilt - t);
}

// The mean over visible flakes, on a Fibonacci lattice.
double albedo(double tilt, double mu) {
  constexpr int points = 832040, previous = 514229;  // Fibonacci numbers
  const Fibers fibers{tilt};
  const Vec3d wo(std::sqrt(1.0 - mu * mu), 0.0, mu);
  double sum = 0.0;
  for (std::int64_t i = 0; i < points; ++i) {
    const Vec2d u{(static_cast<double>(i) + 0.5) / points,
                  static_cast<double>(i * previous % points) / points};
    const Vec3d wi = fibers.sample(wo, u);
    if (wi.z > 0.0) sum += fibers.reflection(wo, wi) / fibers.pdf(wo, wi);
  }
  return sum / points;
}

// 2 times the integral over mu of the interpolated row times mu, by the midpoint rule over t.
double average(const std::array<float, size>& row, double tilt) {
  constexpr int points = 1000 * (size - 1);
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double low = i / static_cast<double>(points), high = (i + 1.0) / points;
    const double mu_low = mu_of_column(low, tilt), mu_high = mu_of_column(high, tilt);
    const double x = 0.5 * (low + high) * (size - 1);
    const auto column = static_cast<std::size_t>(x);
    const double value = std::lerp(row[column], row[column + 1], x - static_cast<double>(column));
    sum += value * (mu_high - mu_low) * (mu_high + mu_low);
  }
  return sum;
}

void print_row(const std::array<float, size>& row) {
  for (std::size_t i = 0; i < size; ++i)
    std::printf("%s%.6ff,", i % 8 == 0 ? "\n    " : " ", row[i]);
}

void print_table() {
  std::printf("#include \"bsdf/fuzz_albedo.h\"\n\n");
  std::printf("// Made by tools/fuzz_albedo.cpp.\n");
  std::printf("// clang-format off\nnamespace lapidary::bsdf {\n\n");
  std::printf("const FuzzAlbedoTable fuzz_albedo_table = {{");
  std::array<float, size> averages{};
  for (std::size_t r = 0; r < size; ++r) {
    std::array<float, size> row{};
    const double tilt = tilt_of_row(r);
    for (std::size_t c = 0; c < size; ++c)
      row[c] =
          static_cast<float>(albedo(tilt, std::clamp(mu_of_column(grid(c), tilt), 1e-12, 1.0)));
    averages[r] = static_cast<float>(average(row, tilt));
    std::printf("\n  {{");
    print_row(row);
    std::printf("\n  }},");
  }
  std::printf("\n}};\n\nconst std::array<float, fuzz_albedo_size> fuzz_average_albedo_table = {");
  print_row(averages);
  std::printf("\n};\n\n}  // namespace lapidary::bsdf\n// clang-format on\n");
}

}  // namespace
}  // namespace lapidary::bsdf

int main() {
  lapidary::bsdf::print_table();
}
