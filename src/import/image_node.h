#pragma once

#include "import/image_file.h"
#include "schema/node_kind.h"

namespace lapidary::import {

/// The node `image`, a texture from a file. What it constructs comes through `images`, which must
/// outlive it, and is noted in `files`, which may be null.
schema::NodeKind image_kind(ImageFiles& images, InputFiles* files);

}  // namespace lapidary::import
