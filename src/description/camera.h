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

/// Which side of the picture an opening spans.
enum class FovAxis { shorter, x, y };

/// A thin-lens camera; a pinhole when `aperture` is 0.
struct Perspective {
  View view;
  double fov = 40;  ///< degrees, in (0, 180)
  FovAxis fov_axis = FovAxis::shorter;
  double aperture = 0;  ///< diameter of the lens, scene units
  /// Distance of the sharp plane along the view, scene units; none: the plane through `at`.
  std::optional<double> focus_distance;
};

/// Parallel projection.
struct Orthographic {
  View view;
  double size = 2;  ///< extent of the picture along `fov_axis`, scene units
  FovAxis fov_axis = FovAxis::shorter;
};

struct Camera {
  std::variant<Perspective, Orthographic> model;
  schema::CallSite where;
};

}  // namespace lapidary::description
