#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "light/departure.h"
#include "light/illumination.h"
#include "light/influence.h"
#include "sampling/distribution.h"
#include "spectrum/spectrum.h"

namespace lapidary::light {

/// The same radiance from every direction. Sampled uniformly over the sphere.
struct ConstantEnvironment {
  Spectrum radiance;

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
};

/// Radiance by direction from an equirectangular picture: rows from +z down to -z, the middle
/// column towards +y, columns to its right towards +x, as it looks from inside. Pixels are
/// interpolated linearly, around the horizon and up to the poles. Sampled in proportion to the
/// luminance of each pixel's cell, so no bright pixel is missed.
class ImageEnvironment {
 public:
  struct Picture {
    std::size_t width = 0;  ///< at least 1
    std::vector<Rgb>
        pixels;           ///< row by row, finite; light of colour {r, g, b}, negatives count as 0
    double rotation = 0;  ///< about +z, counter-clockwise seen from above, in radians
  };

  explicit ImageEnvironment(Picture picture);

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

  /// The interpolated picture towards `wi`.
  Rgb color_towards(Vec3d wi) const;

 private:
  struct Tables;
  std::shared_ptr<const Tables> tables_;  // large, immutable and cheap to hand on
};

}  // namespace lapidary::light
