#pragma once

#include "bsdf/bsdf.h"

/// Which surfaces gather light into caustics.
namespace lapidary::bsdf {

/// GGX lobes up to this alpha - of a grain the geometric mean of both, which says how large the
/// lobe's solid angle is - are narrow: chance that follows them seldom meets a small light, and
/// light that follows them from a lamp still comes out in bundles.
inline constexpr double widest_narrow_alpha = 0.15;

/// Whether all light leaves in lobes that are specular or narrow. Where this is false the lobes
/// that are not specular count as wide together, whatever they are.
bool is_narrow(const Bsdf& bsdf);

/// About the share of light that a material sends on in such lobes, or in the specular ones beside
/// others: 0 only if nowhere any. Textures count as what they may do.
double focused_share(const Finish& finish);

}  // namespace lapidary::bsdf
