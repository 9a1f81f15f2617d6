#pragma once

#include "import/image_file.h"
#include "schema/node_kind.h"

namespace lapidary::import {

/// The node `image`, a texture from a file. What it constructs comes through `files`, which must
/// outlive it.
schema::NodeKind image_kind(ImageFiles& files);

}  // namespace lapidary::import
