#pragma once

#include <cmath>
#include <optional>

#include "bsdf/bsdf.h"
#include "geometry/world.h"
#include "light/choice.h"
#include "math/frame.h"
#include "scene/scene.h"
#include "spectrum/wavelengths.h"
#include "transport/lookup.h"

namespace lapidary::transport {

/// A point of a path where light scatters.
struct Vertex {
  geometry::Surface surface;
  /// Local z is the shading normal; of opaque materials, on the side of wo. Of those with a grain x
  /// is along dp/du and y on the side of dp/dv: left-handed where these are.
  Frame frame;
  Vec3d wo;  ///< local
  bsdf::Bsdf bsdf;
  light::LitPoint lit;  ///< what lights are chosen for
};

/// What a vertex is made of.
struct Meeting {
  const scene::PreparedMaterial& material;
  const geometry::Surface& surface;
  const SurfaceLookup& lookup;  ///< counts where the material has textures or a grain
  Vec3d direction;              ///< of the ray
  /// On the ray's way here, and on the other side.
  const medium::Medium &before, &after;
};

/// The vertex where a ray meets a surface.
Vertex make_vertex(const Meeting& meeting, const Wavelengths& wavelengths, bsdf::Carried carried);

/// Whether a world direction lies on the same side of the surface as it does of the shading
/// normal. Where it does not, smooth normals would let light through an opaque surface.
inline bool sides_agree(const Vertex& vertex, Vec3d wi_world, Vec3d wi_local) {
  const bool same_side_as_wo = (wi_local.z > 0.0) == (vertex.wo.z > 0.0);
  const Vec3d n = vertex.surface.geometric_normal;
  const bool crosses = (dot(wi_world, n) > 0.0) != (dot(vertex.frame.to_world(vertex.wo), n) > 0.0);
  return crosses != same_side_as_wo;
}

/// By how much less light that comes from `l` goes to `c` than the BSDF says, where the shading
/// normal is not the geometric one: the light's edge of a smooth or rough surface fades instead of
/// breaking off where the geometric normal turns away. 1 for light that passes through.
/// Source: Chiang, Li & Burley 2019, "Taming the Shadow Terminator", section 3.
inline double terminator_share(const Vertex& vertex, Vec3d l_world, Vec3d l_local, Vec3d c_local) {
  if ((l_local.z > 0.0) != (c_local.z > 0.0)) return 1.0;
  const Vec3d ns = vertex.frame.normal, ng = vertex.surface.geometric_normal;
  const double agreement = std::abs(dot(ns, ng));
  if (agreement > 1.0 - 1e-9) return 1.0;
  const double g = std::abs(dot(l_world, ng)) / (std::abs(l_local.z) * agreement);
  return g < 1.0 ? g * (1.0 + g * (1.0 - g)) : 1.0;
}
/// The same for a path from the camera, which goes to wo.
inline double terminator_share(const Vertex& vertex, Vec3d wi_world, Vec3d wi_local) {
  return terminator_share(vertex, wi_world, wi_local, vertex.wo);
}

}  // namespace lapidary::transport
