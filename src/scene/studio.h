#pragma once

#include "description/scene_description.h"
#include "math/interval.h"

namespace lapidary::scene {

/// Bounds of everything bounded that `objects` show; empty when nothing is.
Box3d bounds(const std::vector<description::ObjectPtr>& objects);

/// A camera that sees all of `box` from the front, a little from the left and from above, in a
/// picture of the given size. `box` is bounded.
description::Camera framing_camera(const Box3d& box, const description::PictureSize& size);

/// Adds what a scene lacks to be seen: a camera that frames its objects, and a photographer's soft
/// lights around them. Where nothing bounded is there to frame, it frames the unit cube.
void add_missing_studio(description::SceneDescription& scene);

/// Puts the floor of a photographer's studio under the objects of a scene, bending up into a
/// seamless backdrop behind them, and adds lights and a camera where the scene has none.
void stand_in_studio(description::SceneDescription& scene);

}  // namespace lapidary::scene
