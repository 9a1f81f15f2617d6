#pragma once

#include "import/image_file.h"
#include "import/mesh_file.h"

namespace lapidary::import {

/// What scenes read of files, each once. Frames of an animation hand it on, for what the next one
/// reads too: files count as unchanged meanwhile.
/// Either all of them note what they read, or none.
class SceneFiles {
 public:
  SceneFiles() = default;
  SceneFiles(const SceneFiles&) = delete;
  SceneFiles& operator=(const SceneFiles&) = delete;

  /// To be called before another scene is read: drops what the one before did not read.
  void begin_scene() {
    images.begin_scene();
    meshes.begin_scene();
  }

  ImageFiles images;
  MeshFiles meshes{&images};
};

}  // namespace lapidary::import
