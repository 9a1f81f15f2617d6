#include "bsdf/glossy_passage.h"

#include <cmath>

namespace lapidary::bsdf {
namespace {

constexpr std::size_t size = GlossyPassage::size;
using Values = std::array<double, size>;

/// The table's lobes at one roughness.
class Lobes {
 public:
  explicit Lobes(double alpha)
      : place_(table_place(roughness_coordinate(alpha), glossy_lobe_roughnesses)) {}

  /// Means over the light from each cosine.
  Values mean(const Values& v) const {
    Values means{};
    const GlossyLobe &low = glossy_lobe_table[place_.index],
                     &high = glossy_lobe_table[place_.index + 1];
    for (std::size_t i = 0; i < size; ++i) {
      double a = 0.0, b = 0.0;
      for (std::size_t k = 0; k < size; ++k) a += low[i][k] * v[k], b += high[i][k] * v[k];
      means[i] = 1e-4 * between(a, b, place_.fraction);
    }
    return means;
  }

 private:
  TablePlace place_;
};

}  // namespace

void GlossyPassage::solve(const Values& t, const Values& seen) {
  constexpr int steps = 5;
  const Lobes lobes(alpha_);
  Values factor;
  factor.fill(1.0);
  for (int step = 0; step < steps; ++step) {
    Values a;
    for (std::size_t i = 0; i < size; ++i) a[i] = factor[i] * t[i] / std::sqrt(seen[i]);
    // Half way, in logarithms, to the a that would fit these others: they change as well.
    const Values mean = lobes.mean(a);
    for (std::size_t i = 0; i < size; ++i) {
      factor[i] = std::sqrt(factor[i] * std::sqrt(seen[i]) / mean[i]);
    }
  }
  for (std::size_t i = 0; i < size; ++i) factor_[i] = static_cast<float>(factor[i]);
}

}  // namespace lapidary::bsdf
