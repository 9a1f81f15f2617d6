#pragma once

#include "film/film.h"
#include "image/image.h"

namespace lapidary::film {

/// The picture on `film`: the beauty as R, G, B in linear Rec. 709, and where the film has all
/// layers albedo.R/G/B, normal.X/Y/Z, depth.Z, id.object and variance.R/G/B (of the mean).
image::LayeredImage develop(const Film& film);

}  // namespace lapidary::film
