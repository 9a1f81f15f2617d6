// Prints src/bsdf/ggx_grain_table.cpp, coat_grain_table.cpp or glass_grain_table.cpp: the
// directional albedo after a single bounce of facets that are rougher along one direction. Run by
// hand when the distribution changes, from the root of the repository:
//
//   g++ -std=c++20 -O2 -march=x86-64-v3 -Isrc tools/grain_albedo.cpp -o /tmp/grain_albedo
//   for kind in ggx coat glass; do /tmp/grain_albedo $kind > src/bsdf/${kind}_grain_table.cpp; done

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "bsdf/coat_albedo.h"
#include "bsdf/ggx_albedo.h"
#include "bsdf/glass_albedo.h"

namespace lapidary::bsdf {
namespace {

enum class Kind { metal, coat, glass };

struct Size {
  std::size_t roughnesses, anisotropies, azimuths, cosines;
};

double grid(std::size_t i, std::size_t size) {
  return static_cast<double>(i) / static_cast<double>(size - 1);
}

// Row 0 stands for the limit alpha -> 0, where the albedo is a function of mu / alpha.
Grain grain_of(const Size& size, std::size_t row, std::size_t column) {
  const double roughness = std::max(grid(row, size.roughnesses), 3e-3);
  // The inverse of GrainCoordinates::anisotropy_coordinate.
  const double left = 1.0 - grid(column, size.anisotropies);
  return {roughness * roughness, (1.0 - Grain::least_ratio) * (1.0 - left * left)};
}

// The inverse of the coordinates of a direction.
Vec3d direction_of(const Grain& grain, double azimuth, double t) {
  const double c = azimuth == 1.0 ? 0.0 : std::cos(0.5 * pi * azimuth);
  const double s = std::sin(0.5 * pi * azimuth);
  const double mu = std::clamp(t * grain.alpha / (1.0 + grain.alpha - t), 1e-12, 1.0);
  const double sine = std::sqrt(1.0 - mu * mu);
  return {c * sine, s * sine, mu};
}

// What leaves from one facet, as in src/bsdf/rough_dielectric.cpp.
double leaving(const Ggx& ggx, Vec3d wo, Vec3d h, Kind kind, double eta) {
  const double cos_o = std::min(dot(wo, h), 1.0);
  const Refraction facet = kind == Kind::metal ? Refraction{} : refract(cos_o, eta);
  double sum = 0.0;
  const Vec3d reflected = 2.0 * cos_o * h - wo;
  if (reflected.z > 0.0)
    sum += facet.reflectance * 2.0 * (wo.z + ggx.slant(wo)) * ggx.reflection_share(wo, reflected);
  if (kind != Kind::glass) return sum;
  const Vec3d refracted = (cos_o / eta - facet.cos_refracted) * h - wo * (1.0 / eta);
  if (refracted.z < 0.0)
    sum += (1.0 - facet.reflectance) * ggx.visible_share({refracted.x, refracted.y, -refracted.z});
  return sum;
}

// The mean over visible normals, on a Fibonacci lattice.
double albedo(const Grain& grain, Vec3d wo, Kind kind, double eta) {
  const std::int64_t points = kind == Kind::metal ? 196418 : 17711;
  const std::int64_t previous = kind == Kind::metal ? 121393 : 10946;
  const Ggx ggx(grain);
  double sum = 0.0;
  for (std::int64_t i = 0; i < points; ++i) {
    const Vec2d u{(static_cast<double>(i) + 0.5) / static_cast<double>(points),
                  static_cast<double>(i * previous % points) / static_cast<double>(points)};
    sum += leaving(ggx, wo, ggx.sample_visible(wo, u), kind, eta);
  }
  return sum / static_cast<double>(points);
}

double smooth(Kind kind, double mu, double eta) {
  return kind == Kind::coat ? refract(mu, eta).reflectance : 1.0;
}

// The index of the coat, or of the glass, of one part of its table.
double eta_of(Kind kind, std::size_t i) {
  if (kind == Kind::metal) return 1.0;
  const double s = grid(i, kind == Kind::coat ? coat_grain_indices : glass_albedo_indices);
  // The inverses of coat_index_coordinate and index_coordinate.
  const double t = 2.0 * s - 1.0;
  const double r = kind == Kind::coat ? std::max(0.5 * s * s, 5e-4) : 0.5 * t * std::abs(t);
  return (1.0 + r) / (1.0 - r);
}

unsigned in_units(double value) {
  return static_cast<unsigned>(std::lround(value / grain_unit));
}

using Directions = std::vector<std::vector<double>>;  // by azimuth and cosine

// 1/pi times the integral over the half sphere of the interpolated table, by the midpoint rule over
// azimuths and the square root of mu, around which albedos change fastest.
double average(const Directions& table, const Grain& grain, Kind kind, double eta) {
  constexpr int azimuths = 180, cosines = 4000;
  double sum = 0.0;
  for (int a = 0; a < azimuths; ++a) {
    const TablePlace row = table_place((a + 0.5) / azimuths, table.size());
    for (int i = 0; i < cosines; ++i) {
      const double root = (i + 0.5) / cosines, mu = root * root;
      const double at[] = {cosine_coordinate(mu, grain.alpha)};
      const double value = between(interpolated(table[row.index], at),
                                   interpolated(table[row.index + 1], at), row.fraction);
      sum += std::min(value * smooth(kind, mu, eta), 1.0) * 4.0 * mu * root / cosines;
    }
  }
  return sum / azimuths;
}

Directions directions(const Size& size, const Grain& grain, Kind kind, double eta) {
  Directions table(size.azimuths, std::vector<double>(size.cosines));
  for (std::size_t a = 0; a < size.azimuths; ++a) {
    for (std::size_t m = 0; m < size.cosines; ++m) {
      const Vec3d wo = direction_of(grain, grid(a, size.azimuths), grid(m, size.cosines));
      table[a][m] = albedo(grain, wo, kind, eta) / smooth(kind, wo.z, eta);
    }
  }
  return table;
}

// One table with the averages that go with it: to be printed after all tables.
std::string print_table(const Size& size, Kind kind, double eta) {
  std::string averages = "{{";
  std::printf("{{");
  for (std::size_t r = 0; r < size.roughnesses; ++r) {
    std::printf("\n{{");
    averages += "{{";
    for (std::size_t s = 0; s < size.anisotropies; ++s) {
      const Grain grain = grain_of(size, r, s);
      const Directions table = directions(size, grain, kind, eta);
      std::printf("\n{{");
      for (const std::vector<double>& row : table) {
        std::printf("\n{{");
        for (const double value : row) std::printf("%u, ", in_units(value));
        std::printf("}},");
      }
      std::printf("}},");
      averages += std::to_string(in_units(average(table, grain, kind, eta))) + ", ";
    }
    std::printf("}},");
    averages += "}},\n";
  }
  std::printf("}}");
  return averages + "}}";
}

void print(const std::string& name, const Size& size, Kind kind, std::size_t indices) {
  const std::string parts = std::to_string(indices);
  const std::string counts =
      std::to_string(size.roughnesses) + ", " + std::to_string(size.anisotropies);
  const std::string table_type = "GrainTable<" + counts + ", " + std::to_string(size.azimuths) +
                                 ", " + std::to_string(size.cosines) + ">";
  const std::string averages_type = "GrainAverages<" + counts + ">";
  const auto type = [&](const std::string& of) {
    return indices == 0 ? of : "std::array<" + of + ", " + parts + ">";
  };
  std::printf("#include \"bsdf/%s_albedo.h\"\n\n// Made by tools/grain_albedo.cpp.\n",
              name.c_str());
  std::printf("// clang-format off\nnamespace lapidary::bsdf {\n\n");
  std::printf("const %s %s_grain_table = ", type(table_type).c_str(), name.c_str());
  std::string averages;
  if (indices == 0) averages = print_table(size, kind, 1.0);
  if (indices > 0) std::printf("{{\n");
  for (std::size_t i = 0; i < indices; ++i) {
    averages += print_table(size, kind, eta_of(kind, i)) + ",\n";
    std::printf(",\n");
  }
  std::printf(indices > 0 ? "}};\n\n" : ";\n\n");
  std::printf("const %s %s_average_grain_table =\n    ", type(averages_type).c_str(), name.c_str());
  std::printf(indices > 0 ? "{{%s}};\n\n" : "%s;\n\n", averages.c_str());
  std::printf("}  // namespace lapidary::bsdf\n// clang-format on\n");
}

}  // namespace
}  // namespace lapidary::bsdf

int main(int argc, char** argv) {
  using namespace lapidary::bsdf;
  const std::string kind = argc > 1 ? argv[1] : "";
  if (kind == "ggx") {
    print("ggx", {12, 8, 8, 12}, Kind::metal, 0);
  } else if (kind == "coat") {
    print("coat", {8, 6, 6, 10}, Kind::coat, coat_grain_indices);
  } else if (kind == "glass") {
    print("glass", {8, 6, 6, 10}, Kind::glass, glass_albedo_indices);
  } else {
    std::fprintf(stderr, "usage: grain_albedo ggx|coat|glass\n");
    return 2;
  }
}
