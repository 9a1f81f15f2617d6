#include "scene/prepare_camera.h"

#include <cmath>

namespace lapidary::scene {
namespace {

using description::FovAxis;
using description::PictureSize;

/// Half the picture's width and height where half the side that `axis` names is `half`.
Vec2d half_extent(double half, FovAxis axis, const PictureSize& size) {
  const double width = size.width, height = size.height;
  const bool along_x = axis == FovAxis::x || (axis == FovAxis::shorter && width < height);
  return along_x ? Vec2d{half, half * height / width} : Vec2d{half * width / height, half};
}

camera::Camera prepare(const description::Perspective& p, const PictureSize& size) {
  const Vec2d half = half_extent(std::tan(radians(0.5 * p.fov)), p.fov_axis, size);
  camera::Perspective c;
  c.position = p.view.from;
  c.frame = camera::look_at(p.view.from, p.view.at, p.view.up);
  c.half_width = half.x;
  c.half_height = half.y;
  c.lens_radius = 0.5 * p.aperture;
  c.focus_distance = p.focus_distance.value_or(length(p.view.at - p.view.from));
  return c;
}

camera::Camera prepare(const description::Orthographic& o, const PictureSize& size) {
  const Vec2d half = half_extent(0.5 * o.size, o.fov_axis, size);
  return camera::Orthographic{o.view.from, camera::look_at(o.view.from, o.view.at, o.view.up),
                              half.x, half.y};
}

}  // namespace

camera::Camera prepare_camera(const description::Camera& camera, const PictureSize& size) {
  return std::visit([&](const auto& model) { return prepare(model, size); }, camera.model);
}

}  // namespace lapidary::scene
