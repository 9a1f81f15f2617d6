#pragma once

#include <string>

#include "app/command_line.h"
#include "app/exit_code.h"
#include "app/preparation.h"
#include "distributed/crew.h"
#include "render/origin.h"

namespace lapidary::app {

/// Waits until all of the crew have made of the scene what this rank has. Throws Error where one of
/// them cannot, and DifferentPicture where one has another scene.
void wait_until_ready(distributed::Crew& crew, const render::Origin& origin,
                      const Preparation& preparation);

/// Renders for rank 0, to the end. What goes wrong is for that to tell.
ExitCode work_for_rank_0(distributed::Channel& channel, const RenderCommand& command);

/// As messages name it.
std::string name_of_rank(int rank, const std::string& host);

}  // namespace lapidary::app
