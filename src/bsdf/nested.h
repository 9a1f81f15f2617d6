#pragma once

#include <algorithm>
#include <memory>

#include "spectrum/sampled_spectrum.h"

namespace lapidary::bsdf {

/// A BSDF that is part of another one; see bsdf.h. Shared and never changed: a value.
struct Nested;
using NestedPtr = std::shared_ptr<const Nested>;

/// What others need to know of a BSDF that they are made of.
struct Traits {
  /// Of the light of all directions, the share that is not absorbed; an estimate where a model has
  /// no closed form. Also a guess of how much a sample of it is worth.
  SampledSpectrum albedo;
  /// 0 where light leaves under the angle at which it came, like off a mirror, 1 where that is
  /// forgotten, like off chalk.
  double spread = 0;
  bool specular = false;     ///< all lobes are
  bool transparent = false;  ///< light passes to the other side
};

/// A random number that fell into [low, high), made uniform in [0, 1) again.
inline double rescaled(double u, double low, double high) {
  return std::clamp((u - low) / (high - low), 0.0, 0x1.fffffffffffffp-1);
}

}  // namespace lapidary::bsdf
