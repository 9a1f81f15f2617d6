#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "description/camera.h"
#include "description/leaves.h"
#include "description/light.h"
#include "description/object.h"
#include "description/settings.h"
#include "schema/call_site.h"

namespace lapidary::description {

/// A scene as its author said it. What is missing (no camera, no lights) whoever renders it adds.
struct SceneDescription {
  std::optional<Camera> camera;
  std::vector<ObjectPtr> objects;  ///< lights with a surface included
  std::vector<Light> lights;
  /// Taken away from all solids, to show their insides, but not from those that wear Emissive as a
  /// whole; null: nothing.
  ObjectPtr section;
  RenderSettings render;
  FilmSettings film;
  double metres_per_unit = 1;
  schema::CallSite where;
};

/// Calls `visit` for every leaf of the scene's objects in the order of writing; what the scene's
/// section takes away comes last in `removed`. The references hold for the duration of the call.
void for_each_leaf(const SceneDescription& scene, const std::function<void(const Leaf&)>& visit);

/// Whether any part of it wears Emissive.
bool gives_light(const Leaf& leaf);
bool gives_light(std::span<const ObjectPtr> objects);

/// Whether anything gives light: an entry of `lights`, or an object that wears Emissive.
bool has_light(const SceneDescription& scene);

}  // namespace lapidary::description
