#pragma once

#include "app/command_line.h"
#include "app/outputs.h"
#include "base/input_files.h"
#include "description/scene_description.h"
#include "render/block.h"
#include "render/canvas.h"
#include "render/origin.h"
#include "render/render.h"

namespace lapidary::app {

/// What a render of `command` is made from.
render::Origin origin_of(const RenderCommand& command,
                         const description::SceneDescription& description, InputFiles& files);

/// When it is to stop.
render::StopRules stop_rules_of(const RenderCommand& command,
                                const description::RenderSettings& settings);

/// Where a render starts.
struct Start {
  render::Canvas canvas;
  enum class From {
    nothing,
    no_checkpoint,  ///< there is none to resume
    checkpoint,
  };
  From from = From::nothing;
};

/// The canvas to render on, with what a checkpoint has, for --resume, or its plan, for --plan.
/// Throws DifferentPicture where it is not from `origin`, Error where it cannot be used, and
/// UsageError where blocks need a plan and have none.
Start start_of(const RenderCommand& command, const Outputs& outputs, const render::Origin& origin,
               const film::Film::Settings& settings, const render::BlockRenderer& renderer);

}  // namespace lapidary::app
