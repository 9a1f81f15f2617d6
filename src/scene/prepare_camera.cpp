#include "scene/prepare_camera.h"

#include <cmath>

namespace lapidary::scene {
namespace {

using camera::FisheyeMapping;
using description::FovAxis;
using description::PictureSize;
using Model = decltype(camera::Camera::model);

/// Half the picture's width and height where half the side that `axis` names is `half`.
Vec2d half_extent(double half, FovAxis axis, const PictureSize& size) {
  const double width = size.width, height = size.height;
  const bool along_x = axis == FovAxis::x || (axis == FovAxis::shorter && width < height);
  return along_x ? Vec2d{half, half * height / width} : Vec2d{half * width / height, half};
}

Interval in_radians(Vec2d range) {
  return {radians(range.x), radians(range.y)};
}

Model prepare(const description::Perspective& p, const PictureSize& size) {
  const Vec2d half = half_extent(std::tan(radians(0.5 * p.fov)), p.fov_axis, size);
  camera::Perspective c;
  c.half_width = half.x;
  c.half_height = half.y;
  c.shift = p.shift * (2.0 * std::max(half.x, half.y));
  c.aperture = {0.5 * p.aperture, p.blades, radians(p.blade_rotation), p.anamorphic};
  c.focus.distance = p.focus_distance.value_or(length(p.view.at - p.view.from));
  c.focus.slope = {std::tan(radians(p.tilt.y)), std::tan(radians(p.tilt.x))};
  return c;
}

Model prepare(const description::Orthographic& o, const PictureSize& size) {
  const Vec2d half = half_extent(0.5 * o.size, o.fov_axis, size);
  return camera::Orthographic{half.x, half.y};
}

Model prepare(const description::Panorama& p, const PictureSize&) {
  return camera::Panorama{in_radians(p.longitude), in_radians(p.latitude)};
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

Model prepare(const description::Fisheye& f, const PictureSize& size) {
  const Vec2d half = half_extent(1.0, f.fov_axis, size);
  return camera::Fisheye{mapping_of(f.mapping), radians(0.5 * f.fov), half.x, half.y};
}

template <typename DescribedModel>
camera::Pose pose_of(const DescribedModel&, const description::View& view) {
  constexpr bool leans = !std::is_same_v<DescribedModel, description::Panorama>;
  const auto frame = leans ? camera::look_at : camera::turn_to;
  return {view.from, frame(view.from, view.at, view.up)};
}

}  // namespace

camera::Camera prepare_camera(const description::Camera& camera, const PictureSize& size) {
  return std::visit(
      [&](const auto& model) {
        camera::Camera prepared{prepare(model, size), pose_of(model, model.view)};
        if (camera.view_at_end) {
          prepared.motion.emplace(prepared.pose, pose_of(model, *camera.view_at_end));
        }
        prepared.shutter = {camera.shutter.open, camera.shutter.close};
        return prepared;
      },
      camera.model);
}

}  // namespace lapidary::scene
