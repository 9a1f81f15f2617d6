#pragma once

#include <functional>
#include <vector>

#include "transport/next_event.h"
#include "transport/photon.h"
#include "transport/photon_emitter.h"
#include "transport/walk.h"

namespace lapidary::transport {

/// Which light a photon is left of, wherever it falls on what scatters widely.
enum class PhotonLight {
  caustics,  ///< that of a caustic's path: it went on from there, but came there by focusing alone
  indirect,  ///< all that next-event estimation does not find: scattered before, or through glass
  all,       ///< what comes straight from lights as well
};

/// Follows photons from lights, and leaves one wherever light of the kind that is wanted falls on
/// what scatters widely. Photons go on from there: light of a caustic is that on all surfaces it
/// reaches. Those inside of opaque solids end.
///
/// Source: Jensen 1996, "Global Illumination using Photon Maps"; Veach 1997, section 5.3, on
/// shading normals.
class PhotonTracer {
 public:
  /// `max_depth` of whole paths, the camera's end included.
  PhotonTracer(const scene::Scene& scene, const PhotonEmitter& emitter, int max_depth,
               PhotonLight wanted = PhotonLight::caustics);

  /// Which photon: a number of its pass, whose wavelengths are the context's.
  struct Number {
    std::uint64_t seed = 0;
    std::uint32_t pass = 0;
    std::uint32_t index = 0;
  };
  /// Where a photon is left.
  struct Arrival {
    const Walk& walk;       ///< stands on the surface
    SampledSpectrum power;  ///< as Photon's
    std::size_t hero = 0;   ///< which wavelength led it
    float dispersion = 0;   ///< as Photon's
    double density = 0;     ///< as Photon's
    Course course = Course::focused;

    /// The power that falls right here: behind what disperses the hero's.
    SampledSpectrum power_here() const;
  };
  using Leave = std::function<void(const Arrival&)>;
  /// Traces one photon and calls `leave` wherever it is left. What it was drawn as, unless it was a
  /// miss.
  std::optional<PhotonEmitter::Origin> trace(const Number& number, const Wavelengths& wavelengths,
                                             const Leave& leave, Counters& counters) const;
  /// Traces one photon. Appends what it leaves to `left`, at positions from `origin`. What it was
  /// drawn as, unless it was a miss. Its number has to say which wavelength leads: Photon::hero.
  std::optional<PhotonEmitter::Origin> trace(const Number& number, const Wavelengths& wavelengths,
                                             Vec3d origin, Photons& left, Counters& counters) const;

 private:
  class Flight;
  /// The ray of light that leaves a surface of finite extent, with what its pattern makes of it;
  /// false where the light is not there.
  bool leave_light(PhotonEmitter::Emission& emission, const Wavelengths& wavelengths,
                   Counters& counters) const;

  const scene::Scene& scene_;
  const PhotonEmitter& emitter_;
  int max_depth_;
  PhotonLight wanted_;
  Interval shutter_;  ///< when the camera takes light: photons of other times are of no use
  std::vector<double> look_back_;  ///< of each light: how far off it it is looked for; scene units
};

}  // namespace lapidary::transport
