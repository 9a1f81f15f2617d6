#include "spectrum/refractive_index.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lapidary {
namespace {

double sellmeier_index(const RefractiveIndex::Sellmeier& s, double nm) {
  const double square = nm * nm * 1e-6;
  double n_squared = 1.0 + s.constant;
  for (std::size_t i = 0; i < s.b.size(); ++i) n_squared += s.b[i] * square / (square - s.c[i]);
  return std::sqrt(n_squared);
}

}  // namespace

RefractiveIndex RefractiveIndex::constant(double n) {
  assert(n > 0.0);
  return RefractiveIndex(n);
}

RefractiveIndex RefractiveIndex::sellmeier(const Sellmeier& coefficients) {
  return RefractiveIndex(coefficients);
}

RefractiveIndex RefractiveIndex::table(SpectrumTable table) {
  assert(is_valid(table));
  return RefractiveIndex(std::move(table));
}

double RefractiveIndex::at(double nm) const {
  if (const auto* constant = std::get_if<double>(&form_)) return *constant;
  if (const auto* sellmeier = std::get_if<Sellmeier>(&form_))
    return sellmeier_index(*sellmeier, nm);
  return std::get<SpectrumTable>(form_).at(nm);
}

std::array<double, 4> RefractiveIndex::at(const Wavelengths& wavelengths) const {
  std::array<double, 4> n;
  for (std::size_t i = 0; i < n.size(); ++i) n[i] = at(wavelengths.lambda(i));
  return n;
}

bool RefractiveIndex::dispersive() const {
  if (std::holds_alternative<double>(form_)) return false;
  if (const auto* sellmeier = std::get_if<Sellmeier>(&form_)) {
    // A term without resonance, C = 0, is a constant.
    for (std::size_t i = 0; i < sellmeier->b.size(); ++i) {
      if (sellmeier->b[i] != 0.0 && sellmeier->c[i] != 0.0) return true;
    }
    return false;
  }
  const auto& values = std::get<SpectrumTable>(form_).values;
  return std::any_of(values.begin(), values.end(), [&](float v) { return v != values.front(); });
}

}  // namespace lapidary
