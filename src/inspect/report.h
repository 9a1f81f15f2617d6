#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "description/scene_description.h"
#include "geometry/mesh_closure.h"
#include "inspect/measure.h"
#include "inspect/overlap.h"

namespace lapidary::inspect {

/// What stands in a scene at one place.
struct ObjectReport {
  std::string name;  ///< may be empty
  std::string kind;  ///< "sphere", "mesh", ...
  Location where;
  Measure measure;
  std::size_t triangles = 0;
  /// Whether it has an inside: solids have, sheets have not, meshes have if they are closed.
  bool closed = false;
  std::optional<geometry::MeshClosure> closure;  ///< of meshes only
};

/// What can be said about a scene without rendering it.
struct SceneReport {
  std::vector<ObjectReport> objects;  ///< in order of writing, groups resolved
  OverlapSearch overlaps;             ///< by index into `objects`
  std::size_t lights = 0;             ///< entries of the list of lights and objects that shine
  std::size_t operands = 0;           ///< leaves of solids
  std::size_t triangles = 0;          ///< instances counted each
};

/// Looks at every object of `scene`.
SceneReport inspect(const description::SceneDescription& scene);

}  // namespace lapidary::inspect
