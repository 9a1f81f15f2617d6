#include "bsdf/glossy_passage.h"

namespace lapidary::bsdf {
namespace {

constexpr std::size_t size = GlossyPassage::size;
using Values = std::array<float, size>;

GlossyLobe lobes_of(double alpha) {
  const TablePlace place = table_place(roughness_coordinate(alpha), glossy_lobe_roughnesses);
  const GlossyLobe &low = glossy_lobe_table[place.index],
                   &high = glossy_lobe_table[place.index + 1];
  const auto t = static_cast<float>(place.fraction);
  GlossyLobe lobes;
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t i = 0; i < size; ++i) {
      lobes[k][i] = low[k][i] + (high[k][i] - low[k][i]) * t;
    }
  }
  return lobes;
}

/// Over the light from each cosine.
Values means(const GlossyLobe& lobes, const Values& v) {
  Values sums{};
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t i = 0; i < size; ++i) sums[i] += lobes[k][i] * v[k];
  }
  return sums;
}

}  // namespace

void GlossyPassage::solve(const Values& t, const Values& seen) {
  constexpr int steps = 4;
  const GlossyLobe lobes = lobes_of(alpha_);
  Values root, start, factor;
  for (std::size_t i = 0; i < size; ++i) root[i] = std::sqrt(seen[i]);
  for (std::size_t i = 0; i < size; ++i) start[i] = t[i] / root[i];
  factor.fill(1.0f);
  for (int step = 0; step < steps; ++step) {
    Values a;
    for (std::size_t i = 0; i < size; ++i) a[i] = factor[i] * start[i];
    // Half way, in logarithms, to the a that would fit these others: they change as well.
    const Values mean = means(lobes, a);
    for (std::size_t i = 0; i < size; ++i) factor[i] = std::sqrt(factor[i] * root[i] / mean[i]);
  }
  factor_ = factor;
}

}  // namespace lapidary::bsdf
