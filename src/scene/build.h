#pragma once

#include "base/input_files.h"
#include "base/log.h"
#include "base/parallel.h"
#include "description/scene_description.h"
#include "scene/mesh_solids.h"
#include "scene/scene.h"

namespace lapidary::scene {

/// What takes long to build, for the scene that comes after.
struct Kept {
  geometry::World::Kept world;
  MeshSolids meshes;
};

/// What building a scene needs beside its description.
struct BuildOptions {
  description::PictureSize size;  ///< its shape decides what the field of view spans
  ThreadPool& pool;
  WarningLog& warnings;
  description::LightChoice light_choice = description::LightChoice::tree;
  InputFiles* files = nullptr;  ///< notes what is read; null: nobody wants to know
  /// Of a scene before this, of which what is the same is not built again; left as that of this
  /// scene, which is the same with and without it. Null: there is none.
  Kept* kept = nullptr;
};

/// Turns what the user said into what light transport reads. The description has a camera; a scene
/// without lights is black. Throws Error at the place of whatever cannot be rendered.
Scene build(const description::SceneDescription& description, const BuildOptions& options);

}  // namespace lapidary::scene
