#pragma once

#include <optional>
#include <variant>

#include "camera/cone.h"
#include "camera/pose.h"
#include "geometry/ray.h"
#include "math/interval.h"
#include "math/vec.h"

namespace lapidary::camera {

/// The opening that a lens lets light through, across the view and used evenly.
struct Aperture {
  double radius = 0;      ///< of the circle that its corners lie on; 0: a pinhole
  int blades = 0;         ///< corners of a regular polygon, the first to the right; 0: round
  double rotation = 0;    ///< counter-clockwise as the camera sees it, radians
  double anamorphic = 1;  ///< how many times taller than wide
};

/// The plane that a thin lens shows sharply. At the place (x, y) right of and above the view's axis
/// it lies at the distance `distance + slope.x x + slope.y y` along the view.
struct FocusPlane {
  double distance = 1;  ///< > 0
  Vec2d slope;
};

/// A pinhole or thin-lens camera.
///
/// The rays of one point of the film start on the aperture and meet in one point of the focus
/// plane, or would do so behind the lens. The picture is that of a film across the view, so a
/// tilted focus plane leaves the perspective as it is.
struct Perspective {
  double half_width = 1;  ///< of the picture, at distance 1
  double half_height = 1;
  Vec2d shift;  ///< of the picture's middle off the view's axis, at distance 1; right and up
  Aperture aperture;
  FocusPlane focus;
};

/// Parallel rays along the view direction.
struct Orthographic {
  double half_width = 1;  ///< of the picture, in scene units
  double half_height = 1;
};

/// Longitude along x and latitude along y (equirectangular), as the picture of an environment is
/// laid out: the view at (0, 0), greater longitudes to its right, greater latitudes above.
struct Panorama {
  Interval longitude{-pi, pi};             ///< of the left and the right edge, radians
  Interval latitude{-0.5 * pi, 0.5 * pi};  ///< of the lower and the upper edge
};

/// How the distance r from a fisheye picture's middle grows with the angle theta to the view.
enum class FisheyeMapping {
  equidistant,    ///< r ~ theta
  equisolid,      ///< r ~ sin(theta / 2): equal solid angles have equal areas
  stereographic,  ///< r ~ tan(theta / 2): small shapes are kept
  orthographic,   ///< r ~ sin(theta): the sphere as seen from far away
};

/// A picture inside of a circle, with nothing around it.
struct Fisheye {
  FisheyeMapping mapping = FisheyeMapping::equidistant;
  /// Between the view and the circle, radians: at most pi, less than that if stereographic and at
  /// most pi / 2 if orthographic.
  double half_angle = 0.5 * pi;
  double half_width = 1;  ///< of the picture, where the circle's radius is 1
  double half_height = 1;
};

struct Camera {
  std::variant<Perspective, Orthographic, Panorama, Fisheye> model;
  Pose pose;                         ///< at time 0, when the frame begins
  std::optional<PoseMotion> motion;  ///< from there to time 1; none: it stands still
  Interval shutter{0, 1};            ///< when light is taken, within [0, 1]

  Pose pose_at(double time) const { return motion ? motion->at(time) : pose; }
};

/// The numbers of a ray.
struct CameraSample {
  Vec2d film;       ///< from (0, 0) at the top left corner of the picture to (1, 1)
  Vec2d lens;       ///< in [0, 1)^2, for a point of the aperture
  double time = 0;  ///< in [0, 1), from the opening of the shutter to its closing
};

/// The ray that sees a point of the film, and when (Ray::time); nothing where the camera shows
/// nothing. The direction has unit length.
std::optional<geometry::Ray> generate_ray(const Camera& camera, const CameraSample& sample);

/// The cone of the rays through a pixel of a picture of `pixels.x` x `pixels.y`, in its middle:
/// half of a pixel wide, since samples are spread over the pixel themselves.
Cone pixel_cone(const Camera& camera, Vec2d pixels);

/// The depth layer's value for a point that the camera sees at that time: how far it lies from the
/// camera's plane along the view, or, of a panorama and a fisheye, which have no such plane, from
/// the camera.
double depth(const Camera& camera, Vec3d p, double time);

}  // namespace lapidary::camera
