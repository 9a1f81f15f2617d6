#include "transport/vertex.h"

namespace lapidary::transport {
namespace {

using bsdf::Bsdf;
using bsdf::Carried;

/// The media above and below the local z.
struct Sides {
  const medium::Medium &above, &below;
};

Bsdf bsdf_at(const bsdf::Matte& matte, const Sides&, const bsdf::Place& place, Carried) {
  return make_bsdf(matte, place);
}
Bsdf bsdf_at(const bsdf::Metal& metal, const Sides&, const bsdf::Place& place, Carried) {
  return make_bsdf(metal, place);
}
Bsdf bsdf_at(const bsdf::Glass& glass, const Sides& sides, const bsdf::Place& place,
             Carried carried) {
  const Wavelengths& wavelengths = place.wavelengths;
  return make_glass({sides.above.index.at(wavelengths), sides.below.index.at(wavelengths)},
                    place.share(glass.roughness), carried);
}
Bsdf bsdf_at(const bsdf::Black& black, const Sides&, const bsdf::Place&, Carried) {
  return black;
}

/// The shading normal, or the geometric one where wo sees the two from different sides.
Vec3d usable_normal(const geometry::Surface& surface, Vec3d wo) {
  const bool agree =
      (dot(wo, surface.shading_normal) > 0.0) == (dot(wo, surface.geometric_normal) > 0.0);
  return agree ? surface.shading_normal : surface.geometric_normal;
}

}  // namespace

Vertex make_vertex(const Meeting& m, const Wavelengths& wavelengths, Carried carried) {
  const Vec3d wo = -m.direction;
  Vec3d normal = usable_normal(m.surface, wo);
  const bool faces_ray = dot(wo, m.surface.geometric_normal) > 0.0;
  const bool transparent = std::holds_alternative<bsdf::Glass>(m.material.material);
  if (!transparent && dot(wo, normal) < 0.0) normal = -normal;
  const Frame frame = Frame::from_normal(normal);
  const Sides sides{faces_ray ? m.before : m.after, faces_ray ? m.after : m.before};
  const bsdf::Place place{m.lookup, wavelengths};
  return {m.surface, frame, frame.to_local(wo),
          std::visit([&](const auto& kind) { return bsdf_at(kind, sides, place, carried); },
                     m.material.material)};
}

}  // namespace lapidary::transport
