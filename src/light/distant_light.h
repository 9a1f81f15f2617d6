#pragma once

#include <optional>

#include "light/departure.h"
#include "light/illumination.h"
#include "light/influence.h"
#include "math/frame.h"
#include "spectrum/spectrum.h"

namespace lapidary::light {

/// A sun: light from one direction, or from a round patch of the sky about it.
class DistantLight {
 public:
  struct Source {
    Vec3d towards{0, 0, 1};  ///< from the scene to the light; not zero
    double radius = 0;       ///< half the angular diameter, in radians in [0, pi / 2]
  };

  /// `irradiance` on a plane that faces the light [W/(m2 nm)]; the patch has that over
  /// pi sin^2(radius) as its radiance.
  DistantLight(const Source& source, Spectrum irradiance);

  Extent extent() const { return one_minus_cos_ > 0.0 ? Extent::area : Extent::delta; }

  std::optional<LightSample> sample_illumination(Vec3d p, const LightNumbers& numbers,
                                                 const Wavelengths& wavelengths) const;
  double pdf_illumination(Vec3d p, Vec3d wi, const LightHit& hit) const;
  std::optional<Departure> sample_departure(Vec3d, const LightNumbers&, const Wavelengths&) const {
    return {};
  }
  double pdf_departure(Vec3d, const LightHit&) const { return 0.0; }
  SampledSpectrum emitted(Vec3d wi, const LightHit& hit, const Wavelengths& wavelengths) const;
  double power(double scene_radius) const;
  Influence influence() const;

 private:
  bool in_patch(Vec3d wi) const;

  Frame frame_;            // normal to the middle of the patch
  double one_minus_cos_;   // of its radius
  double chord_;           // from its middle to its rim on the unit sphere
  double per_irradiance_;  // radiance over irradiance, 1 for a delta light
  Spectrum irradiance_;
};

}  // namespace lapidary::light
