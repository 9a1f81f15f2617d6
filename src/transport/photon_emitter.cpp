#include "transport/photon_emitter.h"

#include <algorithm>
#include <cmath>

#include "math/frame.h"
#include "sampling/warp.h"

namespace lapidary::transport {
namespace {

using light::Ball;
using Target = PhotonEmitter::Target;

constexpr std::size_t most_targets = 24;
/// Of the photons of a light, those that are not aimed.
constexpr double unaimed_share = 0.05;
/// Of a light's power, what reaches a target at least, as far as it is known without looking: an
/// estimate of nothing may be wrong where a light touches the rim of a large target.
constexpr double least_reaching = 1e-3;
/// Cells of a proposal's square along each side.
constexpr std::size_t guide_width = 24;
/// Of what emission was like before it learned, the share that stays.
constexpr double kept_share = 0.15;
/// Photons that a cell learns from, with its neighbours if it must be: where too few had any worth,
/// by chance, those of later passes would be rare and as bright.
constexpr double fewest_photons_of_cell = 4.0;

Ball ball_around(const Box3d& box) {
  return {box.center(), 0.5 * length(box.extent())};
}

/// Of a point that rounding may have put on the far sides of the unit square.
Vec2d inside(Vec2d square) {
  constexpr double last = 1.0 - 0x1p-53;
  return {std::clamp(square.x, 0.0, last), std::clamp(square.y, 0.0, last)};
}

/// Means of a grid's values over squares of cells that hold `fewest_photons_of_cell` of `photons`,
/// if these are spread evenly; at the rim over what there is of them.
std::vector<double> smoothed(const std::vector<double>& grid, std::size_t photons) {
  constexpr auto width = static_cast<int>(guide_width);
  const double cells = fewest_photons_of_cell * static_cast<double>(grid.size());
  const double across = std::sqrt(cells / static_cast<double>(photons));
  const int reach = static_cast<int>(std::ceil(0.5 * (across - 1.0)));
  if (reach < 1) return grid;
  const auto along = [&](const std::vector<double>& from, std::size_t step, std::size_t line) {
    std::vector<double> to(from.size());
    for (int at = 0; at < width * width; ++at) {
      const auto start = static_cast<std::size_t>(at / width) * line;
      const int low = std::max(at % width - reach, 0),
                high = std::min(at % width + reach, width - 1);
      double sum = 0.0;
      for (int i = low; i <= high; ++i) sum += from[start + static_cast<std::size_t>(i) * step];
      to[start + static_cast<std::size_t>(at % width) * step] = sum / (high - low + 1);
    }
    return to;
  };
  return along(along(grid, 1, guide_width), guide_width, 1);
}

Target target_of(std::span<const scene::Caster> casters) {
  Target target;
  for (const scene::Caster& caster : casters) {
    target.box.extend(caster.box);
    target.share = std::max(target.share, caster.share);
  }
  target.ball = ball_around(target.box);
  return target;
}

/// Whether a ray comes into a box. Source: Kay & Kajiya 1986.
bool meets(const Box3d& box, Vec3d origin, Vec3d direction) {
  double near = 0.0, far = infinity;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double inverse = 1.0 / direction[axis];
    double t0 = (box.min[axis] - origin[axis]) * inverse;
    double t1 = (box.max[axis] - origin[axis]) * inverse;
    if (t0 > t1) std::swap(t0, t1);
    // Not a number where the ray lies in the plane of a face: then this axis decides nothing.
    near = t0 > near ? t0 : near;
    far = t1 < far ? t1 : far;
  }
  return near <= far * (1.0 + 1e-9);
}

/// The point of the unit square that gives this direction of the cone.
template <typename Cone>
Vec2d square_of(const Cone& cone, Vec3d direction) {
  const Frame frame = Frame::from_normal(cone.axis);
  const Vec2d across{dot(direction, frame.tangent), dot(direction, frame.bitangent)};
  const double sine = std::hypot(across.x, across.y);
  if (sine == 0.0) return {0.5, 0.5};
  const double height = 0.5 * length_squared(direction - cone.axis);
  const double radius = std::min(std::sqrt(height / cone.one_minus_cos), 1.0 - 1e-15);
  return inside(concentric_square(across * (radius / sine)));
}

/// The point of the unit square that gives the place on the ball's disk across the direction.
Vec2d square_of(const Ball& ball, Vec3d p, Vec3d direction) {
  const Frame frame = Frame::from_normal(direction);
  const Vec3d from = (p - ball.center) / ball.radius;
  return inside(concentric_square({dot(from, frame.tangent), dot(from, frame.bitangent)}));
}

/// The place there that a point of the unit square gives.
Vec3d on_disc(const Ball& ball, Vec3d direction, Vec2d square) {
  const Vec2d disk = sample_uniform_disk(square) * ball.radius;
  const Frame frame = Frame::from_normal(direction);
  return ball.center + frame.tangent * disk.x + frame.bitangent * disk.y;
}

/// The radius of the disk across `axis`, in the middle of the box, that is crossed by all lines
/// from the ball to the box; the axis goes from the middle of one to that of the other. Nothing
/// where lines come in so flat that it would be very large, or from all sides.
std::optional<double> disc_radius(const Ball& from, Vec3d axis, const Box3d& box) {
  constexpr double most_slope = 3.0;
  double radius = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3d p{corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                  corner & 4 ? box.max.z : box.min.z};
    const double along = dot(p - from.center, axis);
    const double aside = length(p - from.center - axis * along);
    const double sine = from.radius / std::hypot(along, aside);
    if (!(along > 0.0 && sine < 1.0)) return {};
    const double slope = std::tan(std::atan2(aside, along) + std::asin(sine));
    if (!(slope >= 0.0 && slope <= most_slope)) return {};
    radius = std::max(radius, aside + slope * std::abs(dot(p - box.center(), axis)));
  }
  return radius;
}

/// Of other lights the surface at a place that was drawn is known only when a ray has met it.
bool knows_density_by_place(const light::Light& light) {
  return std::holds_alternative<light::SphereLight>(light) ||
         std::holds_alternative<light::RectangleLight>(light) ||
         std::holds_alternative<light::DiskLight>(light);
}

/// Whether the line through p along `direction` passes through the ball.
bool passes_through(const Ball& ball, Vec3d p, Vec3d direction) {
  const Vec3d to = p - ball.center;
  return length_squared(to - direction * dot(to, direction)) <= ball.radius * ball.radius;
}

}  // namespace

std::vector<Target> gather_targets(std::span<const scene::Caster> casters, const Box3d& scene_box,
                                   std::size_t most) {
  std::vector<scene::Caster> bounded;
  for (scene::Caster caster : casters) {
    caster.box = caster.box.intersect(scene_box);
    if (caster.box.bounded()) bounded.push_back(caster);
  }
  if (bounded.empty()) return {};
  // Cut the group whose ball is largest at the middle of its longest side, again and again.
  using Group = std::span<scene::Caster>;
  std::vector<std::pair<Group, Target>> groups{{Group(bounded), target_of(bounded)}};
  while (groups.size() < most) {
    const auto size = [](const auto& g) {
      return g.first.size() > 1 ? g.second.ball.radius : -1.0;
    };
    const auto largest =
        std::max_element(groups.begin(), groups.end(),
                         [&](const auto& a, const auto& b) { return size(a) < size(b); });
    if (size(*largest) < 0.0) break;
    const Group group = largest->first;
    Box3d centers;
    for (const scene::Caster& caster : group) centers.extend(caster.box.center());
    const Vec3d extent = centers.extent();
    const std::size_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                             : extent.y >= extent.z                       ? 1
                                                                          : 2;
    const auto middle = group.begin() + static_cast<std::ptrdiff_t>(group.size() / 2);
    std::nth_element(group.begin(), middle, group.end(), [axis](const auto& a, const auto& b) {
      return a.box.center()[axis] < b.box.center()[axis];
    });
    const Group first(group.begin(), middle), second(middle, group.end());
    *largest = {first, target_of(first)};
    groups.emplace_back(second, target_of(second));
  }
  std::vector<Target> targets;
  for (const auto& group : groups) targets.push_back(group.second);
  return targets;
}

PhotonEmitter::PhotonEmitter(const scene::Scene& scene, Aim aim) : scene_(scene), aim_(aim) {
  const Box3d box = scene.world().bounds();
  if (box.empty() && aim == Aim::casters) return;
  around_ = box.empty() ? Ball{{}, 1.0} : ball_around(box);
  const geometry::SolidScene& solids = scene.world().solids();
  const bool is_bounded = solids.world().unbounded().empty() && solids.regions_at_rest().empty();
  if (aim != Aim::casters && !is_bounded) around_.radius *= 2.0;
  if (aim != Aim::nowhere) targets_ = gather_targets(scene.casters(), box, most_targets);
  if (targets_.empty() && aim == Aim::casters) return;
  all_bounded_ = std::all_of(scene.casters().begin(), scene.casters().end(),
                             [](const scene::Caster& caster) { return caster.box.bounded(); });
  std::vector<double> weights;
  for (std::uint32_t light = 0; light < scene.lights().size(); ++light) {
    first_.push_back(static_cast<std::uint32_t>(proposals_.size()));
    add_proposals(light, weights);
  }
  first_.push_back(static_cast<std::uint32_t>(proposals_.size()));
  double total = 0.0;
  for (const double weight : weights) total += weight;
  if (!(total > 0.0)) return;
  set_probabilities(weights);
}

void PhotonEmitter::set_probabilities(std::span<const double> weights) {
  chosen_.emplace(weights);
  for (std::size_t i = 0; i < proposals_.size(); ++i) {
    proposals_[i].probability = chosen_->probability(i);
  }
}

void PhotonEmitter::learn(std::span<const Lesson> lessons, std::uint32_t emitted) {
  constexpr std::size_t cells = guide_width * guide_width;
  std::vector<std::vector<double>> wanted(proposals_.size());
  std::vector<std::size_t> seen(proposals_.size());
  for (const auto& [origin, worth] : lessons) {
    std::vector<double>& grid = wanted[origin.proposal];
    grid.resize(cells);
    const auto along = [](double u) {
      return std::min(static_cast<std::size_t>(u * guide_width), guide_width - 1);
    };
    grid[along(origin.square.y) * guide_width + along(origin.square.x)] += worth;
    ++seen[origin.proposal];
  }
  std::vector<double> weights(proposals_.size());
  double all = 0.0;
  for (std::size_t i = 0; i < proposals_.size(); ++i) {
    for (std::size_t cell = 0; cell < wanted[i].size(); ++cell) {
      wanted[i][cell] *= emitted * proposals_[i].probability * density_of_cell(i, cell) / cells;
    }
    if (seen[i] > 0) wanted[i] = smoothed(wanted[i], seen[i]);
    for (double& value : wanted[i]) {
      value = std::sqrt(value);
      weights[i] += value;
    }
    all += weights[i];
  }
  if (!(all > 0.0)) return;
  for (std::size_t i = 0; i < proposals_.size(); ++i) {
    // Of a few photons a grid would know little.
    if (seen[i] >= guide_width && weights[i] > 0.0) {
      for (std::size_t cell = 0; cell < cells; ++cell) {
        const double before = density_of_cell(i, cell) * weights[i] / cells;
        wanted[i][cell] = std::lerp(wanted[i][cell], before, kept_share);
      }
      proposals_[i].guide.emplace(wanted[i], guide_width);
    }
    weights[i] = std::lerp(weights[i] / all, proposals_[i].probability, kept_share);
  }
  set_probabilities(weights);
}

/// The density on a proposal's square in a cell of the grid.
double PhotonEmitter::density_of_cell(std::size_t proposal, std::size_t cell) const {
  return proposals_[proposal].density(
      {(static_cast<double>(cell % guide_width) + 0.5) / guide_width,
       (static_cast<double>(cell / guide_width) + 0.5) / guide_width});
}

/// By the light that reaches the target, or the scene.
void PhotonEmitter::add_proposals(std::uint32_t index, std::vector<double>& weights) {
  const light::Light& light = scene_.lights()[index];
  const light::Influence influence = light::influence(light);
  const double whole = light::power(light, around_.radius);
  if (!(whole > 0.0)) return;
  const auto own = light::bounding_ball(light);
  double aimed = 0.0;
  for (std::uint32_t i = 0; i < targets_.size(); ++i) {
    const Ball& ball = targets_[i].ball;
    Cone cone;
    if (own) {
      const Vec3d to = ball.center - own->center;
      const double distance = length(to), reach = ball.radius + own->radius;
      if (distance > reach) {
        const double sine = reach / distance;
        cone = {to / distance, sine * sine / (1.0 + std::sqrt(1.0 - sine * sine))};
      }
    }
    // Light of the flat side, of which some reaches a ball whose centre lies behind.
    const double irradiance = std::max(influence.at(ball.center),
                                       influence.at(ball.center + influence.front * ball.radius));
    const double reaches =
        std::clamp(irradiance * pi * ball.radius * ball.radius, least_reaching * whole, whole);
    const double weight = reaches * targets_[i].share;
    proposals_.push_back({index, i, cone, {}});
    if (knows_density_by_place(light)) {
      const Vec3d axis = normalize(ball.center - own->center);
      const auto radius = disc_radius(*own, axis, targets_[i].box);
      if (radius) proposals_.back().disc = Disc{axis, *radius};
    }
    weights.push_back(weight);
    aimed += weight;
  }
  Cone lobe;
  if (influence.reach == light::Influence::Reach::in_front) lobe = {influence.front, 1.0};
  if (influence.reach == light::Influence::Reach::in_cone) {
    lobe = {influence.front, std::min(2.0, 1.0 - influence.normal_cosine + 1e-9)};
  }
  proposals_.push_back({index, no_target, lobe, {}});
  weights.push_back(aim_ == Aim::casters ? aimed * unaimed_share / (1.0 - unaimed_share) : whole);
}

std::span<const PhotonEmitter::Proposal> PhotonEmitter::proposals_of(std::uint32_t light) const {
  return std::span(proposals_).subspan(first_[light], first_[light + 1] - first_[light]);
}

double PhotonEmitter::density_of_rays(std::uint32_t light, Vec3d direction,
                                      const light::LightHit& hit, double pdf_on_light) const {
  double sum = 0.0;
  for (const Proposal& proposal : proposals_of(light)) {
    if (proposal.disc) {
      sum += density_through(proposal, direction, hit);
      continue;
    }
    const Cone& cone = proposal.cone;
    // As pdf_uniform_cone, which wants local coordinates: the chord keeps narrow cones exact.
    const double height = 0.5 * length_squared(direction - cone.axis);
    if (!(height <= cone.one_minus_cos * (1.0 + 1e-12))) continue;
    const double uniform =
        proposal.probability * pdf_uniform_cone(cone.one_minus_cos) * pdf_on_light;
    sum += proposal.guide ? uniform * proposal.density(square_of(cone, direction)) : uniform;
  }
  return sum;
}

double PhotonEmitter::density_through(const Proposal& proposal, Vec3d direction,
                                      const light::LightHit& hit) const {
  const auto& [axis, radius] = *proposal.disc;
  const double cosine = dot(direction, axis);
  if (!(cosine > 0.0)) return 0.0;
  const Vec3d center = ball_of(proposal).center;
  const Vec3d place = hit.point + direction * (dot(center - hit.point, axis) / cosine);
  if (!(length_squared(place - center) <= radius * radius)) return 0.0;
  const double arrives =
      light::pdf_illumination(scene_.lights()[proposal.light], place, -direction, hit);
  const double on_disc =
      proposal.density(square_of({center, radius}, place, axis)) / (pi * radius * radius);
  return proposal.probability * arrives * on_disc / cosine;
}

double PhotonEmitter::density_of_places(std::uint32_t light, Vec3d p, Vec3d direction) const {
  double sum = 0.0;
  for (const Proposal& proposal : proposals_of(light)) {
    const Ball& ball = ball_of(proposal);
    if (!passes_through(ball, p, direction)) continue;
    const double uniform = proposal.probability / (pi * ball.radius * ball.radius);
    sum += proposal.guide ? uniform * proposal.density(square_of(ball, p, direction)) : uniform;
  }
  return sum;
}

// By whichever proposal: the density is that of all of them.
bool PhotonEmitter::may_meet(Vec3d origin, Vec3d direction) const {
  if (aim_ != Aim::casters || !all_bounded_) return true;
  return std::any_of(targets_.begin(), targets_.end(),
                     [&](const Target& target) { return meets(target.box, origin, direction); });
}

std::optional<PhotonEmitter::Emission> PhotonEmitter::sample(const Numbers& numbers,
                                                             const Wavelengths& wavelengths) const {
  const DiscreteDistribution::Sample choice = chosen_->sample(numbers.proposal);
  const Proposal& proposal = proposals_[choice.index];
  const bool is_infinite = light::is_infinite(scene_.lights()[proposal.light]);
  const Vec2d u = is_infinite || proposal.disc ? numbers.place : numbers.direction;
  const Origin origin{static_cast<std::uint32_t>(choice.index),
                      proposal.guide ? proposal.guide->sample(u).point : u};
  auto emission = is_infinite ? sample_infinite(origin, numbers, choice.remainder, wavelengths)
                  : proposal.disc
                      ? sample_through_disc(origin, numbers, choice.remainder, wavelengths)
                      : sample_finite(origin, numbers, choice.remainder, wavelengths);
  if (emission) emission->ray.time = numbers.time;
  return emission;
}

PhotonEmitter::Emission PhotonEmitter::emission_of(const Origin& origin, SampledSpectrum L,
                                                   double density, light::Extent extent) const {
  Emission emission;
  emission.origin = origin;
  emission.light = proposals_[origin.proposal].light;
  emission.power = L * static_cast<float>(1.0 / density);
  emission.density = density;
  emission.extent = extent;
  return emission;
}

std::optional<PhotonEmitter::Emission> PhotonEmitter::sample_finite(
    const Origin& origin, const Numbers& numbers, double part,
    const Wavelengths& wavelengths) const {
  const Proposal& proposal = proposals_[origin.proposal];
  const Vec3d local = sample_uniform_cone(origin.square, proposal.cone.one_minus_cos);
  const Vec3d direction = normalize(Frame::from_normal(proposal.cone.axis).to_world(local));
  const auto from = light::sample_departure(scene_.lights()[proposal.light], direction,
                                            {part, numbers.place, numbers.time}, wavelengths);
  if (!from || !may_meet(from->point, direction)) return {};
  const light::LightHit at{from->point, from->normal, {}, numbers.time};
  const double density = density_of_rays(proposal.light, direction, at, from->pdf);
  if (!(density > 0.0 && std::isfinite(density))) return {};
  Emission emission = emission_of(origin, from->L, density, from->extent);
  emission.ray.origin = from->point;
  emission.ray.direction = direction;
  emission.on_leaf = from->on_leaf;
  emission.from_surface = from->extent == light::Extent::area;
  return emission;
}

std::optional<PhotonEmitter::Emission> PhotonEmitter::sample_through_disc(
    const Origin& origin, const Numbers& numbers, double part,
    const Wavelengths& wavelengths) const {
  const Proposal& proposal = proposals_[origin.proposal];
  const light::Light& light = scene_.lights()[proposal.light];
  const auto& [axis, radius] = *proposal.disc;
  const Vec3d place = on_disc({ball_of(proposal).center, radius}, axis, origin.square);
  const auto from = light::sample_illumination(
      light, place, {part, numbers.direction, numbers.time}, wavelengths);
  if (!from) return {};
  const Vec3d direction = -from->wi, point = place + from->wi * from->distance;
  if (!may_meet(point, direction)) return {};
  // These lights ask a normal for its side alone.
  const light::LightHit at{point, direction, {}, numbers.time};
  const double density =
      density_of_rays(proposal.light, direction, at, light::pdf_departure(light, direction, at));
  if (!(density > 0.0 && std::isfinite(density))) return {};
  Emission emission = emission_of(origin, from->L, density, from->extent);
  emission.ray.origin = point;
  emission.ray.direction = direction;
  emission.from_surface = true;
  return emission;
}

std::optional<PhotonEmitter::Emission> PhotonEmitter::sample_infinite(
    const Origin& origin, const Numbers& numbers, double part,
    const Wavelengths& wavelengths) const {
  const Proposal& proposal = proposals_[origin.proposal];
  const Ball& ball = ball_of(proposal);
  const auto from =
      light::sample_illumination(scene_.lights()[proposal.light], ball.center,
                                 {part, numbers.direction, numbers.time}, wavelengths);
  if (!from) return {};
  const Vec3d direction = -from->wi;
  const Vec3d across = on_disc(ball, direction, origin.square);
  // From behind everything, as seen along the ray.
  const double back = dot(across - around_.center, direction) + 1.01 * around_.radius;
  const Vec3d start = across - direction * back;
  if (!may_meet(start, direction)) return {};
  const double density = from->pdf * density_of_places(proposal.light, across, direction);
  if (!(density > 0.0 && std::isfinite(density))) return {};
  Emission emission = emission_of(origin, from->L, density, from->extent);
  emission.ray.origin = start;
  emission.ray.direction = direction;
  return emission;
}

double PhotonEmitter::density(std::uint32_t index, Vec3d p, Vec3d wi,
                              const light::LightHit& hit) const {
  const light::Light& light = scene_.lights()[index];
  if (light::is_delta(light)) return 0.0;
  if (light::is_infinite(light)) {
    return light::pdf_illumination(light, p, wi, hit) * density_of_places(index, p, -wi);
  }
  return density_of_rays(index, -wi, hit, light::pdf_departure(light, -wi, hit));
}

}  // namespace lapidary::transport
