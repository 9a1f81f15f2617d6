#include "scene/prepare_camera.h"

#include <cmath>

namespace lapidary::scene {
namespace {

using camera::FisheyeMapping;
using description::FovAxis;
using description::PictureSize;

/// Half the picture's width and height where half the side that `axis` names is `half`.
Vec2d half_extent(double half, FovAxis axis, const PictureSize& size) {
  const double width = size.width, height = size.height;
  const bool along_x = axis == FovAxis::x || (axis == FovAxis::shorter && width < height);
  return along_x ? Vec2d{half, half * height / width} : Vec2d{half * width / height, half};
}

Interval in_radians(Vec2d range) {
  return {radians(range.x), radians(range.y)};
}

camera::Camera prepare(const description::Perspective& p, const PictureSize& size) {
  const Vec2d half = half_extent(std::tan(radians(0.5 * p.fov)), p.fov_axis, size);
  camera::Perspective c;
  c.half_width = half.x;
  c.half_height = half.y;
  c.shift = p.shift * (2.0 * std::max(half.x, half.y));
  c.aperture = {0.5 * p.aperture, p.blades, radians(p.blade_rotation), p.anamorphic};
  c.focus.distance = p.focus_distance.value_or(length(p.view.at - p.view.from));
  c.focus.slope = {std::tan(radians(p.tilt.y)), std::tan(radians(p.tilt.x))};
  return {c, {p.view.from, camera::look_at(p.view.from, p.view.at, p.view.up)}};
}

camera::Camera prepare(const description::Orthographic& o, const PictureSize& size) {
  const Vec2d half = half_extent(0.5 * o.size, o.fov_axis, size);
  return {camera::Orthographic{half.x, half.y},
          {o.view.from, camera::look_at(o.view.from, o.view.at, o.view.up)}};
}

camera::Camera prepare(const description::Panorama& p, const PictureSize&) {
  return {camera::Panorama{in_radians(p.longitude), in_radians(p.latitude)},
          {p.view.from, camera::turn_to(p.view.from, p.view.at, p.view.up)}};
}

FisheyeMapping mapping_of(description::FisheyeMapping mapping) {
  switch (mapping) {
    case description::FisheyeMapping::equidistant:
      break;
    case description::FisheyeMapping::equisolid:
      return FisheyeMapping::equisolid;
    case description::FisheyeMapping::stereographic:
      return FisheyeMapping::stereographic;
    case description::FisheyeMapping::orthographic:
      return FisheyeMapping::orthographic;
  }
  return FisheyeMapping::equidistant;
}

camera::Camera prepare(const description::Fisheye& f, const PictureSize& size) {
  const Vec2d half = half_extent(1.0, f.fov_axis, size);
  return {camera::Fisheye{mapping_of(f.mapping), radians(0.5 * f.fov), half.x, half.y},
          {f.view.from, camera::look_at(f.view.from, f.view.at, f.view.up)}};
}

}  // namespace

camera::Camera prepare_camera(const description::Camera& camera, const PictureSize& size) {
  return std::visit([&](const auto& model) { return prepare(model, size); }, camera.model);
}

}  // namespace lapidary::scene
