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

// Gold, silver, copper: Johnson & Christy 1972, Physical Review B 6, 4370-4379.
// Aluminium: Rakic 1995, Applied Optics 34, 4755-4767.
// All as collected by refractiveindex.info (public domain, CC0).
// clang-format off
constexpr Sample gold[] = {
    {354.2, 1.5, 1.866}, {367.9, 1.48, 1.895}, {381.5, 1.46, 1.933}, {397.4, 1.47, 1.952},
    {413.3, 1.46, 1.958}, {430.5, 1.45, 1.948}, {450.9, 1.38, 1.914}, {471.4, 1.31, 1.849},
    {495.9, 1.04, 1.833}, {520.9, 0.62, 2.081}, {548.6, 0.43, 2.455}, {582.1, 0.29, 2.863},
    {616.8, 0.21, 3.272}, {659.5, 0.14, 3.697}, {704.5, 0.13, 4.103}, {756.0, 0.14, 4.542},
    {821.1, 0.16, 5.083}, {892.0, 0.17, 5.663},
};

constexpr Sample silver[] = {
    {354.2, 0.1, 1.419}, {367.9, 0.07, 1.657}, {381.5, 0.05, 1.864}, {397.4, 0.05, 2.07},
    {413.3, 0.05, 2.275}, {430.5, 0.04, 2.462}, {450.9, 0.04, 2.657}, {471.4, 0.05, 2.869},
    {495.9, 0.05, 3.093}, {520.9, 0.05, 3.324}, {548.6, 0.06, 3.586}, {582.1, 0.05, 3.858},
    {616.8, 0.06, 4.152}, {659.5, 0.05, 4.483}, {704.5, 0.04, 4.838}, {756.0, 0.03, 5.242},
    {821.1, 0.04, 5.727}, {892.0, 0.04, 6.312},
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
