// Prints src/bsdf/glossy_lobe_table.cpp: at which cosines light leaves white metal. Run by hand
// when the distribution of facets changes, from the root of the repository:
//
//   g++ -std=c++20 -O2 -Isrc tools/glossy_lobe.cpp src/bsdf/{conductor,fresnel,ggx_*}.cpp
//   ./a.out

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bsdf/conductor.h"
#include "bsdf/glossy_passage.h"

namespace lapidary::bsdf {
namespace {

constexpr std::size_t size = GlossyPassage::size;

// Weights of the two cosines around each direction, of all light that leaves.
std::array<double, size> lobe(double alpha, double mu) {
  const Conductor metal(ConductorFresnel::from_normal_incidence(SampledSpectrum(1.0f)), alpha);
  const auto coordinate = [](int i, double step) { return std::fmod(0.5 + i * step, 1.0); };
  const Vec3d wo(std::sqrt(1.0 - mu * mu), 0.0, mu);
  std::array<double, size> weights{};
  double sum = 0.0;
  for (int i = 0; i < 400000; ++i) {
    const Vec2d u{coordinate(i, 0.8191725133961645), coordinate(i, 0.6710436067037893)};
    const auto s = metal.sample(wo, coordinate(i, 0.5497004779019703), u);
    if (!s) continue;
    const TablePlace place =
        table_place(cosine_coordinate(s->wi.z, GlossyPassage::scale(alpha)), size);
    weights[place.index] += s->weight[0] * (1.0 - place.fraction);
    weights[place.index + 1] += s->weight[0] * place.fraction;
    sum += s->weight[0];
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

void print() {
  std::printf("#include \"bsdf/glossy_passage.h\"\n\n// Made by tools/glossy_lobe.cpp.\n");
  std::printf("// clang-format off\nnamespace lapidary::bsdf {\n\n");
  std::printf("const std::array<GlossyLobe, glossy_lobe_roughnesses> glossy_lobe_table = {{\n");
  for (std::size_t r = 0; r < glossy_lobe_roughnesses; ++r) {
    const double root = static_cast<double>(r) / (glossy_lobe_roughnesses - 1);
    const double alpha = std::max(root * root, 1e-4);
    std::printf("  {{  // alpha = %.5f\n", alpha);
    std::array<std::array<double, size>, size> from;
    for (std::size_t i = 0; i < size; ++i)
      from[i] = lobe(alpha, std::clamp(GlossyPassage::cosine(i, alpha), 1e-6, 1.0));
    for (std::size_t k = 0; k < size; ++k) {
      std::printf("    {{");
      for (std::size_t i = 0; i < size; ++i)
        std::printf("%.6ff%s", from[i][k], i + 1 < size ? ", " : "}},\n");
    }
    std::printf("  }},\n");
  }
  std::printf("}};\n\n}  // namespace lapidary::bsdf\n// clang-format on\n");
}

}  // namespace
}  // namespace lapidary::bsdf

int main() {
  lapidary::bsdf::print();
}
