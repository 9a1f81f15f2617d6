#include <algorithm>
#include <array>
#include <iterator>
#include <span>

#include "spectrum/catalogue_name.h"
#include "spectrum/refractive_index.h"

namespace lapidary {
namespace {

/// Complex refractive index n + i k at one wavelength.
struct Sample {
  double nm, n, k;
};

// Gold, silver: Babar & Weaver 2015, Applied Optics 54, 477-481. The gold films of Johnson &
// Christy have more blue and less green than what is published as the colour of gold. Copper:
// Johnson & Christy 1972, Physical Review B 6, 4370-4379. Aluminium: Rakic 1995, Applied Optics 34,
// 4755-4767. All as collected by refractiveindex.info (public domain, CC0).
// clang-format off
constexpr Sample gold[] = {
    {354.2, 1.61, 1.755}, {364.7, 1.59, 1.78}, {375.7, 1.576, 1.801}, {387.5, 1.568, 1.824},
    {399.9, 1.569, 1.839}, {413.3, 1.559, 1.825}, {427.5, 1.53, 1.811}, {442.8, 1.486, 1.797},
    {459.2, 1.457, 1.736}, {476.9, 1.266, 1.56}, {495.9, 0.8564, 1.629}, {516.6, 0.502, 1.853},
    {539.1, 0.329, 2.249}, {563.6, 0.2452, 2.569}, {590.4, 0.1823, 2.88}, {619.9, 0.1357, 3.204},
    {652.5, 0.1091, 3.529}, {688.8, 0.08524, 3.871}, {729.3, 0.07661, 4.242},
    {774.9, 0.07883, 4.63}, {826.6, 0.08019, 5.05}, {885.6, 0.087, 5.517},
};

constexpr Sample silver[] = {
    {354.2, 0.106, 1.467}, {364.7, 0.076, 1.645}, {375.7, 0.061, 1.815}, {387.5, 0.05, 1.981},
    {399.9, 0.054, 2.138}, {413.3, 0.05, 2.292}, {427.5, 0.051, 2.448}, {442.8, 0.052, 2.604},
    {459.2, 0.052, 2.765}, {476.9, 0.053, 2.93}, {495.9, 0.052, 3.105}, {516.6, 0.052, 3.288},
    {539.1, 0.05168, 3.483}, {563.6, 0.05009, 3.694}, {590.4, 0.04977, 3.918},
    {619.9, 0.04803, 4.164}, {652.5, 0.04964, 4.432}, {688.8, 0.0508, 4.725},
    {729.3, 0.05151, 5.048}, {774.9, 0.05269, 5.409}, {826.6, 0.05504, 5.814},
    {885.6, 0.05896, 6.276},
};

constexpr Sample copper[] = {
    {354.2, 1.37, 1.916}, {367.9, 1.36, 1.975}, {381.5, 1.33, 2.045}, {397.4, 1.32, 2.116},
    {413.3, 1.28, 2.207}, {430.5, 1.25, 2.305}, {450.9, 1.24, 2.397}, {471.4, 1.25, 2.483},
    {495.9, 1.22, 2.564}, {520.9, 1.18, 2.608}, {548.6, 1.02, 2.577}, {582.1, 0.7, 2.704},
    {616.8, 0.3, 3.205}, {659.5, 0.22, 3.747}, {704.5, 0.21, 4.205}, {756.0, 0.24, 4.665},
    {821.1, 0.26, 5.18}, {892.0, 0.3, 5.768},
};

constexpr Sample aluminium[] = {
    {326.28, 0.31474, 3.9165}, {364.66, 0.39877, 4.3957}, {413.28, 0.52135, 5.0008},
    {442.8, 0.6079, 5.3676}, {476.87, 0.7278, 5.7781}, {516.6, 0.8734, 6.2418},
    {563.57, 1.0728, 6.7839}, {619.93, 1.366, 7.4052}, {652.25, 1.5724, 7.7354},
    {688.81, 1.8301, 8.0601}, {729.32, 2.1606, 8.3565}, {774.91, 2.6154, 8.4914},
    {794.78, 2.7675, 8.3866}, {815.69, 2.7668, 8.2573}, {837.74, 2.6945, 8.1878},
};
// clang-format on

/// Linear in wavelength between the samples, onto a uniform grid that tables can be read from fast.
ConductorIndex resample(std::span<const Sample> samples) {
  constexpr double step = 5.0;
  SpectrumTable n{lambda_min, step, {}}, k{lambda_min, step, {}};
  for (double nm = lambda_min; nm <= lambda_max; nm += step) {
    const auto b = std::find_if(std::next(samples.begin()), std::prev(samples.end()),
                                [nm](const Sample& sample) { return sample.nm >= nm; });
    const auto a = std::prev(b);
    const double fraction = (nm - a->nm) / (b->nm - a->nm);
    n.values.push_back(static_cast<float>(a->n + fraction * (b->n - a->n)));
    k.values.push_back(static_cast<float>(a->k + fraction * (b->k - a->k)));
  }
  return {Spectrum::table(std::move(n)), Spectrum::table(std::move(k))};
}

struct Metal {
  std::array<std::string_view, 3> keys;  ///< the first is the name; some are empty
  std::span<const Sample> samples;
};

constexpr Metal metals[] = {
    {{"gold", "au", ""}, gold},
    {{"silver", "ag", ""}, silver},
    {{"copper", "cu", ""}, copper},
    {{"aluminium", "aluminum", "al"}, aluminium},
};

}  // namespace

std::optional<ConductorIndex> find_metal(std::string_view name) {
  const std::string key = catalogue_key(name);
  if (key.empty()) return std::nullopt;
  for (const Metal& metal : metals) {
    if (std::find(metal.keys.begin(), metal.keys.end(), key) != metal.keys.end()) {
      return resample(metal.samples);
    }
  }
  return std::nullopt;
}

std::vector<std::string> metal_names() {
  std::vector<std::string> names;
  for (const Metal& metal : metals) names.emplace_back(metal.keys.front());
  return names;
}

}  // namespace lapidary
