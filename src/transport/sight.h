#pragma once

#include "camera/cone.h"
#include "scene/scene.h"
#include "transport/first_surface.h"
#include "transport/interior.h"

namespace lapidary::transport {

/// A straight way, and what it begins in.
struct Way {
  geometry::Ray ray;  ///< its direction has unit length
  camera::Cone cone;
  MeshStack inside;
  std::uint32_t medium = 0;
};

/// What stands at the end of a way that leads on through gaps in surfaces, and through panes.
struct Sight {
  geometry::Ray ray;            ///< the last leg of it
  geometry::Hit hit;            ///< on that leg; kind none when the way is free
  double passed = 0;            ///< length of the legs before
  SampledSpectrum share{1.0f};  ///< of light that comes through all that, and those legs' media
  std::uint32_t medium = 0;     ///< of the last leg
};

/// Follows the way to its end or to the first surface that lets nothing through.
Sight look(const scene::Scene& scene, const Way& way, const Wavelengths& wavelengths,
           Counters& counters);

/// The share of a surface that is there.
double opacity(const bsdf::SurfaceDetail& detail, const texture::Lookup& lookup);

}  // namespace lapidary::transport
