#include "transport/camera_path.h"

#include "sampling/mis.h"

namespace lapidary::transport {

using bsdf::Lobe;

bool CameraPath::advance() {
  const bool found = walk_.advance();
  beta_ *= walk_.transmittance();
  return found;
}

double CameraPath::share_of_bsdf_sampling(std::uint32_t index, const light::LightHit& hit) const {
  if (origin_.lobe == Lobe::specular || walk_.went_through_glass()) return 1.0;
  const scene::Scene& scene = setting_.scene;
  const double pdf_light =
      scene.light_selector()->probability(origin_.lit, index) *
      light::pdf_illumination(scene.lights()[index], origin_.lit.p, walk_.ray().direction, hit);
  return power_heuristic(origin_.pdf, pdf_light);
}

void CameraPath::add_direct_light(const Vertex& vertex, const VertexPoints& points) {
  if (is_specular(vertex.bsdf)) return;
  const NextEvent::Place place{vertex, walk_.media(), walk_.cone(), walk_.inside()};
  L_ += beta_ * setting_.next_event.direct_light(place, points, setting_.context);
}

bool CameraPath::take(const Vertex& vertex, const Scattered& way, bool is_narrow) {
  const bsdf::BsdfSample& sample = way.sample;
  beta_ *= sample.weight;
  if (sample.side == bsdf::Side::straight) {
    // Light sampling sees through: where the path was scattered last stays its origin.
    walk_.scatter(vertex, sample, way.direction);
    return !beta_.is_zero();
  }
  if (sample.lobe != Lobe::specular) {
    beta_ *= static_cast<float>(terminator_share(vertex, way.direction, sample.wi));
  }
  const bool wide = is_wide(way, is_narrow);
  if (wide) ++wide_;
  index_squared_ *= sample.relative_index * sample.relative_index;
  origin_ = {vertex.lit, sample.pdf, sample.lobe, !wide};
  walk_.scatter(vertex, sample, way.direction);
  return !beta_.is_zero();
}

bool CameraPath::pass_straight() {
  if (!walk_.material().lets_through) return false;
  const Vertex vertex = walk_.vertex();
  return take(vertex, straight_way(vertex, walk_.ray().direction), true);
}

double CameraPath::throughput() const {
  // The hero alone carries the weight of four.
  const float brightest =
      walk_.carried() == bsdf::Carried::hero ? 0.25f * beta_.max() : beta_.max();
  return static_cast<double>(brightest) * index_squared_;
}

bool CameraPath::survives_roulette(double u) {
  // The ways of a split go on together until one of them is scattered widely: to drop one at random
  // would give back what the split has gained.
  const double throughput = this->throughput() / (wide_ > 0 ? 1.0 : split_share_);
  if (walk_.depth() < 2 || throughput >= 1.0) return throughput > 0.0;
  if (u >= throughput) return false;
  beta_ *= static_cast<float>(1.0 / throughput);
  return true;
}

bool CameraPath::take_specular(const Vertex& vertex,
                               const std::optional<bsdf::BsdfSample>& sample) {
  if (!sample) return false;
  const Vec3d direction = vertex.frame.to_world(sample->wi);
  const double before = throughput();
  if (!sides_agree(vertex, direction, sample->wi)) return false;
  if (!take(vertex, {*sample, direction}, true)) return false;
  split_share_ *= throughput() / before;
  return true;
}

}  // namespace lapidary::transport
