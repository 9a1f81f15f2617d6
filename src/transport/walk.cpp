#include "transport/walk.h"

#include <algorithm>
#include <cmath>

#include "transport/relief.h"
#include "transport/sight.h"

namespace lapidary::transport {
namespace {

using bsdf::Lobe;
using geometry::SurfaceKind;

/// The spread of the cone of paths that one of a scattered lobe stands for, drawn with `pdf`: a
/// share of what it would be if there were no other. The lobe itself averages what it sees; this
/// only spares looking at grains that no number of paths would resolve.
double spread(double pdf) {
  constexpr double share = 0.125;
  return share * 2.0 * std::sqrt(1.0 / (pi * pdf));
}

}  // namespace

bool Walk::advance() {
  transmittance_ = SampledSpectrum(1.0f);
  went_through_glass_ = false;
  for (;;) {
    ++context_.counters.nearest_queries;
    hit_ = scene_.world().nearest(ray_);
    if (hit_.kind == SurfaceKind::none) {
      add_leg(infinity, inside_.medium(scene_, hit_.region_before));
      return false;
    }
    surface_ = scene_.world().surface(ray_, hit_);
    media_ = inside_.media(scene_, hit_, surface_, ray_.direction);
    add_leg(hit_.t, media_.before);  // directions have unit length
    cone_.width = cone_.width_at(hit_.t);
    slot_ = &scene_.slot(hit_);
    material_ = &scene_.material(*slot_);
    look_up();
    if (finds_gap()) {
      pass_through();
    } else if (is_glass_without_change()) {
      pass_through();
      went_through_glass_ = true;
    } else {
      return true;
    }
  }
}

void Walk::look_up() {
  if (slot_->frame == scene::Slot::no_frame) return;
  lookup_.meet(scene_, met());
  if (!material_->detail.has_relief()) return;
  surface_.shading_normal = relief_normal(material_->detail, surface_, lookup_, ray_.direction);
}

bool Walk::finds_gap() {
  if (!material_->detail.has_gaps()) return false;
  const double there = opacity(material_->detail, lookup_.at);
  // One number decides about all surfaces before the next vertex: what is left of it after a gap
  // is as uniform as before.
  if (!presence_) presence_ = points().presence();
  if (*presence_ < there || there == 1.0) return false;
  presence_ = std::min((*presence_ - there) / (1.0 - there), 1.0 - 0x1p-53);
  return true;
}

bool Walk::is_glass_without_change() const {
  return media_.before == media_.after &&
         std::holds_alternative<bsdf::Glass>(material_->finish.kind);
}

void Walk::pass_through() {
  inside_.cross(scene_, surface_, ray_.direction);
  ray_ = geometry::World::leave(surface_, ray_.direction);
}

Vertex Walk::vertex() const {
  return make_vertex({*material_, surface_, lookup_, ray_.direction, scene_.medium(media_.before),
                      scene_.medium(media_.after)},
                     context_.wavelengths, carried_);
}

void Walk::scatter(const Vertex& vertex, const bsdf::BsdfSample& sample, Vec3d direction) {
  ++vertices_;
  presence_.reset();
  if (sample.side == bsdf::Side::straight) {
    pass_through();
    return;
  }
  if (sample.carried == bsdf::Carried::hero) carried_ = bsdf::Carried::hero;
  if (sample.lobe != Lobe::specular) {
    cone_.spread = std::max(cone_.spread, spread(sample.pdf));
  }
  if (sample.lobe == Lobe::diffuse) care_ = texture::Lookup::Care::glance;
  if ((sample.wi.z > 0.0) != (vertex.wo.z > 0.0)) inside_.cross(scene_, surface_, direction);
  ray_ = geometry::World::leave(surface_, direction);
  ++depth_;
}

FirstSurface first_surface(const scene::Scene& scene, const Walk& walk) {
  const geometry::Surface& surface = walk.surface();
  const bool from_behind = dot(surface.shading_normal, walk.ray().direction) > 0.0;
  return {walk.material().albedo.rgb_at(walk.lookup()),
          from_behind ? -surface.shading_normal : surface.shading_normal,
          camera::depth(scene.camera(), surface.p, walk.ray().time),
          scene.object_index(walk.hit()) + 1};
}

Scattered straight_way(const Vertex& vertex, Vec3d direction) {
  bsdf::BsdfSample straight{-vertex.wo, straight_through(vertex.bsdf, vertex.wo)};
  straight.lobe = bsdf::Lobe::specular;
  straight.side = bsdf::Side::straight;
  return {straight, direction};
}

std::optional<Scattered> sample_direction(const Vertex& vertex, const VertexPoints& points,
                                          bsdf::Mode mode) {
  const auto sample =
      bsdf::sample(vertex.bsdf, vertex.wo, points.lobe_choice(), points.direction(), mode);
  if (!sample) return {};
  const Vec3d direction = vertex.frame.to_world(sample->wi);
  if (!sides_agree(vertex, direction, sample->wi)) return {};
  return Scattered{*sample, direction};
}

}  // namespace lapidary::transport
