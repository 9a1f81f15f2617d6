#pragma once

#include <memory>
#include <optional>

#include "light/departure.h"
#include "light/illumination.h"
#include "light/influence.h"
#include "light/photometric_web.h"
#include "math/frame.h"
#include "spectrum/spectrum.h"

namespace lapidary::light {

/// A point that shines as a luminaire was measured to.
class ProfileLight {
 public:
  struct Place {
    Vec3d position;
    Vec3d axis{0, 0, -1};  ///< of vertical angle 0; not zero
    Vec3d up{0, 1, 0};     ///< towards horizontal angle 0, as far as it is across; not along `axis`
  };

  /// `per_candela` is the intensity [W/(sr nm)] where the profile says one candela.
  ProfileLight(const Place& place, std::shared_ptr<const PhotometricWeb> profile,
               Spectrum per_candela);

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
  Vec3d position_;
  Frame frame_;  // local z is the axis, x the horizontal angle 0
  std::shared_ptr<const PhotometricWeb> profile_;
  Spectrum per_candela_;
};

}  // namespace lapidary::light
