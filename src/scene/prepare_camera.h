#pragma once

#include "camera/camera.h"
#include "description/camera.h"
#include "description/settings.h"

namespace lapidary::scene {

/// The camera for pictures of the given size.
camera::Camera prepare_camera(const description::Camera& camera,
                              const description::PictureSize& size);

}  // namespace lapidary::scene
