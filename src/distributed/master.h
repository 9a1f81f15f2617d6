#pragma once

#include "distributed/crew.h"
#include "distributed/run_thread.h"
#include "render/canvas.h"
#include "render/render.h"

namespace lapidary::distributed {

/// Renders as render::render does, with all ranks of the crew and this one, each of which renders
/// with all its threads. The crew is dismissed at the end, and is at work (`work`) before.
///
/// With a limit of samples, blocks or noise the picture has the same bits as of one rank: for the
/// noise films are looked at one block at a time in their order, and what comes after the end is
/// thrown away. At the end of the time all finish the block that they are at; stopped from outside,
/// they drop it, and there may be gaps between the passes.
/// Throws Error where a rank gives up or sends what makes no sense, and bad_alloc; the canvas then
/// is what it was before that.
/// Precondition: `check_can_go_on`.
render::Statistics render(Crew& crew, const Equipment& equipment, const render::StopRules& rules,
                          const render::Control& control, render::Canvas& canvas);

}  // namespace lapidary::distributed
