#pragma once

#include "math/vec.h"
#include "spectrum/sampled_spectrum.h"

namespace lapidary::bsdf {

/// What flows along the path that is being traced: radiance for paths from the camera, importance
/// for photons. Only refraction tells them apart (Veach 1997, section 5.2).
enum class Mode { radiance, importance };

/// How concentrated a sampled lobe is; a specular one is a Dirac delta.
enum class Lobe { diffuse, glossy, specular };

/// Where a direction leads. `straight` is through, as if there was nothing: what light does so is
/// known without chance, by `straight_through`, and it counts as not scattered.
enum class Side { reflected, transmitted, straight };

/// The wavelengths that a path still carries: all four, or the hero alone.
enum class Carried { all, hero };

/// The BSDF times the cosine for one pair of directions, with the density of `sample`.
struct BsdfValue {
  SampledSpectrum f_cos;  ///< f(wo, wi) |cos theta_i| [1/sr]; without specular lobes
  double pdf = 0;         ///< of choosing wi given wo, per solid angle [1/sr]
};

/// A sampled direction.
struct BsdfSample {
  Vec3d wi;                ///< unit length
  SampledSpectrum weight;  ///< f(wo, wi) |cos theta_i| / pdf; of a specular lobe its limit
  double pdf = 0;          ///< per solid angle [1/sr]; 0 for a specular lobe
  Lobe lobe = Lobe::diffuse;
  Side side = Side::reflected;
  /// Index beyond the surface over index on wo's side at the hero wavelength; 1 if reflected. Its
  /// square undoes the radiance scaling in `weight` where Russian roulette looks at throughput.
  double relative_index = 1;
  /// `hero` when the direction belongs to the hero wavelength; `weight` then includes the factor
  /// `Wavelengths::hero_only()`, and every later BSDF of the path is made with `Carried::hero`.
  Carried carried = Carried::all;
};

}  // namespace lapidary::bsdf
