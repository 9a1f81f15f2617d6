#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "description/scene_description.h"
#include "geometry/mesh_closure.h"
#include "inspect/crofton.h"
#include "inspect/measure.h"
#include "inspect/operands.h"
#include "inspect/overlap.h"
#include "inspect/worn.h"

namespace lapidary::inspect {

/// What lines through a combination say, or through a solid with a section.
struct CombinationReport {
  Box3d bounds;                  ///< tighter than those of the measure; may be infinite, or empty
  std::optional<BodySize> size;  ///< nothing where it is unbounded
  OperandReport operands;
};

/// What stands in a scene at one place.
struct ObjectReport {
  std::string name;  ///< may be empty
  std::string kind;  ///< "sphere", "mesh", ...
  Location where;
  Measure measure;
  Worn worn;  ///< what glows as a whole is a light, and no object to the counts below
  std::size_t triangles = 0;
  /// Whether it has an inside: solids have, sheets have not, meshes have if they are closed.
  bool closed = false;
  std::optional<geometry::MeshClosure> closure;  ///< of meshes only
  bool combined = false;                         ///< of several solids, or cut by a section
  /// Of what is combined, unless there is too much of that in the scene.
  std::optional<CombinationReport> combination;
};

/// A light without a surface.
struct LightReport {
  std::string kind;  ///< "point_light", "environment", ...
  Location where;
};

/// What can be said about a scene without rendering it.
struct SceneReport {
  std::vector<ObjectReport> surfaces;  ///< objects and lights, in order of writing, no groups
  std::vector<LightReport> lights_without_surface;
  /// Of opaque bodies of equal priority, by index into `surfaces`: who fills a place with glass, or
  /// gives priorities, means it.
  OverlapSearch overlaps;
  std::size_t unmeasured = 0;  ///< combinations without a report, since there are so many
  std::size_t objects = 0;     ///< surfaces that reflect, all or a part of them
  std::size_t lights = 0;      ///< surfaces that glow, all or a part of them, and those without one
  std::size_t operands = 0;    ///< leaves of solids among the objects
  std::size_t triangles = 0;   ///< of the objects, instances counted each
};

/// Looks at every object and light of `scene`, cut by its section as a renderer cuts them. Throws
/// Error where a combination cannot be built.
SceneReport inspect(const description::SceneDescription& scene, ThreadPool& pool);

}  // namespace lapidary::inspect
