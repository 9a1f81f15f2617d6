#include "transport/vertex.h"

namespace lapidary::transport {
namespace {

/// The shading normal, or the geometric one where wo sees the two from different sides.
Vec3d usable_normal(const geometry::Surface& surface, Vec3d wo) {
  const bool agree =
      (dot(wo, surface.shading_normal) > 0.0) == (dot(wo, surface.geometric_normal) > 0.0);
  return agree ? surface.shading_normal : surface.geometric_normal;
}

/// Along the surface's coordinates, where they have directions there.
Frame frame_of_grain(Vec3d normal, const SurfaceLookup& lookup) {
  const Vec3d u = lookup.dpdu - normal * dot(normal, lookup.dpdu);
  const double size = length(u);
  if (!(size > 0.0)) return Frame::from_normal(normal);
  const Vec3d tangent = u / size, bitangent = cross(normal, tangent);
  return {tangent, dot(bitangent, lookup.dpdv) < 0.0 ? -bitangent : bitangent, normal};
}

}  // namespace

Vertex make_vertex(const Meeting& m, const Wavelengths& wavelengths, bsdf::Carried carried) {
  const Vec3d wo = -m.direction;
  const bool faces_ray = dot(wo, m.surface.geometric_normal) > 0.0;
  const bsdf::Surroundings around{(faces_ray ? m.before : m.after).index,
                                  (faces_ray ? m.after : m.before).index, carried};
  Vertex vertex{
      m.surface, {}, {}, make_bsdf(m.material.finish, {m.lookup.at, wavelengths}, around), {}};
  Vec3d normal = usable_normal(m.surface, wo);
  const bool transparent = is_transparent(vertex.bsdf);
  if (!transparent && dot(wo, normal) < 0.0) normal = -normal;
  vertex.frame =
      m.material.has_grain ? frame_of_grain(normal, m.lookup) : Frame::from_normal(normal);
  vertex.wo = vertex.frame.to_local(wo);
  vertex.lit = {m.surface.p, transparent ? Vec3d() : normal};
  return vertex;
}

}  // namespace lapidary::transport
