#include "spectrum/wavelength_density.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "spectrum/wavelengths.h"

namespace lapidary {
namespace {

using Table = std::array<double, cie_samples>;

/// Convolves with a Gaussian of `variance` nm^2 by repeated binomial filters (each adds 1/2),
/// with the ends mirrored.
void smooth(Table& table, int variance) {
  for (int step = 0; step < 2 * variance; ++step) {
    double before = table.front();
    for (std::size_t i = 0; i < cie_samples; ++i) {
      const double here = table[i];
      const double after = table[std::min(i + 1, cie_samples - 1)];
      table[i] = 0.25 * before + 0.5 * here + 0.25 * after;
      before = here;
    }
  }
}

}  // namespace

WavelengthDensity::WavelengthDensity() {
  // Found by trial on the spectra of Wavelengths::sample: the errors are flat around here.
  constexpr int variance = 100;
  constexpr double floor = 0.03;
  for (std::size_t i = 0; i < cie_samples; ++i) {
    const auto& [x, y, z] = cie_1931_observer[i];
    pdf_[i] = std::sqrt(x + y + z);
  }
  smooth(pdf_, variance);
  const double lift = floor * *std::max_element(pdf_.begin(), pdf_.end());
  for (double& p : pdf_) p += lift;
  for (std::size_t i = 1; i < cie_samples; ++i) {
    cdf_[i] = cdf_[i - 1] + 0.5 * (pdf_[i - 1] + pdf_[i]);
  }
  const double total = cdf_.back();
  for (double& p : pdf_) p /= total;
  for (double& c : cdf_) c /= total;
}

double WavelengthDensity::pdf(double nm) const {
  if (!(nm >= lambda_min && nm <= lambda_max)) return 0.0;
  const auto i = std::min(static_cast<std::size_t>(nm - lambda_min), cie_samples - 2);
  const double fraction = nm - lambda_min - static_cast<double>(i);
  return pdf_[i] * (1.0 - fraction) + pdf_[i + 1] * fraction;
}

double WavelengthDensity::cdf(double nm) const {
  const double x = std::clamp(nm - lambda_min, 0.0, lambda_max - lambda_min);
  const auto i = std::min(static_cast<std::size_t>(x), cie_samples - 2);
  const double fraction = x - static_cast<double>(i);
  return cdf_[i] + fraction * (pdf_[i] + 0.5 * fraction * (pdf_[i + 1] - pdf_[i]));
}

double WavelengthDensity::sample(double u) const {
  const auto above = std::upper_bound(cdf_.begin() + 1, cdf_.end() - 1, u);
  const auto i = static_cast<std::size_t>(above - cdf_.begin()) - 1;
  // Area under a straight line: a x + b x^2 = area, by the form of the root that never cancels.
  const double area = std::max(u - cdf_[i], 0.0);
  const double a = pdf_[i], b = 0.5 * (pdf_[i + 1] - pdf_[i]);
  const double fraction = 2.0 * area / (a + std::sqrt(std::max(a * a + 4.0 * b * area, 0.0)));
  return lambda_min + static_cast<double>(i) + std::min(fraction, 1.0);
}

}  // namespace lapidary
