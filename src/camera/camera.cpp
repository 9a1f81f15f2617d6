#include "camera/camera.h"

#include "sampling/warp.h"

namespace lapidary::camera {
namespace {

using geometry::Ray;

/// Film coordinates to the picture plane: right and up positive, in [-1, 1].
Vec2d screen(Vec2d film) {
  return {2.0 * film.x - 1.0, 1.0 - 2.0 * film.y};
}

Ray generate(const Perspective& c, Vec2d film, Vec2d lens) {
  const Vec2d s = screen(film);
  const Vec3d pinhole{s.x * c.half_width, s.y * c.half_height, -1.0};
  Ray ray;
  if (c.lens_radius == 0.0) {
    ray.origin = c.position;
    ray.direction = normalize(c.frame.to_world(pinhole));
    return ray;
  }
  const Vec2d disk = sample_uniform_disk(lens) * c.lens_radius;
  const Vec3d start{disk.x, disk.y, 0.0};
  ray.origin = c.position + c.frame.to_world(start);
  ray.direction = normalize(c.frame.to_world(pinhole * c.focus_distance - start));
  return ray;
}

Ray generate(const Orthographic& c, Vec2d film, Vec2d) {
  const Vec2d s = screen(film);
  Ray ray;
  ray.origin = c.position + c.frame.to_world({s.x * c.half_width, s.y * c.half_height, 0.0});
  ray.direction = -c.frame.normal;
  return ray;
}

// A share of a pixel.
constexpr double cone_share = 0.5;

Cone cone_of(const Perspective& c, Vec2d pixels) {
  return {0.0, cone_share * 2.0 * c.half_height / pixels.y};
}

Cone cone_of(const Orthographic& c, Vec2d pixels) {
  return {cone_share * 2.0 * c.half_height / pixels.y, 0.0};
}

}  // namespace

Frame look_at(Vec3d from, Vec3d at, Vec3d up) {
  const Vec3d back = normalize(from - at);
  const Vec3d right = normalize(cross(up, back));
  return {right, cross(back, right), back};
}

Ray generate_ray(const Camera& camera, Vec2d film, Vec2d lens) {
  return std::visit([&](const auto& c) { return generate(c, film, lens); }, camera);
}

Cone pixel_cone(const Camera& camera, Vec2d pixels) {
  return std::visit([&](const auto& c) { return cone_of(c, pixels); }, camera);
}

double depth(const Camera& camera, Vec3d p) {
  return std::visit([&](const auto& c) { return dot(c.position - p, c.frame.normal); }, camera);
}

}  // namespace lapidary::camera
