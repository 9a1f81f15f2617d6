#include "transport/lookup.h"

#include <algorithm>
#include <cmath>

namespace lapidary::transport {
namespace {

/// What a cone covers of the surface's plane: its axes, the second along the ray.
struct Footprint {
  Vec3d across, along;
};

Footprint footprint(const Met& met) {
  // Seen from the very side a cone covers no finite piece.
  constexpr double least_cosine = 1e-3;
  const Vec3d n = met.surface.geometric_normal, d = met.direction;
  const double cosine = dot(n, d), sine2 = 1.0 - cosine * cosine;
  const bool head_on = !(sine2 > 1e-12);
  const Vec3d in_plane = head_on ? Frame::from_normal(n).tangent : d - n * cosine;
  const double shortened = std::max(std::abs(cosine), least_cosine);
  const double scale = met.width / (shortened * (head_on ? 1.0 : std::sqrt(sine2)));
  return {cross(n, in_plane) * (scale * shortened), in_plane * scale};
}

/// How far (u, v) go on ways along the surface; nearest in the sense of least squares where a step
/// leaves the plane of dpdu and dpdv.
class UvSteps {
 public:
  explicit UvSteps(const geometry::SurfaceUv& at) {
    const double uu = dot(at.dpdu, at.dpdu), vv = dot(at.dpdv, at.dpdv), uv = dot(at.dpdu, at.dpdv);
    const double determinant = uu * vv - uv * uv;
    // A pole, or a chart that is folded flat: any direction is as good as another.
    if (!(determinant > 1e-14 * uu * vv)) return;
    const double scale = 1.0 / determinant;
    u_ = (at.dpdu * vv - at.dpdv * uv) * scale;
    v_ = (at.dpdv * uu - at.dpdu * uv) * scale;
  }
  Vec2d along(Vec3d step) const { return {dot(u_, step), dot(v_, step)}; }

 private:
  Vec3d u_, v_;  ///< gradients
};

/// A piece of a surface on its way from one space to another.
struct Piece {
  Vec3d p, normal;  ///< the normal a covector: not of unit length
  Vec3d across, along;

  /// From coordinates that something stands in to its own.
  Piece into(const geometry::OwnSpace& space) const {
    const Mat3& m = space.own_from_world();
    return {space.point(p), space.normal(normal), m * across, m * along};
  }
  Piece mapped(const Transform& map) const {
    return {map.point(p), map.normal(normal), map.vector(across), map.vector(along)};
  }
};

/// From the world at the time of the hit to what the frame of the textures stands in.
Piece in_base(const scene::Scene& scene, const Met& met, scene::TextureFrame::Base base,
              const Piece& in_world) {
  const geometry::World& world = scene.world();
  const double time = met.surface.time;
  if (met.hit.kind == geometry::SurfaceKind::triangle) {
    const geometry::MeshPlacement& placement = world.triangles().placement(met.hit.index);
    if (!placement.motion) return in_world;
    return in_world.into(placement.motion->space_at(time)).mapped(placement.world_from_mesh);
  }
  if (met.hit.kind != geometry::SurfaceKind::solid || met.hit.place == 0) return in_world;
  const geometry::SolidScene::Place& place = world.solids().places()[met.hit.place - 1];
  if (base == scene::TextureFrame::Base::world && !place.motion) return in_world;
  const Piece own = place.at(time, [&](const auto& space) { return in_world.into(space); });
  if (base == scene::TextureFrame::Base::place) return own;
  return own.mapped(place.space.world_from_own());  // where it was when the frame began
}

/// What a lookup knows besides the surface's own coordinates.
void place_in_space(const scene::Scene& scene, const Met& met, const scene::TextureFrame& frame,
                    SurfaceLookup& lookup) {
  const Piece in_world{met.surface.p, met.surface.geometric_normal, lookup.dpdx, lookup.dpdy};
  const Piece worn = in_base(scene, met, frame.base, in_world).mapped(frame.wearer_from_base);
  lookup.at.p = worn.p;
  lookup.at.normal = normalize(worn.normal);
  lookup.at.dpdx = worn.across;
  lookup.at.dpdy = worn.along;
}

}  // namespace

void SurfaceLookup::meet(const scene::Scene& scene, const Met& met) {
  const scene::Slot& slot = scene.slot(met.hit);
  if (slot.frame == scene::Slot::no_frame) return;
  const Footprint world = footprint(met);
  const geometry::SurfaceUv own = scene.world().surface_uv(met.hit, met.surface);
  const UvSteps steps(own);
  at.uv = own.uv;
  at.duvdx = steps.along(world.across);
  at.duvdy = steps.along(world.along);
  at.care = met.care;
  at.shown.picture = nullptr;
  dpdx = world.across;
  dpdy = world.along;
  dpdu = own.dpdu;
  dpdv = own.dpdv;
  if (scene.material(slot).in_space)
    place_in_space(scene, met, scene.texture_frame(slot.frame), *this);
}

}  // namespace lapidary::transport
