#include "camera/camera.h"

#include <cmath>

#include "sampling/regular_polygon.h"
#include "sampling/warp.h"

namespace lapidary::camera {
namespace {

using geometry::Ray;

/// Film coordinates to the picture plane: right and up positive, in [-1, 1].
Vec2d screen(Vec2d film) {
  return {2.0 * film.x - 1.0, 1.0 - 2.0 * film.y};
}

Ray ray_of(Vec3d origin, Vec3d direction) {
  Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  return ray;
}

Vec2d point_of(const Aperture& a, Vec2d u) {
  if (a.blades == 0) {
    const Vec2d p = sample_uniform_disk(u) * a.radius;
    return {p.x / a.anamorphic, p.y};
  }
  const Vec2d p = sample_regular_polygon(u, a.blades) * a.radius;
  const double c = std::cos(a.rotation), s = std::sin(a.rotation);
  return {(p.x * c - p.y * s) / a.anamorphic, p.x * s + p.y * c};
}

// The pinhole's ray through the lens's centre, (x, y, 1) t along the view, meets the focus plane at
// t = distance / nearness with nearness = 1 - slope . (x, y), and all other rays of that point of
// the film do so there, too: from the point l of the aperture towards (x, y, 1) t - l. Divided by
// t, that holds beyond nearness = 0, where they meet in front of nothing and diverge.
std::optional<Ray> generate(const Perspective& c, const Pose& pose, const CameraSample& sample) {
  const Vec2d s = screen(sample.film);
  const Vec3d pinhole{s.x * c.half_width + c.shift.x, s.y * c.half_height + c.shift.y, -1.0};
  if (c.aperture.radius == 0.0) {
    return ray_of(pose.position, normalize(pose.frame.to_world(pinhole)));
  }
  const Vec2d l = point_of(c.aperture, sample.lens);
  const Vec3d start{l.x, l.y, 0.0};
  const double nearness = 1.0 - c.focus.slope.x * pinhole.x - c.focus.slope.y * pinhole.y;
  const Vec3d direction = pinhole * c.focus.distance - start * nearness;
  return ray_of(pose.position + pose.frame.to_world(start),
                normalize(pose.frame.to_world(direction)));
}

std::optional<Ray> generate(const Orthographic& c, const Pose& pose, const CameraSample& sample) {
  const Vec2d s = screen(sample.film);
  const Vec3d start{s.x * c.half_width, s.y * c.half_height, 0.0};
  return ray_of(pose.position + pose.frame.to_world(start), -pose.frame.normal);
}

std::optional<Ray> generate(const Panorama& c, const Pose& pose, const CameraSample& sample) {
  const double longitude = c.longitude.min + sample.film.x * c.longitude.length();
  const double latitude = c.latitude.max - sample.film.y * c.latitude.length();
  const double level = std::cos(latitude);
  const Vec3d direction{std::sin(longitude) * level, std::sin(latitude),
                        -std::cos(longitude) * level};
  return ray_of(pose.position, normalize(pose.frame.to_world(direction)));
}

/// The angle to the view at the distance `r` from the middle, in shares of the circle's radius.
double angle_at(const Fisheye& c, double r) {
  switch (c.mapping) {
    case FisheyeMapping::equidistant:
      break;
    case FisheyeMapping::equisolid:
      return 2.0 * std::asin(r * std::sin(0.5 * c.half_angle));
    case FisheyeMapping::stereographic:
      return 2.0 * std::atan(r * std::tan(0.5 * c.half_angle));
    case FisheyeMapping::orthographic:
      return std::asin(r * std::sin(c.half_angle));
  }
  return r * c.half_angle;
}

std::optional<Ray> generate(const Fisheye& c, const Pose& pose, const CameraSample& sample) {
  const Vec2d s = screen(sample.film);
  const Vec2d p{s.x * c.half_width, s.y * c.half_height};
  const double r = std::hypot(p.x, p.y);
  if (r > 1.0) return std::nullopt;
  const double angle = angle_at(c, r);
  const double aside = r > 0.0 ? std::sin(angle) / r : 0.0;
  const Vec3d direction{p.x * aside, p.y * aside, -std::cos(angle)};
  return ray_of(pose.position, normalize(pose.frame.to_world(direction)));
}

/// A share of a pixel.
constexpr double cone_share = 0.5;

Cone cone_of(const Perspective& c, Vec2d pixels) {
  return {0.0, cone_share * 2.0 * c.half_height / pixels.y};
}
Cone cone_of(const Orthographic& c, Vec2d pixels) {
  return {cone_share * 2.0 * c.half_height / pixels.y, 0.0};
}
Cone cone_of(const Panorama& c, Vec2d pixels) {
  return {0.0, cone_share * c.latitude.length() / pixels.y};
}
Cone cone_of(const Fisheye& c, Vec2d pixels) {
  return {0.0, cone_share * 2.0 * c.half_height * c.half_angle / pixels.y};
}

template <typename Model>
constexpr bool has_plane =
    std::is_same_v<Model, Perspective> || std::is_same_v<Model, Orthographic>;

}  // namespace

std::optional<Ray> generate_ray(const Camera& camera, const CameraSample& sample) {
  const double time = camera.shutter.min + sample.time * camera.shutter.length();
  const Pose pose = camera.pose_at(time);
  auto ray =
      std::visit([&](const auto& model) { return generate(model, pose, sample); }, camera.model);
  if (ray) ray->time = time;
  return ray;
}

Cone pixel_cone(const Camera& camera, Vec2d pixels) {
  return std::visit([&](const auto& model) { return cone_of(model, pixels); }, camera.model);
}

double depth(const Camera& camera, Vec3d p, double time) {
  const Pose pose = camera.pose_at(time);
  const Vec3d back = pose.position - p;
  return std::visit(
      [&]<typename Model>(const Model&) {
        return has_plane<Model> ? dot(back, pose.frame.normal) : length(back);
      },
      camera.model);
}

}  // namespace lapidary::camera
