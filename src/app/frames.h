#pragma once

#include <string>
#include <string_view>

#include "app/command_line.h"

namespace lapidary::app {

/// `text` with each run of # replaced by the frame's number, filled with zeros to as many digits;
/// a number that has more is written out. As it is where it has none.
std::string with_frame_number(std::string_view text, int frame);

/// `command` for one of the frames of --frames: that frame's scene, and its number in place of ####
/// in all names of files that it writes or has a plan from.
RenderCommand of_frame(const RenderCommand& command, int frame);

/// Whether --resume has nothing to do for a command of one frame: its pictures are there, and are
/// complete, as the checkpoint of one that is not would lie beside it. Never where a picture holds
/// the checkpoint itself: that says better what the picture is of, and whether it has its samples.
bool is_done_already(const RenderCommand& command);

}  // namespace lapidary::app
