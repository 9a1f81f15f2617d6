#pragma once

#include <array>
#include <cstdint>

#include "spectrum/rgb.h"
#include "spectrum/sampled_spectrum.h"

namespace lapidary {

inline constexpr double lambda_min = 360.0;  ///< nm
inline constexpr double lambda_max = 830.0;  ///< nm

/// The four wavelengths that all paths of one pass share, and everything that depends on them
/// alone, so that a path only multiplies.
///
/// One of them, the hero, is what a dispersive interface keeps; a path that loses the others
/// carries on with weight `hero_only()`. Each of the four has to be the hero of as many paths, and
/// those paths as independent of the choice as of any other.
class Wavelengths {
 public:
  /// `u` in [0, 1): the first, which is the hero, follows a density shaped like the eye's response,
  /// the other three are rotated by quarters of the unit interval before the same warp.
  ///
  /// Accuracy of the mean of `to_rgb` over N values from `pass_stratum`, relative to the largest
  /// component, as root mean square over sixteen spectra (D65 on nine RGB reflectances, gold and
  /// copper, blackbodies of 2000-10000 K) and all rotations: 0.11 for N = 1, 0.004 for 4, 0.0003
  /// for 16, 2e-5 for 64.
  static Wavelengths sample(double u);
  /// The `u` of a pass, such that every aligned block of 2^m passes has its first wavelengths in
  /// each 2^-m of the unit interval once, and all 4 * 2^m in strata of their own. (Plain strata of
  /// u will not do: four of them, a quarter turn apart, give the same four wavelengths.) `rotation`
  /// in [0, 1), say from the seed, turns all of them.
  static double pass_stratum(std::uint64_t pass, double rotation);

  /// The same four with another hero.
  Wavelengths led_by(std::size_t hero) const;
  std::size_t hero() const { return hero_; }

  double lambda(std::size_t i) const { return lambda_[i]; }  ///< nm
  double pdf(std::size_t i) const { return pdf_[i]; }        ///< per nm

  /// Linear Rec. 709 estimate of spectral radiance `L` [W/(m2 sr nm)]; a D65-shaped spectrum of
  /// total radiance 1 W/(m2 sr) over 360-830 nm has the mean {1, 1, 1} over `u`.
  Rgb to_rgb(SampledSpectrum L) const {
    return {(L * rgb_weight_[0]).sum(), (L * rgb_weight_[1]).sum(), (L * rgb_weight_[2]).sum()};
  }

  /// Basis for reflectances: r * rgb_basis(0) + g * rgb_basis(1) + b * rgb_basis(2).
  SampledSpectrum rgb_basis(std::size_t channel) const { return rgb_basis_[channel]; }
  /// D65 with total radiance 1 over 360-830 nm [1/nm].
  SampledSpectrum d65() const { return d65_; }

  /// `Spectrum::reflectance(rgb)` here, at no more than its five multiplications and additions.
  /// Exactly 1 for {1, 1, 1}.
  SampledSpectrum reflectance(Rgb rgb) const {
    return (rgb.r * rgb_basis_[0] + rgb.g * rgb_basis_[1]) + rgb.b * rgb_basis_[2];
  }
  /// `Spectrum::illuminant(rgb)` here.
  SampledSpectrum illuminant(Rgb rgb) const { return reflectance(rgb) * d65_; }

  /// Multiplies a path that goes on with the hero wavelength alone: 4 there, 0 elsewhere.
  SampledSpectrum hero_only() const { return SampledSpectrum::only(hero_, 4.0f); }

 private:
  std::array<double, 4> lambda_{};
  std::array<double, 4> pdf_{};
  std::array<SampledSpectrum, 3> rgb_weight_;
  std::array<SampledSpectrum, 3> rgb_basis_;
  SampledSpectrum d65_;
  std::size_t hero_ = 0;
};

/// Wavelengths of a pass, led by each of the four in turn.
using Heroes = std::array<Wavelengths, SampledSpectrum::size>;
Heroes every_hero(const Wavelengths& wavelengths);

}  // namespace lapidary
