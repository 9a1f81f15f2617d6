#include "spectrum/refractive_index.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lapidary {
namespace {

/// Term by term, so that the compiler may take all wavelengths at once.
template <std::size_t N>
std::array<double, N> sellmeier_index(const RefractiveIndex::Sellmeier& s,
                                      std::array<double, N> nm) {
  std::array<double, N> square, n;
  for (std::size_t k = 0; k < N; ++k) {
    square[k] = nm[k] * nm[k] * 1e-6;
    n[k] = 1.0 + s.constant;
  }
  for (std::size_t i = 0; i < s.b.size(); ++i) {
    for (std::size_t k = 0; k < N; ++k) n[k] += s.b[i] * square[k] / (square[k] - s.c[i]);
  }
  for (std::size_t k = 0; k < N; ++k) n[k] = std::sqrt(n[k]);
  return n;
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
    return sellmeier_index<1>(*sellmeier, {nm})[0];
  return std::get<SpectrumTable>(form_).at(nm);
}

std::array<double, 4> RefractiveIndex::at(const Wavelengths& wavelengths) const {
  std::array<double, 4> nm, n;
  for (std::size_t i = 0; i < nm.size(); ++i) nm[i] = wavelengths.lambda(i);
  if (const auto* sellmeier = std::get_if<Sellmeier>(&form_))
    return sellmeier_index(*sellmeier, nm);
  for (std::size_t i = 0; i < n.size(); ++i) n[i] = at(nm[i]);
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
