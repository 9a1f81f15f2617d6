#include "spectrum/spectrum.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "spectrum/cie_functions.h"

namespace lapidary {
namespace {

double reflectance_at(Rgb rgb, double nm) {
  const auto basis = rgb_basis_at(nm);
  return rgb.r * basis[0] + rgb.g * basis[1] + rgb.b * basis[2];
}

/// Planck's law, relative to its value at 830 nm.
double planck(double kelvin, double nm) {
  // h c / k in nm K, from the exact constants of the SI of 2019 (CODATA 2018).
  constexpr double second_radiation_constant = 6.62607015e-34 * 299792458.0 / 1.380649e-23 * 1e9;
  const double scale = second_radiation_constant / kelvin;
  const double x = scale / nm, x_end = scale / lambda_max;
  // exp(-x) / (1 - exp(-x)) is 1 / (exp(x) - 1) that cannot overflow; taken relative to the red
  // end, it does not vanish everywhere when the body is cold.
  const double ratio = std::exp(x_end - x) * std::expm1(-x_end) / std::expm1(-x);
  return std::pow(lambda_max / nm, 5) * ratio;
}

/// The integral over 360-830 nm.
double quadrature(const Spectrum& spectrum) {
  const std::vector<double> nm = spectrum.knots();
  double sum = 0.0;
  for (std::size_t i = 1; i < nm.size(); ++i) {
    sum += simpson([&](double x) { return spectrum.at(x); }, nm[i - 1], nm[i]);
  }
  return sum;
}

}  // namespace

double SpectrumTable::at(double nm) const {
  const std::size_t last = values.size() - 1;
  const double x = std::clamp((nm - first_nm) / step_nm, 0.0, static_cast<double>(last));
  const auto i = static_cast<std::size_t>(x);
  const double fraction = x - static_cast<double>(i);
  return values[i] * (1.0 - fraction) + values[std::min(i + 1, last)] * fraction;
}

bool is_valid(const SpectrumTable& table) {
  return !table.values.empty() && std::isfinite(table.first_nm) && table.step_nm > 0.0 &&
         std::isfinite(table.step_nm) &&
         std::all_of(table.values.begin(), table.values.end(),
                     [](float value) { return std::isfinite(value); });
}

Spectrum Spectrum::constant(float value) {
  return Spectrum(Constant{value});
}

Spectrum Spectrum::reflectance(Rgb rgb) {
  return Spectrum(Reflectance{rgb});
}

Spectrum Spectrum::illuminant(Rgb rgb) {
  return Spectrum(Illuminant{rgb});
}

Spectrum Spectrum::blackbody(double kelvin) {
  assert(kelvin >= 1.0 && std::isfinite(kelvin));
  constexpr std::size_t samples = 471;
  SpectrumTable shape{lambda_min, 1.0, std::vector<float>(samples)};
  std::vector<double> radiance(samples);
  double total = 0.0;
  for (std::size_t i = 0; i < samples; ++i) {
    radiance[i] = planck(kelvin, lambda_min + static_cast<double>(i));
    total += i == 0 || i + 1 == samples ? 0.5 * radiance[i] : radiance[i];
  }
  for (std::size_t i = 0; i < samples; ++i) {
    shape.values[i] = static_cast<float>(radiance[i] / total);
  }
  return table(std::move(shape));
}

Spectrum Spectrum::table(SpectrumTable table) {
  assert(is_valid(table));
  return Spectrum(Tabulated{std::make_shared<const SpectrumTable>(std::move(table)), 1.0f});
}

SampledSpectrum Spectrum::tabulated_at(const Wavelengths& wavelengths) const {
  const Tabulated& tabulated = std::get<Tabulated>(form_);
  SampledSpectrum values;
  for (std::size_t i = 0; i < SampledSpectrum::size; ++i) {
    values.set(i, static_cast<float>(tabulated.table->at(wavelengths.lambda(i))));
  }
  return tabulated.scale * values;
}

double Spectrum::at(double nm) const {
  if (const auto* reflectance = std::get_if<Reflectance>(&form_)) {
    return reflectance_at(reflectance->rgb, nm);
  }
  if (const auto* illuminant = std::get_if<Illuminant>(&form_)) {
    return reflectance_at(illuminant->rgb, nm) * d65_at(nm);
  }
  if (const auto* constant = std::get_if<Constant>(&form_)) return constant->value;
  const Tabulated& tabulated = std::get<Tabulated>(form_);
  return tabulated.scale * tabulated.table->at(nm);
}

Spectrum Spectrum::scaled(float factor) const {
  Form form = form_;
  if (auto* constant = std::get_if<Constant>(&form)) constant->value *= factor;
  if (auto* reflectance = std::get_if<Reflectance>(&form)) reflectance->rgb *= factor;
  if (auto* illuminant = std::get_if<Illuminant>(&form)) illuminant->rgb *= factor;
  if (auto* tabulated = std::get_if<Tabulated>(&form)) tabulated->scale *= factor;
  return Spectrum(std::move(form));
}

double Spectrum::integral() const {
  // Illuminants are sums of three, and scenes hold very many of them.
  if (const auto* illuminant = std::get_if<Illuminant>(&form_)) {
    const auto primary = [](Rgb rgb) { return quadrature(Spectrum::illuminant(rgb)); };
    static const std::array<double, 3> of_primaries{primary({1, 0, 0}), primary({0, 1, 0}),
                                                    primary({0, 0, 1})};
    const auto [r, g, b] = illuminant->rgb;
    return r * of_primaries[0] + g * of_primaries[1] + b * of_primaries[2];
  }
  return quadrature(*this);
}

std::vector<double> Spectrum::knots() const {
  std::vector<double> nm;
  for (double whole = lambda_min; whole <= lambda_max; whole += 1.0) nm.push_back(whole);
  if (const auto* tabulated = std::get_if<Tabulated>(&form_)) {
    const SpectrumTable& table = *tabulated->table;
    for (std::size_t i = 0; i < table.values.size(); ++i) {
      const double node = table.first_nm + table.step_nm * static_cast<double>(i);
      if (node > lambda_min && node < lambda_max) nm.push_back(node);
    }
    std::sort(nm.begin(), nm.end());
  }
  return nm;
}

}  // namespace lapidary
