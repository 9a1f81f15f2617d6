#include "spectrum/wavelengths.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "spectrum/cie_functions.h"
#include "spectrum/color.h"
#include "spectrum/wavelength_density.h"

namespace lapidary {
namespace {

std::uint64_t reverse_bits(std::uint64_t bits) {
  std::uint64_t reversed = 0;
  for (int i = 0; i < 64; ++i) reversed |= (bits >> i & 1) << (63 - i);
  return reversed;
}

/// The weight of radiance at `nm` in each component of linear Rec. 709.
Vec3d rgb_response(double nm) {
  static const double efficacy = luminous_efficacy(Spectrum::illuminant({1, 1, 1}));
  const auto [x, y, z] = observer_at(nm);
  return rgb_from_xyz() * (Vec3d{x, y, z} * (peak_luminous_efficacy / efficacy));
}

}  // namespace

Wavelengths Wavelengths::sample(double u) {
  assert(u >= 0.0 && u < 1.0);
  static const WavelengthDensity density;
  Wavelengths w;
  for (std::size_t i = 0; i < SampledSpectrum::size; ++i) {
    const double turned = u + static_cast<double>(i) / SampledSpectrum::size;
    const double nm = density.sample(turned < 1.0 ? turned : turned - 1.0);
    const double pdf = density.pdf(nm);
    w.lambda_[i] = nm;
    w.pdf_[i] = pdf;

    const Vec3d response = rgb_response(nm) / (SampledSpectrum::size * pdf);
    for (std::size_t c = 0; c < 3; ++c) {
      w.rgb_weight_[c].set(i, static_cast<float>(response[c]));
    }
    // The last is what the first two leave of one, so that white reflects everything exactly.
    const auto basis = rgb_basis_at(nm);
    const auto red = static_cast<float>(basis[0]);
    const float green = std::min(static_cast<float>(basis[1]), 1.0f - red);
    w.rgb_basis_[0].set(i, red);
    w.rgb_basis_[1].set(i, green);
    w.rgb_basis_[2].set(i, 1.0f - (red + green));
    w.d65_.set(i, static_cast<float>(d65_at(nm)));
  }
  return w;
}

Wavelengths Wavelengths::led_by(std::size_t hero) const {
  assert(hero < SampledSpectrum::size);
  Wavelengths led = *this;
  led.hero_ = hero;
  return led;
}

Heroes every_hero(const Wavelengths& wavelengths) {
  return {wavelengths.led_by(0), wavelengths.led_by(1), wavelengths.led_by(2),
          wavelengths.led_by(3)};
}

double Wavelengths::pass_stratum(std::uint64_t pass, double rotation) {
  assert(rotation >= 0.0 && rotation < 1.0);
  // The place within a quarter is the radical inverse of the pass: a block of 2^m passes has one in
  // each 2^-m. The quarter must then be settled by the two highest bits of the block's counter, for
  // every m: the parities of the even and of the odd bits do that.
  const double within = static_cast<double>(reverse_bits(pass) >> 11) * 0x1p-53;
  const int even = std::popcount(pass & 0x5555555555555555) & 1;
  const int odd = std::popcount(pass & 0xaaaaaaaaaaaaaaaa) & 1;
  const double u = 0.25 * (2 * even + odd + within) + rotation;
  return u < 1.0 ? u : u - 1.0;
}

}  // namespace lapidary
