#pragma once

#include <optional>
#include <variant>

#include "math/vec.h"
#include "schema/call_site.h"

namespace lapidary::description {

/// Where a camera stands and looks; `at` differs from `from`, and `up` is not parallel to the view.
struct View {
  Vec3d from{0, -5, 2};
  Vec3d at;
  Vec3d up{0, 0, 1};
};

/// Which part of a frame, that lasts from 0 to 1, the picture is taken in: open <= close.
struct Shutter {
  double open = 0;
  double close = 1;
};

/// Which side of the picture an opening spans.
enum class FovAxis { shorter, x, y };

/// A thin-lens camera; a pinhole when `aperture` is 0.
struct Perspective {
  View view;
  double fov = 40;  ///< degrees, in (0, 180)
  FovAxis fov_axis = FovAxis::shorter;
  double aperture = 0;  ///< diameter of the lens, scene units
  /// Where the view's axis meets the sharp plane, scene units; none: in `at`.
  std::optional<double> focus_distance;
  int blades = 0;             ///< corners of the aperture, at least 3; 0: it is round
  double blade_rotation = 0;  ///< degrees, counter-clockwise as the camera sees it
  double anamorphic = 1;      ///< how many times taller than wide the aperture is
  Vec2d shift;                ///< of the picture to the right and up, in shares of its longer side
  Vec2d tilt;  ///< of the sharp plane, degrees in (-90, 90): its top, its right side leaning away
};

/// Parallel projection.
struct Orthographic {
  View view;
  double size = 2;  ///< extent of the picture along `fov_axis`, scene units
  FovAxis fov_axis = FovAxis::shorter;
};

/// Everything around: longitude and latitude. The camera does not lean, whatever `at`.
struct Panorama {
  View view;
  Vec2d longitude{-180, 180};  ///< degrees, ascending, at most 360 apart; 0 towards `at`
  Vec2d latitude{-90, 90};     ///< degrees, ascending; 0 level
};

enum class FisheyeMapping { equidistant, equisolid, stereographic, orthographic };

/// A round picture with nothing around it.
struct Fisheye {
  View view;
  double fov = 180;  ///< degrees across the circle, as far as the mapping goes
  FovAxis fov_axis = FovAxis::shorter;
  FisheyeMapping mapping = FisheyeMapping::equidistant;
};

struct Camera {
  std::variant<Perspective, Orthographic, Panorama, Fisheye> model;
  schema::CallSite where;
  Shutter shutter = {};
  /// When the frame ends, if it moves: the position goes there straight, the view turns there
  /// evenly. What is sharp stays as far away as it was.
  std::optional<View> view_at_end = {};
};

}  // namespace lapidary::description
