#include "transport/vertex.h"

namespace lapidary::transport {
namespace {

using bsdf::Bsdf;
using bsdf::Carried;

Bsdf bsdf_at(const bsdf::Matte& matte, const Wavelengths& wavelengths, Carried) {
  return make_bsdf(matte, wavelengths);
}
Bsdf bsdf_at(const bsdf::Metal& metal, const Wavelengths& wavelengths, Carried) {
  return make_bsdf(metal, wavelengths);
}
Bsdf bsdf_at(const bsdf::Glass& glass, const Wavelengths& wavelengths, Carried carried) {
  // Media do not nest yet: every transparent body stands in air, whose index is one.
  static const RefractiveIndex air = RefractiveIndex::constant(1.0);
  return make_bsdf(glass, air, wavelengths, carried);
}
Bsdf bsdf_at(const bsdf::Black& black, const Wavelengths&, Carried) {
  return black;
}

/// The shading normal, or the geometric one where wo sees the two from different sides.
Vec3d usable_normal(const geometry::Surface& surface, Vec3d wo) {
  const bool agree =
      (dot(wo, surface.shading_normal) > 0.0) == (dot(wo, surface.geometric_normal) > 0.0);
  return agree ? surface.shading_normal : surface.geometric_normal;
}

}  // namespace

Vertex make_vertex(const scene::PreparedMaterial& material, const geometry::Surface& surface,
                   Vec3d direction, const Wavelengths& wavelengths, Carried carried) {
  const Vec3d wo = -direction;
  Vec3d normal = usable_normal(surface, wo);
  const bool transparent = std::holds_alternative<bsdf::Glass>(material.material);
  if (!transparent && dot(wo, normal) < 0.0) normal = -normal;
  const Frame frame = Frame::from_normal(normal);
  return {surface, frame, frame.to_local(wo),
          std::visit([&](const auto& m) { return bsdf_at(m, wavelengths, carried); },
                     material.material)};
}

}  // namespace lapidary::transport
