#pragma once

#include <optional>

#include "app/command_line.h"
#include "base/input_files.h"
#include "base/log.h"
#include "base/parallel.h"
#include "description/scene_description.h"
#include "film/film.h"
#include "render/block.h"
#include "scene/scene.h"

namespace lapidary::app {

/// A scene that was read and built, and can be rendered. It stays where it is: its parts refer to
/// each other.
class Preparation {
 public:
  /// `files`, if not null, notes what is read. Throws Error, or UsageError.
  Preparation(const RenderCommand& command, film::Layers layers, WarningLog& warnings,
              InputFiles* files, ThreadPool& pool);
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  const description::SceneDescription& description() const { return description_; }
  const scene::Scene& scene() const { return *scene_; }
  const film::Film::Settings& film() const { return film_; }
  const render::BlockRenderer& renderer() const { return *renderer_; }

  /// Wall time from one step to the next.
  struct Seconds {
    double load = 0, build = 0, photons = 0;
  };
  const Seconds& seconds() const { return seconds_; }
  /// Processor time of this process that had gone by before the photons.
  double cpu_seconds_before() const { return cpu_seconds_before_; }

 private:
  Seconds seconds_;
  double cpu_seconds_before_ = 0;
  description::SceneDescription description_;
  std::optional<scene::Scene> scene_;
  film::Film::Settings film_;
  std::optional<render::BlockRenderer> renderer_;
};

}  // namespace lapidary::app
