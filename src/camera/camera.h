#pragma once

#include <variant>

#include "camera/cone.h"
#include "geometry/ray.h"
#include "math/frame.h"
#include "math/vec.h"

namespace lapidary::camera {

/// A pinhole or thin-lens camera. The lens is a disk of radius `lens_radius` about `position`,
/// across the view direction; the plane at `focus_distance` along it is sharp.
struct Perspective {
  Vec3d position;
  Frame frame;  ///< tangent: picture right, bitangent: picture up, normal: against the view
  double half_width = 1;  ///< of the picture, at distance 1
  double half_height = 1;
  double lens_radius = 0;
  double focus_distance = 1;
};

/// Parallel rays along the view direction.
struct Orthographic {
  Vec3d position;
  Frame frame;
  double half_width = 1;  ///< of the picture, in scene units
  double half_height = 1;
};

using Camera = std::variant<Perspective, Orthographic>;

/// The frame of a camera at `from` that looks at `at` with `up` upright in the picture.
/// Preconditions: from != at; `up` not along the view.
Frame look_at(Vec3d from, Vec3d at, Vec3d up);

/// A ray through `film`, each coordinate in [0, 1] from the top left corner, from the point of
/// the lens that `lens` in [0, 1)^2 picks uniformly. The direction has unit length.
geometry::Ray generate_ray(const Camera& camera, Vec2d film, Vec2d lens);

/// The cone of the rays through a pixel of a picture of `pixels.x` x `pixels.y`: half of a pixel
/// wide, since samples are spread over the pixel themselves.
Cone pixel_cone(const Camera& camera, Vec2d pixels);

/// How far `p` lies from the camera's plane along the view direction: the depth layer's value.
double depth(const Camera& camera, Vec3d p);

}  // namespace lapidary::camera
