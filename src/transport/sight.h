#pragma once

#include "camera/cone.h"
#include "scene/scene.h"
#include "transport/first_surface.h"

namespace lapidary::transport {

/// What stands at the end of a straight way that leads on through gaps in surfaces.
struct Sight {
  geometry::Ray ray;  ///< the last leg of it
  geometry::Hit hit;  ///< on that leg; kind none when the way is free
  double passed = 0;  ///< length of the legs before
  double share = 1;   ///< of light that comes through the gaps
};

/// Follows `ray`, whose direction has unit length, to its end or to the first surface without gaps.
Sight look(const scene::Scene& scene, geometry::Ray ray, camera::Cone cone, Counters& counters);

/// The share of a surface that is there.
double opacity(const bsdf::SurfaceDetail& detail, const texture::Lookup& lookup);

}  // namespace lapidary::transport
