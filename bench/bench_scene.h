#pragma once

#include <string>

#include "lua/load_scene.h"
#include "scene/build.h"

namespace lapidary::bench {

/// A scene of bench/scenes, at its own size, for one thread.
struct BenchScene {
  explicit BenchScene(const std::string& name)
      : description(lua::load_scene(LAPIDARY_BENCH_SCENES "/" + name + ".lua").scene) {}

  ThreadPool pool{1};
  WarningLog warnings;
  description::SceneDescription description;
  description::PictureSize size = description.render.size;
  scene::Scene scene = scene::build(description, {size, pool, warnings});
};

}  // namespace lapidary::bench
