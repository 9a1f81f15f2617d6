#pragma once

#include "app/command_line.h"
#include "base/input_files.h"
#include "base/log.h"
#include "description/scene_description.h"

namespace lapidary::app {

/// Reads what `arguments` name, a scene or a mesh, as it is. `files`, if not null, notes what is
/// read. Throws Error, or UsageError where the kind of file does not go with the other arguments.
description::SceneDescription load_scene(const SceneArguments& arguments,
                                         const std::vector<Assignment>& settings,
                                         WarningLog& warnings, InputFiles* files = nullptr);

/// Adds what must be there to make a picture: to a bare mesh a studio to stand in, to a scene the
/// camera and the lights that it lacks.
void complete_scene(const SceneArguments& arguments, description::SceneDescription& scene);

/// Throws UsageError for a setting that no scene could have, before anything is read.
void check_settings(const std::vector<Assignment>& settings);

}  // namespace lapidary::app
