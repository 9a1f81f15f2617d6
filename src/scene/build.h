#pragma once

#include "base/input_files.h"
#include "base/log.h"
#include "base/parallel.h"
#include "description/scene_description.h"
#include "scene/scene.h"

namespace lapidary::scene {

/// What building a scene needs beside its description.
struct BuildOptions {
  description::PictureSize size;  ///< its shape decides what the field of view spans
  ThreadPool& pool;
  WarningLog& warnings;
  description::LightChoice light_choice = description::LightChoice::tree;
  InputFiles* files = nullptr;  ///< notes what is read; null: nobody wants to know
  /// Those of a scene before this, of which what is the same is not built again; null: none.
  const geometry::TriangleScene* earlier = nullptr;
};

/// Turns what the user said into what light transport reads. The description has a camera; a scene
/// without lights is black. Throws Error at the place of whatever cannot be rendered.
Scene build(const description::SceneDescription& description, const BuildOptions& options);

}  // namespace lapidary::scene
