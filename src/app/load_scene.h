#pragma once

#include "app/command_line.h"
#include "base/input_files.h"
#include "base/log.h"
#include "description/scene_description.h"
#include "import/scene_files.h"

namespace lapidary::app {

/// What is told, kept and used of earlier scenes while one is read.
struct Loading {
  WarningLog& warnings;
  InputFiles* files = nullptr;  ///< notes what is read; null: nobody wants to know
  import::SceneFiles* kept =
      nullptr;  ///< with what earlier scenes have read; null: there were none
};

/// Reads what `arguments` name, a scene or a mesh, as it is. Throws Error, or UsageError where the
/// kind of file does not go with the other arguments.
description::SceneDescription load_scene(const SceneArguments& arguments,
                                         const std::vector<Assignment>& settings,
                                         const Loading& loading);

/// Adds what must be there to make a picture: to a bare mesh a studio to stand in, to a scene the
/// camera and the lights that it lacks.
void complete_scene(const SceneArguments& arguments, description::SceneDescription& scene);

/// Throws UsageError for a setting that no scene could have, before anything is read.
void check_settings(const std::vector<Assignment>& settings);

}  // namespace lapidary::app
