#pragma once

#include "app/command_line.h"
#include "base/log.h"
#include "description/scene_description.h"

namespace lapidary::app {

/// Reads what `arguments` name: a scene as it is, or a mesh, put into a studio. A scene gets the
/// camera and the lights that it lacks. Throws Error, or UsageError where the kind of file does not
/// go with the other arguments.
description::SceneDescription load_scene(const SceneArguments& arguments,
                                         const std::vector<Assignment>& settings,
                                         WarningLog& warnings);

/// Throws UsageError for a setting that no scene could have, before anything is read.
void check_settings(const std::vector<Assignment>& settings);

}  // namespace lapidary::app
