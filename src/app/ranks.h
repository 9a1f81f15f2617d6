#pragma once

#include "app/command_line.h"
#include "app/exit_code.h"
#include "app/preparation.h"
#include "distributed/crew.h"
#include "render/origin.h"

namespace lapidary::app {

/// What a rank has made of a scene.
struct Readiness {
  const render::Origin& origin;
  const Preparation& preparation;
  const render::BlockRenderer& renderer;
};

/// Waits until all of the crew are ready as this rank is. Throws Error where one of them cannot be,
/// and DifferentPicture where one has made something else of the scene.
void wait_until_ready(distributed::Crew& crew, const Readiness& here);

/// Warns where a rank is given fewer processors than its share of the machine and --threads is not
/// there to say that this is meant.
void warn_about_binding(const RenderCommand& command, WarningLog& warnings);

/// Renders for rank 0, to the end. What goes wrong is for that to tell.
ExitCode work_for_rank_0(distributed::Channel& channel, const RenderCommand& command);

}  // namespace lapidary::app
