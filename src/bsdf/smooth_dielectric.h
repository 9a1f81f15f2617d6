#pragma once

#include <array>
#include <optional>

#include "bsdf/fresnel.h"
#include "bsdf/scattering.h"

namespace lapidary::bsdf {

/// The refractive indices at a path's wavelengths on both sides of a surface.
struct InterfaceIndices {
  std::array<double, 4> above;  ///< the side that z points to
  std::array<double, 4> below;
  std::size_t hero = 0;  ///< which wavelength is
};

/// Indices below the surface (z < 0) over those above it at the path's wavelengths.
///
/// Reflection keeps all wavelengths, each with its own Fresnel reflectance F_i; refraction at a
/// dispersive interface keeps the hero. The chance of reflection,
///   q = m / (m + 1 - F_h), m the mean of the F_i,
/// h the hero, gives both ways the same total weight, m + 1 - F_h <= 1.75 per wavelength, which is
/// 1 without dispersion, and never refracts under total reflection of the hero.
class RelativeIndex {
 public:
  explicit RelativeIndex(const InterfaceIndices& indices);

  /// Index beyond over index before, at the hero wavelength, for a direction with this z.
  double hero(double z) const { return beyond(z)[hero_]; }
  bool dispersive() const { return dispersive_; }
  Carried carried_by_refraction() const { return dispersive_ ? Carried::hero : Carried::all; }

  /// What happens at a smooth facet.
  struct Split {
    SampledSpectrum reflectance;  ///< F_i
    double transmittance = 0;     ///< 1 - F_h
    double cos_refracted = 0;     ///< of the hero
    double chance_to_reflect = 1;
  };
  /// `cos_incident` in [0, 1]; `z` of the direction, whose sign is the side it is on.
  Split split(double cos_incident, double z) const;

  /// A weight of refraction for the wavelengths that go on. Radiance also shrinks or grows with
  /// the square of the index as the solid angle does: Veach 1997, section 5.2.
  SampledSpectrum refracted(double weight, double eta, Mode mode) const {
    const auto scaled = static_cast<float>(mode == Mode::radiance ? weight / (eta * eta) : weight);
    return dispersive_ ? SampledSpectrum::only(hero_, 4.0f * scaled) : SampledSpectrum(scaled);
  }

  /// Index beyond over index before at every wavelength, for a direction with this z.
  const std::array<double, 4>& beyond(double z) const {
    return z > 0.0 ? below_over_above_ : above_over_below_;
  }

 private:
  std::array<double, 4> below_over_above_;
  std::array<double, 4> above_over_below_;
  std::size_t hero_;
  bool dispersive_ = false;
};

/// The polished boundary of two transparent media: a specular reflection and a specular refraction.
struct SmoothDielectric {
  RelativeIndex index;
};

inline BsdfValue evaluate_with_pdf(const SmoothDielectric&, Vec3d, Vec3d, Mode) {
  return {};
}

std::optional<BsdfSample> sample(const SmoothDielectric& bsdf, Vec3d wo, double u_lobe, Vec2d u,
                                 Mode mode);

/// Both of what `sample` chooses between, each with its share of the light as its weight, for who
/// follows both. Nothing for a way that no light takes.
struct BothWays {
  std::optional<BsdfSample> reflected, refracted;
};
BothWays both_ways(const SmoothDielectric& bsdf, Vec3d wo, Mode mode);

/// What refraction does to all wavelengths, where they may be taken to go the hero's way.
struct Spread {
  SampledSpectrum transmittance;  ///< 1 - F_i
  double divergence = 0;          ///< largest angle between two; infinite if one is not refracted
};
Spread spread_of_refraction(const RelativeIndex& index, double z);

}  // namespace lapidary::bsdf
