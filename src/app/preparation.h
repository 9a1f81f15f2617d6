#pragma once

#include <optional>

#include "app/command_line.h"
#include "app/progress.h"
#include "base/input_files.h"
#include "base/log.h"
#include "base/parallel.h"
#include "description/scene_description.h"
#include "film/film.h"
#include "import/scene_files.h"
#include "render/block.h"
#include "render/render.h"
#include "scene/build.h"
#include "scene/scene.h"

namespace lapidary::app {

/// What one frame of an animation leaves to the next.
struct Kept {
  import::SceneFiles files;
  scene::Kept scene;
};

/// What the work on a picture needs beside its command.
struct Workshop {
  WarningLog& warnings;
  InputFiles& files;  ///< notes what is read
  Kept& kept;
  ProgressDisplay& display;
  ThreadPool& pool;
};

/// A scene that was read and built. It stays where it is: its parts refer to each other.
class Preparation {
 public:
  /// Throws Error, or UsageError.
  Preparation(const RenderCommand& command, film::Layers layers, const Workshop& with);
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  const description::SceneDescription& description() const { return description_; }
  const scene::Scene& scene() const { return *scene_; }
  const film::Film::Settings& film() const { return film_; }
  render::SampleSettings samples() const { return render::sample_settings(description_.render); }
  render::BlockRenderer::Picture picture() const { return {film_.width, film_.height}; }

  /// Wall time from one step to the next.
  struct Seconds {
    double load = 0, build = 0;
  };
  const Seconds& seconds() const { return seconds_; }

 private:
  Seconds seconds_;
  description::SceneDescription description_;
  std::optional<scene::Scene> scene_;
  film::Film::Settings film_;
};

/// Warns of caustics and illumination maps that are wanted and will not be there.
void warn_about_photons(const render::BlockRenderer& renderer, WarningLog& warnings);

}  // namespace lapidary::app
