#pragma once

#include <optional>

#include "light/departure.h"
#include "light/illumination.h"
#include "light/influence.h"
#include "spectrum/spectrum.h"

namespace lapidary::light {

/// A point that shines alike in all directions with `intensity` [W/(sr nm)], 1 / (4 pi) of its
/// power.
struct PointLight {
  Vec3d position;
  Spectrum intensity;

  std::optional<LightSample> sample_illumination(Vec3d p, const LightNumbers& numbers,
                                                 const Wavelengths& wavelengths) const;
  double pdf_illumination(Vec3d, Vec3d, const LightHit&) const { return 0.0; }
  std::optional<Departure> sample_departure(Vec3d direction, const LightNumbers& numbers,
                                            const Wavelengths& wavelengths) const;
  double pdf_departure(Vec3d, const LightHit&) const { return 0.0; }
  SampledSpectrum emitted(Vec3d, const LightHit&, const Wavelengths&) const { return {}; }
  double power(double scene_radius) const;
  Influence influence() const;
};

/// A point that shines into a cone about an axis. With t = (cos theta - cos outer) /
/// (cos inner - cos outer) clamped to [0, 1], the intensity is that on the axis times
/// t^2 (3 - 2 t): all of it within the inner angle, none beyond the outer one.
class SpotLight {
 public:
  struct Cone {
    Vec3d axis{0, 0, -1};  ///< not zero
    double inner = 0;      ///< half angles in radians, 0 <= inner <= outer <= pi
    double outer = 0.5;
  };

  /// `intensity` on the axis [W/(sr nm)]: the power over `effective_solid_angle`.
  SpotLight(Vec3d position, const Cone& cone, Spectrum intensity);

  /// Power over intensity on the axis [sr], exact: 2 pi (1 - (cos inner + cos outer) / 2).
  static double effective_solid_angle(const Cone& cone);

  std::optional<LightSample> sample_illumination(Vec3d p, const LightNumbers& numbers,
                                                 const Wavelengths& wavelengths) const;
  double pdf_illumination(Vec3d, Vec3d, const LightHit&) const { return 0.0; }
  std::optional<Departure> sample_departure(Vec3d direction, const LightNumbers& numbers,
                                            const Wavelengths& wavelengths) const;
  double pdf_departure(Vec3d, const LightHit&) const { return 0.0; }
  SampledSpectrum emitted(Vec3d, const LightHit&, const Wavelengths&) const { return {}; }
  double power(double scene_radius) const;
  Influence influence() const;

 private:
  double falloff(double cos_theta) const;

  Vec3d position_;
  Vec3d axis_;
  double cos_inner_, cos_outer_;
  double effective_solid_angle_;
  Spectrum intensity_;
};

}  // namespace lapidary::light
